// SPDX-License-Identifier: Apache-2.0
/// Pairs of pictures with the answers of the FLIP authors' program, where they are at hand.
#pragma once

#include "core/image.h"
#include "tests/tools/metrics/pairs.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace alidade::test {

struct PublishedAnswer {
    std::string name;
    Picture reference, test;
    nlohmann::json numbers;
};

/// Of the list `key`: "ldr" as display values, "hdr" as linear ones. None if the file is not there.
inline std::vector<PublishedAnswer> published_answers(const char* key) {
    const std::filesystem::path folder = SHARED_DATA "/flip";
    std::ifstream file(folder / "expected.json");
    std::vector<PublishedAnswer> answers;
    if (!file) return answers;
    const auto document = nlohmann::json::parse(file);
    for (const auto& entry : document.at(key)) {
        const auto read = [&](const char* which) {
            auto picture = read_picture((folder / entry.at(which).get<std::string>()).string(), Encoding::linear);
            if (!picture) throw std::runtime_error(picture.error());
            return std::move(*picture);
        };
        answers.push_back({entry.at("test").get<std::string>(), read("reference"), read("test"), entry});
    }
    return answers;
}

inline void expect_published(const Measured& measured, const PublishedAnswer& answer) {
    for (const auto& [name, value] : answer.numbers.items()) {
        if (!value.is_number()) continue;
        EXPECT_NEAR(number(measured, name), value.get<double>(), name == "min" || name == "max" ? 1e-3 : 1e-4) << answer.name << ", " << name;
    }
}

}  // namespace alidade::test
