// SPDX-License-Identifier: Apache-2.0
/// The decision on a triangle that passed the filter: an exact one, and t, u, v refined in double.
#pragma once

#include "accel/triangles/edge_filter.h"

#include <optional>

namespace alidade {

using Corners = std::array<Vec3, 3>;

/// Refers to the local ray.
struct DecideRay {
    explicit DecideRay(const LocalRay& ray) : DecideRay(ray, ShearAxes(ray.dir)) {}
    [[gnu::always_inline]] inline DecideRay(const LocalRay& ray, const ShearAxes& shear_axes)
        : origin(ray.origin), dir(ray.dir), axes(shear_axes), dir_z(component(dir, axes.z)), shear_x(component(dir, axes.x) / dir_z), shear_y(component(dir, axes.y) / dir_z) {}

    const Vec3 &origin, &dir;
    ShearAxes axes;
    double dir_z, shear_x, shear_y;
};

struct TriangleCrossing {
    double t;      ///< local, within the interval in which the ray is in the triangle's box as computed in double
    double u, v;   ///< weights of the second and third corner
};

/// Where the line crosses the triangle. The decision is that of exact arithmetic on the ray and corners as they are; an edge or a corner counts as hit, a triangle
/// seen edge-on does not. So the line through any point of a closed mesh hits one of the triangles there. `exact` counts signs that needed more than double.
/// Crossings that are surely before `low`, or whose t would surely be beyond `high`, may be left out, which is cheaper.
std::optional<TriangleCrossing> decide(const DecideRay& ray, const Corners& corners, double low, double high, uint64_t& exact);

/// How far ray.at(t) may be from the plane of the triangle. Derived in docs/numerics.md, "The error of a hit". The same bits for all instructions.
ErrorBound plane_error(const Ray& ray, double t, const Corners& corners, Isa isa = Isa::best);

}  // namespace alidade
