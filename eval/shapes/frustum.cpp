// SPDX-License-Identifier: Apache-2.0
#include "eval/shapes/frustum.h"

#include "eval/shapes/twice.h"

namespace alidade {

/// A ray, taken apart along and across the axis: its point nearest to `a`, its direction, and how they change the radius.
struct Frustum::Line {
    Place start;
    double along;
    Vec3 across;
    double radius;   ///< k H
    double size;     ///< |d|

    double square() const { return dot(across, across) - radius * radius; }
    double half_linear() const { return dot(start.across, across) - radius * start.radius; }
    double constant() const {
        const double q = length(start.across), r = std::abs(start.radius);
        return (q - r) * (q + r);
    }
    /// (b/2)^2 - a c
    double discriminant() const {
        const double from = length(start.radius * across - radius * start.across), to = length(cross(start.across, across));
        return (from - to) * (from + to);
    }
};

/// A part of the line with |q| <= |r|; its ends may be infinite.
struct Frustum::Stretch {
    End enter{-kInf, 0}, leave{kInf, 0};
};

Frustum::Frustum(const Vec3& a, const Vec3& b, double radius_a, double radius_b, bool open)
    : a_(a), b_(b), axis_(normalized(b - a)), length_(length(b - a)), radius_a_(radius_a), radius_b_(radius_b), slope_((radius_b - radius_a) / length_), open_(open) {}

Frustum::Place Frustum::place(const Vec3& from_a) const {
    const double along = dot(from_a, axis_);
    return {along, from_a - along * axis_, radius_a_ + slope_ * along};
}

/// A root of the side after at most two Newton steps on |q| - |r|; a step that does not bring it nearer, as at the silhouette, is not taken.
double Frustum::polished(const Line& line, double t) const {
    const auto distance = [&](double at) { return length(line.start.across + at * line.across) - std::abs(line.start.radius + at * line.radius); };
    double here = distance(t);
    for (int step = 0; step < 2 && here != 0; ++step) {
        const Vec3 q = line.start.across + t * line.across;
        const double speed = dot(q, line.across) / length(q) - std::copysign(line.radius, line.radius * (line.start.radius + t * line.radius));
        const double next = t - here / speed, there = distance(next);
        if (!(std::abs(there) < std::abs(here))) break;
        t = next, here = there;
    }
    return t;
}

/// The crossing of the side at `s` along the line, where the ray is at `t`: near a tangent the roundings of |q| - |r| move it far.
double Frustum::near_tangent(const Line& line, double s, const Ray& ray, double t) const {
    const Vec3 across = line.start.across + s * line.across;
    const double radius = line.start.radius + s * line.radius, slope = dot(across, line.across) - radius * line.radius;
    if (slope * slope >= kNearTangent * dot(across, across) * (1 + slope_ * slope_) * line.size * line.size) return t;
    const TwiceVec x = TwiceVec::difference(ray.origin, a_).moved(t, ray.dir), axis(axis_);
    const Twice along = dot(x, axis), r = slope_ * along + radius_a_;
    const TwiceVec q = x.moved(-along, axis);
    return after_step(t, std::abs(t) + max_abs(ray.origin) / line.size, dot(q, q) - r * r, 2 * slope);
}

/// Where |q| <= |r|; returns how many stretches that are, in order. Roots that are apart are left to be polished.
int Frustum::stretches(const Line& line, const RoughCrossings& rough, Stretch (&out)[2]) const {
    const double a = line.square(), b = line.half_linear(), c = line.constant(), d = line.discriminant();
    if (std::isnan(a + b + c + d) || (a >= 0 && d < 0)) return 0;
    const double q = -(b + std::copysign(std::sqrt(std::max(d, 0.0)), b));   // steeper than the cone, a line always meets both of its halves
    if (q == 0) return c <= 0 && a <= 0 ? 1 : 0;                             // along the axis, or along a line of the side
    End first{c / q, 0, false}, second{q / a, 0, false};
    if (a == 0) {   // parallel to a line of the side: one root
        (b > 0 ? out[0].leave : out[0].enter) = first;
        return 1;
    }
    if (!rough.surely_before(first.t, second.t) && !rough.surely_before(second.t, first.t)) first = {polished(line, first.t), 0}, second = {polished(line, second.t), 0};
    if (first.t > second.t) std::swap(first, second);
    if (a > 0) {
        out[0].enter = first, out[0].leave = second;
        return 1;
    }
    out[0].leave = first, out[1].enter = second;
    return 2;
}

ErrorBound Frustum::error(const Ray& ray, double t, uint32_t part) const {
    if (part != 0) {
        const Vec3 p = ray.at(t) - (part == 1 ? a_ : b_);
        return {std::abs(dot(p, axis_)) + gamma_bound(10) * length(p) + at_rounding(ray, t)};
    }
    const Vec3 p = ray.at(t) - a_;
    const Place here = place(p);
    const double off = std::abs(length(here.across) - std::abs(here.radius)), steep = std::abs(slope_);
    // The roundings: of the axis, of h and q, of the slope and what it is multiplied with. Across the side, only a part of the difference counts.
    const double rounding = gamma_bound(20) * ((1 + steep) * length(p) + std::abs(radius_a_) + std::abs(radius_b_));
    return {(off + rounding) / std::hypot(1.0, steep) * (1 + gamma_bound(4)) + at_rounding(ray, t)};
}

/// Adds a crossing, not before the last one. False if it is not in the ray's interval.
bool Frustum::add(const Line& line, const Approach& p, const Ray& ray, const LineInterval& box, const End& end, Crossings& out) const {
    if ((open_ && end.part != 0) || !std::isfinite(end.t)) return false;
    const double s = p.rest + end.t, t = p.shift + s;
    const double at = std::clamp(end.part == 0 && end.polished ? near_tangent(line, s, ray, t) : t, box.entry, box.exit);
    out.add(out.count > 0 ? std::max(at, out.at[size_t(out.count - 1)].t) : at, end.part);
    return at >= ray.tmin && at <= ray.tmax;
}

[[gnu::always_inline]] inline Crossings Frustum::crossings_inline(const Bounds& own, const Ray& ray, Wanted wanted) const {
    Crossings out;
    const Approach p = approach_inline(a_, ray);
    if (!is_finite(ray) || !std::isfinite(p.shift) || !(length_ > 0)) return out;
    const double along = dot(ray.dir, axis_);
    const Line line{place(p.nearest), along, ray.dir - along * axis_, slope_ * along, length(ray.dir)};

    Stretch between;   // the caps
    if (line.along != 0) {
        between.enter = {-line.start.along / line.along, 1};
        between.leave = {(length_ - line.start.along) / line.along, 2};
        if (between.enter.t > between.leave.t) std::swap(between.enter, between.leave);
    } else if (!(line.start.along >= 0 && line.start.along <= length_)) {
        return out;
    }
    const RoughCrossings rough(ray, std::abs(p.shift) + (length_ + std::abs(radius_a_) + std::abs(radius_b_)) / line.size);
    Stretch found[2];
    const int count = stretches(line, rough, found);
    if (count == 0) return out;
    const LineInterval box = inside_bounds(ray, own);
    if (box.empty()) return out;
    const auto polish = [&](End& end) {   // unless it lies outside of the ray's interval or of the caps
        if (end.polished || rough.surely_outside(p.shift + end.t) || rough.surely_before(end.t, between.enter.t) || rough.surely_before(between.leave.t, end.t)) return;
        end = {polished(line, end.t), end.part};
    };
    for (int i = 0; i < count; ++i) {
        polish(found[i].enter);
        const End enter = found[i].enter.t >= between.enter.t ? found[i].enter : between.enter;
        const bool surely_in = wanted != Wanted::all && rough.surely_before(enter.t, std::min(found[i].leave.t, between.leave.t));
        if (surely_in && add(line, p, ray, box, enter, out)) return out;   // nobody asks where it ends
        polish(found[i].leave);
        const End leave = found[i].leave.t <= between.leave.t ? found[i].leave : between.leave;
        if (!(enter.t <= leave.t)) continue;
        if (!surely_in) add(line, p, ray, box, enter, out);
        add(line, p, ray, box, leave, out);
    }
    return out;
}

#ifdef __x86_64__
[[gnu::target("fma"), gnu::flatten]] Crossings Frustum::crossings_with_fma(const Bounds& own, const Ray& ray, Wanted wanted) const { return crossings_inline(own, ray, wanted); }
#endif

Crossings Frustum::crossings(const Bounds& own, const Ray& ray, Wanted wanted) const {
#ifdef __x86_64__
    if (kHasFma) return crossings_with_fma(own, ray, wanted);
#endif
    return crossings_inline(own, ray, wanted);
}

Vec3 Frustum::outwards(const Place& here, const Vec3& any) const {
    const double radius = length(here.across);
    return radius > 0 ? here.across / radius : any;
}

Vec3 Frustum::side_normal(const Place& here, const Vec3& outwards) const { return normalized(outwards - (here.radius < 0 ? -1 : 1) * slope_ * axis_); }

Vec3 Frustum::normal(const Vec3& point, uint32_t part) const {
    if (part != 0) return part == 1 ? -axis_ : axis_;
    const Place here = place(point - a_);
    Vec3 s, t;
    orthonormal_basis(axis_, s, t);
    return side_normal(here, outwards(here, s));
}

/// On the side, u runs around the axis and v from a (0) to b (1). On a cap, (u, v) runs from (0, 0) to (1, 1) over the square around it.
SurfacePoint Frustum::surface(const Vec3& point, uint32_t part) const {
    const Place here = place(point - a_);
    SurfacePoint out;
    Vec3 s, t;
    orthonormal_basis(axis_, s, t);
    if (part != 0) {
        const double radius = std::abs(part == 1 ? radius_a_ : radius_b_), size = radius > 0 ? 2 * radius : 1;
        out.normal = part == 1 ? -axis_ : axis_;
        out.uv = {0.5 + dot(here.across, s) / size, 0.5 + dot(here.across, t) / size};
        out.dpdu = size * s, out.dpdv = size * t;
        return out;
    }
    const double radius = length(here.across), sign = here.radius < 0 ? -1 : 1;
    const Vec3 from_axis = outwards(here, s);
    const double angle = std::atan2(dot(from_axis, t), dot(from_axis, s)) / (2 * kPi);
    out.normal = side_normal(here, from_axis);
    out.uv = {angle < 0 ? angle + 1 : angle, here.along / length_};
    out.dpdu = (2 * kPi * (radius > 0 ? radius : length_)) * cross(axis_, from_axis);
    out.dpdv = length_ * axis_ + sign * (radius_b_ - radius_a_) * from_axis;
    return out;
}

bool Frustum::inside(const Vec3& point) const {
    const Place here = place(point - a_);
    return here.along >= 0 && here.along <= length_ && length(here.across) <= std::abs(here.radius);
}

}  // namespace alidade
