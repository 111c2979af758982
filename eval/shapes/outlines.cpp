// SPDX-License-Identifier: Apache-2.0
#include "eval/shapes/outlines.h"

#include "eval/shapes/polynomial_roots.h"

namespace alidade {

namespace {

double cross2(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

/// Where (1 - x)^2 a + 2 x (1 - x) c + x^2 b is 0 for 0 <= x <= 1. One root if a and b have different signs (0 is positive), else none or two.
int roots_in_arc(double a, double c, double b, double (&out)[2]) {
    const bool one = (a >= 0) != (b >= 0);
    if (!one && ((a >= 0) == (c >= 0) || std::abs(c) * std::abs(c) < std::abs(a) * std::abs(b))) return 0;
    const double square = a - 2 * c + b, half = c - a;
    const double discriminant = std::max(0.0, c * c - a * b);
    const double sum = -(half + std::copysign(std::sqrt(discriminant), half));
    const double x[] = {sum / square, sum != 0 ? a / sum : 0};
    if (one) {
        const auto outside = [](double r) { return r >= 0 && r <= 1 ? 0 : std::isfinite(r) ? std::max(-r, r - 1) : kInf; };
        out[0] = std::clamp(outside(x[0]) < outside(x[1]) ? x[0] : x[1], 0.0, 1.0);
        return 1;
    }
    out[0] = std::clamp(std::min(x[0], x[1]), 0.0, 1.0), out[1] = std::clamp(std::max(x[0], x[1]), 0.0, 1.0);
    return 2;
}

template <class F> void for_arcs(const Extrusion& e, const Vec2& origin, const F& f) {
    uint32_t index = 0;
    for (const Outline& outline : e.outlines) {
        const size_t count = outline.points.size() / 2 * 2;
        for (size_t i = 0; i < count; i += 2, ++index)
            f(index, BezierArc{outline.points[i] - origin, outline.points[i + 1] - origin, outline.points[i + 2 < count ? i + 2 : 0] - origin});
    }
}

}  // namespace

Vec2 BezierArc::at(double tau) const {
    const double rest = 1 - tau;
    return rest * (rest * a + tau * control) + tau * (rest * control + tau * b);
}

/// At an end whose control point it shares, the direction to the other end.
Vec2 BezierArc::tangent(double tau) const {
    const Vec2 out = (1 - tau) * (control - a) + tau * (b - control);
    return out == Vec2(0) ? b - a : out;
}

double BezierArc::nearest(const Vec2& p) const {
    const Vec2 from = a - p, first = 2.0 * (control - a), second = a - 2.0 * control + b;
    const double c[] = {dot(from, first), dot(first, first) + 2 * dot(from, second), 3 * dot(first, second), 2 * dot(second, second)};
    double roots[kMostRoots];
    const int count = real_roots(c, roots);
    double best = 0, distance = dot(from, from);
    const auto consider = [&](double tau) {
        const Vec2 off = at(tau) - p;
        if (dot(off, off) < distance) distance = dot(off, off), best = tau;
    };
    consider(1);
    for (int i = 0; i < count; ++i) consider(std::clamp(roots[i], 0.0, 1.0));
    return best;
}

BezierArc arc_of(const Extrusion& e, size_t index, const Vec2& origin) {
    for (const Outline& outline : e.outlines) {
        const size_t arcs = outline.points.size() / 2;
        if (index >= arcs) {
            index -= arcs;
            continue;
        }
        return {outline.points[2 * index] - origin, outline.points[2 * index + 1] - origin, outline.points[index + 1 < arcs ? 2 * index + 2 : 0] - origin};
    }
    return {};
}

std::pmr::vector<Cut> cuts_of(const Extrusion& e, const Vec2& origin, const Vec2& p, const Vec2& d, std::pmr::memory_resource& memory) {
    std::pmr::vector<Cut> cuts(&memory);
    cuts.reserve(32);
    const double square = dot(d, d);
    for_arcs(e, origin, [&](uint32_t index, const BezierArc& arc) {
        const double a = cross2(d, arc.a - p), b = cross2(d, arc.b - p);
        const bool straight = arc.control == arc.a;
        double tau[2];
        int count = 0;
        if (!straight) count = roots_in_arc(a, cross2(d, arc.control - p), b, tau);
        else if ((a >= 0) != (b >= 0)) count = 1, tau[0] = std::clamp(a / (a - b), 0.0, 1.0);
        for (int i = 0; i < count; ++i) {
            const Vec2 at = straight ? (1 - tau[i]) * arc.a + tau[i] * arc.b : arc.at(tau[i]);
            const double s = dot(d, at - p) / square;
            if (!std::isnan(s)) cuts.push_back({s, index, (a < 0) == (i == 0) ? 1 : -1});   // a NaN has no place in an order
        }
    });
    std::sort(cuts.begin(), cuts.end(), [](const Cut& x, const Cut& y) { return x.s < y.s; });
    return cuts;
}

bool outlines_hold(const Extrusion& e, const Vec2& point) {
    std::byte space[2048];
    std::pmr::monotonic_buffer_resource memory(space, sizeof space);
    int winding = 0, count = 0;
    for (const Cut& cut : cuts_of(e, Vec2(0), point, Vec2(1, 0), memory)) {
        if (cut.s > 0) break;
        winding += cut.turn, ++count;
    }
    return is_inside(e, winding, count);
}

}  // namespace alidade
