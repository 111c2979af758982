// SPDX-License-Identifier: Apache-2.0
#include "scene/validation.h"

namespace alidade {

namespace {

template <class V> bool finite_components(const V& value) {
    for (int i = 0; i < V::length(); ++i)
        if (!std::isfinite(value[i])) return false;
    return true;
}

/// In the order of ShapeGeometry.
constexpr const char* kKinds[] = {"sphere", "plane", "box", "disc", "cylinder", "cone", "torus", "quadric", "polynomial", "polygon", "extrusion", "mesh"};
static_assert(std::size(kKinds) == std::variant_size_v<ShapeGeometry>);

/// A shape whose line is told needs no number.
Label label_of(const ShapeEntry& entry, size_t index) {
    return entry.from.line ? label(kKinds[entry.geometry.index()], std::nullopt, entry.name) : label("shape", index, entry.name);
}

/// Examines one shape; what it says starts with the shape's name.
class ShapeCheck {
  public:
    ShapeCheck(Validation& v, const ShapeEntry& entry, size_t index) : v_(v), from_(entry.from), who_(label_of(entry, index).text()) {}

    void operator()(const Sphere& s) const {
        if (!is_finite(s.center) || !std::isfinite(s.radius)) return not_finite();
        if (s.radius == 0) warning("is a sphere of radius 0: it cannot be seen");
    }

    void operator()(const Plane& p) const {
        if (!is_finite(p.normal) || !std::isfinite(p.distance)) return not_finite();
        if (p.normal == Vec3(0)) warning("is a plane without a normal: it is left out", "give it a normal that is not <0, 0, 0>");
    }

    void operator()(const Box& b) const {
        if (!is_finite(b.a) || !is_finite(b.b)) return not_finite();
        const Vec3 size = glm::abs(b.a - b.b);
        if (int(size.x == 0) + int(size.y == 0) + int(size.z == 0) > 1) warning("is a box without area: it cannot be seen");
    }

    void operator()(const Disc& d) const {
        if (!is_finite(d.center) || !is_finite(d.normal) || !std::isfinite(d.radius) || !std::isfinite(d.hole)) return not_finite();
        if (d.normal == Vec3(0)) warning("is a disc without a normal: it is left out", "give it a normal that is not <0, 0, 0>");
        if (std::abs(d.hole) >= std::abs(d.radius)) warning("is a disc that is all hole: it cannot be seen");
    }

    void operator()(const Cylinder& c) const {
        if (!is_finite(c.a) || !is_finite(c.b) || !std::isfinite(c.radius)) return not_finite();
        if (c.radius == 0) warning("is a cylinder of radius 0: it cannot be seen");
        has_length(c.a, c.b, "cylinder");
    }

    void operator()(const Cone& c) const {
        if (!is_finite(c.a) || !is_finite(c.b) || !std::isfinite(c.radius_a) || !std::isfinite(c.radius_b)) return not_finite();
        if (c.radius_a == 0 && c.radius_b == 0) warning("is a cone of radius 0: it cannot be seen");
        has_length(c.a, c.b, "cone");
    }

    void operator()(const Torus& t) const {
        if (!is_finite(t.center) || !std::isfinite(t.major) || !std::isfinite(t.minor)) return not_finite();
        if (t.minor == 0) warning("is a torus of minor radius 0: it cannot be seen");
    }

    void operator()(const Quadric& q) const {
        if (!is_finite(q.squares) || !is_finite(q.products) || !is_finite(q.linear) || !std::isfinite(q.constant)) return not_finite();
        if (q.squares == Vec3(0) && q.products == Vec3(0) && q.linear == Vec3(0)) warning("is a quadric that is the same everywhere: it cannot be seen");
    }

    void operator()(const Polynomial& f) const {
        if (f.order < 1 || f.order > Polynomial::kMostOrder) return error(fmt::format("is a polynomial of order {}", f.order), fmt::format("the order is 1 to {}", Polynomial::kMostOrder));
        const size_t terms = Polynomial::terms(f.order);
        if (f.coefficients.size() != terms) return error(fmt::format("has {} coefficients for a polynomial of order {}, which has {}", f.coefficients.size(), f.order, terms));
        if (!std::all_of(f.coefficients.begin(), f.coefficients.end(), [](double c) { return std::isfinite(c); })) not_finite();
    }

    void operator()(const Polygon& polygon) const {
        for (const auto& loop : polygon.loops)
            if (!std::all_of(loop.begin(), loop.end(), [](const Vec3& p) { return is_finite(p); })) return not_finite();
        const Vec3 normal = normal_of(polygon);
        if (normal == Vec3(0)) return warning("is a polygon without area: it cannot be seen");
        double size = 0, off = 0;
        for (const auto& loop : polygon.loops)
            for (const Vec3& p : loop) size = std::max(size, length(p)), off = std::max(off, std::abs(dot(normal, p - polygon.loops.front().front())));
        if (off > 1e-6 * size) warning(fmt::format("is a polygon with a point {} away from its plane: it is drawn as if it were flat", off));
    }

    void operator()(const Extrusion& e) const {
        if (!std::isfinite(e.bottom) || !std::isfinite(e.top)) return not_finite();
        for (const Outline& outline : e.outlines) {
            if (outline.points.size() % 2 != 0) return error(fmt::format("has an outline of {} points", outline.points.size()), "points on the curve and control points stand by turns");
            if (!std::all_of(outline.points.begin(), outline.points.end(), finite_components<Vec2>)) return not_finite();
        }
    }

    void operator()(const Mesh& mesh) const {
        if (!is_finite(mesh.origin)) return not_finite();
        if (mesh.inside_vector && (!is_finite(*mesh.inside_vector) || *mesh.inside_vector == Vec3(0))) error("has an inside_vector that leads nowhere");
        if (!positions(mesh)) return;
        per_triangle(mesh.slots, mesh, "material slots");
        if (!mesh.corner_slots.empty() && mesh.corner_slots.size() != 3 * mesh.triangles.size()) error(fmt::format("has {} material slots of corners for {} triangles", mesh.corner_slots.size(), mesh.triangles.size()));
        if (slot_count(mesh) > kMostSlots) error(fmt::format("has a material slot beyond {}", kMostSlots - 1));
        per_triangle(mesh.faces, mesh, "face numbers");
        attribute(mesh.normals, mesh, "normals");
        attribute(mesh.tangents, mesh, "tangents");
        for (const auto& uv : mesh.uvs) attribute(uv, mesh, "texture coordinates");
        for (const auto& color : mesh.colors) attribute(color, mesh, "colors");
        joints(mesh);
        morphs(mesh);
    }

  private:
    /// Not "sphere is a sphere of radius 0".
    std::string sentence(const std::string& what) const { return from_.line && what.starts_with("is ") ? what.substr(3) : who_ + " " + what; }
    void error(const std::string& what, std::string hint = {}) const { v_.error(from_, sentence(what), std::move(hint)); }
    void warning(const std::string& what, std::string hint = {}) const { v_.warning(from_, sentence(what), std::move(hint)); }
    void not_finite() const { warning("has a number that is not finite: it is left out"); }

    void has_length(const Vec3& a, const Vec3& b, const char* kind) const {
        if (a == b) warning(fmt::format("is a {} without length: it is left out", kind), "give it two different ends, or use a disc");
    }

    /// False if a triangle points at nothing.
    bool positions(const Mesh& mesh) const {
        const size_t count = mesh.positions.size();
        if (!mesh.exact_positions.empty() && mesh.exact_positions.size() != count)
            error(fmt::format("has {} exact positions for {} positions", mesh.exact_positions.size(), count));
        size_t out_of_range = 0, first = 0, not_finite = 0;
        for (size_t i = 0; i < mesh.triangles.size(); ++i) {
            const Index3& t = mesh.triangles[i];
            if (std::max({t.x, t.y, t.z}) >= count) {
                if (out_of_range++ == 0) first = i;
                continue;
            }
            if (!finite_vertex(mesh, t.x) || !finite_vertex(mesh, t.y) || !finite_vertex(mesh, t.z)) ++not_finite;
        }
        if (out_of_range) {
            const Index3& t = mesh.triangles[first];
            error(fmt::format("has {} triangles with vertices that do not exist; the first, triangle {}, names vertex {} of {}", out_of_range, first,
                              std::max({t.x, t.y, t.z}), count));
        }
        if (not_finite) warning(fmt::format("has {} triangles with a vertex that is not finite: they are left out", not_finite));
        return out_of_range == 0;
    }

    static bool finite_vertex(const Mesh& mesh, uint32_t i) {
        return finite_components(mesh.positions[i]) && (i >= mesh.exact_positions.size() || is_finite(mesh.exact_positions[i]));
    }

    void per_triangle(const std::vector<uint32_t>& values, const Mesh& mesh, const char* what) const {
        if (!values.empty() && values.size() != mesh.triangles.size()) error(fmt::format("has {} {} for {} triangles", values.size(), what, mesh.triangles.size()));
    }

    template <class T> void attribute(const Attribute<T>& a, const Mesh& mesh, const char* what) const {
        if (a.corners.empty()) {
            if (a.present() && a.values.size() != mesh.positions.size())
                error(fmt::format("has {} {} for {} positions", a.values.size(), what, mesh.positions.size()));
        } else if (a.corners.size() != 3 * mesh.triangles.size()) {
            error(fmt::format("has {} corners with {} for {} triangles", a.corners.size(), what, mesh.triangles.size()));
        } else if (const uint32_t largest = *std::max_element(a.corners.begin(), a.corners.end()); largest >= a.values.size()) {
            error(fmt::format("has a corner that names number {} of {} {}", largest, a.values.size(), what));
        }
        const auto broken = std::count_if(a.values.begin(), a.values.end(), [](const T& x) { return !finite_components(x); });
        if (broken) warning(fmt::format("has {} {} that are not finite: shading there is undefined", broken, what));
    }

    void joints(const Mesh& mesh) const {
        for (size_t i = 0; i < mesh.joint_sets.size(); ++i) {
            const JointSet& set = mesh.joint_sets[i];
            if (set.joints.size() != mesh.positions.size() || set.weights.size() != mesh.positions.size())
                error(fmt::format("has {} joints and {} weights in set {} for {} positions", set.joints.size(), set.weights.size(), i, mesh.positions.size()));
            if (!std::all_of(set.weights.begin(), set.weights.end(), finite_components<Vec4f>)) error("has a joint weight that is not finite");
        }
    }

    void morphs(const Mesh& mesh) const {
        for (size_t i = 0; i < mesh.morphs.size(); ++i) {
            const MorphTarget& target = mesh.morphs[i];
            for (const auto* deltas : {&target.positions, &target.normals, &target.tangents}) {
                if (!deltas->empty() && deltas->size() != mesh.positions.size())
                    error(fmt::format("has {} deltas in morph target {} for {} positions", deltas->size(), i, mesh.positions.size()));
            }
        }
        if (!mesh.morph_weights.empty() && mesh.morph_weights.size() != mesh.morphs.size())
            error(fmt::format("has {} morph weights for {} morph targets", mesh.morph_weights.size(), mesh.morphs.size()));
        if (!std::all_of(mesh.morph_weights.begin(), mesh.morph_weights.end(), [](double w) { return std::isfinite(w); }))
            error("has a morph weight that is not finite");
    }

    Validation& v_;
    const SourcePos& from_;
    std::string who_;
};

}  // namespace

void check_shapes(Validation& v) {
    for (size_t i = 0; i < v.scene.shapes.size(); ++i) std::visit(ShapeCheck(v, v.scene.shapes[i], i), v.scene.shapes[i].geometry);
}

}  // namespace alidade
