// SPDX-License-Identifier: Apache-2.0
/// Small scenes for the rows' cases.
#pragma once

#include "scene/scene.h"

#include <utility>

namespace alidade::numerics {

/// Adds to a Scene, one call a thing.
struct SceneMaker {
    Scene scene;

    SignalId constant(const Vec4& value) {
        scene.signals.push_back({ConstantSignal{value}, {}});
        return {uint32_t(scene.signals.size() - 1)};
    }

    template <class Layer> MaterialId material(Layer layer) {
        scene.materials.push_back({{}, {std::move(layer)}, {}});
        return {uint32_t(scene.materials.size() - 1)};
    }

    /// What glows by itself alone: its colour is seen, whatever the light.
    MaterialId unlit(const Color& color) {
        GltfPbr m;
        m.base_color = constant(Vec4(color, 1)), m.unlit = true;
        return material(m);
    }

    /// Without a parent: a root.
    uint32_t node(Node node, uint32_t parent = kNoId) {
        const NodeId id{uint32_t(scene.nodes.size())};
        scene.nodes.push_back(std::move(node));
        (parent == kNoId ? scene.roots : scene.nodes[parent].children).push_back(id);
        return id.index;
    }

    uint32_t object(ShapeGeometry geometry, MaterialId material, const Transform& place = {}, uint32_t parent = kNoId) {
        scene.shapes.push_back({"", std::move(geometry), {}});
        Node n;
        n.what = ShapeId{uint32_t(scene.shapes.size() - 1)}, n.materials = {material}, n.to_parent = place;
        return node(std::move(n), parent);
    }

    void light(Light light, const Transform& place) {
        scene.lights.push_back(std::move(light));
        Node n;
        n.what = LightId{uint32_t(scene.lights.size() - 1)}, n.to_parent = place;
        node(std::move(n));
    }

    /// Parallel rays along the unit `direction` through a square window of that side.
    void camera(const Vec3& location, const Vec3& direction, double side) {
        Camera c;
        c.projection = Projection::orthographic, c.location = location, c.direction = direction;
        orthonormal_basis(direction, c.right, c.up);
        c.right *= side, c.up *= side;
        scene.cameras.push_back(c);
        Node n;
        n.what = CameraId{uint32_t(scene.cameras.size() - 1)};
        node(std::move(n));
    }
};

}  // namespace alidade::numerics
