// SPDX-License-Identifier: Apache-2.0
#include "eval/quadric_reach.h"

#include <algorithm>
#include <optional>

namespace alidade {

namespace {

constexpr double kZero = 1e-10;

/// The least of a x^2 + g x over a range.
double least(double a, double g, double low, double high) {
    if (a == 0 && g == 0) return 0;
    const auto at = [&](double x) { return std::isfinite(x) ? (a * x + g) * x : a != 0 ? a * kInf : g * x; };
    if (a > 0) return at(std::clamp(-g / (2 * a), low, high));
    return std::min(at(low), at(high));
}

/// Where a x^2 + g x <= c allows x to be.
void shorten(double a, double g, double c, double& low, double& high) {
    if (!std::isfinite(c) || a < 0 || (a == 0 && g == 0)) return;
    if (a == 0) {
        if (g > 0) high = std::min(high, c / g);
        else low = std::max(low, c / g);
        return;
    }
    const double square = g * g + 4 * a * c;
    if (!(square >= 0)) return;
    low = std::max(low, (-g - std::sqrt(square)) / (2 * a));
    high = std::min(high, (-g + std::sqrt(square)) / (2 * a));
}

/// Has it no products, and at most one zero among the squares?
bool is_round(const Quadric& q) {
    return !has_products(q) && int(q.squares.x == 0) + int(q.squares.y == 0) + int(q.squares.z == 0) < 2;
}

/// Transformations leave something of what was 0.
Quadric without_roundings(Quadric q) {
    const double least = kZero * max_abs(q.squares), least_linear = kZero * max_abs(q.linear);
    for (int i = 0; i < 3; ++i) {
        if (std::abs(q.squares[i]) < least) q.squares[i] = 0;
        if (std::abs(q.linear[i]) < least_linear) q.linear[i] = 0;
    }
    return q;
}

/// The same surface with as many positive squares as negative ones at least.
Quadric turned_out(const Quadric& q) {
    int signs = 0;
    for (int i = 0; i < 3; ++i) signs += (q.squares[i] > 0) - (q.squares[i] < 0);
    return signs >= 0 ? q : Quadric{-q.squares, -q.products, -q.linear, -q.constant};
}

/// What POV-Ray takes for a hyperboloid of one sheet: its waist has the square 1.
std::optional<Quadric> boxed_hyperboloid(Quadric q) {
    const double waist = dot(q.linear, q.linear / (4.0 * q.squares)) - q.constant;
    if (waist < -kZero) return std::nullopt;
    if (waist > kZero) q.constant += waist - 1;
    return q;
}

/// What POV-Ray takes for a paraboloid along `axis`: one with the other constant; where it is shifted across its axis, a cylinder.
Quadric boxed_paraboloid(Quadric q, int axis) {
    Vec3 across = q.linear;
    across[axis] = 0;
    if (q.linear[axis] == 0) return q;
    if (across == Vec3(0)) q.constant = -q.constant;
    else q.linear[axis] = q.constant = 0;
    return q;
}

/// The quadric that POV-Ray makes boxes of, or nothing where it makes none.
std::optional<Quadric> boxed(const Quadric& of) {
    const Quadric q = turned_out(without_roundings(of));
    if (!is_round(q)) return std::nullopt;
    const double least = std::min({q.squares.x, q.squares.y, q.squares.z});
    if (least > 0) return q;
    for (int i = 0; i < 3; ++i)
        if (q.squares[i] == 0) return least < 0 ? std::nullopt : std::optional(boxed_paraboloid(q, i));
    return boxed_hyperboloid(q);
}

/// A paraboloid that ends before `box` begins has a width all the same.
void fill_width(const Quadric& q, int axis, Bounds& box) {
    const double length = std::abs(box.max[axis] - box.min[axis]);
    for (int i = 0; i < 3; ++i) {
        if (i == axis || (std::isfinite(box.min[i]) && std::isfinite(box.max[i]))) continue;
        const double half = std::sqrt(std::abs(q.linear[axis]) * length / q.squares[i]);
        box.min[i] = -half, box.max[i] = half;
    }
}

}  // namespace

bool has_products(const Quadric& q) { return max_abs(q.products) > 1e-10 * std::max(max_abs(q.squares), max_abs(q.products)); }

Bounds box_of_ellipsoid(Quadric q) {
    Bounds out{Vec3(-kInf), Vec3(kInf)};
    if (has_products(q)) return out;
    if (q.squares.x < 0) q.squares = -q.squares, q.linear = -q.linear, q.constant = -q.constant;
    if (!(q.squares.x > 0 && q.squares.y > 0 && q.squares.z > 0)) return out;
    const Vec3 center = q.linear / (-2.0 * q.squares);
    const double square = dot(q.squares, center * center) - q.constant;
    if (!(square > 0)) return out;
    const Vec3 half = glm::sqrt(Vec3(square) / q.squares);
    return {center - half, center + half};
}

Bounds reach(const Quadric& of, const Bounds& box) {
    const auto made = boxed(of);
    if (!made) return box;
    const Quadric& q = *made;
    Bounds out = box;
    for (int pass = 0; pass < 2 && !out.empty(); ++pass)
        for (int i = 0; i < 3 && !out.empty(); ++i) {
            double rest = q.constant;
            for (int j = 0; j < 3; ++j)
                if (j != i) rest += least(q.squares[j], q.linear[j], out.min[j], out.max[j]);
            shorten(q.squares[i], q.linear[i], -rest, out.min[i], out.max[i]);
        }
    for (int i = 0; i < 3; ++i)
        if (out.empty() && q.squares[i] == 0 && q.linear[i] != 0) fill_width(q, i, out);
    return out;
}

bool may_outgrow_reach(const Quadric& of) {
    const auto made = boxed(of);
    if (!made) return false;
    for (int i = 0; i < 3; ++i)
        if (of.squares[i] == 0 && of.linear[i] != 0) return true;
    return made->constant > turned_out(of).constant + kZero;
}

/// With x = M y + m in x.A x + g.x + c.
Quadric moved(const Quadric& q, const Transform& t) {
    const auto back = inverse(t);
    if (!back) return q;
    const Vec3& p = q.products;
    const Mat3 a(q.squares.x, p.x / 2, p.y / 2, p.x / 2, q.squares.y, p.z / 2, p.y / 2, p.z / 2, q.squares.z);
    const Mat3& m = back->linear;
    const Vec3& o = back->translation;
    const Mat3 b = glm::transpose(m) * a * m;
    Quadric out;
    out.squares = Vec3(b[0].x, b[1].y, b[2].z);
    out.products = 2.0 * Vec3(b[0].y, b[0].z, b[1].z);
    out.linear = glm::transpose(m) * (2.0 * (a * o) + q.linear);
    out.constant = dot(o, a * o) + dot(q.linear, o) + q.constant;
    return out;
}

}  // namespace alidade
