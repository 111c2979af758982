// SPDX-License-Identifier: Apache-2.0
/// What the tests over the table of shapes need of each kind: the exact distance of a point from the surface.
#pragma once

#include "numerics/shape_samples.h"
#include "tests/core/draw.h"
#include "tests/core/quad.h"

namespace alidade::test {

using numerics::default_shape, numerics::placed, numerics::power_index, numerics::randomize, numerics::ring, numerics::sample_shape;

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
    const Quad around = sqrtq(p.x * p.x + p.z * p.z), major = fabsq(t.major), minor = fabsq(t.minor);
    const auto from = [&](Quad off) { return fabsq(sqrtq(off * off + p.y * p.y) - minor); };
    return minor > major ? fminq(from(around - major), from(around + major)) : from(around - major);
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

/// From `distance` away towards a point near the origin; |dir| is anything from 0.1 to 10.
inline Ray ray_from(double distance, Draw& draw) {
    Ray ray;
    const Vec3 target = draw.vector(2);
    ray.origin = target + distance * draw.direction();
    ray.dir = normalized(target - ray.origin) * draw(0.1, 10);
    return ray;
}

}  // namespace alidade::test
