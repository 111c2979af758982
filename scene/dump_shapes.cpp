// SPDX-License-Identifier: Apache-2.0
#include "scene/dump_line.h"

namespace alidade {

namespace {

void dump_shape(std::string& out, const std::string& head, const ShapeEntry& entry, const Sphere& s) {
    Line(out, head).word("sphere").field("name", entry.name).always("center", s.center).always("radius", s.radius).field("from", entry.from);
}

void dump_shape(std::string& out, const std::string& head, const ShapeEntry& entry, const Plane& p) {
    Line(out, head).word("plane").field("name", entry.name).always("normal", p.normal).always("distance", p.distance).field("from", entry.from);
}

void dump_shape(std::string& out, const std::string& head, const ShapeEntry& entry, const Box& b) {
    Line(out, head).word("box").field("name", entry.name).always("a", b.a).always("b", b.b).field("from", entry.from);
}

void dump_shape(std::string& out, const std::string& head, const ShapeEntry& entry, const Disc& d) {
    Line(out, head).word("disc").field("name", entry.name).always("center", d.center).always("normal", d.normal).always("radius", d.radius)
        .field("hole", d.hole).field("from", entry.from);
}

void dump_shape(std::string& out, const std::string& head, const ShapeEntry& entry, const Cylinder& c) {
    Line(out, head).word("cylinder").field("name", entry.name).always("a", c.a).always("b", c.b).always("radius", c.radius).field("open", c.open)
        .field("from", entry.from);
}

void dump_shape(std::string& out, const std::string& head, const ShapeEntry& entry, const Cone& c) {
    Line(out, head).word("cone").field("name", entry.name).always("a", c.a).always("b", c.b).always("radius_a", c.radius_a).always("radius_b", c.radius_b)
        .field("open", c.open).field("from", entry.from);
}

void dump_shape(std::string& out, const std::string& head, const ShapeEntry& entry, const Torus& t) {
    Line(out, head).word("torus").field("name", entry.name).field("center", t.center).always("major", t.major).always("minor", t.minor)
        .field("from", entry.from);
}

void dump_shape(std::string& out, const std::string& head, const ShapeEntry& entry, const Quadric& q) {
    Line(out, head).word("quadric").field("name", entry.name).always("squares", q.squares).field("products", q.products).field("linear", q.linear)
        .always("constant", q.constant).field("from", entry.from);
}

void dump_shape(std::string& out, const std::string& head, const ShapeEntry& entry, const Polynomial& f) {
    Line(out, head).word("polynomial").field("name", entry.name).always("order", f.order).always("coefficients", f.coefficients).field("from", entry.from);
}

void dump_shape(std::string& out, const std::string& head, const ShapeEntry& entry, const Polygon& polygon) {
    Line(out, head).word("polygon").field("name", entry.name).always("loops", polygon.loops).field("from", entry.from);
}

void dump_shape(std::string& out, const std::string& head, const ShapeEntry& entry, const Extrusion& e) {
    Line(out, head).word("extrusion").field("name", entry.name).always("bottom", e.bottom).always("top", e.top).field("even_odd", e.even_odd).field("from", entry.from);
    for (size_t i = 0; i < e.outlines.size(); ++i) Line(out, fmt::format("  outline {}", i)).always("points", e.outlines[i].points);
}

template <class T> void dump_attribute(std::string& out, const std::string& name, const Attribute<T>& a, MeshLists how) {
    if (a.values.empty() && a.corners.empty()) return;
    Line(out, "  " + name).list("values", a.values, how).list("corners", a.corners, how);
}

void dump_mesh(std::string& out, const std::string& head, const ShapeEntry& entry, const Mesh& mesh, MeshLists how) {
    Line(out, head).word("mesh").field("name", entry.name).field("origin", mesh.origin).field("inside_vector", mesh.inside_vector).field("from", entry.from);
    Line(out, "  positions").list("values", mesh.positions, how).list("exact", mesh.exact_positions, how);
    Line(out, "  triangles").list("vertices", mesh.triangles, how).list("slots", mesh.slots, how).list("corner_slots", mesh.corner_slots, how).list("faces", mesh.faces, how);
    dump_attribute(out, "normals", mesh.normals, how);
    for (size_t i = 0; i < mesh.uvs.size(); ++i) dump_attribute(out, fmt::format("uv {}", i), mesh.uvs[i], how);
    dump_attribute(out, "tangents", mesh.tangents, how);
    for (size_t i = 0; i < mesh.colors.size(); ++i) dump_attribute(out, fmt::format("colors {}", i), mesh.colors[i], how);
    for (size_t i = 0; i < mesh.morphs.size(); ++i) {
        const MorphTarget& target = mesh.morphs[i];
        Line(out, fmt::format("  morph {}", i))
            .list("positions", target.positions, how).list("normals", target.normals, how).list("tangents", target.tangents, how);
    }
    if (!mesh.morph_weights.empty()) Line(out, "  morph weights").always("values", mesh.morph_weights);
    for (size_t i = 0; i < mesh.joint_sets.size(); ++i)
        Line(out, fmt::format("  joints {}", i)).list("joints", mesh.joint_sets[i].joints, how).list("weights", mesh.joint_sets[i].weights, how);
}

}  // namespace

void dump_shapes(std::string& out, const Scene& scene, MeshLists lists) {
    for (size_t i = 0; i < scene.shapes.size(); ++i) {
        const ShapeEntry& entry = scene.shapes[i];
        const std::string head = fmt::format("shape {}", i);
        std::visit([&](const auto& shape) {
            if constexpr (std::is_same_v<decltype(shape), const Mesh&>) dump_mesh(out, head, entry, shape, lists);
            else dump_shape(out, head, entry, shape);
        }, entry.geometry);
    }
}

}  // namespace alidade
