// SPDX-License-Identifier: Apache-2.0
/// Shapes of every row of the table, at random; `Draw` gives the numbers, of the rows' cases or of tests.
#pragma once

#include "core/draws.h"
#include "eval/shapes/shape_ops.h"

#include <algorithm>
#include <utility>
#include <variant>

namespace alidade::numerics {

/// The numbers of a case, in the words of what follows.
struct ShapeDraw {
    Draws& draws;
    double operator()(double low, double high) { return draws.uniform(low, high); }
    uint32_t below(uint32_t n) { return draws.below(n); }
    double sign() { return draws.sign(); }
    Vec3 vector(double size = 1) { return draws.in_box(Vec3(-size), Vec3(size)); }
    Vec3 direction() { return draws.direction(); }
};

template <class Draw> void randomize(Sphere& s, Draw& draw) { s = {draw.vector(), draw.sign() * draw(0.2, 2)}; }
template <class Draw> void randomize(Plane& p, Draw& draw) { p = {draw.direction() * draw(0.1, 10), draw(-2, 2)}; }
template <class Draw> void randomize(Box& b, Draw& draw) {
    b = {draw.vector() - 1.1, draw.vector() + 1.1};
    for (int axis = 0; axis < 3; ++axis)
        if (draw.sign() < 0) std::swap(b.a[axis], b.b[axis]);
}
template <class Draw> void randomize(Disc& d, Draw& draw) { d = {draw.vector(0.5), draw.direction() * draw(0.1, 10), draw.sign() * draw(2, 4), draw.sign() * draw(0, 1)}; }
template <class Draw> void randomize(Cylinder& c, Draw& draw) { c = {draw.vector() - 1.1, draw.vector() + 1.1, draw.sign() * draw(0.5, 2), draw.below(3) == 0}; }
/// A third of them are double cones.
template <class Draw> void randomize(Cone& c, Draw& draw) {
    c = {draw.vector() - 1.2, draw.vector() + 1.2, draw.sign() * draw(0.2, 2.5), 0, draw.below(3) == 0};
    c.radius_b = draw.below(4) == 0 ? 0 : draw(0.2, 2.5) * (draw.below(3) == 0 ? -1 : 1) * (c.radius_a < 0 ? -1 : 1);
}
template <class Draw> void randomize(Torus& t, Draw& draw) { t = {draw.vector(0.5), draw.sign() * draw(0.8, 2), draw.sign() * draw(0.4, 1.2)}; }
/// Every second one is an ellipsoid; a third has no products, and so perhaps bounds.
template <class Draw> void randomize(Quadric& q, Draw& draw) {
    const bool closed = draw.below(2) == 0;
    for (int i = 0; i < 3; ++i) q.squares[i] = draw(0.2, 1) * (closed ? 1 : draw.sign());
    q.products = draw.below(3) == 0 ? Vec3(0) : draw.vector(0.3);
    q.linear = draw.vector(0.3), q.constant = -draw(0.3, 2);
}
/// Where the coefficient of x^i y^j z^k stands.
inline size_t power_index(int order, int i, int j, int k) {
    size_t at = 0;
    for (int a = order; a >= 0; --a)
        for (int b = order - a; b >= 0; --b)
            for (int c = order - a - b; c >= 0; --c, ++at)
                if (a == i && b == j && c == k) return at;
    return at;
}
/// Orders 2 to 6.
template <class Draw> void randomize(Polynomial& f, Draw& draw) {
    f.order = 2 + int(draw.below(5));
    f.coefficients.resize(Polynomial::terms(f.order));
    for (double& c : f.coefficients) c = draw(-0.2, 0.2);
    f.coefficients[0] += 1, f.coefficients[power_index(f.order, 0, f.order, 0)] += 1, f.coefficients[power_index(f.order, 0, 0, f.order)] += 1;
    f.coefficients.back() = -draw(0.5, 2);
}
/// A loop around the origin, counter-clockwise: no two of its sides meet but at corners.
template <class Draw> std::vector<Vec2> ring(int corners, double low, double high, Draw& draw) {
    std::vector<Vec2> out;
    const double start = draw(0, 1);
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * kPi * (i + start) / corners;
        out.push_back(draw(low, high) * Vec2(std::cos(angle), std::sin(angle)));
    }
    return out;
}
/// Every second one has a hole.
template <class Draw> void randomize(Polygon& polygon, Draw& draw) {
    Vec3 s, t;
    orthonormal_basis(draw.direction(), s, t);
    const Vec3 center = draw.vector(0.5);
    polygon.loops.clear();
    for (uint32_t loop = 0; loop <= draw.below(2); ++loop) {
        polygon.loops.emplace_back();
        for (const Vec2& p : ring(4 + int(draw.below(6)), loop ? 0.3 : 2, loop ? 1 : 4, draw)) polygon.loops.back().push_back(center + p.x * s + p.y * t);
    }
}
/// Straight and bent sides; every second one has a hole, wound the other way round.
template <class Draw> void randomize(Extrusion& e, Draw& draw) {
    const Vec2 center(draw(-0.5, 0.5), draw(-0.5, 0.5));
    e.bottom = draw(-1.5, 0), e.top = draw(0.2, 1.5), e.even_odd = draw.below(2) == 0;
    if (draw.below(2) == 0) std::swap(e.bottom, e.top);
    e.outlines.clear();
    for (uint32_t loop = 0; loop <= draw.below(2); ++loop) {
        std::vector<Vec2> points = ring(2 * (3 + int(draw.below(4))), loop ? 0.3 : 1.2, loop ? 0.6 : 2.5, draw);
        for (size_t i = 0; i < points.size(); i += 2)
            if (draw.below(3) == 0) points[i + 1] = points[i];
        if (loop) std::rotate(points.begin(), points.begin() + 1, points.end()), std::reverse(points.begin(), points.end());
        if (loop)
            for (size_t i = 0; i < points.size(); i += 2)
                if (points[i + 1] == points[i + 2 < points.size() ? i + 2 : 0]) points[i + 1] = points[i];
        for (Vec2& p : points) p += center;
        e.outlines.push_back({points});
    }
}
template <class Draw> void randomize(Mesh&, Draw&) {}

/// Scaled about the origin, then moved.
inline void place(Sphere& s, double scale, const Vec3& offset) { s = {scale * s.center + offset, scale * s.radius}; }
inline void place(Plane& p, double scale, const Vec3& offset) { p.distance = scale * p.distance + dot(p.normal, offset) / length(p.normal); }
inline void place(Box& b, double scale, const Vec3& offset) { b = {scale * b.a + offset, scale * b.b + offset}; }
inline void place(Disc& d, double scale, const Vec3& offset) { d = {scale * d.center + offset, d.normal, scale * d.radius, scale * d.hole}; }
inline void place(Cylinder& c, double scale, const Vec3& offset) { c = {scale * c.a + offset, scale * c.b + offset, scale * c.radius, c.open}; }
inline void place(Cone& c, double scale, const Vec3& offset) {
    c = {scale * c.a + offset, scale * c.b + offset, scale * c.radius_a, scale * c.radius_b, c.open};
}
inline void place(Torus& t, double scale, const Vec3& offset) { t = {scale * t.center + offset, scale * t.major, scale * t.minor}; }
inline void place(Quadric& q, double scale, const Vec3& o) {
    const Vec3 &s = q.squares, &m = q.products;
    q.linear *= scale, q.constant *= scale * scale;
    const Vec3 row(2 * s.x * o.x + m.x * o.y + m.y * o.z, 2 * s.y * o.y + m.x * o.x + m.z * o.z, 2 * s.z * o.z + m.y * o.x + m.z * o.y);
    q.constant += 0.5 * dot(row, o) - dot(q.linear, o);
    q.linear -= row;
}
/// f(p / scale - offset / scale) scale^order: first the powers of the scale, then the shift, an axis after the other, by Horner's rule.
inline void place(Polynomial& f, double scale, const Vec3& offset) {
    const int n = f.order;
    std::vector<double> dense(size_t((n + 1) * (n + 1) * (n + 1)));
    const auto at = [&](int i, int j, int k) -> double& { return dense[size_t((i * (n + 1) + j) * (n + 1) + k)]; };
    size_t next = 0;
    for (int i = n; i >= 0; --i)
        for (int j = n - i; j >= 0; --j)
            for (int k = n - i - j; k >= 0; --k) at(i, j, k) = f.coefficients[next++] * std::pow(scale, n - i - j - k);
    for (int axis = 0; axis < 3; ++axis)
        for (int j = 0; j <= n; ++j)
            for (int k = 0; k <= n; ++k)
                for (int low = 0; low < n; ++low)
                    for (int i = n - 1; i >= low; --i) {
                        const auto c = [&](int power) -> double& { return axis == 0 ? at(power, j, k) : axis == 1 ? at(j, power, k) : at(j, k, power); };
                        c(i) -= offset[axis] * c(i + 1);
                    }
    next = 0;
    for (int i = n; i >= 0; --i)
        for (int j = n - i; j >= 0; --j)
            for (int k = n - i - j; k >= 0; --k) f.coefficients[next++] = at(i, j, k);
}
inline void place(Polygon& polygon, double scale, const Vec3& offset) {
    for (auto& loop : polygon.loops)
        for (Vec3& p : loop) p = scale * p + offset;
}
inline void place(Extrusion& e, double scale, const Vec3& offset) {
    for (Outline& outline : e.outlines)
        for (Vec2& p : outline.points) p = scale * p + Vec2(offset.x, offset.y);
    e.bottom = scale * e.bottom + offset.z, e.top = scale * e.top + offset.z;
}
inline void place(Mesh&, double, const Vec3&) {}

/// The shape of a row of the table, with the numbers of its default constructor.
template <size_t I = 0> ShapeGeometry default_shape(size_t kind) {
    if constexpr (I + 1 < std::variant_size_v<ShapeGeometry>)
        if (kind != I) return default_shape<I + 1>(kind);
    return std::variant_alternative_t<I, ShapeGeometry>();
}

/// A random shape of the row's kind; the first is the default one.
template <class Draw> ShapeGeometry sample_shape(const ShapeOps& row, int i, Draw& draw) {
    ShapeGeometry g = default_shape(row.kind);
    if (i > 0) std::visit([&](auto& shape) { randomize(shape, draw); }, g);
    return g;
}

inline ShapeGeometry placed(ShapeGeometry g, double scale, const Vec3& offset) {
    std::visit([&](auto& shape) { place(shape, scale, offset); }, g);
    return g;
}

}  // namespace alidade::numerics
