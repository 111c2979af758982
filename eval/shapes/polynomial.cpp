// SPDX-License-Identifier: Apache-2.0
#include "eval/shapes/approach.h"
#include "eval/shapes/implicit.h"
#include "eval/shapes/narrow.h"
#include "eval/shapes/polynomial_horner.h"
#include "eval/shapes/polynomial_roots.h"
#include "eval/shapes/wanted.h"

namespace alidade {

namespace {

static_assert(Polynomial::kMostOrder <= kMostRoots);

struct Jet : ImplicitValue {
    void times(double x, int axis) {
        gradient *= x, gradient[axis] += value;
        value *= x, magnitude *= std::abs(x);
    }
    void add(const Jet& j) { value += j.value, gradient += j.gradient, magnitude += j.magnitude; }
    void add(double c) { value += c, magnitude += std::abs(c); }
};

ImplicitValue evaluate(const Polynomial& f, const Vec3& p) {
    return horner<Jet>(f, [&](Jet& sum, int axis) { sum.times(p[axis], axis); });
}

/// A number and its derivative along a line.
struct Dual {
    double value = 0, slope = 0;
    void times(double x, double by) { slope = slope * x + value * by, value *= x; }
    void add(const Dual& d) { value += d.value, slope += d.slope; }
    void add(double c) { value += c; }
};

/// The value and its derivative along u.
std::pair<double, double> evaluate_along(const Polynomial& f, const Vec3& p, const Vec3& u) {
    const Dual at = horner<Dual>(f, [&](Dual& sum, int axis) { sum.times(p[axis], u[axis]); });
    return {at.value, at.slope};
}

int roundings(const Polynomial& f) { return 2 * f.order + 4; }

/// A polynomial in s, and `kMagnitudes`: what its coefficients would be if no term cancelled. Only the first degree + 1 are set.
template <bool kMagnitudes> struct Powers {
    double c[Polynomial::kMostOrder + 1], magnitude[kMagnitudes ? Polynomial::kMostOrder + 1 : 1];
    int degree = 0;
    bool is_zero = true;

    Powers() { set(0, 0, 0); }

    void set(int i, double value, double of) {
        c[i] = value;
        if constexpr (kMagnitudes) magnitude[i] = of;
    }
    double size(int i) const {
        if constexpr (kMagnitudes) return magnitude[i];
        return 0;
    }
    /// Becomes itself times (a + b s).
    void times(double a, double b) {
        if (is_zero) return;
        const double abs_a = std::abs(a), abs_b = std::abs(b);
        set(degree + 1, b * c[degree], abs_b * size(degree));
        for (int i = degree; i > 0; --i) set(i, a * c[i] + b * c[i - 1], abs_a * size(i) + abs_b * size(i - 1));
        set(0, a * c[0], abs_a * size(0));
        ++degree;
    }
    void add(const Powers& other) {
        if (other.is_zero) return;
        is_zero = false;
        for (; degree < other.degree; ++degree) set(degree + 1, 0, 0);
        for (int i = 0; i <= other.degree; ++i) set(i, c[i] + other.c[i], size(i) + other.size(i));
    }
    void add(double value) {
        is_zero = is_zero && value == 0;
        set(0, c[0] + value, size(0) + std::abs(value));
    }
};

/// f(p + s u) as a polynomial in s.
template <bool kMagnitudes> Powers<kMagnitudes> on_line(const Polynomial& f, const Vec3& p, const Vec3& u) {
    return horner<Powers<kMagnitudes>>(f, [&](Powers<kMagnitudes>& sum, int axis) { sum.times(p[axis], u[axis]); });
}

/// No magnitude of a coefficient on the line is larger: the sum of those of f, with every power of s at 1.
double largest_magnitude(const Polynomial& f, const Vec3& p, const Vec3& u) {
    double sums[4] = {};   // four at once
    size_t i = 0;
    for (; i + 4 <= f.coefficients.size(); i += 4)
        for (size_t k = 0; k < 4; ++k) sums[k] += std::abs(f.coefficients[i + k]);
    for (; i < f.coefficients.size(); ++i) sums[0] += std::abs(f.coefficients[i]);
    double sum = (sums[0] + sums[1]) + (sums[2] + sums[3]);
    const double reach = std::max(1.0, max_abs(glm::abs(p) + glm::abs(u)));
    for (int power = 0; power < f.order; ++power) sum *= reach;
    return sum;
}

/// A line p + s u, |u| = 1, and where it crosses the surface.
struct PolynomialLine {
    const Polynomial& f;
    Vec3 p, u;

    /// In order, those in the range exactly. The highest coefficients are left out where all of them is rounding: they would make crossings far away from everything.
    int crossings(RootRange& range, double* out) const {
        const Powers<false> on = on_line<false>(f, p, u);
        int degree = on.degree;
        // Most are larger than any rounding could be.
        if (!(std::abs(on.c[degree]) > 2 * gamma_bound(roundings(f)) * largest_magnitude(f, p, u))) {
            const Powers<true> sized = on_line<true>(f, p, u);
            while (degree > 0 && std::abs(on.c[degree]) <= gamma_bound(roundings(f)) * sized.magnitude[degree]) --degree;
        }
        const int count = real_roots_in({on.c, size_t(degree + 1)}, range, out);
        for (int i = 0; i < count; ++i)
            if (out[i] >= range.from && out[i] <= range.to) out[i] = polished([&](const Vec3& x) { return evaluate_along(f, x, u); }, p, u, out[i]);
        std::sort(out, out + count);
        return count;
    }
};

Bounds polynomial_bounds(const ShapeGeometry& geometry) { return bounds(geometry); }

/// Units    the shape's space; `t` counts multiples of |ray.dir|.
/// Method   the ray is moved to its point nearest to the origin, from which the coefficients are meant; f along it is a polynomial of one variable, whose
///          roots are isolated and found by polynomial_roots.h, and polished by Newton steps on f.
/// Error    of t: <= 4 units of 2^-52 (|t| + M / |f'|), M being the sum of the magnitudes of f's terms there and f' its derivative by t. Held by
///          tests/eval/implicit_test.cpp against 113-bit arithmetic.
/// A tangent is none or two.
Crossings polynomial_wanted(const ShapeGeometry& geometry, const Bounds&, const Ray& ray, Wanted) {
    const Polynomial& f = std::get<Polynomial>(geometry);
    Crossings out;
    const Approach nearest = approach(Vec3(0), ray);
    const double speed = std::sqrt(dot(ray.dir, ray.dir));
    if (!is_complete(f) || !is_finite(ray) || !std::isfinite(nearest.shift) || !(speed > 0)) return out;
    const RoughCrossings rough(ray, std::abs(nearest.shift) + max_abs(nearest.nearest) / speed);
    const auto s_at = [&](double t) { return ((t - nearest.shift) - nearest.rest) * speed; };
    RootRange range{s_at(ray.tmin - rough.slack(ray.tmin)), s_at(ray.tmax + rough.slack(ray.tmax))};
    double roots[kMostRoots];
    const int count = PolynomialLine{f, nearest.nearest, ray.dir / speed}.crossings(range, roots);
    if (range.sign != 0) out.begins_inside = range.sign < 0;
    for (int i = 0; i < count; ++i) add_crossing(ray, nearest.shift + (nearest.rest + roots[i] / speed), out);
    return out;
}

Crossings polynomial_crossings(const ShapeGeometry& geometry, const Ray& ray) { return polynomial_wanted(geometry, polynomial_bounds(geometry), whole_line(ray), Wanted::all); }

ErrorBound polynomial_error(const ShapeGeometry& geometry, const Ray& ray, double t, uint32_t) {
    const Polynomial& f = std::get<Polynomial>(geometry);
    const Vec3 p = ray.at(t);
    return implicit_bound(evaluate(f, p), roundings(f), p, at_rounding(ray, t));
}

SurfacePoint polynomial_surface(const ShapeGeometry& geometry, const Vec3& point, uint32_t) {
    const Polynomial& f = std::get<Polynomial>(geometry);
    return flat_mapped(is_complete(f) ? normalized(evaluate(f, point).gradient) : Vec3(0, 0, 1), point);
}

bool polynomial_inside(const ShapeGeometry& geometry, const Vec3& point) {
    const Polynomial& f = std::get<Polynomial>(geometry);
    return is_complete(f) && evaluate(f, point).value <= 0;
}

Bounds polynomial_narrow(const ShapeGeometry& geometry, bool outside, const Bounds& box) { return narrowed(std::get<Polynomial>(geometry), outside, box); }

}  // namespace

const ShapeOps kPolynomialOps = {"polynomial", "where a polynomial in x, y and z is negative", kind_of<Polynomial>(), polynomial_bounds, polynomial_crossings, polynomial_error, polynomial_surface, polynomial_inside, always_solid, polynomial_narrow, true, nullptr, polynomial_wanted};

}  // namespace alidade
