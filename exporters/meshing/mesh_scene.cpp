// SPDX-License-Identifier: Apache-2.0
#include "exporters/meshing/mesh_scene.h"

#include "eval/csg_expression.h"
#include "eval/shapes/shape_ops.h"
#include "eval/solid_query.h"
#include "exporters/meshing/dual_contouring.h"
#include "exporters/meshing/shape_mesh.h"
#include "exporters/meshing/unreached.h"
#include "exporters/shown_nodes.h"

#include <fmt/format.h>

#include <algorithm>

namespace alidade::meshing {
namespace {

/// An endless plane is cut to this many times the size of the rest.
constexpr double kPlaneSize = 10;

bool is_mesh(const Scene& scene, ShapeId shape) { return std::holds_alternative<Mesh>(scene.shapes[shape.index].geometry); }

/// Everything bounded, and the cameras. Where all is endless, the middle is at 0.
Bounds region_of(const Scene& scene) {
    Bounds box = world_bounds(scene);
    const bool endless = box.empty();
    visit_shown_nodes(scene, [&](NodeId id, const Transform& to_world) {
        const auto* camera = std::get_if<CameraId>(&scene.nodes[id.index].what);
        const Vec3 at = camera ? to_world.point(scene.cameras[camera->index].location) : Vec3(kInf);
        if (!is_finite(at)) return true;
        box.extend(at);
        if (endless) box.extend(-at);
        return true;
    });
    if (box.empty() || !(max_component(box.extent()) > 0)) {
        const Vec3 middle = box.empty() ? Vec3(0) : box.center();
        return {middle - Vec3(1.0), middle + Vec3(1.0)};
    }
    const Vec3 half(max_component(box.extent()) / 2);   // a cube: what is flat has a size, too
    return {box.center() - half, box.center() + half};
}

Bounds scaled(const Bounds& box, double factor) { return {box.center() - factor / 2 * box.extent(), box.center() + factor / 2 * box.extent()}; }

/// The surfaces of a query as lines meet them, with a slot for each material.
class QueriedSurface {
  public:
    explicit QueriedSurface(const SolidQuery& query) : query_(query) {}

    std::vector<LineCrossing> crossings(const Vec3& origin, const Vec3& span) {
        Ray ray{origin, span};
        ray.tmin = 0, ray.tmax = 1;
        found_.clear();
        query_.all(ray, found_);
        std::vector<LineCrossing> out;
        for (const FoundSurface& surface : found_) out.push_back({surface.t, surface.normal, slot_of(query_.material(surface))});
        return out;
    }

    std::vector<std::optional<MaterialId>> materials;   ///< by slot

  private:
    uint32_t slot_of(const std::optional<MaterialId>& material) {
        const auto known = std::find(materials.begin(), materials.end(), material);
        if (known == materials.end()) return materials.push_back(material), uint32_t(materials.size() - 1);
        return uint32_t(known - materials.begin());
    }

    const SolidQuery& query_;
    std::vector<FoundSurface> found_;
};

class SceneMesher {
  public:
    SceneMesher(const Scene& scene, int segments, Losses& losses)
        : scene_(scene), segments_(segments), losses_(losses), out_(scene), accelerators_(scene), region_(region_of(scene)), done_(scene.shapes.size()) {}

    tl::expected<Scene, std::string> make() {
        visit_shown_nodes(scene_, [&](NodeId id, const Transform& to_world) { return !too_many() && visit(id, to_world); });
        if (too_many())
            return tl::unexpected(fmt::format("the scene's shapes become more than {} triangles: fewer --segments make fewer", kMostMadeTriangles));
        return without_unreached(std::move(out_), scene_);
    }

  private:
    bool too_many() const { return triangles_ > kMostMadeTriangles; }

    /// True if there is more below.
    bool visit(NodeId id, const Transform& to_world) {
        const Node& node = scene_.nodes[id.index];
        if (is_solid(node)) return mesh_solid(id, to_world), false;
        const auto* shape = std::get_if<ShapeId>(&node.what);
        if (shape && !is_mesh(scene_, *shape) && !done_[shape->index]) mesh_shape(*shape, to_world);
        return true;
    }

    void mesh_shape(ShapeId id, const Transform& to_world) {
        done_[id.index] = true;
        const ShapeGeometry& geometry = scene_.shapes[id.index].geometry;
        const bool endless = !bounds(geometry).finite();
        losses_.add("endless shapes", endless, "cut near the rest of the scene");
        const bool has_inner_sheets = std::holds_alternative<Torus>(geometry) && !find_shape(geometry)->solid(geometry);
        losses_.add("the inner sheets of tori whose tubes overlap themselves", has_inner_sheets, "the outer sheets alone");
        auto made = shape_mesh(geometry, segments_, local_region(to_world, kPlaneSize));
        if (made) losses_.add("spheres, planes, boxes and other closed forms", 1, fmt::format("meshes of {} segments a circle", segments_));
        else made = contour_shape(id, to_world);
        replace(id, *made);
    }

    /// A shape alone, in its own space.
    TriangleList contour_shape(ShapeId id, const Transform& to_world) {
        const ShapeGeometry& geometry = scene_.shapes[id.index].geometry;
        if (std::holds_alternative<Polygon>(geometry)) {
            losses_.add("polygons of too many corners", 1, "nothing");   // a face without an inside has no crossings of two signs
            return {};
        }
        const bool text = std::holds_alternative<Extrusion>(geometry);
        losses_.add(text ? "texts of too many corners" : "quadrics and polynomials", 1, fmt::format("meshes of {} cells along their longest side", segments_));
        Scene alone;
        alone.shapes.push_back(scene_.shapes[id.index]);
        alone.nodes.emplace_back().what = ShapeId{0};
        alone.roots.push_back(NodeId{0});
        MeshAccelerators none(alone);
        const SolidQuery query(alone, NodeId{0}, none);
        QueriedSurface surface(query);
        Bounds box = query.bounds();
        if (!box.finite()) box = intersection(box, local_region(to_world, 1));
        return contour(box, surface);
    }

    TriangleList contour(const Bounds& box, QueriedSurface& surface) const {
        return dual_contour(box, segments_, [&](const Vec3& origin, const Vec3& span) { return surface.crossings(origin, span); });
    }

    void mesh_solid(NodeId id, const Transform& to_world) {
        const SolidQuery whole(scene_, id, accelerators_, Transform()), unclipped(scene_, id, accelerators_, Transform(), false);
        QueriedSurface surface(unclipped);
        Bounds box = whole.bounds();
        const bool endless = !box.empty() && !box.finite();
        if (endless) box = intersection(box, local_region(to_world, 1));
        TriangleList made = contour(box, surface);
        for (const NodeId clip : scene_.nodes[id.index].clips) {
            const SolidQuery within(scene_, clip, accelerators_, scene_.nodes[clip.index].to_parent);
            made = made.cut([&](const Vec3& point) { return within.inside(point); });
        }
        losses_.add("solids (intersections, differences, merges, clips)", 1, fmt::format("meshes of {} cells along their longest side", segments_));
        losses_.add("endless shapes", endless, "cut near the rest of the scene");
        losses_.add("solids in which no surface was found", made.size() == 0);
        Node& node = out_.nodes[id.index];
        node.what = ShapeId{uint32_t(out_.shapes.size())};
        node.materials = std::move(surface.materials);
        node.children.clear(), node.clips.clear();
        node.csg = CsgKind::none, node.inverse = false;
        out_.shapes.push_back({node.name, Mesh(), node.from});
        replace(std::get<ShapeId>(node.what), made);
    }

    void replace(ShapeId id, const TriangleList& made) {
        triangles_ += made.size();
        out_.shapes[id.index].geometry = made.mesh();
    }

    Bounds local_region(const Transform& to_world, double factor) const {
        const auto to_local = inverse(to_world);
        return to_local ? to_local->bounds(scaled(region_, factor)) : scaled(region_, factor);
    }

    const Scene& scene_;
    int segments_;
    Losses& losses_;
    Scene out_;
    MeshAccelerators accelerators_;
    Bounds region_;
    std::vector<bool> done_;
    size_t triangles_ = 0;
};

}  // namespace

bool needs_meshes(const Scene& scene) {
    bool needed = false;
    visit_shown_nodes(scene, [&](NodeId id, const Transform&) {
        const Node& node = scene.nodes[id.index];
        const auto* shape = std::get_if<ShapeId>(&node.what);
        needed = needed || is_solid(node) || (shape && !is_mesh(scene, *shape));
        return !needed;
    });
    return needed;
}

tl::expected<Scene, std::string> mesh_scene(const Scene& scene, int segments, Losses& losses) { return SceneMesher(scene, segments, losses).make(); }

}  // namespace alidade::meshing
