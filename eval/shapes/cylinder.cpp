// SPDX-License-Identifier: Apache-2.0
#include "eval/shapes/frustum.h"

namespace alidade {

namespace {

Frustum frustum_of_cylinder(const ShapeGeometry& geometry) {
    const Cylinder& c = std::get<Cylinder>(geometry);
    return {c.a, c.b, c.radius, c.radius, c.open};
}

Bounds cylinder_bounds(const ShapeGeometry& geometry) { return bounds(geometry); }
Crossings cylinder_wanted(const ShapeGeometry& geometry, const Bounds& own, const Ray& ray, Wanted wanted) {
    const Cylinder& c = std::get<Cylinder>(geometry);
    if (surely_passes(c.a, c.b, std::abs(c.radius), ray)) return {};
    return frustum_of_cylinder(geometry).crossings(own, ray, wanted);
}
Crossings cylinder_crossings(const ShapeGeometry& geometry, const Ray& ray) { return cylinder_wanted(geometry, cylinder_bounds(geometry), whole_line(ray), Wanted::all); }
ErrorBound cylinder_error(const ShapeGeometry& geometry, const Ray& ray, double t, uint32_t part) { return frustum_of_cylinder(geometry).error(ray, t, part); }
SurfacePoint cylinder_surface(const ShapeGeometry& geometry, const Vec3& point, uint32_t part) { return frustum_of_cylinder(geometry).surface(point, part); }
Vec3 cylinder_normal(const ShapeGeometry& geometry, const Vec3& point, uint32_t part) { return frustum_of_cylinder(geometry).normal(point, part); }
bool cylinder_inside(const ShapeGeometry& geometry, const Vec3& point) { return frustum_of_cylinder(geometry).inside(point); }
bool cylinder_solid(const ShapeGeometry& geometry) { return !std::get<Cylinder>(geometry).open; }

}  // namespace

const ShapeOps kCylinderOps = {"cylinder", "all points near an axis, with or without caps", kind_of<Cylinder>(), cylinder_bounds, cylinder_crossings, cylinder_error, cylinder_surface, cylinder_inside, cylinder_solid, nullptr, false, cylinder_normal, cylinder_wanted, true};

}  // namespace alidade
