// SPDX-License-Identifier: Apache-2.0
/// NAME=VALUE of the command line: what a scene finds declared.
#pragma once

#include <cctype>
#include <cfloat>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>

namespace alidade::pov {

struct Declared {
    std::string name;
    double value = 0;
};

/// Nothing if the name is no identifier, or the value no number that POV-Ray's floats can hold: there, 1e39 would be infinite.
inline std::optional<Declared> parse_declared(const std::string& text) {
    const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; };
    const size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0 || !is_letter(text[0])) return std::nullopt;
    for (size_t i = 0; i < equals; ++i)
        if (!is_letter(text[i]) && !std::isdigit(static_cast<unsigned char>(text[i]))) return std::nullopt;
    const char* const begin = text.c_str() + equals + 1;
    char* end = nullptr;
    const double value = std::strtod(begin, &end);
    if (end == begin || *end || !(std::fabs(value) <= double(FLT_MAX))) return std::nullopt;
    return Declared{text.substr(0, equals), value};
}

}  // namespace alidade::pov
