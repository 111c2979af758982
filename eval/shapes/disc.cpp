// SPDX-License-Identifier: Apache-2.0
#include "eval/shapes/approach.h"
#include "eval/shapes/rows.h"

namespace alidade {

namespace {

Bounds disc_bounds(const ShapeGeometry& geometry) { return bounds(geometry); }

/// A bound on the distance of ray.at(t) from the plane: the height found by evaluating it there, and the roundings of that (of the unit normal, the
/// difference and the product) and of ray.at(t).
ErrorBound disc_error(const ShapeGeometry& geometry, const Ray& ray, double t, uint32_t) {
    const Disc& d = std::get<Disc>(geometry);
    const Vec3 p = ray.at(t) - d.center;
    return {std::abs(dot(normalized(d.normal), p)) + gamma_bound(10) * length(p) + at_rounding(ray, t)};
}

/// Units    the shape's space; `t` counts multiples of |ray.dir|.
/// Method   the ray is moved to its point nearest to the centre, so that a far origin or centre costs no digits; then the plane, then the radii.
/// Error    of t: <= 4 units of 2^-52 (|t| + radius / |d|) / cosine of the angle to the normal. Held by tests/eval/disc_test.cpp against 113-bit arithmetic.
/// None for a ray parallel to the disc, or in it; none in the hole, whose rim belongs to the disc.
Crossings disc_crossings(const ShapeGeometry& geometry, const Ray& ray) {
    const Disc& d = std::get<Disc>(geometry);
    Crossings out;
    const Vec3 normal = normalized(d.normal);
    const Approach p = approach(d.center, ray);
    const double way = -dot(normal, p.nearest) / dot(normal, ray.dir);
    if (!is_finite(ray) || !std::isfinite(p.shift) || !std::isfinite(way)) return out;
    const Vec3 at = p.nearest + way * ray.dir;
    const double from_center = length(at);
    if (!(from_center <= std::abs(d.radius)) || from_center < std::abs(d.hole)) return out;
    const LineInterval inside = inside_bounds(ray, disc_bounds(geometry));
    if (inside.empty()) return out;
    out.add(std::clamp(p.shift + (p.rest + way), inside.entry, inside.exit), 0);
    return out;
}

/// (u, v) runs from (0, 0) to (1, 1) over the square around the disc.
SurfacePoint disc_surface(const ShapeGeometry& geometry, const Vec3& point, uint32_t) {
    const Disc& d = std::get<Disc>(geometry);
    const double size = d.radius == 0 ? 1 : 2 * std::abs(d.radius);
    SurfacePoint out;
    Vec3 s, t;
    out.normal = normalized(d.normal);
    orthonormal_basis(out.normal, s, t);
    const Vec3 p = point - d.center;
    out.uv = {0.5 + dot(p, s) / size, 0.5 + dot(p, t) / size};
    out.dpdu = size * s, out.dpdv = size * t;
    return out;
}

bool disc_inside(const ShapeGeometry& geometry, const Vec3& point) {
    const Disc& d = std::get<Disc>(geometry);
    return dot(d.normal, point - d.center) <= 0;
}

bool disc_solid(const ShapeGeometry&) { return false; }

}  // namespace

const ShapeOps kDiscOps = {"disc", "a flat disc, with or without a hole", kind_of<Disc>(), disc_bounds, disc_crossings, disc_error, disc_surface, disc_inside, disc_solid};

}  // namespace alidade
