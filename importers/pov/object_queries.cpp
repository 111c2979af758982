// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/object_queries.h"

#include "importers/pov/builders/extents.h"
#include "importers/pov/builders/objects.h"
#include "scene/graph.h"

#include <fmt/format.h>
#include <unordered_map>

namespace alidade::pov {

namespace {

constexpr double kNearest = 1e-4, kFarthest = 1e7;

/// Is there a part without inside? Lights of a light_group itself do not count.
bool has_patches(const Scene& scene, NodeId root) {
    std::vector<NodeId> todo{root};
    std::vector<bool> seen(scene.nodes.size());
    while (!todo.empty()) {
        const NodeId id = todo.back();
        todo.pop_back();
        if (seen[id.index]) continue;
        seen[id.index] = true;
        const Node& node = scene.nodes[id.index];
        const auto* shape = std::get_if<ShapeId>(&node.what);
        const auto* mesh = shape ? std::get_if<Mesh>(&scene.shapes[shape->index].geometry) : nullptr;
        if (std::holds_alternative<LightId>(node.what) || (mesh && !mesh->inside_vector)) return true;
        const bool group = !node.light_group.empty() || !node.global_lights;
        for (const NodeId child : node.children)
            if (!group || !std::holds_alternative<LightId>(scene.nodes[child.index].what)) todo.push_back(child);
    }
    return false;
}

/// POV-Ray's flat triangles look to where their corners are seen clockwise in a right-handed world, and the sides of its letters inwards.
bool looks_the_other_way(const Scene& scene, const FoundSurface& found) {
    return found.facet || (found.part >= kExtrusionSides && std::holds_alternative<Extrusion>(scene.shapes[found.shape.index].geometry));
}

}  // namespace

/// An object that was asked for, kept as long as what was made of it.
struct ObjectQueries::Known {
    Value object;
    std::optional<SolidQuery> solid;
    std::optional<bool> patches;
    std::optional<Bounds> extent;
};

/// The scene that objects are built into. Blocks that are referred to stay alive by those that are known.
struct ObjectQueries::Stage {
    explicit Stage(Parser& p) : build(p), meshes(build.scene), extents(build) { build.shapes_alone = true; }
    Build build;
    MeshAccelerators meshes;
    Extents extents;
    std::unordered_map<const Shared*, Known> known;
    size_t first_size = 0;       ///< of the scene when the first object was in it

    /// Loops make objects without end; when there are many, the next one begins anew.
    bool is_full() const {
        constexpr size_t kObjects = 1000, kNodes = 100'000, kMostNodes = 700'000;
        return known.size() >= kObjects || build.scene.nodes.size() > std::min(kNodes + 3 * first_size, kMostNodes);
    }
};

ObjectQueries::ObjectQueries(Parser& p) : p_(p) {}
ObjectQueries::~ObjectQueries() = default;

ObjectQueries::Known& ObjectQueries::known(const Value& object) {
    if (stage_) {
        const auto there = stage_->known.find(object.shared.get());
        if (there != stage_->known.end()) return there->second;
        if (stage_->is_full()) stage_.reset();
    }
    if (!stage_) stage_ = std::make_unique<Stage>(p_);
    Known& made = stage_->known[object.shared.get()];
    made.object = object;
    return made;
}

/// What fails half-way leaves nothing behind.
template <class Ask> auto ObjectQueries::asked(const Ask& ask) {
    try {
        return ask();
    } catch (...) {
        stage_.reset();
        throw;
    }
}

const SolidQuery& ObjectQueries::solid(const Value& object, Place at) {
    Known& it = known(object);
    if (!it.solid) {
        Build& build = stage_->build;
        const auto built = build_object(build, object.as<Block>());
        const NodeId root = built ? built->node : build.add_node({});
        if (stage_->known.size() == 1) stage_->first_size = build.scene.nodes.size();
        it.patches = has_patches(build.scene, root);
        it.solid.emplace(build.scene, root, stage_->meshes);
        p_.charge(it.solid->size(), at);
    }
    if (!it.solid->complete()) p_.fail(at, "the object has too many parts, or they stand too deep in one another, to be asked");
    return *it.solid;
}

Traced ObjectQueries::trace(const Value& object, const Vec3& origin, const Vec3& dir, Place at) {
    return asked([&] {
        const SolidQuery& query = solid(object, at);
        const Vec3 unit = is_finite(dir) ? normalized(dir) : Vec3(0);
        if (unit == Vec3(0) || !is_finite(origin)) {
            p_.warn(at, unit == Vec3(0) ? "the direction of trace() has no length or is not finite: nothing is met" : "the origin of trace() is not finite: nothing is met");
            return Traced();
        }
        Ray ray;
        ray.origin = origin, ray.dir = unit;
        ray.tmin = kNearest, ray.tmax = kFarthest;
        uint64_t work = 0;
        const auto found = query.first(ray, work);
        p_.charge(work, at);
        if (!found) return Traced();
        return Traced{found->point, looks_the_other_way(stage_->build.scene, *found) ? -found->normal : found->normal};
    });
}

bool ObjectQueries::inside(const Value& object, const Vec3& point, Place at) {
    return asked([&] {
        const SolidQuery& query = solid(object, at);
        if (*known(object).patches) p_.fail(at, "an object with triangles, meshes or lights in it has no inside", "ask inside() of solids, or of meshes with an inside_vector");
        if (!is_finite(point)) p_.warn(at, "the point of inside() is not finite: it is outside");
        uint64_t work = 0;
        const bool in = is_finite(point) && query.inside(point, work);
        p_.charge(work, at);
        return in;
    });
}

Bounds ObjectQueries::extent(const Value& object) {
    return asked([&] {
        Known& it = known(object);
        if (!it.extent) it.extent = stage_->extents.of(object.as<Block>());
        return *it.extent;
    });
}

}  // namespace alidade::pov
