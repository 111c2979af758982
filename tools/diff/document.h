// SPDX-License-Identifier: Apache-2.0
/// What `diff` tells, for programs and for people. The schema is docs/diff.md.
#pragma once

#include "tools/diff/cause.h"
#include "tools/diff/judge.h"
#include "tools/diff/tiles.h"
#include "tools/json.h"

namespace alidade {

/// Everything that is known of one comparison.
struct Comparison {
    std::string reference, test;       ///< the files' names
    std::optional<LoadedPair> loaded;  ///< absent if there is nothing to measure
    Measurements measured;
    TileTable tiles;
    bool aligned = false;              ///< a shift was looked for
    std::optional<Shift> shift;        ///< and found
    Judgement judgement;
    Cause cause;
    std::vector<uint8_t> marked;       ///< pixels that heat_map() marks, one a pixel; empty for none
};

/// The versioned document: `schema` counts up when a key changes its meaning or goes.
Json to_json(const Comparison& comparison);
/// Lines for a terminal.
std::string as_lines(const Comparison& comparison);
/// A JUnit file: one test case a rule, or one that says why there is nothing to measure.
std::string as_junit(const Comparison& comparison);

/// The error that pictures of it show, 0 .. 1 for each pixel: FLIP's (HDR-FLIP's where there is one), or the difference of alpha where that is more; 1 where one
/// picture alone is NaN or infinite.
std::vector<float> error_map(const Comparison& comparison);
/// error_map(), from black over purple and orange to white; marked pixels are green.
Picture heat_map(const Comparison& comparison);

}  // namespace alidade
