// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/shapes.h"

#include <fmt/format.h>

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

}  // namespace

BuiltShape build_quadric(Build&, Cursor& at) {
    Quadric q;
    q.squares = at.vector("the squares of a quadric"), q.products = at.vector("the products of a quadric"), q.linear = at.vector("the linear terms of a quadric");
    q.constant = at.number("the constant of a quadric");
    return {q, {}};
}

BuiltShape build_cubic(Build& build, Cursor& at) { return polynomial(build, at, 3); }
BuiltShape build_quartic(Build& build, Cursor& at) { return polynomial(build, at, 4); }

BuiltShape build_poly(Build& build, Cursor& at) {
    const Place place = at.place();
    const double order = at.number("the order of a polynomial");
    if (!(order >= 2 && order < Polynomial::kMostOrder + 1)) build.p.fail(place, fmt::format("the order of a polynomial is 2 to {}, and here it is {}", Polynomial::kMostOrder, order));
    return polynomial(build, at, int(order));
}

}  // namespace alidade::pov
