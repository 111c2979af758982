// SPDX-License-Identifier: Apache-2.0
/// Splines (POV-Ray reference, 3.3.1.11). Which tangents and boundaries they take was found by probing.
#include "importers/pov/expressions.h"
#include "importers/pov/functions.h"
#include "importers/pov/operators.h"

#include <fmt/format.h>

namespace alidade::pov {

namespace {

using Components = std::array<double, 5>;

std::optional<Spline::Type> type_of(const Token& token) {
    if (token.is_word("linear_spline"_w)) return Spline::Type::linear;
    if (token.is_word("quadratic_spline"_w)) return Spline::Type::quadratic;
    if (token.is_word("cubic_spline"_w)) return Spline::Type::cubic;
    if (token.is_word("natural_spline"_w)) return Spline::Type::natural;
    return std::nullopt;
}

Components combined(double a, const Components& p, double b, const Components& q) {
    Components out{};
    for (int i = 0; i < 5; ++i) out[i] = a * p[i] + b * q[i];
    return out;
}

Components slope(const Spline& s, size_t i, size_t j) {
    const double dt = s.knots[j].first - s.knots[i].first;
    return combined(1 / dt, s.knots[j].second, -1 / dt, s.knots[i].second);
}

Components linear(const Spline& s, size_t i, double t) {
    const double a = (t - s.knots[i].first) / (s.knots[i + 1].first - s.knots[i].first);
    return combined(1 - a, s.knots[i].second, a, s.knots[i + 1].second);
}

/// The parabola through the knots i-1, i, i+1 (Newton's form); the first segment takes the first three.
Components quadratic(const Spline& s, size_t i, double t) {
    if (s.knots.size() < 3) return linear(s, i, t);
    const size_t a = i > 0 ? i - 1 : 0, b = a + 1, c = a + 2;
    const Components first = slope(s, a, b), next = slope(s, b, c);
    const double span = s.knots[c].first - s.knots[a].first;
    const Components second = combined(1 / span, next, -1 / span, first);
    const double u = t - s.knots[a].first, w = t - s.knots[b].first;
    return combined(1, combined(1, s.knots[a].second, u, first), u * w, second);
}

/// Cubic Hermite segment i with tangents that are the mean of the slopes on both sides; there is none in the first and the last segment.
Components cubic(const Spline& s, size_t i, double t) {
    const double h = s.knots[i + 1].first - s.knots[i].first, a = (t - s.knots[i].first) / h;
    const Components here = slope(s, i, i + 1);
    const Components left = combined(0.5, slope(s, i - 1, i), 0.5, here), right = combined(0.5, here, 0.5, slope(s, i + 1, i + 2));
    const Components ends = combined((1 + 2 * a) * (1 - a) * (1 - a), s.knots[i].second, a * a * (3 - 2 * a), s.knots[i + 1].second);
    return combined(1, ends, 1, combined(h * a * (1 - a) * (1 - a), left, -h * a * a * (1 - a), right));
}

/// Second derivatives at the knots of the cubic spline that is straight at both ends, by elimination in the tridiagonal system.
std::vector<Components> natural_curvatures(const Spline& s) {
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

Components natural(const Spline& s, size_t i, double t) {
    const std::vector<Components> m = natural_curvatures(s);
    const double h = s.knots[i + 1].first - s.knots[i].first, b = (t - s.knots[i].first) / h, a = 1 - b;
    const Components bend = combined((a * a * a - a) * h * h / 6, m[i], (b * b * b - b) * h * h / 6, m[i + 1]);
    return combined(1, linear(s, i, t), 1, bend);
}

}  // namespace

std::array<double, 5> spline_value(const Spline& s, double t) {
    if (s.type == Spline::Type::cubic && s.knots.size() == 2) return combined(0.5, s.knots[0].second, 0.5, s.knots[1].second);   // wherever it is asked (probed)
    const size_t n = s.knots.size(), margin = s.type == Spline::Type::cubic ? 1 : 0;
    if (n == 1 || n < 2 * margin + 2 || !(t > s.knots[margin].first)) return s.knots[std::min(margin, n - 1)].second;
    if (t >= s.knots[n - 1 - margin].first) return s.knots[n - 1 - margin].second;
    const auto behind = std::upper_bound(s.knots.begin(), s.knots.end(), t, [](double x, const auto& knot) { return x < knot.first; });
    const size_t i = size_t(behind - s.knots.begin()) - 1;
    switch (s.type) {
        case Spline::Type::linear: return linear(s, i, t);
        case Spline::Type::quadratic: return quadratic(s, i, t);
        case Spline::Type::cubic: return cubic(s, i, t);
        case Spline::Type::natural: return natural(s, i, t);
    }
    return {};
}

Value parse_spline(Parser& p, Place at) {
    const Nested nested(p, at);
    Ref<Spline> spline(new Spline);
    p.expect('{', "behind spline");
    if (const Token token = p.peek(); token.kind == TokenKind::name) {
        const Value base = parse_expression(p);
        if (base.kind != Kind::spline && !base.numeric()) p.fail(token.place(), fmt::format("a spline is expected, not {}", kind_name(base)));
        if (base.kind == Kind::spline) *spline = base.as<Spline>();
        else p.fail(token.place(), "a type of spline or a number is expected first");
    }
    if (const std::optional<Spline::Type> type = type_of(p.peek())) spline->type = *type, p.next();
    p.accept(',');
    Components last{};
    while (!p.accept('}')) {
        p.check_items(at);
        const double t = parse_float(p);
        p.accept(',');
        const Place here = p.peek().place();
        const Value value = parse_expression(p);
        if (!value.numeric()) p.fail(here, fmt::format("a vector is expected, not {}", kind_name(value)));
        p.accept(',');
        spline->terms = std::max(spline->terms, std::max<uint8_t>(value.terms, 2));
        const auto place = std::lower_bound(spline->knots.begin(), spline->knots.end(), t, [](const auto& knot, double x) { return knot.first < x; });
        const size_t given = std::max<size_t>(value.terms, 2);
        const Components all = promoted(value, uint8_t(given));
        std::copy_n(all.begin(), given, last.begin());                          // the others stay those of the entry before, a float is two (probed)
        const std::pair<double, Components> knot{t, last};
        if (place != spline->knots.end() && place->first == t) *place = knot;
        else spline->knots.insert(place, knot);
    }
    if (spline->knots.empty()) p.fail(at, "the spline has no points");
    return Value::of(Kind::spline, spline);
}

Value call_spline(Parser& p, const Spline& spline, Place) {
    const Ref<Spline> hold(const_cast<Spline*>(&spline));
    p.expect('(', "behind the name of a spline");
    const double t = parse_float(p);
    Spline other;
    const Spline* asked = &spline;
    if (p.accept(',')) {
        const Token token = p.next();
        const std::optional<Spline::Type> type = type_of(token);
        if (!type) p.fail(token.place(), fmt::format("a type of spline is expected, not {}", p.describe(token)));
        other = spline, other.type = *type, asked = &other;
    }
    p.expect(')', "behind the argument of a spline");
    Value value = Value::vector(std::max<uint8_t>(spline.terms, 2), spline_value(*asked, t));
    std::fill(value.c.begin() + value.terms, value.c.end(), 0.0);
    return value;
}

}  // namespace alidade::pov
