// SPDX-License-Identifier: Apache-2.0
#include "eval/solid_query.h"

#include "eval/bound_tests.h"
#include "eval/bounded_paths.h"
#include "eval/csg_expression.h"
#include "eval/mesh_inside.h"
#include "eval/mesh_points.h"
#include "eval/placed.h"

#include <algorithm>
#include <unordered_map>

namespace alidade {

namespace {

constexpr double kMostPaths = 1e6;
constexpr uint32_t kMostLevels = 1000;
/// What bounds a part is a query of its own: that many calls.
constexpr uint32_t kLevelsOfABound = 4;

/// How many paths begin at a node, and the length of the longest.
struct Below {
    double paths = 1;
    uint32_t levels = 1;
};

/// Each node once, however many paths lead to it, those below it first.
Below below(const Scene& scene, NodeId root) {
    std::unordered_map<uint32_t, Below> known;
    std::vector<NodeId> todo{root};
    while (!todo.empty()) {
        const NodeId id = todo.back();
        const size_t before = todo.size();
        Below sum;
        const auto add = [&](NodeId child, uint32_t levels = 1) {
            const auto there = known.find(child.index);
            if (there == known.end()) return todo.push_back(child);
            sum.paths += there->second.paths;
            sum.levels = std::max(sum.levels, there->second.levels + levels);
        };
        for (const NodeId child : scene.nodes[id.index].children) add(child);
        for (const NodeId clip : scene.nodes[id.index].clips) add(clip);
        for (const NodeId bound : scene.nodes[id.index].bounds) add(bound, kLevelsOfABound);
        if (todo.size() > before) continue;
        known[id.index] = sum;
        todo.pop_back();
    }
    return known[root.index];
}

const Mesh* as_mesh(const Scene& scene, ShapeId shape) { return std::get_if<Mesh>(&scene.shapes[shape.index].geometry); }

}  // namespace

const Accelerator& MeshAccelerators::of(ShapeId shape) {
    std::unique_ptr<Accelerator>& made = made_[shape.index];
    if (!made) {
        const Mesh& mesh = *as_mesh(scene_, shape);
        AccelOptions options;
        options.precision = Precision::double_;      // the file's own numbers
        made = find_accelerator("auto")->over_triangles({mesh.positions, mesh.exact_positions, mesh.triangles}, options);
    }
    return *made;
}

/// Places the shapes.
class SolidQuery::Parts final : public CsgParts {
  public:
    Parts(SolidQuery& out, MeshAccelerators& meshes) : out_(out), meshes_(meshes) {}

    BoundedPaths bounded;      ///< to shapes

    bool enters(const Visit&) override { return true; }

    uint32_t place(const Visit& at, const Transform&) override {
        const auto* shape = std::get_if<ShapeId>(&out_.scene_.nodes[at.node.index].what);
        if (!shape) return kNoId;
        const Mesh* mesh = as_mesh(out_.scene_, *shape);
        PlacedShape placed;
        placed.shape = *shape;
        placed.to_world = mesh ? at.to_world * Transform::translate(mesh->origin) : at.to_world;
        const auto to_local = inverse(placed.to_world);
        if (!to_local) return kNoId;
        placed.to_local = *to_local, placed.node = at.node;
        placed.inherited = inherited_material(out_.scene_, {at.path.begin(), at.path.end() - 1}, 0);
        placed.triangles = mesh ? &meshes_.of(*shape) : nullptr;
        placed.ops = mesh ? nullptr : find_shape(out_.scene_.shapes[shape->index].geometry);
        out_.shapes_.push_back(std::move(placed));
        if (BoundTests::bounded(out_.scene_, at.path)) bounded.add(uint32_t(out_.shapes_.size() - 1), at.path);
        return uint32_t(out_.shapes_.size() - 1);
    }

    /// Fills in what the tree asks of its leaves, and which are turned inside out.
    void describe(CsgExpression& e, bool inverse = false) const {
        inverse = inverse != e.inverse;
        for (size_t i = 0; i < e.parts.size(); ++i) describe(e.parts[i], turns_part(e, i, inverse));
        if (e.op != CsgOp::leaf || e.leaf.id == kNoId) return;
        PlacedShape& placed = out_.shapes_[e.leaf.id];
        placed.inverted = inverse && !(placed.ops && placed.ops->sheet);
        const ShapeGeometry& geometry = out_.scene_.shapes[placed.shape.index].geometry;
        e.leaf.inside = csg_inside(placed.ops, geometry), e.leaf.endless = csg_endless(geometry);
        e.leaf.bounds = placed.to_world.bounds(placed.ops ? placed.ops->bounds(geometry) : placed.triangles->bounds());
    }

  private:
    SolidQuery& out_;
    MeshAccelerators& meshes_;
};

/// The shapes, as the tree asks for them.
class SolidQuery::Leaves final : public CsgLeaves {
  public:
    Leaves(const SolidQuery& query, uint64_t& work, bool any_ray = false) : query_(query), work_(work), any_ray_(any_ray) {}

    bool crossings(uint32_t id, const Ray& ray, std::vector<CsgCrossing>& out) const override {
        ++work_;
        const PlacedShape& placed = query_.shapes_[id];
        const Ray local = placed.to_local.ray(ray);
        if (placed.triangles) {
            WorkCounters unused;
            thread_local std::vector<Hit> hits;
            hits.clear();
            placed.triangles->all_hits(local, hits, unused, id);
            for (const Hit& hit : hits) out.push_back({hit, 0});
            return false;
        }
        const ShapeGeometry& geometry = query_.scene_.shapes[placed.shape.index].geometry;
        const Crossings crossings = placed.ops->crossings(geometry, local);
        for (int i = 0; i < crossings.count; ++i) out.push_back({hit_of(crossings.at[i], id), 0});
        return !placed.ops->bounds(geometry).finite() && begins_inside(*placed.ops, geometry, local, crossings);
    }

    bool inside(uint32_t id, const Vec3& point) const override {
        ++work_;
        const PlacedShape& placed = query_.shapes_[id];
        const Vec3 local = placed.to_local.point(point);
        WorkCounters unused;
        if (placed.triangles) return inside_mesh(*as_mesh(query_.scene_, placed.shape), *placed.triangles, local, unused);
        return placed.ops && placed.ops->inside(query_.scene_.shapes[placed.shape.index].geometry, local);
    }

    Sharpness sharpness(const Ray& ray, const Hit& hit) const override {
        const PlacedShape& placed = query_.shapes_[hit.instance];
        const FoundSurface found = query_.surface(ray, hit);
        const ErrorBound own = placed.ops ? placed.ops->error(query_.scene_.shapes[placed.shape.index].geometry, placed.to_local.ray(ray), hit.t, hit.part) : hit.error;
        const PlacedNorms norms(placed.to_world, placed.to_local);
        return {placed_error(norms, own, mapped_error(norms, ray, hit.t), ray, hit.t, found.point), std::abs(dot(found.normal, ray.dir)) / length(ray.dir)};
    }

    bool sees(uint32_t id, const Ray& ray) const override { return any_ray_ || query_.bounds_->passes(query_.shapes_[id].bound_test, ray); }

  private:
    const SolidQuery& query_;
    uint64_t& work_;
    bool any_ray_;
};

SolidQuery::SolidQuery(const Scene& scene, NodeId root, MeshAccelerators& meshes, const Transform& placed, bool clipped) : scene_(scene) {
    const Below size = below(scene, root);
    complete_ = size.paths <= kMostPaths && size.levels <= kMostLevels;
    if (!complete_) return;
    Visit at{root, placed, {root}};
    Parts parts(*this, meshes);
    auto expression = csg_expression(scene, at, kMaskAll, parts);
    if (!expression) return;
    if (!clipped && expression->op == CsgOp::clip) expression = CsgExpression(std::move(expression->parts[0]));
    parts.describe(*expression);
    tree_.emplace(*expression);
    if (!parts.bounded.empty()) find_bounds(parts.bounded, placed);
}

SolidQuery::~SolidQuery() = default;
SolidQuery::SolidQuery(SolidQuery&&) noexcept = default;

void SolidQuery::find_bounds(const BoundedPaths& bounded, const Transform& placed) {
    bounds_ = std::make_unique<BoundTests>(scene_);
    std::vector<Bounds> surfaces(shapes_.size());
    for (const CsgNode& node : tree_->nodes())
        if (node.op == CsgOp::leaf && node.leaf != kNoId) surfaces[node.leaf] = intersection(node.box, tree_->bounds());
    bounded.for_each([&](uint32_t shape, const std::vector<NodeId>& path) { shapes_[shape].bound_test = bounds_->by_shapes(path, placed, surfaces[shape]); });
    tree_->find_bounded([this](uint32_t leaf) { return shapes_[leaf].bound_test != kNoId; });
}

FoundSurface SolidQuery::surface(const Ray& ray, const Hit& hit) const {
    const PlacedShape& placed = shapes_[hit.instance];
    FoundSurface found;
    found.point = ray.at(hit.t);
    found.shape = placed.shape, found.part = hit.part, found.t = hit.t, found.leaf = hit.instance;
    Vec3 normal;
    if (placed.ops) {
        normal = placed.ops->surface(scene_.shapes[placed.shape.index].geometry, placed.to_local.point(found.point), hit.part).normal;
    } else {
        const Mesh& mesh = *as_mesh(scene_, placed.shape);
        found.facet = !mesh.normals.present();
        found.slot = mesh.slots.empty() ? 0 : mesh.slots[hit.primitive];
        normal = found.facet ? triangle_normal(mesh, hit.primitive) : Vec3(interpolate(mesh.normals, mesh, hit.primitive, hit.u, hit.v));
    }
    found.normal = normalized(placed.to_local.transposed(normal));
    if (placed.inverted) found.normal = -found.normal;
    return found;
}

std::optional<FoundSurface> SolidQuery::first(const Ray& asked, uint64_t& work) const {
    if (!tree_) return std::nullopt;
    Ray ray = asked;
    ray.mask = kMaskCamera;
    Hit hit;
    if (!tree_->first(ray, Leaves(*this, work), hit)) return std::nullopt;
    return surface(ray, hit);
}

void SolidQuery::all(const Ray& ray, std::vector<FoundSurface>& out) const {
    if (!tree_) return;
    uint64_t unused = 0;
    std::vector<Hit> hits;
    tree_->all(ray, Leaves(*this, unused, true), hits);
    for (const Hit& hit : hits) out.push_back(surface(ray, hit));
}

std::optional<MaterialId> SolidQuery::material(const FoundSurface& at) const {
    const PlacedShape& placed = shapes_[at.leaf];
    const auto own = inherited_material(scene_, {placed.node}, at.slot);
    return own ? own : placed.inherited;
}

bool SolidQuery::inside(const Vec3& point, uint64_t& work) const { return tree_ && tree_->inside(point, Leaves(*this, work)); }

}  // namespace alidade
