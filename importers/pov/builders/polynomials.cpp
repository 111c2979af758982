// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/shapes.h"

#include <fmt/format.h>
#include <optional>

namespace alidade::pov {

namespace {

/// `<...>` with as many coefficients as a polynomial of this order has.
BuiltShape polynomial(Build& build, Cursor& at, int order) {
    const Place place = at.place();
    const size_t terms = Polynomial::terms(order);
    if (at.done() || at.peek().kind != Item::Kind::numbers) build.p.fail(place, fmt::format("the {} coefficients of a polynomial are expected", terms));
    Polynomial f;
    f.order = order, f.coefficients = at.next().as<NumberList>().numbers;
    if (f.coefficients.size() != terms) build.p.fail(place, fmt::format("a polynomial of order {} has {} coefficients, and here are {}", order, terms, f.coefficients.size()));
    return {std::move(f), {}};
}

int take_order(Build& build, Cursor& at) {
    const Place place = at.place();
    const double order = at.number("the order of a polynomial");
    if (!(order >= 2 && order < Polynomial::kMostOrder + 1)) build.p.fail(place, fmt::format("the order of a polynomial is 2 to {}, and here it is {}", Polynomial::kMostOrder, order));
    return int(order);
}

/// Where the coefficient of x^a y^b z^c stands; fractions of powers are cut.
std::optional<size_t> index_of(int order, double a, double b, double c) {
    if (!(a > -1 && b > -1 && c > -1 && a + b + c < order + 3)) return std::nullopt;
    const int x = int(a), y = int(b), z = int(c);
    if (x + y + z > order) return std::nullopt;
    // Before those of x^a stand as many as a polynomial of the next lower order than what is left has; among them likewise in y and z.
    const int left = order - x, rest = left - y;
    const size_t before_x = left > 0 ? Polynomial::terms(left - 1) : 0, before_y = size_t(rest) * size_t(rest + 1) / 2;
    return before_x + before_y + size_t(rest - z);
}

}  // namespace

BuiltShape build_quadric(Build&, Cursor& at) {
    Quadric q;
    q.squares = at.vector("the squares of a quadric"), q.products = at.vector("the products of a quadric"), q.linear = at.vector("the linear terms of a quadric");
    q.constant = at.number("the constant of a quadric");
    return {q, {}};
}

BuiltShape build_cubic(Build& build, Cursor& at) { return polynomial(build, at, 3); }
BuiltShape build_quartic(Build& build, Cursor& at) { return polynomial(build, at, 4); }

BuiltShape build_poly(Build& build, Cursor& at) { return polynomial(build, at, take_order(build, at)); }

BuiltShape build_polynomial(Build& build, Cursor& at) {
    Polynomial f;
    f.order = take_order(build, at);
    f.coefficients.assign(Polynomial::terms(f.order), 0);
    while (!at.done() && at.peek().kind == Item::Kind::numbers) {
        const Place place = at.place();
        const std::vector<double>& term = at.next().as<NumberList>().numbers;
        const auto index = term.size() == 4 ? index_of(f.order, term[0], term[1], term[2]) : std::nullopt;
        if (!index) build.p.fail(place, fmt::format("xyz(x, y, z) of a polynomial of order {} has powers from 0 that add up to {} at most", f.order, f.order));
        f.coefficients[*index] = term[3];
    }
    return {std::move(f), {}};
}

}  // namespace alidade::pov
