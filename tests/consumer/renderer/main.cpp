// SPDX-License-Identifier: Apache-2.0
/// A scene made in code, rendered in memory: a red sphere, a light beside the camera, and nothing behind.
#include "scene/queries.h"
#include "tracer/render.h"

#include <cmath>
#include <cstdio>

using namespace alidade;

namespace {

NodeId add_node(Scene& scene, Node node) {
    scene.nodes.push_back(std::move(node));
    scene.roots.push_back(NodeId{uint32_t(scene.nodes.size() - 1)});
    return scene.roots.back();
}

/// Red has a base colour of 0.8, the other channels none: they show the highlight alone.
Scene red_sphere() {
    Scene scene;
    scene.signals.push_back({ConstantSignal{Vec4(0.8, 0, 0, 1)}, {}});
    GltfPbr red;
    red.base_color = SignalId{0};
    Material material;
    material.layers.emplace_back(red);
    scene.materials.push_back(material);

    scene.shapes.push_back({"ball", Sphere{Vec3(0, 0, -5), 1}, {}});
    Node ball;
    ball.what = ShapeId{0};
    ball.materials = {MaterialId{0}};
    add_node(scene, ball);

    Light sun;
    sun.kind = DirectionalLight{};
    sun.intensity = Color(2);
    scene.lights.push_back(sun);
    Node shining;
    shining.what = LightId{0};
    add_node(scene, shining);

    Camera camera;
    camera.right = Vec3(4.0 / 3, 0, 0);
    scene.cameras.push_back(camera);
    Node looking;
    looking.what = CameraId{0};
    add_node(scene, looking);
    return scene;
}

}  // namespace

int main() {
    const Scene scene = red_sphere();
    const Diagnostics problems = validate(scene);
    Diagnostics said;
    const auto compiled = compile(scene, {}, said);
    if (problems.has_errors() || !compiled) {
        std::printf("%s%s", problems.text().c_str(), said.text().c_str());
        return 1;
    }
    RenderOptions options;
    options.width = 32, options.height = 24, options.spp = 1;
    options.aovs = {"coverage"};
    const auto film = render(*compiled, options);
    if (!film) {
        std::printf("%s\n", film.error().c_str());
        return 1;
    }
    const float* center = film->picture.at(16, 12);
    const float* corner = film->picture.at(0, 0);
    const float* mirrored = film->picture.at(15, 12);
    std::printf("center %g %g %g %g, corner coverage %g\n", double(center[0]), double(center[1]), double(center[2]), double(center[3]), double(corner[3]));
    const bool lit = center[0] > 0.1f && center[0] > 3 * center[1] && center[3] == 1;
    const bool symmetric = std::abs(center[0] - mirrored[0]) < 1e-5f;
    return lit && symmetric && corner[3] == 0 ? 0 : 1;
}
