// SPDX-License-Identifier: Apache-2.0
#include "tools/stress/from_scene.h"

#include "scene/queries.h"
#include "tracer/cameras.h"

#include <fmt/format.h>

namespace alidade {

namespace {

/// More paths than this are a mistake of the file: each takes a place of 200 bytes, in each structure.
constexpr double kMostPaths = 1e7;

class Gatherer {
  public:
    Gatherer(const Scene& scene, Diagnostics& said) : scene_(scene), said_(said), mesh_of_(scene.shapes.size(), kNoId) { out_.meshes.clear(); }

    void visit(const Visit& visit) {
        const Node& node = scene_.nodes[visit.node.index];
        if (const auto* shape = std::get_if<ShapeId>(&node.what)) place(*shape, visit.to_world);
        else if (const auto* light = std::get_if<LightId>(&node.what)) add_lamp(scene_.lights[light->index], visit.to_world);
        else if (const auto* camera = std::get_if<CameraId>(&node.what); camera && !camera_) camera_ = placed(scene_.cameras[camera->index], visit.to_world);
    }

    StressScene finish() {
        if (flat_) said_.note({}, fmt::format("{} meshes are left out: their transforms have no inverse", flat_));
        if (nowhere_) said_.note({}, fmt::format("{} lights are left out: they shine from nowhere", nowhere_));
        if (other_) said_.note({}, fmt::format("{} closed forms are left out: only triangles are measured", other_), "`alidade convert SCENE out.glb` makes meshes of them");
        if (out_.lamps.empty() && !out_.places.empty()) add_default_lamp();
        if (out_.places.size() == 1 && out_.places[0].to_world.is_identity()) out_.places.clear();
        return std::move(out_);
    }
    size_t closed_forms() const { return other_; }

    Camera camera() const { return camera_ ? *camera_ : framing_camera(bounds_); }

  private:
    void place(ShapeId id, Transform to_world) {
        const ShapeGeometry& geometry = scene_.shapes[id.index].geometry;
        const Mesh* mesh = std::get_if<Mesh>(&geometry);
        if (!mesh) return void(++other_);
        if (mesh->triangles.empty()) return;
        to_world = to_world * Transform::translate(mesh->origin);
        if (!inverse(to_world)) return void(++flat_);
        if (mesh_of_[id.index] == kNoId) {
            mesh_of_[id.index] = uint32_t(out_.meshes.size());
            out_.meshes.push_back({mesh->positions, mesh->exact_positions, mesh->triangles});
            boxes_.push_back(bounds_of(*mesh));
        }
        out_.places.push_back({to_world, mesh_of_[id.index]});
        if (const Bounds box = to_world.bounds(boxes_[mesh_of_[id.index]]); box.finite()) bounds_.extend(box);
    }

    static Bounds bounds_of(const Mesh& mesh) {
        Bounds box;
        for (const Vec3f& p : mesh.positions) box.extend(Vec3(p));
        return box;
    }

    void add_lamp(const Light& light, const Transform& to_world) {
        const bool far = std::holds_alternative<DirectionalLight>(light.kind);
        const Vec3 place = far ? -normalized(to_world.vector(Vec3(0, 0, -1))) : to_world.point(Vec3(0));
        if (is_finite(place)) out_.lamps.push_back({place, far});
        else ++nowhere_;
    }

    /// As a scene without lights is rendered.
    void add_default_lamp() {
        const Camera c = camera();
        said_.note({}, "the scene has no light: shadow rays go to a sun over the camera's left shoulder");
        out_.lamps.push_back({-normalized(normalized(c.direction) * 2.0 + normalized(c.right) - normalized(c.up) * 1.5), true});
    }

    const Scene& scene_;
    Diagnostics& said_;
    std::vector<uint32_t> mesh_of_;   // by shape
    StressScene out_;
    std::optional<Camera> camera_;
    std::vector<Bounds> boxes_;       // of the meshes
    Bounds bounds_;
    size_t other_ = 0, flat_ = 0, nowhere_ = 0;
};

std::vector<StressRay> rays_of(const Camera& camera, size_t side) {
    const CameraRays rays(camera, int(side), int(side));
    std::vector<StressRay> out;
    for (size_t i = 0; i < side * side; ++i) {
        const Ray ray = rays.at(double(i % side) + 0.5, double(i / side) + 0.5);
        out.push_back({Vec3(Vec3f(ray.origin)), Vec3(Vec3f(ray.dir)), std::max(0.0, ray.tmin), ray.tmax});
    }
    return out;
}

}  // namespace

std::optional<StressSubject> stress_subject(Scene scene, const std::string& path, size_t side, Diagnostics& said) {
    const Diagnostics checked = validate(scene);
    for (const Diagnostic& d : checked.list())
        if (d.severity == Severity::error) said.add(d);
    if (checked.has_errors()) return std::nullopt;
    const uint32_t file = said.add_file(path);
    if (path_count(scene) > kMostPaths) {
        said.error({file, 0, 0, {}}, fmt::format("the scene has more than {:g} paths from a root to a node", kMostPaths));
        return std::nullopt;
    }
    scene = deform(std::move(scene));
    Gatherer gatherer(scene, said);
    visit_paths(scene, [&](const Visit& visit) {
        gatherer.visit(visit);
        return true;
    });
    StressSubject subject;
    subject.scene = gatherer.finish();
    if (subject.scene.meshes.empty()) {
        said.error({file, 0, 0, {}}, "the scene has no triangles", gatherer.closed_forms() ? "`alidade convert SCENE out.glb` makes meshes of its closed forms" : "");
        return std::nullopt;
    }
    subject.primary = rays_of(gatherer.camera(), side);
    return subject;
}

}  // namespace alidade
