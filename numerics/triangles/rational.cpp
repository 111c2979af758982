// SPDX-License-Identifier: Apache-2.0
#include "numerics/triangles/rational.h"

namespace alidade::numerics {

RationalVec rational(const Vec3& v) { return {Rational(v.x), Rational(v.y), Rational(v.z)}; }

RationalVec operator-(const RationalVec& a, const RationalVec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

RationalVec cross(const RationalVec& a, const RationalVec& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Rational dot(const RationalVec& a, const RationalVec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

ExactCrossing exact_crossing(const Ray& ray, const std::array<Vec3, 3>& triangle) {
    const RationalVec p0 = rational(triangle[0]), e1 = rational(triangle[1]) - p0, e2 = rational(triangle[2]) - p0;
    const RationalVec dir = rational(ray.dir), from = rational(ray.origin) - p0, normal = cross(e1, e2);
    const Rational slope = dot(dir, normal);
    ExactCrossing crossing;
    if (slope == 0) return crossing;
    // Cramer's rule for from + t dir = u e1 + v e2.
    const RationalVec moment = cross(dir, from);
    crossing.t = -dot(from, normal) / slope;
    crossing.u = dot(e2, moment) / slope;
    crossing.v = -dot(e1, moment) / slope;
    const Rational w = 1 - crossing.u - crossing.v;
    crossing.side = std::min({sgn(crossing.u), sgn(crossing.v), sgn(w)});
    return crossing;
}

bool within(const Vec3& p, double bound, const std::array<Vec3, 3>& triangle) {
    const RationalVec p0 = rational(triangle[0]), normal = cross(rational(triangle[1]) - p0, rational(triangle[2]) - p0);
    const Rational height = dot(rational(p) - p0, normal), limit = Rational(bound);
    return height * height <= limit * limit * dot(normal, normal);
}

double relative_error(double computed, const Rational& exact) {
    const Rational error = abs(Rational(computed) - exact);
    return (exact == 0 ? error : Rational(error / abs(exact))).get_d();
}

}  // namespace alidade::numerics
