// SPDX-License-Identifier: Apache-2.0
/// How a ray is tested against a triangle: what a test costs, and what it may get wrong.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace alidade {

/// exact: the decisions of exact arithmetic, and one answer from all structures. robust: nothing leaks, but signs are those of the mesh's precision, and t of double. fast: of the mesh's own precision, boxes without pads.
enum class Intersect { exact, robust, fast };

/// What bench/results/intersect.md measured: wrong answers of a million, and time.
struct IntersectMeasured {
    double edges, vertices;   ///< rays aimed at them that slip through closed meshes: rows T01 and T02 of the numerical suite
    double decisions;         ///< at edges of triangles that graze, are far, thin or tiny: row T05
    double time;              ///< of rays through the BVH in float, over that of `exact`
};

struct IntersectEntry {
    const char* name;
    const char* doc;
    Intersect value;
    IntersectMeasured measured;

    /// Its doc and what was measured, as a sentence.
    std::string text() const;
};

/// The table, in the order of Intersect; the first row is what is taken when nobody asks.
std::span<const IntersectEntry> intersects();
inline const char* name(Intersect how) { return intersects()[size_t(how)].name; }

}  // namespace alidade
