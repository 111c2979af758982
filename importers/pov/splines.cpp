// SPDX-License-Identifier: Apache-2.0
/// Splines (POV-Ray reference, 3.3.1.11).
#include "eval/functions/spline.h"
#include "importers/pov/expressions.h"
#include "importers/pov/functions.h"
#include "importers/pov/operators.h"

#include <fmt/format.h>

namespace alidade::pov {

namespace {

using Components = SplineCurve::Components;
using Type = SplineCurve::Type;

std::optional<Type> type_of(const Token& token) {
    if (token.is_word("linear_spline"_w)) return Type::linear;
    if (token.is_word("quadratic_spline"_w)) return Type::quadratic;
    if (token.is_word("cubic_spline"_w)) return Type::cubic;
    if (token.is_word("natural_spline"_w)) return Type::natural;
    return std::nullopt;
}

}  // namespace

Value parse_spline(Parser& p, Place at) {
    const Nested nested(p, at);
    Ref<Spline> spline(new Spline);
    spline->curve.terms = 2;                                                   // a float is two
    p.expect('{', "behind spline");
    if (const Token token = p.peek(); token.kind == TokenKind::name) {
        const Value base = parse_expression(p);
        if (base.kind != Kind::spline && !base.numeric()) p.fail(token.place(), fmt::format("a spline is expected, not {}", kind_name(base)));
        if (base.kind == Kind::spline) spline->curve = base.as<Spline>().curve;
        else p.fail(token.place(), "a type of spline or a number is expected first");
    }
    if (const std::optional<Type> type = type_of(p.peek())) spline->curve.type = *type, p.next();
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
        spline->curve.terms = std::max(spline->curve.terms, value.terms);
        const auto place = std::lower_bound(spline->curve.knots.begin(), spline->curve.knots.end(), t, [](const auto& knot, double x) { return knot.first < x; });
        const size_t given = std::max<size_t>(value.terms, 2);
        const Components all = promoted(value, uint8_t(given));
        std::copy_n(all.begin(), given, last.begin());                          // the others stay those of the entry before, a float is two (probed)
        const std::pair<double, Components> knot{t, last};
        if (place != spline->curve.knots.end() && place->first == t) *place = knot;
        else spline->curve.knots.insert(place, knot);
    }
    if (spline->curve.knots.empty()) p.fail(at, "the spline has no points");
    return Value::of(Kind::spline, spline);
}

Value call_spline(Parser& p, const Spline& spline, Place) {
    const Ref<Spline> hold(const_cast<Spline*>(&spline));
    p.expect('(', "behind the name of a spline");
    const double t = parse_float(p);
    SplineCurve asked = spline.curve;
    if (p.accept(',')) {
        const Token token = p.next();
        const std::optional<Type> type = type_of(token);
        if (!type) p.fail(token.place(), fmt::format("a type of spline is expected, not {}", p.describe(token)));
        asked.type = *type;
    }
    p.expect(')', "behind the argument of a spline");
    Value value = Value::vector(spline.curve.terms, SplineEvaluator(std::move(asked)).value(t));
    std::fill(value.c.begin() + value.terms, value.c.end(), 0.0);
    return value;
}

}  // namespace alidade::pov
