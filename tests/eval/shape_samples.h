// SPDX-License-Identifier: Apache-2.0
/// What the tests over the table of shapes need of each kind: random ones, moved ones, and the exact distance of a point from the surface.
#pragma once

#include "eval/shapes/shape_ops.h"
#include "tests/core/draw.h"
#include "tests/core/quad.h"

namespace alidade::test {

inline void randomize(Sphere& s, Draw& draw) { s = {draw.vector(), draw.sign() * draw(0.2, 2)}; }
inline void randomize(Plane& p, Draw& draw) { p = {draw.direction() * draw(0.1, 10), draw(-2, 2)}; }
inline void randomize(Box& b, Draw& draw) {
    b = {draw.vector() - 1.1, draw.vector() + 1.1};
    for (int axis = 0; axis < 3; ++axis)
        if (draw.sign() < 0) std::swap(b.a[axis], b.b[axis]);
}
inline void randomize(Disc& d, Draw& draw) { d = {draw.vector(0.5), draw.direction() * draw(0.1, 10), draw.sign() * draw(2, 4), draw.sign() * draw(0, 1)}; }
inline void randomize(Cylinder& c, Draw& draw) { c = {draw.vector() - 1.1, draw.vector() + 1.1, draw.sign() * draw(0.5, 2), draw.below(3) == 0}; }
/// A third of them are double cones.
inline void randomize(Cone& c, Draw& draw) {
    c = {draw.vector() - 1.2, draw.vector() + 1.2, draw.sign() * draw(0.2, 2.5), 0, draw.below(3) == 0};
    c.radius_b = draw.below(4) == 0 ? 0 : draw(0.2, 2.5) * (draw.below(3) == 0 ? -1 : 1) * (c.radius_a < 0 ? -1 : 1);
}
inline void randomize(Torus& t, Draw& draw) { t = {draw.vector(0.5), draw.sign() * draw(0.8, 2), draw.sign() * draw(0.4, 1.2)}; }
/// Every second one is an ellipsoid; a third has no products, and so perhaps bounds.
inline void randomize(Quadric& q, Draw& draw) {
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
inline void randomize(Polynomial& f, Draw& draw) {
    f.order = 2 + int(draw.below(5));
    f.coefficients.resize(Polynomial::terms(f.order));
    for (double& c : f.coefficients) c = draw(-0.2, 0.2);
    f.coefficients[0] += 1, f.coefficients[power_index(f.order, 0, f.order, 0)] += 1, f.coefficients[power_index(f.order, 0, 0, f.order)] += 1;
    f.coefficients.back() = -draw(0.5, 2);
}
/// A loop around the origin, counter-clockwise: no two of its sides meet but at corners.
inline std::vector<Vec2> ring(int corners, double low, double high, Draw& draw) {
    std::vector<Vec2> out;
    const double start = draw(0, 1);
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * kPi * (i + start) / corners;
        out.push_back(draw(low, high) * Vec2(std::cos(angle), std::sin(angle)));
    }
    return out;
}
/// Every second one has a hole.
inline void randomize(Polygon& polygon, Draw& draw) {
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
inline void randomize(Extrusion& e, Draw& draw) {
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
inline void randomize(Mesh&, Draw&) {}

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

/// The share of an offset that a shape can be moved by and keep its digits: polynomials have no place of their own but in their coefficients, which grow
/// with powers of the offset.
inline double mobility(const ShapeGeometry& g) { return std::holds_alternative<Quadric>(g) || std::holds_alternative<Polynomial>(g) ? 1e-4 : 1; }
/// A polygon has no inside.
inline bool has_inside(const ShapeGeometry& g) { return !std::holds_alternative<Polygon>(g); }

#ifdef ALIDADE_HAS_QUAD
/// Of the surface that carries the part.
inline Quad distance(const Sphere& s, const QuadVec& p, uint32_t) { return fabsq(length(p - QuadVec(s.center)) - fabsq(s.radius)); }
inline Quad distance(const Plane& plane, const QuadVec& p, uint32_t) {
    const QuadVec n(plane.normal);
    return fabsq(dot(n, p) / length(n) - Quad(plane.distance));
}
inline Quad distance(const Box& b, const QuadVec& p, uint32_t part) {
    const Vec3 corner = part % 2 ? glm::max(b.a, b.b) : glm::min(b.a, b.b);
    const Quad at[] = {p.x, p.y, p.z};
    return fabsq(at[part / 2] - Quad(corner[int(part / 2)]));
}
inline Quad distance(const Disc& d, const QuadVec& p, uint32_t) {
    const QuadVec n(d.normal);
    return fabsq(dot(n, p - QuadVec(d.center)) / length(n));
}
inline Quad distance(const Cone& c, const QuadVec& p, uint32_t part) {
    const QuadVec axis = QuadVec(c.b) - QuadVec(c.a), from = p - QuadVec(part == 2 ? c.b : c.a);
    const Quad size = length(axis), along = dot(from, axis) / size;
    if (part != 0) return fabsq(along);
    const Quad across = length(cross(from, axis)) / size, slope = (Quad(c.radius_b) - Quad(c.radius_a)) / size;
    return fabsq(across - fabsq(Quad(c.radius_a) + slope * along)) / sqrtq(1 + slope * slope);
}
inline Quad distance(const Cylinder& c, const QuadVec& p, uint32_t part) { return distance(Cone{c.a, c.b, c.radius, c.radius, c.open}, p, part); }
inline Quad distance(const Torus& t, const QuadVec& at, uint32_t) {
    const QuadVec p = at - QuadVec(t.center);
    const Quad off = sqrtq(p.x * p.x + p.z * p.z) - fabsq(t.major);
    return fabsq(sqrtq(off * off + p.y * p.y) - fabsq(t.minor));
}
/// To the first order: the value over the length of the gradient.
inline Quad distance(const Quadric& q, const QuadVec& p, uint32_t) {
    const Vec3 &s = q.squares, &m = q.products, &l = q.linear;
    const QuadVec gradient(2 * Quad(s.x) * p.x + m.x * p.y + m.y * p.z + l.x, 2 * Quad(s.y) * p.y + m.x * p.x + m.z * p.z + l.y, 2 * Quad(s.z) * p.z + m.y * p.x + m.z * p.y + l.z);
    const Quad value = dot(gradient + QuadVec(l), p) / 2 + q.constant;
    return fabsq(value) / length(gradient);
}
struct QuadJet {
    Quad value = 0;
    QuadVec gradient;
};
inline QuadJet quad_value(const Polynomial& f, const QuadVec& p) {
    QuadJet sum;
    std::vector<Quad> x{1}, y{1}, z{1};
    for (int i = 0; i < f.order; ++i) x.push_back(x.back() * p.x), y.push_back(y.back() * p.y), z.push_back(z.back() * p.z);
    const double* c = f.coefficients.data();
    for (int i = f.order; i >= 0; --i)
        for (int j = f.order - i; j >= 0; --j)
            for (int k = f.order - i - j; k >= 0; --k, ++c) {
                const size_t a = size_t(i), b = size_t(j), d = size_t(k);
                sum.value += *c * x[a] * y[b] * z[d];
                if (i) sum.gradient.x += i * *c * x[a - 1] * y[b] * z[d];
                if (j) sum.gradient.y += j * *c * x[a] * y[b - 1] * z[d];
                if (k) sum.gradient.z += k * *c * x[a] * y[b] * z[d - 1];
            }
    return sum;
}
inline Quad distance(const Polynomial& f, const QuadVec& p, uint32_t) {
    const QuadJet jet = quad_value(f, p);
    return fabsq(jet.value) / length(jet.gradient);
}
inline Quad distance(const Polygon& polygon, const QuadVec& p, uint32_t) {
    const auto& loop = polygon.loops.front();
    const QuadVec first(loop[0]);
    QuadVec area;
    for (size_t i = 2; i < loop.size(); ++i) area = area + cross(QuadVec(loop[i - 1]) - first, QuadVec(loop[i]) - first);
    return fabsq(dot(area, p - first)) / length(area);
}
/// To the arc: the least of many places on it, each local minimum polished by Newton steps.
inline Quad distance_to_arc(const Vec2& a, const Vec2& control, const Vec2& b, Quad x, Quad y) {
    constexpr int kPlaces = 256;
    const Quad bx = 2 * (Quad(control.x) - a.x), by = 2 * (Quad(control.y) - a.y), cx = Quad(a.x) - 2 * Quad(control.x) + b.x, cy = Quad(a.y) - 2 * Quad(control.y) + b.y;
    const auto square = [&](Quad t) {
        const Quad px = a.x - x + t * (bx + t * cx), py = a.y - y + t * (by + t * cy);
        return px * px + py * py;
    };
    Quad least = square(1), before = square(0), here = before;
    for (int i = 0; i <= kPlaces; ++i) {
        const Quad after = i < kPlaces ? square(Quad(i + 1) / kPlaces) : here;
        if (here <= before && here <= after) {
            Quad t = Quad(i) / kPlaces;
            for (int k = 0; k < 10; ++k) {
                const Quad px = a.x - x + t * (bx + t * cx), py = a.y - y + t * (by + t * cy), dx = bx + 2 * t * cx, dy = by + 2 * t * cy;
                const Quad slope = dx * dx + dy * dy + 2 * (px * cx + py * cy);
                if (slope == 0) break;
                t -= (px * dx + py * dy) / slope;
                t = t < 0 ? 0 : t > 1 ? 1 : t;
            }
            least = std::min({least, here, square(t)});
        }
        before = here, here = after;
    }
    return sqrtq(least);
}
inline Quad distance(const Extrusion& e, const QuadVec& p, uint32_t part) {
    if (part < 2) return fabsq(p.z - Quad(part == 0 ? std::min(e.bottom, e.top) : std::max(e.bottom, e.top)));
    size_t arc = (part - 2) / 2;
    for (const Outline& outline : e.outlines) {
        const size_t arcs = outline.points.size() / 2;
        if (arc < arcs) return distance_to_arc(outline.points[2 * arc], outline.points[2 * arc + 1], outline.points[arc + 1 < arcs ? 2 * arc + 2 : 0], p.x, p.y);
        arc -= arcs;
    }
    return 1;
}
inline Quad distance(const Mesh&, const QuadVec&, uint32_t) { return 0; }
#endif

/// The shape of a row of the table, with the numbers of its default constructor.
template <size_t I = 0> ShapeGeometry default_shape(size_t kind) {
    if constexpr (I + 1 < std::variant_size_v<ShapeGeometry>)
        if (kind != I) return default_shape<I + 1>(kind);
    return std::variant_alternative_t<I, ShapeGeometry>();
}

/// A random shape of the row's kind; the first is the default one.
inline ShapeGeometry sample_shape(const ShapeOps& row, int i, Draw& draw) {
    ShapeGeometry g = default_shape(row.kind);
    if (i > 0) std::visit([&](auto& shape) { randomize(shape, draw); }, g);
    return g;
}

inline ShapeGeometry placed(ShapeGeometry g, double scale, const Vec3& offset) {
    std::visit([&](auto& shape) { place(shape, scale, offset); }, g);
    return g;
}

/// From `distance` away towards a point near the origin; |dir| is anything from 0.1 to 10.
inline Ray ray_from(double distance, Draw& draw) {
    Ray ray;
    const Vec3 target = draw.vector(2);
    ray.origin = target + distance * draw.direction();
    ray.dir = normalized(target - ray.origin) * draw(0.1, 10);
    return ray;
}

}  // namespace alidade::test
