// SPDX-License-Identifier: Apache-2.0
#include "eval/functions/spline.h"

#include <algorithm>

namespace alidade {

namespace {

using Components = SplineCurve::Components;

Components combined(double a, const Components& p, double b, const Components& q) {
    Components out{};
    for (int i = 0; i < 5; ++i) out[i] = a * p[i] + b * q[i];
    return out;
}

Components slope(const SplineCurve& s, size_t i, size_t j) {
    const double dt = s.knots[j].first - s.knots[i].first;
    return combined(1 / dt, s.knots[j].second, -1 / dt, s.knots[i].second);
}

Components linear(const SplineCurve& s, size_t i, double t) {
    const double a = (t - s.knots[i].first) / (s.knots[i + 1].first - s.knots[i].first);
    return combined(1 - a, s.knots[i].second, a, s.knots[i + 1].second);
}

/// The parabola through the knots i-1, i, i+1 (Newton's form); the first segment takes the first three.
Components quadratic(const SplineCurve& s, size_t i, double t) {
    if (s.knots.size() < 3) return linear(s, i, t);
    const size_t a = i > 0 ? i - 1 : 0, b = a + 1, c = a + 2;
    const Components first = slope(s, a, b), next = slope(s, b, c);
    const double span = s.knots[c].first - s.knots[a].first;
    const Components second = combined(1 / span, next, -1 / span, first);
    const double u = t - s.knots[a].first, w = t - s.knots[b].first;
    return combined(1, combined(1, s.knots[a].second, u, first), u * w, second);
}

/// Cubic Hermite segment i with tangents that are the mean of the slopes on both sides; there is none in the first and the last segment.
Components cubic(const SplineCurve& s, size_t i, double t) {
    const double h = s.knots[i + 1].first - s.knots[i].first, a = (t - s.knots[i].first) / h;
    const Components here = slope(s, i, i + 1);
    const Components left = combined(0.5, slope(s, i - 1, i), 0.5, here), right = combined(0.5, here, 0.5, slope(s, i + 1, i + 2));
    const Components ends = combined((1 + 2 * a) * (1 - a) * (1 - a), s.knots[i].second, a * a * (3 - 2 * a), s.knots[i + 1].second);
    return combined(1, ends, 1, combined(h * a * (1 - a) * (1 - a), left, -h * a * a * (1 - a), right));
}

/// Second derivatives at the knots of the cubic spline that is straight at both ends, by elimination in the tridiagonal system.
std::vector<Components> natural_curvatures(const SplineCurve& s) {
    const size_t n = s.knots.size();
    std::vector<Components> m(n, Components{}), rhs(n, Components{});
    std::vector<double> upper(n, 0);
    for (size_t i = 1; i + 1 < n; ++i) {
        const double h0 = s.knots[i].first - s.knots[i - 1].first, h1 = s.knots[i + 1].first - s.knots[i].first;
        const Components jump = combined(6, slope(s, i, i + 1), -6, slope(s, i - 1, i));
        const double pivot = 2 * (h0 + h1) - h0 * upper[i - 1];
        upper[i] = h1 / pivot;
        rhs[i] = combined(1 / pivot, jump, -h0 / pivot, rhs[i - 1]);
    }
    for (size_t i = n - 1; i-- > 1;) m[i] = combined(1, rhs[i], -upper[i], m[i + 1]);
    return m;
}

Components natural(const SplineCurve& s, const std::vector<Components>& m, size_t i, double t) {
    const double h = s.knots[i + 1].first - s.knots[i].first, b = (t - s.knots[i].first) / h, a = 1 - b;
    const Components bend = combined((a * a * a - a) * h * h / 6, m[i], (b * b * b - b) * h * h / 6, m[i + 1]);
    return combined(1, linear(s, i, t), 1, bend);
}

}  // namespace

SplineEvaluator::SplineEvaluator(SplineCurve curve) : curve_(std::move(curve)) {
    if (curve_.type == SplineCurve::Type::natural) curvatures_ = natural_curvatures(curve_);
}

Components SplineEvaluator::value(double t) const {
    using Type = SplineCurve::Type;
    const auto& knots = curve_.knots;
    if (curve_.type == Type::cubic && knots.size() == 2) return combined(0.5, knots[0].second, 0.5, knots[1].second);   // wherever it is asked (probed)
    const size_t n = knots.size(), margin = curve_.type == Type::cubic ? 1 : 0;
    if (n == 1 || n < 2 * margin + 2 || !(t > knots[margin].first)) return knots[std::min(margin, n - 1)].second;
    if (t >= knots[n - 1 - margin].first) return knots[n - 1 - margin].second;
    const auto behind = std::upper_bound(knots.begin(), knots.end(), t, [](double x, const auto& knot) { return x < knot.first; });
    const size_t i = size_t(behind - knots.begin()) - 1;
    switch (curve_.type) {
        case Type::linear: return linear(curve_, i, t);
        case Type::quadratic: return quadratic(curve_, i, t);
        case Type::cubic: return cubic(curve_, i, t);
        case Type::natural: return natural(curve_, curvatures_, i, t);
    }
    return {};
}

}  // namespace alidade
