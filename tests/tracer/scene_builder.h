// SPDX-License-Identifier: Apache-2.0
/// Small scenes, made in code.
#pragma once

#include "tracer/render.h"

#include <gtest/gtest.h>

namespace alidade::test {

/// Adds to a Scene, one call a thing.
struct SceneBuilder {
    Scene scene;

    SignalId constant(const Vec4& value) {
        scene.signals.push_back({ConstantSignal{value}, {}});
        return {uint32_t(scene.signals.size() - 1)};
    }

    /// Opaque by default: base colour, metallic, roughness.
    GltfPbr pbr(const Color& base, double metallic = 0, double roughness = 1) {
        GltfPbr m;
        m.base_color = constant(Vec4(base, 1));
        m.metallic = constant(Vec4(metallic));
        m.roughness = constant(Vec4(roughness));
        return m;
    }

    /// A perfectly diffuse surface.
    GltfPbr lambert(const Color& base) {
        GltfPbr m = pbr(base);
        m.specular = constant(Vec4(0));
        return m;
    }

    GltfPbr glass(double ior) {
        GltfPbr m = pbr(Color(1), 0, 0);
        m.transmission = constant(Vec4(1));
        m.ior = ior;
        return m;
    }

    MaterialId material(const GltfPbr& layer, std::string name = "m") {
        Material m;
        m.name = std::move(name);
        m.layers.push_back(layer);
        scene.materials.push_back(m);
        return {uint32_t(scene.materials.size() - 1)};
    }

    NodeId node(Node n, bool root = true) {
        scene.nodes.push_back(std::move(n));
        const NodeId id{uint32_t(scene.nodes.size() - 1)};
        if (root) scene.roots.push_back(id);
        return id;
    }

    ShapeId shape(ShapeGeometry geometry) {
        scene.shapes.push_back({"s", std::move(geometry), {}});
        return {uint32_t(scene.shapes.size() - 1)};
    }

    NodeId object(ShapeGeometry geometry, MaterialId material, const Transform& transform = {}) {
        Node n;
        n.what = shape(std::move(geometry));
        n.materials = {material};
        n.to_parent = transform;
        return node(n);
    }

    NodeId light(decltype(Light::kind) kind, const Color& intensity, const Transform& transform = {}) {
        Light l;
        l.kind = kind;
        l.intensity = intensity;
        scene.lights.push_back(l);
        Node n;
        n.what = LightId{uint32_t(scene.lights.size() - 1)};
        n.to_parent = transform;
        return node(n);
    }

    /// Looks from `eye` to `target`, `angle` degrees high and wide.
    void camera(const Vec3& eye, const Vec3& target, double angle = 40, const Vec3& up = {0, 1, 0}) {
        Camera c;
        const Vec3 direction = normalized(target - eye), right = normalized(cross(direction, up));
        const double size = 2 * std::tan(angle / 2 * kPi / 180);
        c.location = eye;
        c.direction = direction;
        c.right = right * size;
        c.up = cross(right, direction) * size;
        scene.cameras.push_back(c);
        Node n;
        n.what = CameraId{uint32_t(scene.cameras.size() - 1)};
        node(n);
    }
};

/// A square of side 2 in the xy plane that faces +z, as two triangles.
inline Mesh square() {
    Mesh m;
    m.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    m.triangles = {{0, 1, 2}, {0, 2, 3}};
    m.uvs.resize(1);
    m.uvs[0].values = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    return m;
}

inline std::shared_ptr<const CompiledScene> compiled(const Scene& scene, const CompileOptions& options = {}) {
    Diagnostics said;
    auto out = compile(scene, options, said);
    EXPECT_TRUE(out) << said.text();
    return out;
}

inline Film rendered(const Scene& scene, const RenderOptions& options, const CompileOptions& compile_options = {}) {
    const auto c = compiled(scene, compile_options);
    if (!c) return {};
    auto film = render(*c, options);
    EXPECT_TRUE(film) << film.error();
    return film ? std::move(*film) : Film{};
}

/// A picture of one pixel a side `size`, one ray through each centre.
inline RenderOptions centre_rays(int size, std::vector<std::string> aovs = {}) {
    RenderOptions o;
    o.width = o.height = size;
    o.spp = 1;
    o.threads = 1;
    o.aovs = std::move(aovs);
    return o;
}

/// The value of channel `name` at a pixel.
inline double value(const Picture& p, int x, int y, const std::string& name) {
    for (int c = 0; c < p.channels; ++c)
        if (p.names[size_t(c)] == name) return p.at(x, y)[c];
    ADD_FAILURE() << "no channel " << name;
    return 0;
}

}  // namespace alidade::test
