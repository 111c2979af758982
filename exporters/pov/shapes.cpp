// SPDX-License-Identifier: Apache-2.0
#include "exporters/pov/shapes.h"

#include "exporters/vertices.h"

namespace alidade::pov_export {

namespace {

/// POV-Ray takes less for nothing.
constexpr double kSmallest = 1e-10;

// One pair of functions for each kind of shape: a kind without them does not compile.

bool seen(const Sphere&) { return true; }
bool seen(const Plane& s) { return length(s.normal) > kSmallest; }
bool seen(const Box&) { return true; }
bool seen(const Disc& s) { return length(s.normal) > kSmallest; }
bool seen(const Cylinder& s) { return length(s.b - s.a) > kSmallest; }
bool seen(const Cone& s) { return length(s.b - s.a) > kSmallest; }
bool seen(const Torus&) { return true; }
bool seen(const Quadric&) { return true; }
bool seen(const Polynomial& s) { return s.coefficients.size() == Polynomial::terms(s.order); }
bool seen(const Polygon& s) { return normal_of(s) != Vec3(0); }
bool seen(const Extrusion& s) { return s.top != s.bottom && !s.outlines.empty(); }
bool seen(const Mesh& s) { return !finite_triangles(s).empty(); }

void begin(const Sphere& s, const ShapeContext& c) {
    c.sdl.begin("sphere");
    c.sdl.line(s.center, ",", std::abs(s.radius));   // the box of a negative one is empty in POV-Ray
}

void begin(const Plane& s, const ShapeContext& c) {
    c.sdl.begin("plane");
    c.sdl.line(s.normal, ",", s.distance);
}

void begin(const Box& s, const ShapeContext& c) {
    c.sdl.begin("box");
    c.sdl.line(s.a, ",", s.b);
}

void begin(const Disc& s, const ShapeContext& c) {
    c.sdl.begin("disc");
    if (s.hole == 0) c.sdl.line(s.center, ",", s.normal, ",", s.radius);
    else c.sdl.line(s.center, ",", s.normal, ",", s.radius, ",", s.hole);
}

void begin(const Cylinder& s, const ShapeContext& c) {
    c.sdl.begin("cylinder");
    c.sdl.line(s.a, ",", s.b, ",", s.radius, s.open ? "open" : "");
}

void begin(const Cone& s, const ShapeContext& c) {
    c.sdl.begin("cone");
    c.sdl.line(s.a, ",", s.radius_a, ",", s.b, ",", s.radius_b, s.open ? "open" : "");
}

void begin(const Torus& s, const ShapeContext& c) {
    c.sdl.begin("torus");
    c.sdl.line(s.major, ",", s.minor);
    if (s.center != Vec3(0)) c.sdl.line("translate", s.center);
}

void begin(const Quadric& s, const ShapeContext& c) {
    c.sdl.begin("quadric");
    c.sdl.line(s.squares, ",", s.products, ",", s.linear, ",", s.constant);
}

void begin(const Polynomial& s, const ShapeContext& c) {
    c.sdl.begin("poly");
    c.sdl.line(s.order, ", <");
    for (const double x : s.coefficients) c.sdl.item(x);
    c.sdl.end_items();
    c.sdl.line(">");
}

/// A loop ends where its first point comes again.
void begin(const Polygon& s, const ShapeContext& c) {
    size_t count = 0;
    for (const auto& loop : s.loops) count += loop.empty() ? 0 : loop.size() + 1;
    c.sdl.begin("polygon");
    c.sdl.line(count, ",");
    for (const auto& loop : s.loops) {
        for (const Vec3& p : loop) c.sdl.item(p);
        if (!loop.empty()) c.sdl.item(loop.front());
    }
    c.sdl.end_items();
}

/// A prism lies on its side: it is swept along y. Quadratic curves are cubic ones, with control points at two thirds of the way to theirs.
void begin(const Extrusion& s, const ShapeContext& c) {
    size_t count = 0;
    for (const Outline& outline : s.outlines) count += outline.points.size() / 2 * 4;
    c.sdl.begin("prism");
    c.sdl.line("bezier_spline linear_sweep", std::min(s.bottom, s.top), ",", std::max(s.bottom, s.top), ",", count, ",");
    for (const Outline& outline : s.outlines)
        for (size_t i = 0; i + 1 < outline.points.size(); i += 2) {
            const Vec2 a = outline.points[i], control = outline.points[i + 1], b = outline.points[(i + 2) % outline.points.size()];
            c.sdl.item(a), c.sdl.item(a + (control - a) * (2.0 / 3)), c.sdl.item(b + (control - b) * (2.0 / 3)), c.sdl.item(b);
        }
    c.sdl.end_items();
    c.sdl.line(Transform{Mat3(1, 0, 0, 0, 0, 1, 0, 1, 0), Vec3(0)});
    c.losses.add("letters whose outlines overlap", !s.even_odd && s.outlines.size() > 1, "prisms: what an odd number of outlines surrounds");
}

}  // namespace

bool can_be_seen(const ShapeGeometry& geometry) {
    return std::visit([](const auto& shape) { return seen(shape); }, geometry);
}

void begin_shape(const ShapeGeometry& geometry, const SlotMaterials& slots, const ShapeContext& context) {
    if (const auto* mesh = std::get_if<Mesh>(&geometry)) return begin_mesh(*mesh, slots, context);
    std::visit([&](const auto& shape) {
        if constexpr (!std::is_same_v<std::decay_t<decltype(shape)>, Mesh>) begin(shape, context);
    }, geometry);
}

}  // namespace alidade::pov_export
