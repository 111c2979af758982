// SPDX-License-Identifier: Apache-2.0
/// The inside of closed lines in a plane as triangles.
#pragma once

#include "core/vec.h"

#include <functional>
#include <optional>
#include <vector>

namespace alidade::meshing {

struct Filled {
    /// From point a to point b with the inside on its left.
    struct RimEdge {
        uint32_t a, b;
        std::optional<size_t> line;     ///< the edge, counted through all loops as they were given, that it is a part of; nothing if rounding hides it
    };
    std::vector<Vec2> points;           ///< the lines' own and those where they cross
    std::vector<Index3> triangles;      ///< counter-clockwise
    std::vector<RimEdge> rim;
};

inline constexpr size_t kMostFilledPoints = 20'000, kMostSplitLines = 2'000'000;

/// Fills what `inside(winding, crossings)` says of places around which the lines wind that often, and that so many of them surround. Lines may cross. Nothing if they
/// have more than kMostFilledPoints points, or would be split into more than kMostSplitLines at each other's heights.
///
/// Method   trapezoids between all heights at which a line turns or two of them cross; those of neighbouring heights share all points, so that the mesh is as closed
///          as its lines, and walls that stand on its rim fit to it.
/// Time     the square of the number of points.
std::optional<Filled> fill(const std::vector<std::vector<Vec2>>& loops, const std::function<bool(int winding, int crossings)>& inside);

}  // namespace alidade::meshing
