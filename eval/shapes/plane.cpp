// SPDX-License-Identifier: Apache-2.0
#include "eval/shapes/narrow.h"
#include "eval/shapes/rows.h"

namespace alidade {

namespace {

/// dot(normal, p) = offset, with the normal as it stands in the scene.
struct Equation {
    Vec3 normal;
    double size, offset;
    explicit Equation(const Plane& plane) : normal(plane.normal), size(length_of(plane.normal)), offset(plane.distance * size) {}

    /// Most normals are unit vectors along an axis: their square is 1, and a root takes as long as the rest of a crossing.
    static double length_of(const Vec3& normal) { return dot(normal, normal) == 1 ? 1 : length(normal); }

    /// The signed distance of a point from the plane, times the length of the normal.
    double height(const Vec3& p) const { return dot(normal, p) - offset; }
    /// A bound on the rounding of height(p).
    double height_rounding(const Vec3& p) const { return gamma_bound(8) * (dot(glm::abs(normal), glm::abs(p)) + std::abs(offset)); }
};

/// A plane has no box, not even where it is parallel to an axis: as a solid it fills half of space.
Bounds plane_bounds(const ShapeGeometry& geometry) { return bounds(geometry); }

/// The height found by evaluating it at ray.at(t), and the roundings of that evaluation and of ray.at(t).
ErrorBound plane_error(const ShapeGeometry& geometry, const Ray& ray, double t, uint32_t) {
    const Equation plane(std::get<Plane>(geometry));
    const Vec3 p = ray.at(t), moved{at_rounding(ray, t, 0), at_rounding(ray, t, 1), at_rounding(ray, t, 2)};
    const double bound = std::abs(plane.height(p)) + plane.height_rounding(p) + dot(glm::abs(plane.normal), moved);
    return {bound * (1 + gamma_bound(8)) / plane.size};
}

/// One crossing, or none where the ray is parallel to the plane (also in it) and where it is so nearly parallel that t is not finite.
Crossings plane_crossings(const ShapeGeometry& geometry, const Ray& ray) {
    const Equation plane(std::get<Plane>(geometry));
    Crossings out;
    const double rise = dot(plane.normal, ray.dir), t = -plane.height(ray.origin) / rise;
    if (!std::isfinite(rise) || !std::isfinite(t)) return out;   // one of them is not where the ray is not
    out.add(t, 0);
    out.begins_inside = rise > 0;
    return out;
}

Vec3 plane_normal(const ShapeGeometry& geometry, const Vec3&, uint32_t) { return normalized(std::get<Plane>(geometry).normal); }

/// With the unit normal n and the axis a to which n is least parallel (the first of equals), s = a made perpendicular to n and unit, t = n x s:
/// u = dot(p, s), v = dot(p, t). A plane with the normal +y has u = x, v = -z.
SurfacePoint plane_surface(const ShapeGeometry& geometry, const Vec3& point, uint32_t part) {
    SurfacePoint out;
    const Vec3 n = out.normal = plane_normal(geometry, point, part);
    int axis = 0;
    for (int i = 1; i < 3; ++i)
        if (std::abs(n[i]) < std::abs(n[axis])) axis = i;
    Vec3 along(0);
    along[axis] = 1;
    out.dpdu = normalized(along - dot(along, n) * n);
    out.dpdv = cross(n, out.dpdu);
    out.uv = {dot(point, out.dpdu), dot(point, out.dpdv)};
    return out;
}

/// The side opposite to the normal.
bool plane_inside(const ShapeGeometry& geometry, const Vec3& point) { return Equation(std::get<Plane>(geometry)).height(point) <= 0; }

/// A quadric without squares.
Bounds plane_narrow(const ShapeGeometry& geometry, bool outside, const Bounds& box) {
    const Equation plane(std::get<Plane>(geometry));
    return narrowed(Quadric{Vec3(0), Vec3(0), plane.normal, -plane.offset}, outside, box);
}

}  // namespace

const ShapeOps kPlaneOps = {"plane", "a half space: the side opposite to a normal", kind_of<Plane>(), plane_bounds, plane_crossings, plane_error, plane_surface, plane_inside, always_solid, plane_narrow, false, plane_normal};

}  // namespace alidade
