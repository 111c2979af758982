// SPDX-License-Identifier: Apache-2.0
#include "accel/cell_boxes.h"
#include "accel/lazy.h"
#include "core/deep_stack.h"
#include "core/float_mode.h"
#include "core/parallel.h"
#include "eval/bound_tests.h"
#include "eval/csg_expression.h"
#include "scene/queries.h"
#include "tracer/bounds.h"
#include "tracer/cameras.h"
#include "tracer/cutaway.h"
#include "tracer/environment.h"
#include "tracer/filters.h"
#include "tracer/instance_leaves.h"
#include "tracer/instance_set.h"
#include "tracer/interior_carrier.h"
#include "tracer/light_groups.h"
#include "tracer/materials.h"
#include "tracer/normal_maps.h"
#include "tracer/object_boxes.h"
#include "tracer/pov_surface.h"
#include "tracer/projector.h"
#include "tracer/textures.h"
#include "tracer/unrendered.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <map>

namespace alidade {
namespace {

/// More paths than this are a mistake of the file (or an attack): 30 levels of two references each are already a billion.
constexpr double kMostPaths = 1e8;

bool check_path_count(const Scene& scene, Diagnostics& said) {
    if (path_count(scene) <= kMostPaths) return true;
    said.error(scene.nodes[scene.roots.front().index].from, fmt::format("the scene has more than {} paths from a root to a node", kMostPaths), "look for nodes that refer to each other many times over");
    return false;
}

/// Set operations deeper in one another than this are a mistake of the file.
constexpr size_t kDeepestSolid = 20'000;
/// The same of those that are left where unions in unions and intersections in intersections are one: rays walk them on the stacks of their threads.
constexpr uint32_t kDeepestTree = 1000;

/// Of the shape: its own, or what is found by looking where it can be, which takes too long to do it for each ray.
Bounds bounds_of(const ShapeOps& ops, const ShapeGeometry& shape) {
    const Bounds own = ops.bounds(shape);
    if (own.finite() || !ops.narrow) return own;
    const Bounds narrow = ops.narrow(shape, false, own);
    return narrow.empty() || narrow.finite() ? narrow : own;
}

/// A solid with instances as leaves.
struct PlacedSolid {
    CsgExpression what;
    NodeId node;
    SolidSpace space;
};

/// Walks the graph once and fills a CompiledScene with instances, lights and cameras.
class Placer : private CsgParts {
  public:
    Placer(CompiledScene& out, Diagnostics& said) : out_(out), said_(said), geometry_of_(out.scene.shapes.size(), kNoId), materials_(out), groups_(out.scene), objects_(out.scene), beyond_its_box_(nodes_beyond_their_boxes(out.scene)) {}

    /// When all is placed.
    void finish() { groups_.finish(out_); }

    void visit(const Visit& visit) {
        if (visit.path.size() > solid_depth_) return;   // it has been placed with the solid that it is a part of
        const Node& node = out_.scene.nodes[visit.node.index];
        solid_depth_ = is_solid(node) ? visit.path.size() : std::numeric_limits<size_t>::max();
        levels_to_object_ = levels_to_object(visit.path);
        if (is_solid(node)) place_solid(visit);
        else place(visit, node);
    }

    std::vector<PlacedSolid> take_solids() { return std::move(solids_); }
    const BoundedPaths& bounded() const { return bounded_; }

  private:
    void place(const Visit& visit, const Node& node) {
        if (const auto* shape = std::get_if<ShapeId>(&node.what)) place_shape(visit, node, *shape);
        else if (const auto* light = std::get_if<LightId>(&node.what)) place_light(visit, *light);
        else if (const auto* camera = std::get_if<CameraId>(&node.what)) out_.cameras.push_back({placed(out_.scene.cameras[camera->index], visit.to_world)});
    }

    /// Of nodes below `id`: those that place, invert or cover one thing alone.
    size_t levels_to_operation(NodeId id) const {
        size_t levels = 0;
        for (auto below = lone_part(out_.scene.nodes[id.index]); below; below = lone_part(out_.scene.nodes[below->index])) ++levels;
        return levels;
    }

    /// Down to the set that is one object, with itself; to a shape where there is none.
    size_t levels_to_object(const std::vector<NodeId>& path) const {
        const auto object = std::ranges::find_if(path, [&](NodeId id) { return out_.scene.nodes[id.index].whole || is_solid(out_.scene.nodes[id.index]); });
        return object == path.end() ? path.size() : size_t(object - path.begin()) + 1 + levels_to_operation(*object);
    }

    /// What rays see a solid is said by the nodes down to it.
    void place_solid(Visit visit) {
        const Mask mask = mask_of_path(out_.scene, visit.path);
        space_ = {visit.to_world, {}};
        auto solid = csg_expression(out_.scene, visit, mask, *this);
        if (!solid) return;
        solid->mask = mask;
        solids_.push_back({std::move(*solid), visit.node, std::move(space_)});
    }

    bool enters(const Visit& visit) override {
        if (visit.path.size() <= kDeepestSolid) return true;
        if (!too_deep_) said_.error(out_.scene.nodes[visit.node.index].from, fmt::format("set operations stand more than {} levels deep in one another", kDeepestSolid));
        too_deep_ = true;
        return false;
    }

    uint32_t place(const Visit& visit, const Transform& to_set) override {
        const size_t before = out_.instances.size();
        place(visit, out_.scene.nodes[visit.node.index]);
        if (out_.instances.size() == before) return kNoId;
        const Geometry& geometry = out_.geometries[out_.instances.back().geometry];
        if (!geometry.mesh && !geometry.bounds.finite()) space_.endless.emplace(uint32_t(before), to_set);
        return uint32_t(before);
    }

    void place_shape(const Visit& visit, const Node& node, ShapeId shape) {
        Transform to_world = visit.to_world;
        if (const auto* mesh = std::get_if<Mesh>(&out_.scene.shapes[shape.index].geometry)) to_world = to_world * Transform::translate(mesh->origin);
        const auto to_local = inverse(to_world);
        if (!to_local) return said_.warning(node.from, "the transform has no inverse: this shape is flat or infinitely large and is left out");
        Instance instance;
        instance.to_world = to_world;
        instance.to_local = *to_local;
        instance.in_place = to_world.is_identity();
        instance.norms = {to_world, *to_local};
        instance.inexact = instance.norms.cost_digits();
        instance.geometry = geometry(shape);
        instance.mask = mask_of_path(out_.scene, visit.path);
        for (const NodeId id : visit.path) {
            const Node& above = out_.scene.nodes[id.index];
            instance.double_illuminate = instance.double_illuminate || above.flags.double_illuminate;
            instance.turned = instance.turned != above.inverse;
            instance.uv_mapped = instance.uv_mapped || above.flags.uv_mapping;
        }
        instance.node = visit.node, instance.object = objects_.number_of(visit.path);
        instance.light_set = groups_.set_of(visit.path);
        const uint32_t slots = slot_count(out_.scene.shapes[shape.index].geometry);
        const size_t carrier = interior_carrier(out_.scene, visit.path);
        const auto interior = carrier ? out_.scene.nodes[visit.path[carrier - 1].index].interior : std::nullopt;
        instance.carrier = carrier ? carrier_at({visit.path.begin(), visit.path.begin() + std::ptrdiff_t(carrier)}) : carriers_++;
        instance.of_whole = carrier <= levels_to_object_;
        if (!instance.of_whole) add_whole_interior(visit.path, instance.object);
        const bool hollow = is_hollow(out_.scene, visit.path, carrier);
        materials_.add_slots(visit.path, slots, interior, hollow, instance);
        instance.uv_mapped = instance.uv_mapped && instance.inside_slot == kNoId;
        if (std::ranges::any_of(visit.path, [this](NodeId id) { return beyond_its_box_[id.index]; })) bounded_.add(uint32_t(out_.instances.size()), visit.path);
        out_.instances.push_back(instance);
    }

    void add_whole_interior(std::vector<NodeId> path, uint32_t object) {
        if (!out_.whole_interiors.empty() && out_.whole_interiors.back().object == object) return;
        path.resize(levels_to_object_);
        path.resize(interior_carrier(out_.scene, path));
        const uint32_t interior = path.empty() ? kNoId : materials_.interior_of_whole(path);
        if (interior != kNoId) out_.whole_interiors.push_back({object, carrier_at(path), interior});
    }

    /// One number for each path to a node that carries an interior.
    uint32_t carrier_at(const std::vector<NodeId>& path) {
        std::vector<uint32_t> key;
        for (const NodeId id : path) key.push_back(id.index);
        const auto [at, added] = carrier_of_.try_emplace(std::move(key), carriers_);
        carriers_ += added;
        return at->second;
    }

    void place_light(const Visit& visit, LightId id) {
        out_.lights.emplace_back(out_.scene.lights[id.index], visit.to_world);
        out_.lights.back().id = id;
        groups_.add_light(visit.path, id);
        if (const auto& object = out_.lights.back().light.projected_through) project(visit, *object);
    }

    void project(const Visit& visit, NodeId object) {
        const Node& node = out_.scene.nodes[object.index];
        auto projector = std::make_unique<Projector>(out_.scene, object, visit.to_world * node.to_parent);
        if (!projector->complete()) said_.error(node.from, "the object that a light is projected through has too many parts");
        out_.projectors.resize(out_.lights.size());
        out_.projectors.back() = std::move(projector);
    }

    uint32_t geometry(ShapeId shape) {
        uint32_t& index = geometry_of_[shape.index];
        if (index != kNoId) return index;
        index = uint32_t(out_.geometries.size());
        Geometry g;
        g.shape = shape;
        g.source = &out_.scene.shapes[shape.index].geometry;
        g.mesh = std::get_if<Mesh>(g.source);
        g.ops = g.mesh ? nullptr : find_shape(*g.source);
        if (!g.mesh) g.bounds = bounds_of(*g.ops, *g.source);
        g.endless = csg_endless(*g.source);
        out_.geometries.push_back(std::move(g));
        return index;
    }

    CompiledScene& out_;
    Diagnostics& said_;
    std::vector<uint32_t> geometry_of_;   // by shape
    size_t solid_depth_ = std::numeric_limits<size_t>::max();   // of the solid whose parts are being passed over
    size_t levels_to_object_ = 0;   // nodes on the path down to the last object
    std::vector<PlacedSolid> solids_;
    SolidSpace space_;          // of the solid that is being placed
    BoundedPaths bounded_;
    bool too_deep_ = false;
    std::map<std::vector<uint32_t>, uint32_t> carrier_of_;
    uint32_t carriers_ = 0;
    MaterialTable materials_;
    LightGroups groups_;
    ObjectNumbers objects_;
    std::vector<bool> beyond_its_box_;     // by node
};

void report_removed(const CompiledScene& scene, const Geometry& g, Diagnostics& said) {
    const size_t removed = g.triangles->stats().removed.size();
    if (!removed) return;
    const ShapeEntry& shape = scene.scene.shapes[g.shape.index];
    said.note(shape.from, fmt::format("mesh '{}': {} of {} triangles have no area or no finite corners and cannot be hit", shape.name, removed, g.mesh->triangles.size()));
}

void describe_leaves(const CompiledScene& scene, CsgExpression& e) {
    if (e.op == CsgOp::leaf && e.leaf.id != kNoId) e.leaf = csg_leaf(scene, e.leaf.id);
    for (CsgExpression& part : e.parts) describe_leaves(scene, part);
}

/// From here on, their parts are not met by themselves. What goes on for ever, as the inverse of a sphere does, is for POV-Ray what it was before it was
/// inverted: a ray that comes from far away enters it.
void build_solids(CompiledScene& out, std::vector<PlacedSolid> solids, Diagnostics& said) {
    const auto narrow = [&out](uint32_t leaf, bool inverted, const Bounds& box) { return narrowed_leaf(out, leaf, inverted, box); };
    for (PlacedSolid& solid : solids) {
        find_cutaways(out, solid.what);
        describe_leaves(out, solid.what);
        out.solids.push_back({CsgTree(solid.what, narrow, own_space(out, solid.space), [&out](uint32_t leaf) { return half_space(out, leaf); }), solid.what.mask});
        if (out.solids.back().tree.levels() > kDeepestTree) said.error(out.scene.nodes[solid.node.index].from, fmt::format("different set operations stand more than {} levels deep in one another", kDeepestTree));
    }
    for (const Solid& solid : out.solids)
        for (const CsgNode& node : solid.tree.nodes()) {
            if (node.op != CsgOp::leaf || node.leaf == kNoId) continue;
            out.instances[node.leaf].bounds = Bounds();
            out.instances[node.leaf].inverted = node.inverted != solid.tree.nodes()[0].far;
            out.instances[node.leaf].turned = solid.tree.nodes()[0].far;
        }
}

/// World-space boxes of instances. A mesh that is shown again and again is looked at more closely.
void place_bounds(CompiledScene& out, int threads) {
    std::vector<uint32_t> shown(out.geometries.size(), 0);
    for (const Instance& instance : out.instances) shown[instance.geometry] += !instance.in_place;
    std::vector<CellBoxes> cells(out.geometries.size());
    parallel_for(out.geometries.size(), threads, [&](size_t i) {
        const Mesh* mesh = out.geometries[i].mesh;
        if (mesh && shown[i] > 1) cells[i] = CellBoxes({mesh->positions, mesh->exact_positions, mesh->triangles});
    });
    for (Instance& instance : out.instances) instance.bounds = cells[instance.geometry].placed(instance.to_world, out.geometries[instance.geometry].bounds);
}

/// Meshes get their accelerators, in parallel, large ones each on several threads; only those that an instance shows. Lazy ones get them when a ray comes near.
void build_structures(CompiledScene& out, const AcceleratorEntry& accel, std::vector<PlacedSolid> solids, const BoundedPaths& bounded, const CompileOptions& options, Diagnostics& said) {
    const AccelOptions build{options.precision, options.isa, options.threads, options.intersect};
    parallel_for(out.geometries.size(), options.threads, [&](size_t i) {
        Geometry& g = out.geometries[i];
        if (!g.mesh) return;
        const TriangleView view{g.mesh->positions, g.mesh->exact_positions, g.mesh->triangles};
        g.triangles = options.lazy ? over_triangles_lazily(accel, view, build) : accel.over_triangles(view, build);
        g.bounds = g.triangles->bounds();
    });
    for (const Geometry& g : out.geometries)
        if (g.mesh) report_removed(out, g, said);
    place_bounds(out, options.threads);
    build_solids(out, std::move(solids), said);
    find_bounds(out, bounded);
    if (out.scene.settings.first_box_shows) {
        out.first_box_shows = has_hierarchy(out);
        out.object_boxes = object_boxes(out);
        bound_object_boxes(out, bounded);
    }
    out.set = std::make_shared<InstanceSet>(out);
    out.top = accel.over_set(out.set, build);
}

/// What a file without lights is lit by: a sky, and a sun over the camera's left shoulder. Said on stderr, so that nobody takes it for the file's.
void default_light(CompiledScene& out, const CompileOptions& options, Diagnostics& said) {
    const bool asked = options.environment || !options.environment_file.empty();
    if (!out.scene.settings.default_light || !out.lights.empty() || out.sky->lights() || out.glows || asked) return;
    said.note({}, "the scene has no light: a white sky of radiance 0.5 and a sun of 2 W/m^2 are added", "--environment FILE or #rgb sets a sky of your own");
    out.sky = std::make_unique<Sky>(Color(0.5), true);
    const Camera& camera = out.cameras.front().camera;
    const Vec3 towards = normalized(normalized(camera.direction) * 2.0 + normalized(camera.right) - normalized(camera.up) * 1.5);
    Light sun;
    sun.name = "default sun";
    sun.kind = DirectionalLight();
    sun.intensity = Color(2);
    Transform turned;
    orthonormal_basis(-towards, turned.linear[0], turned.linear[1]);
    turned.linear[2] = -towards;
    out.lights.emplace_back(sun, turned);
}

void default_camera(CompiledScene& out, Diagnostics& said) {
    if (!out.cameras.empty()) return;
    Bounds bounds;
    for (const Instance& instance : out.instances)
        if (instance.bounds.finite()) bounds.extend(instance.bounds);
    for (const Solid& solid : out.solids)
        if (solid.tree.bounds().finite()) bounds.extend(solid.tree.bounds());
    said.note({}, "the scene has no camera: one is placed that frames everything");
    out.cameras.push_back({framing_camera(bounds)});
}

bool is_air(const CompiledInterior& in) {
    return in.ior == 1 && in.refraction == 1 && !(in.fade_distance > 0) && in.media.empty() && (!std::isfinite(in.attenuation_distance) || in.attenuation_color == Color(1));
}

void choose_kernel(CompiledScene& out, const AcceleratorEntry& accel, const CompileOptions& options, FeatureReasons& reasons) {
    if (out.sky->lights()) reasons.need(kSampledLights, "the sky");
    for (const PlacedLight& l : out.lights)
        if (l.sampled()) reasons.need(kSampledLights, fmt::format("light '{}'", l.light.name));
    out.all_air = !out.scene.atmosphere.is_hazy() && std::all_of(out.interiors.begin(), out.interiors.end(), is_air);
    out.filters_light = (reasons.mask() & (kAlpha | kTransmission)) != 0;
    if (out.filters_light) build_filters(out, accel, {options.precision, options.isa, options.threads});
    if (options.full_kernel) reasons.need(kAllFeatures, "--full-kernel");
    out.features = reasons.mask();
    out.kernel = reasons.text();
}

}  // namespace

CompiledScene::CompiledScene() = default;
CompiledScene::~CompiledScene() = default;

std::shared_ptr<const CompiledScene> compile(Scene scene, const CompileOptions& options, Diagnostics& said) {
    const AcceleratorEntry* accel = find_accelerator(options.accel);
    if (!accel) {
        said.error({}, fmt::format("there is no accelerator '{}'", options.accel), "info --features lists them");
        return nullptr;
    }
    const DefaultFloatMode mode;
    for (const SourceFile& file : scene.files) said.add_file(file.path);
    const Diagnostics checked = validate(scene);
    for (const Diagnostic& d : checked.list())
        if (d.severity == Severity::error) said.add(d);
    if (said.has_errors()) return nullptr;
    report_unrendered(scene, said);
    auto out = std::make_shared<CompiledScene>();
    if (!check_path_count(scene, said)) return nullptr;
    out->scene = deform(std::move(scene));
    Placer placer(*out, said);
    run_on_deep_stack([&] {
        visit_paths(out->scene, [&](const Visit& visit) {
            placer.visit(visit);
            return true;
        }, SiblingOrder::seen_first);
    });
    FeatureReasons reasons;
    compile_materials(*out, options, reasons, said);
    make_missing_tangents(*out, options.threads);
    make_sky(*out, options, said);
    if (said.has_errors()) return nullptr;
    out->intersect = options.intersect;
    run_on_deep_stack([&] { build_structures(*out, *accel, placer.take_solids(), placer.bounded(), options, said); });
    if (said.has_errors()) return nullptr;
    default_camera(*out, said);
    default_light(*out, options, said);
    placer.finish();
    choose_kernel(*out, *accel, options, reasons);
    out->plain_surfaces = plain_surfaces(*out);
    return out;
}

}  // namespace alidade
