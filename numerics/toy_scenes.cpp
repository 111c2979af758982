// SPDX-License-Identifier: Apache-2.0
#include "numerics/toy_scenes.h"

#include "numerics/shape_samples.h"

#include <fmt/format.h>

#include <array>

namespace alidade::numerics {

namespace {

constexpr size_t kSurfaces = 5;
constexpr std::array<const char*, kSurfaces> kSurfaceNames{"diffuse and highlight", "mirror", "coloured glass", "POV-Ray's patterns", "POV-Ray's glass"};

Mesh tetrahedron() {
    Mesh m;
    m.positions = {{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}};
    m.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    return m;
}

class Toy {
  public:
    Toy(double scale, const Vec3& offset, bool baked) : scale_(scale), baked_(baked ? scale : 1) {
        Node root;
        if (!baked) root.to_parent = Transform::translate(offset) * Transform::scale(Vec3(scale));
        scene_.nodes.push_back(root), scene_.roots.push_back({0});
        scene_.settings.max_depth = 5, scene_.settings.shadow_clearance = 0.001 * scale;
    }

    void surroundings() {
        object(Box{Vec3(-4, -1.6, -4), Vec3(4, -1.5, 4)}, pov_material({0.5, 0.7, 0.9}));
        const MaterialId far = material(0);
        object(Sphere{Vec3(0), 60}, far);   // light goes on for ever nowhere: a fog ends at a distance that no scale changes
        scene_.nodes.back().flags.hollow = true;
        light({2, 4.3, 3}, 40, true), light({-3, 3, 2}, 0.4, false);
        Fog fog;
        fog.distance = 40 * scale_, fog.color = Color(0.3, 0.4, 0.5);
        scene_.atmosphere.fogs.push_back(fog);
        Camera camera;
        camera.location = Vec3(1.03, 1.21, 5) * baked_, camera.direction = normalized(Vec3(-1.01, -1.24, -5)), camera.right = {0.8, 0, 0}, camera.up = {0, 0.6, 0};
        scene_.cameras.push_back(camera);
        Node node;
        node.what = CameraId{0};
        add(std::move(node), 0);
    }

    MaterialId material(size_t surface) {
        if (surface == 3) return pov_material({0.9, 0.6, 0.3});
        if (surface == 4) return pov_glass();
        GltfPbr m;
        m.base_color = constant(surface == 2 ? Vec4(0.8, 1, 0.9, 1) : Vec4(0.7, 0.5, 0.3, 1));
        m.metallic = constant(Vec4(surface == 1 ? 1 : 0)), m.roughness = constant(Vec4(surface == 0 ? 0.4 : 0));
        if (surface == 2) m.transmission = constant(Vec4(1));
        return push({{}, {m}, {}});
    }

    void object(ShapeGeometry geometry, MaterialId material, uint32_t parent = 0) {
        if (auto* mesh = std::get_if<Mesh>(&geometry))
            for (Vec3f& p : mesh->positions) p *= float(baked_);
        scene_.shapes.push_back({"", placed(std::move(geometry), baked_, Vec3(0)), {}});
        Node node;
        node.what = ShapeId{uint32_t(scene_.shapes.size() - 1)};
        node.materials = {material};
        node.interior = interior_;
        add(std::move(node), parent);
    }

    /// A sphere less a box.
    void solid(MaterialId material) {
        Node node;
        node.csg = CsgKind::difference;
        const uint32_t at = add(std::move(node), 0);
        object(Sphere(), material, at), object(Box{Vec3(0, 0, 0), Vec3(2, 2, 2)}, material, at);
    }

    void clear_interior() {
        Interior inside;
        inside.ior = 1.4, inside.attenuation_color = {0.7, 0.9, 0.8}, inside.attenuation_distance = scale_;
        inside.fade_distance = 2 * scale_, inside.fade_power = 1.5, inside.fade_color = {0.9, 0.4, 0.2};
        scene_.interiors.push_back(inside);
        interior_ = InteriorId{0};
    }

    Scene take() { return std::move(scene_); }

  private:
    uint32_t add(Node node, uint32_t parent) {
        scene_.nodes.push_back(std::move(node));
        scene_.nodes[parent].children.push_back({uint32_t(scene_.nodes.size() - 1)});
        return uint32_t(scene_.nodes.size() - 1);
    }
    SignalId push(decltype(Signal::what) what) {
        scene_.signals.push_back({std::move(what), {}});
        return {uint32_t(scene_.signals.size() - 1)};
    }
    MaterialId push(Material m) {
        scene_.materials.push_back(std::move(m));
        return {uint32_t(scene_.materials.size() - 1)};
    }
    SignalId constant(const Vec4& value) { return push(ConstantSignal{value}); }

    MaterialId pov_material(const Color& color) {
        PatternSignal bozo;
        bozo.pattern = "bozo";
        bozo.map = {{0, constant(Vec4(color, 1))}, {1, constant(Vec4(0.2, 0.2, 0.3, 1))}};
        bozo.turbulence.amount = Vec3(0.5), bozo.warps = {{WarpKind::transform, Transform::scale(Vec3(baked_)), {}}};
        ReliefSignal bumps;
        bumps.pattern.pattern = "bumps", bumps.pattern.warps = bozo.warps;
        PovFinish f;
        f.pigment = push(bozo), f.normal = push(bumps);
        f.phong = 0.5, f.specular = 0.3, f.reflection_min = f.reflection_max = Color(0.2);
        return push({{}, {f}, {}});
    }

    MaterialId pov_glass() {
        PovFinish f;
        f.pigment = push(ConstantSignal{Vec4(0.9, 0.8, 0.7, 1), 0.85, 0}), f.ambient = Color(0), f.diffuse = 0.1;
        f.specular = 0.8, f.reflection_min = Color(0), f.reflection_max = Color(1), f.reflection_fresnel = true, f.conserve_energy = true;
        return push({{}, {f}, {}});
    }

    void light(const Vec3& at, double intensity, bool physical) {
        Light light;
        light.intensity = Color(intensity * (physical ? scale_ * scale_ : 1));
        light.inverse_square = physical;
        if (!physical) light.fade = LightFade{4 * scale_, 2}, light.clearance = 0.001 * scale_;
        scene_.lights.push_back(light);
        Node node;
        node.what = LightId{uint32_t(scene_.lights.size() - 1)}, node.to_parent = Transform::translate(at * baked_);
        add(std::move(node), 0);
    }

    double scale_, baked_;   ///< of the world; of what has no transform above it
    Scene scene_;
    std::optional<InteriorId> interior_;
};

size_t form_count() { return shapes().size() + 2; }

}  // namespace

size_t toy_scene_count() { return form_count() * kSurfaces; }

std::string toy_scene_name(size_t number) {
    const size_t form = number / kSurfaces;
    const char* what = form < shapes().size() ? shapes()[form].name : form == shapes().size() ? "mesh" : "difference";
    return fmt::format("{}, {}", what, kSurfaceNames[number % kSurfaces]);
}

namespace {

Scene furnished(Toy toy, size_t number) {
    toy.surroundings();
    const size_t form = number / kSurfaces, surface = number % kSurfaces;
    const MaterialId material = toy.material(surface);
    if (surface == 2 || surface == 4) toy.clear_interior();
    if (form < shapes().size()) toy.object(default_shape(shapes()[form].kind), material);
    else if (form == shapes().size()) toy.object(tetrahedron(), material);
    else toy.solid(material);
    return toy.take();
}

}  // namespace

Scene toy_scene(size_t number, double scale, const Vec3& offset) { return furnished(Toy(scale, offset, false), number); }
Scene baked_toy_scene(size_t number, double scale) { return furnished(Toy(scale, Vec3(0), true), number); }

ShapeGeometry toy_shape(size_t row) { return default_shape(shapes()[row].kind); }

Scene toy_shapes(std::vector<PlacedToy> shapes) {
    Scene scene;
    scene.signals.push_back({ConstantSignal{Vec4(0.5)}, {}});
    GltfPbr matte;
    matte.base_color = SignalId{0};
    scene.materials.push_back({{}, {matte}, {}});
    for (PlacedToy& shape : shapes) {
        scene.shapes.push_back({"", std::move(shape.geometry), {}});
        Node node;
        node.to_parent = shape.to_world;
        node.what = ShapeId{uint32_t(scene.shapes.size() - 1)};
        node.materials = {MaterialId{0}};
        scene.nodes.push_back(std::move(node)), scene.roots.push_back({uint32_t(scene.nodes.size() - 1)});
    }
    return scene;
}

Picture toy_picture(const Scene& scene, CompileOptions compile_options, RenderOptions options) {
    Diagnostics said;
    if (compile_options.threads == 0) compile_options.threads = 1;
    const auto compiled = compile(scene, compile_options, said);
    if (!compiled) return {};
    options.width = 40, options.height = 30, options.spp = 1;
    if (options.threads == 0) options.threads = 1;   // cases are what threads share
    auto film = render(*compiled, options);
    return film ? std::move(film->picture) : Picture();
}

}  // namespace alidade::numerics
