// SPDX-License-Identifier: Apache-2.0
/// What cylinders and cones are: a radius that changes evenly along an axis. Parts: 0 the side, 1 the cap at a, 2 the cap at b.
#pragma once

#include "eval/shapes/approach.h"
#include "eval/shapes/wanted.h"

namespace alidade {

/// Does the ray's line surely pass the cylinder of `radius` around the line from `a` to `b`? Without a root or a division: of the rays that come to the boxes of many small ones, it tells half to three quarters; a scene of few, which nearly all rays hit, pays 2 % for it.
/// Method   the distance of the two lines is |w . n| / |n| with w = origin - a and n = d x (b - a). What is computed of w . n is off by less than `rounding`; nothing is told of
///          numbers so large or small that their squares are not numbers.
inline bool surely_passes(const Vec3& a, const Vec3& b, double radius, const Ray& ray) {
    const Vec3 axis = b - a, from = ray.origin - a, across = cross(ray.dir, axis);
    const double rounding = 1e-14 * max_abs(from) * max_abs(ray.dir) * max_abs(axis), apart = std::abs(dot(from, across)) - rounding;
    const double square = dot(across, across);
    return apart > 0 && apart < 1e140 && square > 1e-280 && apart * apart > (1 + 1e-6) * radius * radius * square;
}

class Frustum {
  public:
    Frustum(const Vec3& a, const Vec3& b, double radius_a, double radius_b, bool open);

    /// Units    the shape's space; `t` counts multiples of |ray.dir|.
    /// Method   the ray is moved to its point nearest to `a`: p + t d. With w the unit axis, h and q the parts of a point along and across it (H and Q of
    ///          the direction), and the radius r = radius_a + k h that the axis says, the side is |q|^2 = r^2. Its discriminant is
    ///          |r Q - k H q|^2 - |q x Q|^2, a difference of squares that cancels only at the silhouette; of the two roots, the one without cancellation
    ///          comes from the formula, the other from their product. Each is polished by Newton steps on |q| - |r|, which carries no squares, and near a tangent by one with twice the digits. Then the
    ///          stretches with |q| <= |r| are cut to those between the caps.
    /// Error    of t: <= 4 units of 2^-52 (|t| + size / |d|) / cosine of the angle to the normal, size being that of the shape. Held by
    ///          tests/eval/frustum_test.cpp against 113-bit arithmetic.
    /// `own` is the box of what the frustum was made of.
    Crossings crossings(const Bounds& own, const Ray& ray, Wanted wanted) const;
    ErrorBound error(const Ray& ray, double t, uint32_t part) const;
    SurfacePoint surface(const Vec3& point, uint32_t part) const;
    Vec3 normal(const Vec3& point, uint32_t part) const;
    bool inside(const Vec3& point) const;

  private:
    struct Line;
    struct Stretch;
    struct End {
        double t;
        uint32_t part;
        bool polished = true;
    };
    /// A point relative to `a`: along the axis, across it, and the signed radius there.
    struct Place {
        double along;
        Vec3 across;
        double radius;
    };
    Crossings crossings_inline(const Bounds& own, const Ray& ray, Wanted wanted) const;
    Crossings crossings_with_fma(const Bounds& own, const Ray& ray, Wanted wanted) const;
    Place place(const Vec3& from_a) const;
    /// The unit direction from the axis to a place; `any` at a tip.
    Vec3 outwards(const Place& here, const Vec3& any) const;
    Vec3 side_normal(const Place& here, const Vec3& outwards) const;
    double polished(const Line& line, double t) const;
    double near_tangent(const Line& line, double s, const Ray& ray, double t) const;
    int stretches(const Line& line, const RoughCrossings& rough, Stretch (&out)[2]) const;
    bool add(const Line& line, const Approach& p, const Ray& ray, const LineInterval& box, const End& end, Crossings& out) const;

    Vec3 a_, b_, axis_;
    double length_, radius_a_, radius_b_, slope_;
    bool open_;
};

}  // namespace alidade
