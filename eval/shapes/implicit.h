// SPDX-License-Identifier: Apache-2.0
/// What surfaces f(p) = 0 of polynomials have in common.
#pragma once

#include "eval/shapes/rows.h"

namespace alidade {

/// A polynomial at a point: its value, its gradient, and the sum of the magnitudes of its terms, which roundings are relative to.
struct ImplicitValue {
    double value = 0;
    Vec3 gradient{0};
    double magnitude = 0;
};

inline std::pair<double, double> along(const ImplicitValue& f, const Vec3& u) { return {f.value, dot(f.gradient, u)}; }

/// A bound on the distance of `p`, computed with `at_rounding`, from the surface: |f| and its rounding (`roundings` of them in a row) over the gradient, with
/// half as much again for the surface's bend. Where the gradient vanishes (the tip of a cone) f grows by a higher power of the distance: the third at most.
ErrorBound implicit_bound(const ImplicitValue& f, int roundings, const Vec3& p, double at_rounding);

/// The distance of a crossing along the line p + s u, |u| = 1: Newton steps on f itself, at the point, as long as they lead nearer. What made `s` were
/// coefficients that had been rounded for all of the line. `f(point)` is its value and its derivative along `u`.
template <class F>
double polished(const F& f, const Vec3& p, const Vec3& u, double s) {
    auto [here, slope] = f(p + s * u);
    for (int i = 0; i < 3; ++i) {
        const double next = s - here / slope;
        if (!std::isfinite(next)) return s;
        const auto [there, slope_there] = f(p + next * u);
        if (!(std::abs(there) < std::abs(here))) return s;
        s = next, here = there, slope = slope_there;
    }
    return s;
}

/// Adds the crossing at `t`, if there is a point.
inline void add_crossing(const Ray& ray, double t, Crossings& out) {
    if (std::isfinite(t) && is_finite(ray.at(t))) out.add(t, 0);
}

/// Normal and texture coordinates of a surface that POV-Ray maps by x and y. A surface along z has no such tangents: any others stand for them.
SurfacePoint flat_mapped(const Vec3& normal, const Vec3& point);

}  // namespace alidade
