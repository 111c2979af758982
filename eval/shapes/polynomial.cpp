// SPDX-License-Identifier: Apache-2.0
#include "eval/shapes/approach.h"
#include "eval/shapes/implicit.h"
#include "eval/shapes/polynomial_roots.h"

namespace alidade {

namespace {

static_assert(Polynomial::kMostOrder <= kMostRoots);

bool is_complete(const Polynomial& f) {
    return f.order >= 1 && f.order <= Polynomial::kMostOrder && f.coefficients.size() == Polynomial::terms(f.order);
}

/// A number, its gradient and its magnitude, under Horner's rule.
struct Jet {
    double value = 0, by_x = 0, by_y = 0, by_z = 0, magnitude = 0;
};

/// How many of the first `most` are 0: Horner's rule begins behind them. Most coefficients of most polynomials are.
int leading_zeros(const double* c, int most) {
    int count = 0;
    while (count < most && c[count] == 0) ++count;
    return count;
}

/// Horner's rule in x, of polynomials in y, of polynomials in z: the order in which the coefficients stand. At most 2 roundings a power in a row.
ImplicitValue evaluate(const Polynomial& f, const Vec3& p) {
    const Vec3 a = glm::abs(p);
    const double* c = f.coefficients.data();
    Jet in_x;
    for (int i = f.order; i >= 0; --i) {
        Jet in_y;
        for (int j = f.order - i; j >= 0; --j) {
            Jet in_z;
            const int zeros = leading_zeros(c, f.order - i - j + 1);
            c += zeros;
            for (int k = f.order - i - j - zeros; k >= 0; --k, ++c) {
                in_z.by_z = in_z.by_z * p.z + in_z.value;
                in_z.value = in_z.value * p.z + *c;
                in_z.magnitude = in_z.magnitude * a.z + std::abs(*c);
            }
            in_y.by_y = in_y.by_y * p.y + in_y.value;
            in_y.by_z = in_y.by_z * p.y + in_z.by_z;
            in_y.value = in_y.value * p.y + in_z.value;
            in_y.magnitude = in_y.magnitude * a.y + in_z.magnitude;
        }
        in_x.by_x = in_x.by_x * p.x + in_x.value;
        in_x.by_y = in_x.by_y * p.x + in_y.by_y;
        in_x.by_z = in_x.by_z * p.x + in_y.by_z;
        in_x.value = in_x.value * p.x + in_y.value;
        in_x.magnitude = in_x.magnitude * a.x + in_y.magnitude;
    }
    return {in_x.value, {in_x.by_x, in_x.by_y, in_x.by_z}, in_x.magnitude};
}

/// The value and its derivative along u, by the same rule.
std::pair<double, double> evaluate_along(const Polynomial& f, const Vec3& p, const Vec3& u) {
    struct Dual {
        double value = 0, slope = 0;
        void step(double x, double by) { slope = slope * x + value * by, value *= x; }
        void add(const Dual& d) { value += d.value, slope += d.slope; }
    };
    const double* c = f.coefficients.data();
    Dual in_x;
    for (int i = f.order; i >= 0; --i) {
        Dual in_y;
        for (int j = f.order - i; j >= 0; --j) {
            Dual in_z;
            const int zeros = leading_zeros(c, f.order - i - j + 1);
            c += zeros;
            for (int k = f.order - i - j - zeros; k >= 0; --k) in_z.step(p.z, u.z), in_z.value += *c++;
            in_y.step(p.y, u.y), in_y.add(in_z);
        }
        in_x.step(p.x, u.x), in_x.add(in_y);
    }
    return {in_x.value, in_x.slope};
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

/// f(p + s u) as a polynomial in s, by the same rule as evaluate().
template <bool kMagnitudes> Powers<kMagnitudes> on_line(const Polynomial& f, const Vec3& p, const Vec3& u) {
    const double* c = f.coefficients.data();
    Powers<kMagnitudes> in_x;
    for (int i = f.order; i >= 0; --i) {
        Powers<kMagnitudes> in_y;
        for (int j = f.order - i; j >= 0; --j) {
            Powers<kMagnitudes> in_z;
            const int zeros = leading_zeros(c, f.order - i - j + 1);
            c += zeros;
            for (int k = f.order - i - j - zeros; k >= 0; --k) in_z.times(p.z, u.z), in_z.add(*c++);
            in_y.times(p.y, u.y), in_y.add(in_z);
        }
        in_x.times(p.x, u.x), in_x.add(in_y);
    }
    return in_x;
}

/// No magnitude of a coefficient on the line is larger: the sum of those of f, with every power of s at 1.
double largest_magnitude(const Polynomial& f, const Vec3& p, const Vec3& u) {
    double sum = 0;
    for (const double c : f.coefficients) sum += std::abs(c);
    const double reach = std::max(1.0, max_abs(glm::abs(p) + glm::abs(u)));
    for (int i = 0; i < f.order; ++i) sum *= reach;
    return sum;
}

/// A line p + s u, |u| = 1, and where it crosses the surface.
struct Line {
    const Polynomial& f;
    Vec3 p, u;

    /// In order. The highest coefficients are left out where all of them is rounding: they would make crossings far away from everything.
    int crossings(double* out) const {
        const Powers<false> on = on_line<false>(f, p, u);
        int degree = on.degree;
        // Most are larger than any rounding could be.
        if (!(std::abs(on.c[degree]) > 2 * gamma_bound(roundings(f)) * largest_magnitude(f, p, u))) {
            const Powers<true> sized = on_line<true>(f, p, u);
            while (degree > 0 && std::abs(on.c[degree]) <= gamma_bound(roundings(f)) * sized.magnitude[degree]) --degree;
        }
        const int count = real_roots({on.c, size_t(degree + 1)}, out);
        for (int i = 0; i < count; ++i) out[i] = polished([&](const Vec3& x) { return evaluate_along(f, x, u); }, p, u, out[i]);
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
Crossings polynomial_crossings(const ShapeGeometry& geometry, const Ray& ray) {
    const Polynomial& f = std::get<Polynomial>(geometry);
    Crossings out;
    const Approach nearest = approach(Vec3(0), ray);
    const double speed = std::sqrt(dot(ray.dir, ray.dir));
    if (!is_complete(f) || !is_finite(ray) || !std::isfinite(nearest.shift) || !(speed > 0)) return out;
    double roots[kMostRoots];
    const int count = Line{f, nearest.nearest, ray.dir / speed}.crossings(roots);
    for (int i = 0; i < count; ++i) add_crossing(ray, nearest.shift + (nearest.rest + roots[i] / speed), out);
    return out;
}

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

}  // namespace

const ShapeOps kPolynomialOps = {"polynomial", "where a polynomial in x, y and z is negative", kind_of<Polynomial>(), polynomial_bounds, polynomial_crossings, polynomial_error, polynomial_surface, polynomial_inside, always_solid, nullptr, true};

}  // namespace alidade
