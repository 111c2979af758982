// SPDX-License-Identifier: Apache-2.0
/// Mandelbrot and Julia sets, and the two magnet fractals.
/// Source   POV-Ray 3.7 user documentation, 3.4.7.1.11 "Fractal Pattern"; the magnets' formulas from Peitgen and Richter, "The Beauty of Fractals" (1986); limits by experiment
#include "eval/patterns/registry.h"

#include <complex>

namespace alidade::pattern {

namespace {

using Complex = std::complex<double>;

/// Written out: std::complex's product looks for infinities first.
Complex times(const Complex& a, const Complex& b) { return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()}; }
Complex divided(const Complex& a, const Complex& b) {
    const Complex n = times(a, std::conj(b));
    const double d = std::norm(b);
    return {n.real() / d, n.imag() / d};
}

Complex power(const Complex& z, int n) {
    Complex result = z;
    for (int i = 1; i < n; ++i) result = times(result, z);
    return result;
}

/// The last point of an orbit, what was its nearest to 0, and the step in which it left, or -1.
struct Orbit {
    Complex last;
    double least;
    double left = -1;
};

/// `from_start`: the start counts as one of the points.
template <class Step, class Left> Orbit follow(Complex z, double iterations, bool from_start, const Step& step, const Left& left) {
    Orbit orbit{z, from_start || iterations < 1 ? std::norm(z) : kInf};
    for (double k = 0; k < iterations; ++k) {
        z = step(z);
        const double square = std::norm(z);
        orbit.least = std::min(orbit.least, square);
        if (left(z, square)) {
            orbit.left = k;
            break;
        }
    }
    orbit.last = z;
    return orbit;
}

int whole(double v, int low, int high) { return int(std::clamp(v, double(low), double(high))); }

/// How an orbit is coloured. `in[first]` and the three after it: exterior, its factor, interior, its factor.
double coloured(const Orbit& orbit, double iterations, const PatternInput& in, size_t first) {
    const bool outside = orbit.left >= 0;
    const double a = orbit.last.real(), b = orbit.last.imag(), factor = in[outside ? first + 1 : first + 3];
    switch (whole(in[outside ? first : first + 2], 0, 8)) {
        case 1: return outside ? orbit.left / iterations : std::sqrt(orbit.least) * factor;
        case 2: return a * factor;
        case 3: return b * factor;
        case 4: return a * a * factor;
        case 5: return b * b * factor;
        case 6: return outside ? std::abs(orbit.last) * factor : a * a + b * b * factor;   // inside, POV-Ray scales one square alone
        case 7: return outside ? std::fmod(orbit.left, factor) / factor : 0;
        case 8: return outside ? std::fmod(orbit.left, factor + 1) / factor : 0;
        default: return factor;
    }
}

double polynomial_set(const Complex& start, const Complex& c, double iterations, const PatternInput& in, size_t first) {
    const int exponent = whole(in[first], 2, 33);   // POV-Ray's own limits
    const Orbit orbit = follow(start, iterations, true, [&](const Complex& z) { return power(z, exponent) + c; }, [](const Complex&, double square) { return square > 4; });
    return coloured(orbit, iterations, in, first + 1);
}

double magnet(const Complex& start, bool from_start, const Complex& c, double iterations, const PatternInput& in, size_t first) {
    const Complex c1 = c - 1.0, c2 = c - 2.0, c12 = times(c1, c2);
    const bool second = in[0] == 2;
    const auto step = [&](const Complex& z) {
        const Complex square = times(z, z);
        const Complex q = second ? divided(times(square, z) + 3.0 * times(c1, z) + c12, 3.0 * square + 3.0 * times(c2, z) + c12 + 1.0) : divided(square + c1, 2.0 * z + c2);
        return times(q, q);
    };
    // An orbit ends far away, or at the fixed point 1.
    const Orbit orbit = follow(start, iterations, from_start, step, [](const Complex& z, double square) { return square > 10000 || std::norm(z - 1.0) < 1e-4; });
    return coloured(orbit, iterations, in, first);
}

}  // namespace

double mandel(const Vec3& p, const PatternInput& in) { return polynomial_set({p.x, p.y}, {p.x, p.y}, in[0], in, 1); }
double julia(const Vec3& p, const PatternInput& in) { return polynomial_set({p.x, p.y}, {in[0], in[1]}, in[2], in, 3); }
double magnet_mandel(const Vec3& p, const PatternInput& in) { return magnet({0, 0}, false, {p.x, p.y}, in[1], in, 2); }
double magnet_julia(const Vec3& p, const PatternInput& in) { return magnet({p.x, p.y}, true, {in[1], in[2]}, in[3], in, 4); }

}  // namespace alidade::pattern
