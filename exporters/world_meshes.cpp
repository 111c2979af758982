// SPDX-License-Identifier: Apache-2.0
#include "exporters/world_meshes.h"

#include "core/image.h"
#include "exporters/vertices.h"
#include "scene/queries.h"

#include <fmt/format.h>

#include <algorithm>

namespace alidade {

namespace {

/// How many of its own sizes away from 0 a mesh of float coordinates may lie.
constexpr double kFarthest = 16;

void add_mesh_losses(const Mesh& mesh, Losses& losses) {
    losses.add("polygons", !mesh.faces.empty(), "triangles");
    losses.add("texture coordinate sets beyond the first", mesh.uvs.empty() ? 0 : mesh.uvs.size() - 1);
    losses.add("vertex colour sets beyond the first", mesh.colors.empty() ? 0 : mesh.colors.size() - 1);
    losses.add("tangents", mesh.tangents.present());
    losses.add("morph targets", mesh.morphs.size(), "the rest shape");
}

void add_scene_losses(const Scene& scene, Losses& losses) {
    add_common_losses(scene, losses);
    losses.add("lights", scene.lights.size());
    losses.add("cameras", scene.cameras.size());
    losses.add("animations", scene.animations.size(), "the scene as it stands");
    losses.add("skins", scene.skins.size(), "the rest shape");
}

/// Collects on a walk over the graph.
class Collector {
  public:
    Collector(const Scene& scene, Losses& losses) : scene_(scene), losses_(losses), seen_(scene.shapes.size()) {}

    bool visit(const Visit& visit) {
        visited_nodes_ += visit.path.size() > 1;
        if (++paths_ > kMostTriangles) return false;
        const Node& node = scene_.nodes[visit.node.index];
        const auto* shape = std::get_if<ShapeId>(&node.what);
        return !shape || add(visit, node, *shape);
    }

    void tell() {
        losses_.add("instances", again_, "copies");
        losses_.add("levels of the hierarchy", visited_nodes_, "meshes in world coordinates");
    }

    std::vector<WorldMesh> meshes;
    size_t triangles = 0;

  private:
    bool add(const Visit& visit, const Node& node, ShapeId id) {
        const ShapeEntry& shape = scene_.shapes[id.index];
        const auto* mesh = std::get_if<Mesh>(&shape.geometry);
        if (!mesh) return losses_.add("spheres, planes, boxes and other shapes that are no meshes"), true;
        const auto to_local = inverse(visit.to_world);
        if (!to_local) return losses_.add("meshes that their transform flattens"), true;
        if (seen_[id.index]) ++again_;
        else add_mesh_losses(*mesh, losses_);
        seen_[id.index] = true;
        WorldMesh out{mesh, node.name.empty() ? shape.name : node.name, visit.to_world, *to_local, {}, finite_triangles(*mesh)};
        std::erase_if(out.finite, [&](uint32_t t) {
            const Index3& v = mesh->triangles[t];
            return !is_finite(out.position(v.x)) || !is_finite(out.position(v.y)) || !is_finite(out.position(v.z));
        });
        losses_.add("triangles with a vertex that is not finite", mesh->triangles.size() - out.finite.size());
        triangles += out.finite.size();
        const uint32_t slots = slot_count(shape.geometry);
        for (uint32_t s = 0; s < slots; ++s) out.materials.push_back(inherited_material(scene_, visit.path, s));
        if (!out.finite.empty()) meshes.push_back(std::move(out));
        return triangles <= kMostTriangles;
    }

    const Scene& scene_;
    Losses& losses_;
    std::vector<bool> seen_;
    size_t again_ = 0, visited_nodes_ = 0, paths_ = 0;
};

bool is_float(double x) { return double(float(x)) == x; }

bool floats_suffice_for(const WorldMesh& m) {
    Bounds box;
    for (const uint32_t t : m.finite)
        for (int c = 0; c < 3; ++c) {
            const Vec3 p = m.position(m.mesh->triangles[t][c]);
            if (!is_float(p.x) || !is_float(p.y) || !is_float(p.z)) return false;
            box.extend(p);
        }
    return std::max(max_abs(box.min), max_abs(box.max)) <= kFarthest * max_component(box.extent());
}

}  // namespace

Vec3 WorldMesh::position(uint32_t vertex) const {
    const Vec3 local = mesh->exact_positions.empty() ? Vec3(mesh->positions[vertex]) : mesh->exact_positions[vertex];
    return to_world.point(mesh->origin + local);
}

Vec3 WorldMesh::normal(const Vec3f& n) const {
    const Vec3 out = normalized(to_world.is_identity() ? Vec3(n) : to_local.transposed(Vec3(n)));
    return is_finite(out) ? out : Vec3(0);
}

tl::expected<std::vector<WorldMesh>, std::string> world_meshes(const Scene& scene, Losses& losses) {
    add_scene_losses(scene, losses);
    Collector collector(scene, losses);
    bool complete = true;
    visit_paths(scene, [&](const Visit& visit) { return complete = collector.visit(visit); });
    if (!complete)
        return tl::unexpected(fmt::format("the scene shows more than {} triangles or nodes once its instances are copied; glTF keeps instances", kMostTriangles));
    collector.tell();
    size_t hidden = 0;
    for (const Node& node : scene.nodes) hidden += !node.flags.visible;
    losses.add("hidden nodes and all below them", hidden);
    return std::move(collector.meshes);
}

bool floats_suffice(const std::vector<WorldMesh>& meshes) { return std::all_of(meshes.begin(), meshes.end(), floats_suffice_for); }

int srgb_byte(float linear) {
    const double encoded = std::round(255 * linear_to_srgb(double(linear)));
    if (!(encoded >= 0 && encoded <= 255)) return -1;
    return float(srgb_to_linear(encoded / 255)) == linear ? int(encoded) : -1;
}

}  // namespace alidade
