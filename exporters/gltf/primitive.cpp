// SPDX-License-Identifier: Apache-2.0
#include "exporters/gltf/primitive.h"

#include <fmt/format.h>

namespace alidade::gltf_export {

namespace {

/// Unit vectors as far as glTF's validator asks: |v|^2 - 1 is at most this (vectors that were stored in 8 bits are off by so much).
constexpr double kUnitTolerance = 5e-3;

template <class V> std::span<const float> flat(const std::vector<V>& values) {
    static_assert(sizeof(V) == size_t(V::length()) * sizeof(float));
    return {reinterpret_cast<const float*>(values.data()), values.size() * size_t(V::length())};
}

template <class V> bool is_number(const V& v) {
    for (int i = 0; i < V::length(); ++i)
        if (!std::isfinite(v[i])) return false;
    return true;
}

class PrimitiveWriter {
  public:
    PrimitiveWriter(const Mesh& mesh, std::span<const uint32_t> which, Document& document, Losses& losses)
        : mesh_(mesh), vertices_(collect_vertices(mesh, which)), document_(document), losses_(losses) {}

    Json write(bool add_origin) {
        add_positions(add_origin);
        add_normals_and_tangents();
        add_sets("TEXCOORD", "VEC2", mesh_.uvs, Vec2f(0));
        add_sets("COLOR", "VEC4", mesh_.colors, Vec4f(1));
        add_joints();
        Json out = {{"attributes", attributes_}, {"indices", document_.add_indices(vertices_.triangles, vertices_.size())}};
        for (const MorphTarget& target : mesh_.morphs) out["targets"].push_back(target_json(target));
        return out;
    }

  private:
    template <class T> std::vector<T> gather(const Attribute<T>& attribute) const {
        std::vector<T> out;
        out.reserve(vertices_.size());
        for (size_t v = 0; v < vertices_.size(); ++v) out.push_back(vertices_.value(attribute, v));
        return out;
    }

    template <class T> std::vector<T> gather(const std::vector<T>& by_position) const {
        std::vector<T> out;
        out.reserve(vertices_.size());
        for (const uint32_t p : vertices_.positions) out.push_back(by_position[p]);
        return out;
    }

    template <class V> std::vector<V> mended(std::vector<V> values, const V& instead) const {
        for (V& v : values)
            if (!is_number(v)) losses_.add("vertex values that are not finite", 1, "usual ones"), v = instead;
        return values;
    }

    template <class V> void put(const std::string& name, const char* type, const std::vector<V>& values, bool extent = false) {
        attributes_[name] = document_.add_floats(flat(values), type, size_t(V::length()), Target::vertices, extent);
    }

    void add_positions(bool add_origin) {
        positions_ = mended(gather(mesh_.positions), Vec3f(0));
        if (add_origin)
            for (Vec3f& p : positions_) p = Vec3f(Vec3(p) + mesh_.origin);
        put("POSITION", "VEC3", positions_, true);
    }

    /// By vertex, the normals of its triangles weighted by their areas; +z where there are none.
    std::vector<Vec3> triangle_normals() const {
        std::vector<Vec3> sums(vertices_.size(), Vec3(0));
        for (const Index3& t : vertices_.triangles) {
            const Vec3 a(positions_[t.x]), n = cross(Vec3(positions_[t.y]) - a, Vec3(positions_[t.z]) - a);
            for (int c = 0; c < 3; ++c) sums[t[c]] += n;
        }
        for (Vec3& n : sums) {
            n = normalized(n);
            if (!is_finite(n) || n == Vec3(0)) n = Vec3(0, 0, 1);
        }
        return sums;
    }

    /// Vectors that are no unit vectors become such.
    void make_unit(Vec3f& v, const Vec3& instead) const {
        const Vec3 d(v);
        if (std::abs(dot(d, d) - 1) <= kUnitTolerance) return;
        losses_.add("normals and tangents that are no unit vectors", 1, "unit vectors");
        const Vec3 unit = normalized(d);
        v = Vec3f(is_finite(unit) && unit != Vec3(0) ? unit : instead);
    }

    void add_normals_and_tangents() {
        if (!mesh_.normals.present()) return;
        std::vector<Vec3f> normals = gather(mesh_.normals);
        const std::vector<Vec3> spare = triangle_normals();
        for (size_t v = 0; v < normals.size(); ++v) make_unit(normals[v], spare[v]);
        put("NORMAL", "VEC3", normals);
        if (!mesh_.tangents.present()) return;
        std::vector<Vec4f> tangents = gather(mesh_.tangents);
        for (size_t v = 0; v < tangents.size(); ++v) {
            Vec3 s, t;
            orthonormal_basis(normalized(Vec3(normals[v])), s, t);
            Vec3f direction(tangents[v].x, tangents[v].y, tangents[v].z);
            make_unit(direction, s);
            tangents[v] = Vec4f(direction.x, direction.y, direction.z, tangents[v].w < 0 ? -1.0f : 1.0f);
        }
        put("TANGENT", "VEC4", tangents);
    }

    template <class V> void add_sets(const char* name, const char* type, const std::vector<Attribute<V>>& sets, const V& usual) {
        for (size_t i = 0; i < sets.size(); ++i) {
            const std::vector<V> values = sets[i].present() ? mended(gather(sets[i]), usual) : std::vector<V>(vertices_.size(), usual);
            put(fmt::format("{}_{}", name, i), type, values);
        }
    }

    void add_joints() {
        for (size_t i = 0; i < mesh_.joint_sets.size(); ++i) {
            attributes_[fmt::format("JOINTS_{}", i)] = document_.add_joints(gather(mesh_.joint_sets[i].joints));
            put(fmt::format("WEIGHTS_{}", i), "VEC4", mended(gather(mesh_.joint_sets[i].weights), Vec4f(1, 0, 0, 0)));
        }
    }

    Json target_json(const MorphTarget& target) {
        Json out = Json::object();
        const auto add = [&](const char* name, const std::vector<Vec3f>& deltas, bool extent) {
            if (!deltas.empty()) out[name] = document_.add_floats(flat(mended(gather(deltas), Vec3f(0))), "VEC3", 3, Target::vertices, extent);
        };
        add("POSITION", target.positions, true);
        if (mesh_.normals.present()) add("NORMAL", target.normals, false);
        if (mesh_.tangents.present()) add("TANGENT", target.tangents, false);
        // A target may not be empty; one without deltas moves nothing.
        if (out.empty()) out["POSITION"] = document_.add_floats(flat(std::vector<Vec3f>(vertices_.size(), Vec3f(0))), "VEC3", 3, Target::vertices, true);
        return out;
    }

    const Mesh& mesh_;
    Vertices vertices_;
    Document& document_;
    Losses& losses_;
    std::vector<Vec3f> positions_;
    Json attributes_ = Json::object();
};

}  // namespace

Json write_primitive(const Mesh& mesh, std::span<const uint32_t> which, bool add_origin, Document& document, Losses& losses) {
    return PrimitiveWriter(mesh, which, document, losses).write(add_origin);
}

}  // namespace alidade::gltf_export
