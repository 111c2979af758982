// SPDX-License-Identifier: Apache-2.0
/// Teapots in a stadium: nearly all triangles of a scene in a place that is nothing beside the whole. What kills a uniform grid.
#pragma once

#include "core/random.h"
#include "numerics/triangles/meshes.h"

#include <span>

namespace alidade::test {

struct TeapotPlace {
    Vec3 foot;       ///< the middle of its bottom, metres; the stadium is 200 m long, its field is z = 0
    double height;   ///< metres
};

struct StadiumScene {
    numerics::TriangleMesh mesh;
    std::vector<Bounds> teapots;
};

/// The shell: a field, six tiers of stands and a rim, of about `shell` triangles, 200 x 150 x 35 m. In it teapots (a body of revolution with a lid, a handle
/// and a spout, 1.6 times as wide as high) of about `fine` triangles each.
StadiumScene teapots_in_a_stadium(const std::string& name, int shell, int fine, std::span<const TeapotPlace> places);

struct StadiumCase {
    const char* name;
    StadiumScene (*make)();
    bool needs_double;   ///< float cannot tell the vertices of a teapot so small, so far from 0
};
/// One in the middle, on the grass, by the stands, many, coarse and fine shells, sizes of 1e-3, 1e-4 and 1e-6 of the stadium's.
std::span<const StadiumCase> stadium_cases();

struct StadiumRays {
    const char* name;
    Ray (*make)(const StadiumScene& scene, const RandomKey& key);
    bool any_hit;
};
/// A camera's that look at a teapot, close and from the stands; random ones through all of the stadium; shadow rays from a teapot, and to it.
std::span<const StadiumRays> stadium_rays();

}  // namespace alidade::test
