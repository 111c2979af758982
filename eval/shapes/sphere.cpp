// SPDX-License-Identifier: Apache-2.0
#include "eval/shapes/approach.h"
#include "eval/shapes/rows.h"
#include "eval/shapes/twice.h"
#include "eval/shapes/wanted.h"

namespace alidade {

namespace {

/// A bound on the distance of ray.at(t) from the sphere: the distance found by evaluating it there, and the roundings of that evaluation (of the
/// difference, the square root of the sum of squares, and the last difference: 5 at the most) and of ray.at(t) itself.
ErrorBound sphere_error(const ShapeGeometry& geometry, const Ray& ray, double t, uint32_t) {
    const Sphere& s = std::get<Sphere>(geometry);
    const Vec3 p = ray.at(t) - s.center;
    const double from_center = std::sqrt(dot(p, p)), radius = std::abs(s.radius);
    return {std::abs(from_center - radius) + gamma_bound(8) * (from_center + radius) + at_rounding(ray, t)};
}

Bounds sphere_bounds(const ShapeGeometry& geometry) { return bounds(geometry); }

struct Chord {
    double middle;   ///< in t, from p.shift + p.rest
    double square;   ///< of half of it, in squared units of t
};

/// That of a line which comes near to the silhouette. The shift leaves next to nothing of dot(from, dir): a double will do for the middle.
Chord near_silhouette(const Sphere& s, const Ray& ray, const Approach& p) {
    const TwiceVec dir(ray.dir), from = TwiceVec::difference(ray.origin, s.center).moved(Twice::sum(p.shift, p.rest), dir);
    const double length2 = dot(ray.dir, ray.dir), middle = -dot(from, dir).value() / length2;
    return {middle, middle * middle - (dot(from, from) - Twice::product(s.radius, s.radius)).value() / length2};
}

/// Of the squared radius: with less of a half chord, its square is found with twice the digits.
constexpr double kSilhouette = 1.0 / 64;

/// Units    the shape's space; `t` counts multiples of |ray.dir|, which need not be 1. Lengths may be from 1e-140 to 1e140.
/// Method   the ray is moved to its point nearest to the centre, twice: what is left of the linear coefficient is only rounding, so nothing cancels
///          however far the origin is. After E. Haines et al., "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems (2019), ch. 7.
/// Error    of t: <= 4 ulp from 4 radii away on, wherever the sphere is (measured: 3.1 at 4 radii, 0.6 from 100 radii on): numerics/, T07. Hit or miss
///          is right outside of 4 ulp of the distance: T08.
/// A tangent is one crossing twice, so that entries and exits always pair; a NaN is a miss.
[[gnu::always_inline]] inline Crossings crossings_inline(const Sphere& s, const Bounds& own, const Ray& ray) {
    Crossings out;
    const Approach p = approach_inline(s.center, ray);
    const double radius2 = s.radius * s.radius, length2 = dot(ray.dir, ray.dir);
    double square = (radius2 - dot(p.nearest, p.nearest)) / length2, middle = p.rest;
    if (std::abs(square) * length2 < kSilhouette * radius2) {
        const Chord chord = near_silhouette(s, ray, p);
        square = chord.square, middle += chord.middle;
    }
    if (!(square >= 0) || !std::isfinite(p.shift) || !is_finite(ray)) return out;
    const LineInterval inside = inside_bounds(ray, own);
    if (inside.empty()) return out;   // accelerators would not ask
    const double half = std::sqrt(square);
    for (const double t : {p.shift + (middle - half), p.shift + (middle + half)}) out.add(std::clamp(t, inside.entry, inside.exit), 0);
    return out;
}

/// Does the ray begin and end so far inside that nothing is crossed between? So do most rays in a sphere that is a scene's sky.
bool stays_inside(const Sphere& s, const Ray& ray) {
    constexpr double kFar = 1e-6;   // in parts of the squared sizes: far more than rounding
    const auto deep = [&](double t) {
        const Vec3 from = ray.origin - s.center, p = from + t * ray.dir;
        return dot(p, p) + kFar * (dot(from, from) + dot(p, p)) < (1 - kFar) * s.radius * s.radius;
    };
    return ray.tmax < kInf && deep(ray.tmax) && deep(ray.tmin);
}

#ifdef __x86_64__
[[gnu::target("fma"), gnu::flatten]] Crossings crossings_with_fma(const Sphere& s, const Bounds& own, const Ray& ray) { return crossings_inline(s, own, ray); }
#endif

Crossings sphere_wanted(const ShapeGeometry& geometry, const Bounds& own, const Ray& ray, Wanted) {
    const Sphere& s = std::get<Sphere>(geometry);
    if (stays_inside(s, ray)) {
        Crossings none;
        none.begins_inside = true;
        return none;
    }
#ifdef __x86_64__
    if (kHasFma) return crossings_with_fma(s, own, ray);
#endif
    return crossings_inline(s, own, ray);
}

Crossings sphere_crossings(const ShapeGeometry& geometry, const Ray& ray) { return sphere_wanted(geometry, sphere_bounds(geometry), whole_line(ray), Wanted::all); }

Vec3 sphere_normal(const ShapeGeometry& geometry, const Vec3& point, uint32_t) { return normalized(point - std::get<Sphere>(geometry).center); }

/// u runs around the y axis from +x by +z, v from the pole -y (0) to the pole +y (1): with the radius r and p relative to the centre,
/// u = atan2(p.z, p.x) / 2 pi (+ 1 if negative), v = 1/2 + asin(p.y / r) / pi. At a pole u is 0, and dpdu has the direction and length that it would
/// have on the equator, so that it is never zero.
SurfacePoint sphere_surface(const ShapeGeometry& geometry, const Vec3& point, uint32_t part) {
    SurfacePoint out;
    out.normal = sphere_normal(geometry, point, part);
    const double radius = std::abs(std::get<Sphere>(geometry).radius), around = std::hypot(out.normal.x, out.normal.z);
    const double u = std::atan2(out.normal.z, out.normal.x) / (2 * kPi);
    out.uv = {u < 0 ? u + 1 : u, 0.5 + std::atan2(out.normal.y, around) / kPi};
    const bool pole = around == 0;
    const double cosine = pole ? 1 : out.normal.x / around, sine = pole ? 0 : out.normal.z / around;
    out.dpdu = (2 * kPi * radius * (pole ? 1 : around)) * Vec3(-sine, 0, cosine);
    out.dpdv = (kPi * radius) * Vec3(-out.normal.y * cosine, around, -out.normal.y * sine);
    return out;
}

bool sphere_inside(const ShapeGeometry& geometry, const Vec3& point) {
    const Sphere& s = std::get<Sphere>(geometry);
    return length(point - s.center) <= std::abs(s.radius);
}

}  // namespace

const ShapeOps kSphereOps = {"sphere", "all points at one distance from a centre", kind_of<Sphere>(), sphere_bounds, sphere_crossings, sphere_error, sphere_surface, sphere_inside, always_solid, nullptr, false, sphere_normal, sphere_wanted, true};

}  // namespace alidade
