// SPDX-License-Identifier: Apache-2.0
#include "eval/shapes/frustum.h"

namespace alidade {

namespace {

Frustum frustum_of_cone(const ShapeGeometry& geometry) {
    const Cone& c = std::get<Cone>(geometry);
    return {c.a, c.b, c.radius_a, c.radius_b, c.open};
}

Bounds cone_bounds(const ShapeGeometry& geometry) { return bounds(geometry); }
Crossings cone_wanted(const ShapeGeometry& geometry, const Bounds& own, const Ray& ray, Wanted wanted) {
    const Cone& c = std::get<Cone>(geometry);
    if (surely_passes(c.a, c.b, std::max(std::abs(c.radius_a), std::abs(c.radius_b)), ray)) return {};
    return frustum_of_cone(geometry).crossings(own, ray, wanted);
}
Crossings cone_crossings(const ShapeGeometry& geometry, const Ray& ray) { return cone_wanted(geometry, cone_bounds(geometry), whole_line(ray), Wanted::all); }
ErrorBound cone_error(const ShapeGeometry& geometry, const Ray& ray, double t, uint32_t part) { return frustum_of_cone(geometry).error(ray, t, part); }
SurfacePoint cone_surface(const ShapeGeometry& geometry, const Vec3& point, uint32_t part) { return frustum_of_cone(geometry).surface(point, part); }
Vec3 cone_normal(const ShapeGeometry& geometry, const Vec3& point, uint32_t part) { return frustum_of_cone(geometry).normal(point, part); }
bool cone_inside(const ShapeGeometry& geometry, const Vec3& point) { return frustum_of_cone(geometry).inside(point); }
bool cone_solid(const ShapeGeometry& geometry) { return !std::get<Cone>(geometry).open; }

}  // namespace

const ShapeOps kConeOps = {"cone", "a cone cut off at both ends, with or without caps", kind_of<Cone>(), cone_bounds, cone_crossings, cone_error, cone_surface, cone_inside, cone_solid, nullptr, false, cone_normal, cone_wanted};

}  // namespace alidade
