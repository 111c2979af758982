// SPDX-License-Identifier: Apache-2.0
#include "importers/gltf/primitives.h"

#include "importers/gltf/joints.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <numeric>

namespace alidade::gltf {

namespace {

/// Sets of texture coordinates, of colours and of joints that are read.
constexpr uint32_t kMaxSets = 8;

enum class Semantic { position, normal, tangent, uv, color, joints, weights };

struct AttributeRule {
    const char* name;   ///< without "_n"
    Semantic semantic;
    bool in_sets;
    std::initializer_list<int> types;
    const char* type_names;
};
const AttributeRule kRules[] = {
    {"POSITION", Semantic::position, false, {TINYGLTF_TYPE_VEC3}, "VEC3"}, {"NORMAL", Semantic::normal, false, {TINYGLTF_TYPE_VEC3}, "VEC3"},
    {"TANGENT", Semantic::tangent, false, {TINYGLTF_TYPE_VEC4}, "VEC4"},   {"TEXCOORD", Semantic::uv, true, {TINYGLTF_TYPE_VEC2}, "VEC2"},
    {"COLOR", Semantic::color, true, {TINYGLTF_TYPE_VEC3, TINYGLTF_TYPE_VEC4}, "VEC3 or VEC4"},
    {"JOINTS", Semantic::joints, true, {TINYGLTF_TYPE_VEC4}, "VEC4"},      {"WEIGHTS", Semantic::weights, true, {TINYGLTF_TYPE_VEC4}, "VEC4"},
};

struct KnownAttribute {
    const AttributeRule* rule = nullptr;
    uint32_t set = 0;
    int accessor = -1;
    std::string at;
};

/// "TEXCOORD_1" -> the rule of TEXCOORD, set 1. No rule if the name is not one of glTF's.
KnownAttribute classify(const std::string& name) {
    for (const AttributeRule& rule : kRules) {
        if (!rule.in_sets && name == rule.name) return {&rule, 0, -1, {}};
        const std::string prefix = std::string(rule.name) + "_";
        if (!rule.in_sets || name.rfind(prefix, 0) != 0) continue;
        uint32_t set = 0;
        const char *first = name.data() + prefix.size(), *last = name.data() + name.size();
        const auto read = std::from_chars(first, last, set);
        if (read.ptr == last && read.ec == std::errc()) return {&rule, set, -1, {}};
    }
    return {};
}

template <class V> std::vector<V> vectors(const std::vector<float>& flat) {
    constexpr int n = V::length();
    std::vector<V> out(flat.size() / n);
    for (size_t i = 0; i < out.size(); ++i)
        for (int c = 0; c < n; ++c) out[i][c] = flat[i * n + size_t(c)];
    return out;
}

class PrimitiveReader {
  public:
    PrimitiveReader(const Model& model, const tinygltf::Primitive& primitive, const std::string& at, ReadBudget& budget, Reporter& report)
        : model_(model), primitive_(primitive), at_(at), budget_(budget), report_(report) {}

    std::optional<Mesh> read() {
        if (!has_surface() || !collect_attributes() || !read_triangles() || !choose_vertices() || !spend()) return std::nullopt;
        for (const KnownAttribute& a : attributes_) read_attribute(a);
        for (size_t i = 0; i < primitive_.targets.size(); ++i)
            if (!read_target(primitive_.targets[i], child(child(at_, "targets"), i))) return std::nullopt;
        if (!finish()) return std::nullopt;
        return std::move(mesh_);
    }

  private:
    bool has_surface() {
        if (primitive_.mode < TINYGLTF_MODE_TRIANGLES) {
            report_.warning(at_, primitive_.mode == TINYGLTF_MODE_POINTS ? "points have no surface: the primitive is left out"
                                                                         : "lines have no surface: the primitive is left out");
            return false;
        }
        if (primitive_.attributes.count("POSITION")) return true;
        report_.warning(at_, "the primitive has no POSITION: it is left out");
        return false;
    }

    bool collect_attributes() {
        count_ = model_.accessors[size_t(primitive_.attributes.at("POSITION"))].count;
        bool good = true;
        for (const auto& entry : primitive_.attributes) {
            KnownAttribute a = classify(entry.first);
            a.accessor = entry.second;
            a.at = child(child(at_, "attributes"), entry.first);
            if (!a.rule) {
                if (entry.first.rfind('_', 0) != 0) report_.warning(a.at, "unknown attribute: it is left out");
            } else if (!check_format(a)) {
                good = false;
            } else if (a.set >= kMaxSets) {
                report_.warning(a.at, fmt::format("only {} sets are supported: this one is left out", kMaxSets));
            } else {
                attributes_.push_back(std::move(a));
            }
        }
        return good;
    }

    bool check_format(const KnownAttribute& a) {
        const tinygltf::Accessor& accessor = model_.accessors[size_t(a.accessor)];
        const auto fail = [&](std::string message) {
            report_.error(a.at, std::move(message));
            return false;
        };
        if (std::find(a.rule->types.begin(), a.rule->types.end(), accessor.type) == a.rule->types.end())
            return fail(fmt::format("the accessor must be {}", a.rule->type_names));
        const int component = accessor.componentType;
        const bool is_short = component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE || component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
        if (a.rule->semantic == Semantic::joints ? !is_short : component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT)
            return fail("the accessor has the wrong component type for this attribute");
        if (accessor.count != count_) return fail(fmt::format("{} elements, but POSITION has {}", accessor.count, count_));
        return true;
    }

    bool read_triangles() {
        if (count_ >= std::numeric_limits<uint32_t>::max()) {
            report_.error(at_, fmt::format("{} vertices are too many", count_));
            return false;
        }
        std::vector<uint32_t> vertices;
        if (primitive_.indices >= 0) {
            if (!read_indices(vertices)) return false;
        } else {
            if (!budget_.spend(count_, at_, report_)) return false;
            vertices.resize(count_);
            std::iota(vertices.begin(), vertices.end(), 0u);
        }
        const bool fits = primitive_.mode == TINYGLTF_MODE_TRIANGLES ? vertices.size() % 3 == 0 : vertices.size() >= 3;
        if (!fits) report_.warning(at_, fmt::format("{} vertices do not make whole triangles: the rest is left out", vertices.size()));
        mesh_.triangles = assemble_triangles(vertices, primitive_.mode);
        return true;
    }

    bool read_indices(std::vector<uint32_t>& vertices) {
        const tinygltf::Accessor& accessor = model_.accessors[size_t(primitive_.indices)];
        const std::string at = child(at_, "indices");
        const int component = accessor.componentType;
        const bool is_unsigned = component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE || component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                                 component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
        if (accessor.type != TINYGLTF_TYPE_SCALAR || !is_unsigned) {
            report_.error(at, "indices must be a SCALAR accessor of unsigned integers");
            return false;
        }
        if (!budget_.spend(accessor.count, at, report_)) return false;
        vertices = read_integers(model_, primitive_.indices);
        const auto bad = std::find_if(vertices.begin(), vertices.end(), [&](uint32_t v) { return v >= count_; });
        if (bad == vertices.end()) return true;
        const uint32_t restart = component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE    ? 0xff
                                 : component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ? 0xffff
                                                                                       : 0xffffffff;
        report_.error(at, fmt::format("index {} is {}, but there are {} vertices", bad - vertices.begin(), *bad, count_),
                      *bad == restart ? "glTF does not allow primitive restart values" : "");
        return false;
    }

    /// Renumbers the triangles if less than a third of the corners can be distinct vertices.
    bool choose_vertices() {
        if (count_ <= 3 * mesh_.triangles.size()) return true;
        if (mesh_.triangles.empty()) return false;   // too few vertices for a triangle: said already
        for (const Index3& t : mesh_.triangles) used_.insert(used_.end(), {t.x, t.y, t.z});
        std::sort(used_.begin(), used_.end());
        used_.erase(std::unique(used_.begin(), used_.end()), used_.end());
        for (Index3& t : mesh_.triangles)
            for (int c = 0; c < 3; ++c) t[c] = uint32_t(std::lower_bound(used_.begin(), used_.end(), t[c]) - used_.begin());
        return true;
    }

    bool spend() {
        uint64_t components = 0;
        for (const KnownAttribute& a : attributes_) components += component_count(model_.accessors[size_t(a.accessor)]);
        for (const auto& target : primitive_.targets) components += 3 * target.size();
        return budget_.spend(components * (used_.empty() ? count_ : used_.size()), at_, report_);
    }

    template <class V> std::vector<V> values(int accessor) const { return vectors<V>(read_floats(model_, accessor, used_)); }

    void read_attribute(const KnownAttribute& a) {
        switch (a.rule->semantic) {
            case Semantic::position: mesh_.positions = values<Vec3f>(a.accessor); return;
            case Semantic::normal: mesh_.normals.values = values<Vec3f>(a.accessor); return;
            case Semantic::tangent: mesh_.tangents.values = values<Vec4f>(a.accessor); return;
            case Semantic::uv: set_of(mesh_.uvs, a.set).values = values<Vec2f>(a.accessor); return;
            case Semantic::color: set_of(mesh_.colors, a.set).values = colors(a.accessor); return;
            case Semantic::joints: set_of(mesh_.joint_sets, a.set).joints = joints(a.accessor); return;
            case Semantic::weights: set_of(mesh_.joint_sets, a.set).weights = values<Vec4f>(a.accessor); return;
        }
    }

    template <class Set> static Set& set_of(std::vector<Set>& sets, uint32_t set) {
        if (sets.size() <= set) sets.resize(set + 1);
        return sets[set];
    }

    std::vector<Vec4f> colors(int accessor) const {
        if (model_.accessors[size_t(accessor)].type == TINYGLTF_TYPE_VEC4) return values<Vec4f>(accessor);
        std::vector<Vec4f> out;
        for (const Vec3f& c : values<Vec3f>(accessor)) out.emplace_back(c.x, c.y, c.z, 1.0f);
        return out;
    }

    std::vector<Joints4> joints(int accessor) const {
        const std::vector<uint32_t> flat = read_integers(model_, accessor, used_);
        std::vector<Joints4> out(flat.size() / 4);
        for (size_t i = 0; i < out.size(); ++i)
            for (int c = 0; c < 4; ++c) out[i][c] = uint16_t(flat[4 * i + size_t(c)]);
        return out;
    }

    bool read_target(const std::map<std::string, int>& from, const std::string& at) {
        MorphTarget target;
        for (const auto& entry : from) {
            std::vector<Vec3f>* to = entry.first == "POSITION"  ? &target.positions
                                     : entry.first == "NORMAL"  ? &target.normals
                                     : entry.first == "TANGENT" ? &target.tangents
                                                                : nullptr;
            const std::string where = child(at, entry.first);
            if (!to) {
                if (entry.first.rfind('_', 0) != 0) report_.not_understood(where, "this attribute cannot be morphed: it is left out");
                continue;
            }
            const tinygltf::Accessor& accessor = model_.accessors[size_t(entry.second)];
            if (accessor.type != TINYGLTF_TYPE_VEC3 || accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT || accessor.count != count_) {
                report_.error(where, fmt::format("a morph target needs a VEC3 accessor of {} elements, as POSITION has", count_));
                return false;
            }
            *to = values<Vec3f>(entry.second);
        }
        mesh_.morphs.push_back(std::move(target));
        return true;
    }

    /// Attributes that make no sense without another are dropped. False if what is left makes no sense either.
    bool finish() {
        if (mesh_.tangents.present() && !mesh_.normals.present()) mesh_.tangents = {};   // specification, section 3.7.2.1: ignored without normals
        return finish_joints(mesh_, used_, child(at_, "attributes"), report_);
    }

    const Model& model_;
    const tinygltf::Primitive& primitive_;
    const std::string& at_;
    ReadBudget& budget_;
    Reporter& report_;
    Mesh mesh_;
    size_t count_ = 0;                         ///< vertices in the file
    std::vector<uint32_t> used_;               ///< the vertices that are read; empty: all
    std::vector<KnownAttribute> attributes_;
};

}  // namespace

std::vector<Index3> assemble_triangles(const std::vector<uint32_t>& v, int mode) {
    std::vector<Index3> out;
    if (v.size() < 3) return out;
    if (mode == TINYGLTF_MODE_TRIANGLES) {
        out.reserve(v.size() / 3);
        for (size_t i = 0; i + 2 < v.size(); i += 3) out.emplace_back(v[i], v[i + 1], v[i + 2]);
        return out;
    }
    out.reserve(v.size() - 2);
    for (size_t i = 0; i + 2 < v.size(); ++i) {
        if (mode == TINYGLTF_MODE_TRIANGLE_FAN) out.emplace_back(v[i + 1], v[i + 2], v[0]);
        else if (i % 2 == 0) out.emplace_back(v[i], v[i + 1], v[i + 2]);
        else out.emplace_back(v[i], v[i + 2], v[i + 1]);
    }
    // Strips are stitched together by triangles that name a vertex twice.
    out.erase(std::remove_if(out.begin(), out.end(), [](const Index3& t) { return t.x == t.y || t.y == t.z || t.z == t.x; }), out.end());
    return out;
}

std::optional<Mesh> read_primitive(const Model& model, const tinygltf::Primitive& primitive, const std::string& at, ReadBudget& budget,
                                   Reporter& report) {
    return PrimitiveReader(model, primitive, at, budget, report).read();
}

}  // namespace alidade::gltf
