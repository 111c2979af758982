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
inline void place(Mesh&, double, const Vec3&) {}

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
