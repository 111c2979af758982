// SPDX-License-Identifier: Apache-2.0
#include "importers/gltf/meshes.h"

#include "importers/gltf/primitives.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace alidade::gltf {

namespace {

/// What the geometry of `mesh` is read from: equal keys give equal shapes. Materials are not in it.
std::string geometry_key(const tinygltf::Mesh& mesh) {
    std::string key = fmt::format("{}", mesh.weights);
    for (const tinygltf::Primitive& p : mesh.primitives) key += fmt::format("|{} {} {} {}", p.mode, p.indices, p.attributes, p.targets);
    return key;
}

template <class T> bool same_sets(const std::vector<Attribute<T>>& a, const std::vector<Attribute<T>>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) { return x.present() == y.present(); });
}

bool same_layout(const Mesh& a, const Mesh& b) {
    const auto same_target = [](const MorphTarget& x, const MorphTarget& y) {
        return x.positions.empty() == y.positions.empty() && x.normals.empty() == y.normals.empty() && x.tangents.empty() == y.tangents.empty();
    };
    return a.normals.present() == b.normals.present() && a.tangents.present() == b.tangents.present() && a.joint_sets.size() == b.joint_sets.size() &&
           same_sets(a.uvs, b.uvs) && same_sets(a.colors, b.colors) &&
           std::equal(a.morphs.begin(), a.morphs.end(), b.morphs.begin(), b.morphs.end(), same_target);
}

template <class T> void append(std::vector<T>& to, const std::vector<T>& from) { to.insert(to.end(), from.begin(), from.end()); }
template <class T> void append(Attribute<T>& to, const Attribute<T>& from) { append(to.values, from.values); }

/// Adds the triangles of `from`, which has the same layout, with `slot`.
void append_slot(Mesh& to, const Mesh& from, uint32_t slot) {
    if (to.slots.empty()) to.slots.assign(to.triangles.size(), 0);
    const auto shift = uint32_t(to.positions.size());
    for (const Index3& t : from.triangles) to.triangles.push_back(t + shift);
    to.slots.resize(to.triangles.size(), slot);
    append(to.positions, from.positions);
    append(to.normals, from.normals);
    append(to.tangents, from.tangents);
    for (size_t i = 0; i < to.uvs.size(); ++i) append(to.uvs[i], from.uvs[i]);
    for (size_t i = 0; i < to.colors.size(); ++i) append(to.colors[i], from.colors[i]);
    for (size_t i = 0; i < to.joint_sets.size(); ++i) {
        append(to.joint_sets[i].joints, from.joint_sets[i].joints);
        append(to.joint_sets[i].weights, from.joint_sets[i].weights);
    }
    for (size_t i = 0; i < to.morphs.size(); ++i) {
        append(to.morphs[i].positions, from.morphs[i].positions);
        append(to.morphs[i].normals, from.morphs[i].normals);
        append(to.morphs[i].tangents, from.morphs[i].tangents);
    }
}

/// A shape under construction: the primitives of one mesh that share a layout.
struct Group {
    Mesh mesh;
    std::vector<size_t> primitives;
};

std::vector<Group> read_groups(const Model& model, const tinygltf::Mesh& mesh, const std::string& at, ReadBudget& budget, Reporter& report) {
    std::vector<Group> groups;
    for (size_t i = 0; i < mesh.primitives.size(); ++i) {
        auto read = read_primitive(model, mesh.primitives[i], child(child(at, "primitives"), i), budget, report);
        if (!read) continue;
        const auto group = std::find_if(groups.begin(), groups.end(), [&](const Group& g) {
            return same_layout(g.mesh, *read) && g.mesh.positions.size() + read->positions.size() < std::numeric_limits<uint32_t>::max();
        });
        if (group == groups.end()) {
            groups.push_back({std::move(*read), {i}});
        } else {
            append_slot(group->mesh, *read, uint32_t(group->primitives.size()));
            group->primitives.push_back(i);
        }
    }
    return groups;
}

void check_weights(const tinygltf::Mesh& mesh, const std::string& at, Reporter& report) {
    for (size_t i = 1; i < mesh.primitives.size(); ++i) {
        if (mesh.primitives[i].targets.size() != mesh.primitives[0].targets.size())
            return report.error(child(child(at, "primitives"), i), "all primitives of a mesh need the same number of morph targets");
    }
    const size_t targets = mesh.primitives[0].targets.size();
    if (!mesh.weights.empty() && mesh.weights.size() != targets)
        report.warning(child(at, "weights"), fmt::format("{} weights for {} morph targets", mesh.weights.size(), targets));
}

}  // namespace

std::vector<std::vector<MeshPart>> convert_meshes(const Model& model, Scene& scene, Reporter& report) {
    struct Shared {
        ShapeId shape;
        std::vector<size_t> primitives;
    };
    std::map<std::string, std::vector<Shared>> read_before;
    std::vector<std::vector<MeshPart>> out;
    ReadBudget budget(model);
    for (size_t i = 0; i < model.meshes.size() && !report.failed(); ++i) {
        const tinygltf::Mesh& mesh = model.meshes[i];
        if (mesh.primitives.empty()) {   // not shown, and left out
            out.emplace_back();
            continue;
        }
        const std::string at = child("/meshes", i);
        check_weights(mesh, at, report);
        const auto [known, fresh] = read_before.try_emplace(geometry_key(mesh));
        if (fresh) {
            for (Group& group : read_groups(model, mesh, at, budget, report)) {
                group.mesh.morph_weights = mesh.weights;
                group.mesh.morph_weights.resize(group.mesh.morphs.size());
                known->second.push_back({ShapeId{uint32_t(scene.shapes.size())}, group.primitives});
                scene.shapes.push_back({mesh.name, std::move(group.mesh), report.at(at)});
            }
        }
        std::vector<MeshPart> parts;
        for (const Shared& shared : known->second) {
            MeshPart part{shared.shape, {}};
            for (const size_t p : shared.primitives) {
                const int material = mesh.primitives[p].material;
                part.materials.push_back(material < 0 ? std::nullopt : std::optional(MaterialId{uint32_t(material)}));
            }
            parts.push_back(std::move(part));
        }
        out.push_back(std::move(parts));
    }
    return out;
}

}  // namespace alidade::gltf
