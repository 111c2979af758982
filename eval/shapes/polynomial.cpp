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

/// Horner's rule in x, of polynomials in y, of polynomials in z: the order in which the coefficients stand. At most 2 roundings a power in a row.
ImplicitValue evaluate(const Polynomial& f, const Vec3& p) {
    const Vec3 a = glm::abs(p);
    const double* c = f.coefficients.data();
    Jet in_x;
    for (int i = f.order; i >= 0; --i) {
        Jet in_y;
        for (int j = f.order - i; j >= 0; --j) {
            Jet in_z;
            for (int k = f.order - i - j; k >= 0; --k, ++c) {
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

int roundings(const Polynomial& f) { return 2 * f.order + 4; }

/// A polynomial in s, and what its coefficients would be if no term cancelled. Only the first degree + 1 are set.
struct Powers {
    double c[Polynomial::kMostOrder + 1], magnitude[Polynomial::kMostOrder + 1];
    int degree = 0;

    explicit Powers(double value) { c[0] = value, magnitude[0] = std::abs(value); }

    /// Becomes itself times (a + b s).
    void times(double a, double b) {
        const double abs_a = std::abs(a), abs_b = std::abs(b);
        c[degree + 1] = b * c[degree], magnitude[degree + 1] = abs_b * magnitude[degree];
        for (int i = degree; i > 0; --i) c[i] = a * c[i] + b * c[i - 1], magnitude[i] = abs_a * magnitude[i] + abs_b * magnitude[i - 1];
        c[0] *= a, magnitude[0] *= abs_a;
        ++degree;
    }
    /// `other` has no higher degree.
    void add(const Powers& other) {
        for (int i = 0; i <= other.degree; ++i) c[i] += other.c[i], magnitude[i] += other.magnitude[i];
    }
};

/// f(p + s u) as a polynomial in s, by the same rule as evaluate().
Powers on_line(const Polynomial& f, const Vec3& p, const Vec3& u) {
    const double* c = f.coefficients.data();
    Powers in_x(*c++);
    for (int i = f.order - 1; i >= 0; --i) {
        Powers in_y(*c++);
        for (int j = f.order - i - 1; j >= 0; --j) {
            Powers in_z(*c++);
            for (int k = f.order - i - j - 1; k >= 0; --k) in_z.times(p.z, u.z), in_z.add(Powers(*c++));
            in_y.times(p.y, u.y), in_y.add(in_z);
        }
        in_x.times(p.x, u.x), in_x.add(in_y);
    }
    return in_x;
}

/// A line p + s u, |u| = 1, and where it crosses the surface.
struct Line {
    const Polynomial& f;
    Vec3 p, u;

    /// In order. The highest coefficients are left out where all of them is rounding: they would make crossings far away from everything.
    int crossings(double* out) const {
        const Powers on = on_line(f, p, u);
        int degree = on.degree;
        while (degree > 0 && std::abs(on.c[degree]) <= gamma_bound(roundings(f)) * on.magnitude[degree]) --degree;
        const int count = real_roots({on.c, size_t(degree + 1)}, out);
        for (int i = 0; i < count; ++i) out[i] = polished([&](const Vec3& x) { return evaluate(f, x); }, p, u, out[i]);
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
    for (int i = 0; i < count; ++i) add_crossing([&](const Vec3& x) { return evaluate(f, x); }, roundings(f), ray, nearest.shift + (nearest.rest + roots[i] / speed), out);
    return out;
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

const ShapeOps kPolynomialOps = {"polynomial", "where a polynomial in x, y and z is negative", kind_of<Polynomial>(), polynomial_bounds, polynomial_crossings, polynomial_surface, polynomial_inside, always_solid};

}  // namespace alidade
