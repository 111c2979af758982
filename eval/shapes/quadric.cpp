// SPDX-License-Identifier: Apache-2.0
#include "eval/shapes/approach.h"
#include "eval/shapes/implicit.h"
#include "eval/shapes/narrow.h"
#include "eval/shapes/twice.h"
#include "eval/shapes/wanted.h"

namespace alidade {

namespace {

/// f by Horner's rule: x (A x + D y + E z + G) + y (B y + F z + H) + z (C z + I) + J. Five roundings in a row.
constexpr int kRoundings = 8;

/// The magnitude is left out: crossings do not ask for it, and take most of their time here.
inline ImplicitValue value_and_gradient(const Quadric& q, const Vec3& p) {
    const Vec3 &s = q.squares, &m = q.products, &l = q.linear;
    const Vec3 row(s.x * p.x + m.x * p.y + m.y * p.z + l.x, s.y * p.y + m.z * p.z + l.y, s.z * p.z + l.z);
    ImplicitValue f;
    f.value = p.x * row.x + p.y * row.y + p.z * row.z + q.constant;
    f.gradient = Vec3(row.x + s.x * p.x, row.y + s.y * p.y + m.x * p.x, row.z + s.z * p.z + m.y * p.x + m.z * p.y);
    return f;
}

ImplicitValue evaluate(const Quadric& q, const Vec3& p) {
    const Vec3 &s = q.squares, &m = q.products, &l = q.linear, a = glm::abs(p);
    ImplicitValue f = value_and_gradient(q, p);
    f.magnitude = dot(a * a, glm::abs(s)) + std::abs(m.x) * a.x * a.y + std::abs(m.y) * a.x * a.z + std::abs(m.z) * a.y * a.z + dot(a, glm::abs(l)) + std::abs(q.constant);
    return f;
}

/// Those of an ellipsoid along the axes, or of a cylinder, which is endless along one of them; all space for every other quadric.
Bounds quadric_bounds(const ShapeGeometry& geometry) { return bounds(geometry); }

/// f(p + s u) = square s^2 + 2 half s + constant.
struct OnLine {
    double square, half, constant;
    bool is_line = false;   ///< what is left of `square` is rounding

    OnLine(const Quadric& q, const Vec3& p, const Vec3& u) {
        const ImplicitValue at = value_and_gradient(q, p);
        const Vec3 products(u.x * u.y, u.x * u.z, u.y * u.z);
        square = dot(q.squares, u * u) + dot(q.products, products);
        half = 0.5 * dot(at.gradient, u);
        constant = at.value;
        is_line = std::abs(square) <= gamma_bound(8) * (dot(glm::abs(q.squares), u * u) + dot(glm::abs(q.products), glm::abs(products)));
    }

    /// The roots in order; a double one twice.
    int roots(double (&out)[2]) const {
        if (is_line) {
            out[0] = -constant / (2 * half);
            return std::isfinite(out[0]) ? 1 : 0;
        }
        const double both = half * half, products = square * constant;
        const double discriminant = std::fma(half, half, -products) + std::fma(-square, constant, products);   // W. Kahan: as if of exact products
        if (!(discriminant >= 0) || !std::isfinite(both)) return 0;
        const double sum = -(half + std::copysign(std::sqrt(discriminant), half));
        out[0] = sum / square, out[1] = sum != 0 ? constant / sum : out[0];
        if (out[1] < out[0]) std::swap(out[0], out[1]);
        return std::isfinite(out[0]) && std::isfinite(out[1]) ? 2 : 0;
    }
};

/// A line p + s u, |u| = 1, and where it crosses the quadric.
struct QuadricLine {
    const Quadric& q;
    Vec3 p, u;

    /// In order but for the last digits. `begins_inside`: is f negative before the first?
    int rough_crossings(double (&out)[2], std::optional<bool>& begins_inside) const {
        const OnLine here(q, p, u);
        const double shift = here.is_line ? 0 : -here.half / here.square;
        const OnLine there(q, p + shift * u, u);   // where f has its extreme: nothing is left to cancel
        const bool nearer = shift != 0 && std::abs(there.constant) < std::abs(here.constant);
        const int count = (nearer ? there : here).roots(out);
        for (int i = 0; i < count; ++i) out[i] = nearer ? shift + out[i] : out[i];
        if (count > 0) begins_inside = here.is_line ? here.half > 0 : here.square < 0;
        return count;
    }
    double polished(double s) const {
        return alidade::polished([&](const Vec3& x) { return along(value_and_gradient(q, x), u); }, p, u, s);
    }
};

/// Near a tangent the roundings of f move its crossings far.
double near_tangent(const Quadric& q, const Ray& ray, double t) {
    const Vec3 gradient = value_and_gradient(q, ray.at(t)).gradient;
    const double slope = dot(gradient, ray.dir);
    if (slope * slope >= kNearTangent * dot(gradient, gradient) * dot(ray.dir, ray.dir)) return t;
    const TwiceVec x = TwiceVec(ray.origin).moved(t, ray.dir);
    const Twice &a = x.v[0], &b = x.v[1], &c = x.v[2];
    const Vec3 &s = q.squares, &m = q.products, &l = q.linear;
    Twice value = a * (s.x * a + l.x) + b * (s.y * b + l.y) + c * (s.z * c + l.z) + q.constant;
    if (m != Vec3(0)) value = value + a * (m.x * b + m.y * c) + m.z * (b * c);
    return after_step(t, std::abs(t) + max_abs(ray.origin) / max_abs(ray.dir), value, slope);
}

/// Units    the shape's space; `t` counts multiples of |ray.dir|.
/// Method   the ray is moved to its point nearest to the origin, from which a quadric's numbers are meant, and then to where f has its extreme along the
///          line; of the two roots, the one without cancellation comes from the formula, the other from their product; then Newton steps on f, near a tangent one with twice the digits.
/// Error    of t: <= 4 units of 2^-52 (|t| + M / |f'|), M being the sum of the magnitudes of f's terms there and f' its derivative by t. Held by
///          tests/eval/implicit_test.cpp against 113-bit arithmetic.
/// A tangent is one crossing twice. A line on which the squares vanish, as the axis of a paraboloid, has one crossing.
[[gnu::always_inline]] inline Crossings crossings_inline(const Quadric& q, const Bounds& own, const Ray& ray, Wanted wanted) {
    Crossings out;
    const LineInterval inside = inside_bounds(ray, own);   // a cylinder is endless: accelerators ask it on lines that pass it by, too
    if (inside.empty() || (wanted != Wanted::all && (inside.exit < ray.tmin || inside.entry > ray.tmax))) return out;
    const Approach nearest = approach_inline(Vec3(0), ray);
    const double speed = std::sqrt(dot(ray.dir, ray.dir));
    if (!is_finite(ray) || !std::isfinite(nearest.shift) || !(speed > 0)) return out;
    const QuadricLine line{q, nearest.nearest, ray.dir / speed};
    double roots[2];
    const int count = line.rough_crossings(roots, out.begins_inside);
    if (count == 0) return out;
    const RoughCrossings rough(ray, std::abs(nearest.shift) + max_abs(nearest.nearest) / speed);
    const auto t_at = [&](double s) { return nearest.shift + (nearest.rest + s / speed); };
    const bool together = count == 2 && !rough.surely_before(t_at(roots[0]), t_at(roots[1]));
    if (together) {
        for (double& s : roots) s = line.polished(s);
        if (roots[1] < roots[0]) std::swap(roots[0], roots[1]);
    }
    double before = -kInf;
    for (int i = 0; i < count; ++i) {
        double t = t_at(roots[i]);
        if (together || !rough.surely_outside(t)) t = near_tangent(q, ray, together ? t : t_at(line.polished(roots[i])));
        before = std::max(before, t);
        add_crossing(ray, std::clamp(before, inside.entry, inside.exit), out);
        if (wanted != Wanted::all && out.count > 0 && out.at[size_t(out.count - 1)].t >= ray.tmin) break;
    }
    return out;
}

#ifdef __x86_64__
[[gnu::target("fma"), gnu::flatten]] Crossings crossings_with_fma(const Quadric& q, const Bounds& own, const Ray& ray, Wanted wanted) { return crossings_inline(q, own, ray, wanted); }
#endif

Crossings quadric_wanted(const ShapeGeometry& geometry, const Bounds& own, const Ray& ray, Wanted wanted) {
    const Quadric& q = std::get<Quadric>(geometry);
#ifdef __x86_64__
    if (kHasFma) return crossings_with_fma(q, own, ray, wanted);
#endif
    return crossings_inline(q, own, ray, wanted);
}

Crossings quadric_crossings(const ShapeGeometry& geometry, const Ray& ray) { return quadric_wanted(geometry, bounds(geometry), whole_line(ray), Wanted::all); }

ErrorBound quadric_error(const ShapeGeometry& geometry, const Ray& ray, double t, uint32_t) {
    const Vec3 p = ray.at(t);
    return implicit_bound(evaluate(std::get<Quadric>(geometry), p), kRoundings, p, at_rounding(ray, t));
}

SurfacePoint quadric_surface(const ShapeGeometry& geometry, const Vec3& point, uint32_t) {
    return flat_mapped(normalized(value_and_gradient(std::get<Quadric>(geometry), point).gradient), point);
}

bool quadric_inside(const ShapeGeometry& geometry, const Vec3& point) { return value_and_gradient(std::get<Quadric>(geometry), point).value <= 0; }

Bounds quadric_narrow(const ShapeGeometry& geometry, bool outside, const Bounds& box) { return narrowed(std::get<Quadric>(geometry), outside, box); }

}  // namespace

const ShapeOps kQuadricOps = {"quadric", "where a polynomial of order 2 is negative", kind_of<Quadric>(), quadric_bounds, quadric_crossings, quadric_error, quadric_surface, quadric_inside, always_solid, quadric_narrow, false, nullptr, quadric_wanted};

}  // namespace alidade
