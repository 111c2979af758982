// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/function.h"

namespace alidade {

/// A spline, ready to be asked. Linear; quadratic: the parabola through three knots; natural: cubic, straight at both ends; cubic: with tangents of both sides.
/// Source   which tangents and boundaries they take was found by experiments with POV-Ray 3.7
class SplineEvaluator {
  public:
    /// `curve` has knots.
    explicit SplineEvaluator(SplineCurve curve);
    SplineCurve::Components value(double t) const;
    size_t terms() const { return curve_.terms; }

  private:
    SplineCurve curve_;
    std::vector<SplineCurve::Components> curvatures_;   ///< second derivatives at the knots of a natural one
};

}  // namespace alidade
