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

/// A bound on the distance of `p`, computed with `at_rounding`, from the surface: |f| and its rounding (`roundings` of them in a row) over the gradient, with
/// half as much again for the surface's bend. Where the gradient vanishes (the tip of a cone) f grows by a higher power of the distance: the third at most.
ErrorBound implicit_bound(const ImplicitValue& f, int roundings, const Vec3& p, double at_rounding);

/// Normal and texture coordinates of a surface that POV-Ray maps by x and y. A surface along z has no such tangents: any others stand for them.
SurfacePoint flat_mapped(const Vec3& normal, const Vec3& point);

}  // namespace alidade
