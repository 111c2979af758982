// SPDX-License-Identifier: Apache-2.0
/// The words that benches of accelerators over made scenes have in common.
#pragma once

#include "accel/accelerator.h"
#include "stress/scene.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace alidade::bench {

struct Words {
    std::vector<std::string> accel{"bvh"}, kinds;   ///< all kinds, if none is named
    double scale = 1;                               ///< of the scenes' numbers of triangles
    int rounds = 5;

    /// The scenes that are asked for, each with its number of triangles.
    template <class Each> void for_each_kind(Each&& each) const {
        for (const StressKind& kind : stress_kinds())
            if (kinds.empty() || std::find(kinds.begin(), kinds.end(), kind.name) != kinds.end()) each(kind, std::max<size_t>(100, size_t(double(kind.triangles) * scale)));
    }
    std::vector<const AcceleratorEntry*> entries() const {
        std::vector<const AcceleratorEntry*> list;
        for (const std::string& name : accel) list.push_back(find_accelerator(name));
        return list;
    }
};

template <class Rows> std::vector<std::string> names(const Rows& rows) {
    std::vector<std::string> list;
    for (const auto& row : rows) list.emplace_back(row.name);
    return list;
}

inline void add_words(CLI::App& app, Words& words) {
    app.add_option("--accel", words.accel, "accelerators")->delimiter(',')->check(CLI::IsMember(names(accelerators())))->capture_default_str();
    app.add_option("--kinds", words.kinds, "made scenes (all)")->delimiter(',')->check(CLI::IsMember(names(stress_kinds())));
    app.add_option("--scale", words.scale, "of their numbers of triangles")->check(CLI::PositiveNumber)->capture_default_str();
    app.add_option("--rounds", words.rounds)->check(CLI::Range(2, 1000))->capture_default_str();
}

/// As main() does: the exit code of the words, or of `run`.
template <class Run> int parsed(CLI::App& app, int argc, char** argv, Run&& run) {
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return app.exit(e);
    }
    run();
    return 0;
}

}  // namespace alidade::bench
