// SPDX-License-Identifier: Apache-2.0
/// Scenes without what depends on where and how they stand in a file, so that two of them can be compared by their dump.
#pragma once

#include "scene/scene.h"

#include <array>
#include <string>
#include <vector>

namespace alidade::test {

/// Without places, settings and files; shapes, signals, images in the order in which nodes and materials use them, equal ones once, unused ones not at all;
/// pictures by their bytes.
Scene canonical(Scene scene);

/// Equal, but for numbers that differ by less than 1e-14 of them (a rotation that is normalised twice, an angle behind a tangent): the first line that
/// differs, or "".
std::string first_difference(const std::string& a, const std::string& b);

/// A corner of a triangle in the world: x y z, normal, uv, colour; NaN where there is none.
using Corner = std::array<double, 3 + 3 + 2 + 4>;
struct WorldTriangle {
    std::array<Corner, 3> corners;
    std::string material;   ///< its base colour, roughness and metalness
};

/// What the scene shows, as a renderer sees it: every path, mirrored ones turned, the first corner the least one. Sorted by positions rounded to float.
/// Triangles with two equal corners are left out. `exact`: with the digits beyond float, if the scene has them.
std::vector<WorldTriangle> world_triangles(const Scene& scene, bool exact);

}  // namespace alidade::test
