// SPDX-License-Identifier: Apache-2.0
/// Renders one scene by one kernel, for kernel_cost_test.py to count its instructions:
///
///   kernel_cost SCENE lean|full     SCENE: plain, or without-FEATURE: everything that the tracer knows but that; plain-without-THING: plain, and less
///   kernel_cost unused lean|full    plain, with everything that a scene can require below hidden nodes
///   kernel_cost list                the scenes, each with its mask and what it does not require (scene/queries.h), separated by ';'
///
/// Prints the mask of the scene and of the kernel, and all bits of the picture.
#include "tests/tracer/unused_features.h"
#include "tracer/compiled_scene.h"

#include <algorithm>
#include <bit>
#include <cstdio>
#include <cstring>

namespace alidade::test {
namespace {

/// What a scene is without, beside features of the kernel.
enum Thing : unsigned { kMeshes = 1, kShapes = 2, kPointLights = 4 };

struct Case {
    const char* name;
    unsigned features;
    unsigned without = 0;
    bool unused = false;   ///< everything is there, and hidden
};

constexpr Case kCases[] = {
    {"plain", 0},
    {"without-textures", kAllFeatures & ~kTextures},
    {"without-alpha", kAllFeatures & ~kAlpha},
    {"without-transmission", kAllFeatures & ~kTransmission},
    {"without-mirrors", kAllFeatures & ~(kMirrors | kTransmission)},   // glass is a mirror too: its roughness is 0
    {"without-area-lights", kAllFeatures & ~kSampledLights},
    {"plain-without-meshes", 0, kMeshes},
    {"plain-without-shapes", 0, kShapes},
    {"without-point-lights", kSampledLights, kPointLights},
    {"unused", 0, 0, true},
};

Mesh bumpy_sphere(int n) {
    Mesh m;
    const auto at = [&](int i, int j) { return uint32_t(i * (2 * n) + j % (2 * n)); };
    for (int i = 0; i <= n; ++i) {
        for (int j = 0; j < 2 * n; ++j) {
            const double theta = kPi * i / n, phi = kPi * j / n, r = 1 + 0.1 * std::sin(5 * theta) * std::cos(7 * phi);
            m.positions.push_back(Vec3f(Vec3(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)) * r));
            if (i < n && i > 0) m.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j)});
            if (i < n - 1) m.triangles.push_back({at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)});
        }
    }
    return m;
}

SignalId checks(SceneBuilder& b) {
    static constexpr const char kPicture[] = "P2\n2 2\n255\n40 230 230 40\n";
    const auto* bytes = reinterpret_cast<const std::byte*>(kPicture);
    b.scene.images.push_back({"checks", "", std::vector<std::byte>(bytes, bytes + sizeof kPicture - 1), {}});
    b.scene.signals.push_back({ImageSignal(), {}});
    return {uint32_t(b.scene.signals.size() - 1)};
}

/// A mesh; or, where there may be none, a box.
ShapeGeometry either(const Case& c, Mesh mesh) { return c.without & kMeshes ? ShapeGeometry(Box{{-1, -1, -1e-3}, {1, 1, 0}}) : ShapeGeometry(std::move(mesh)); }

Scene scene_of(const Case& c) {
    const unsigned features = c.features;
    SceneBuilder b;
    GltfPbr wall = b.pbr(Color(0.7, 0.7, 0.6));
    if (features & kTextures) wall.base_color = checks(b);
    b.object(either(c, square()), b.material(wall), Transform::translate({0, 0.5, -2}) * Transform::scale(Vec3(4, 2.5, 1)));
    if (!(c.without & kShapes)) b.object(Plane{{0, 1, 0}, -1}, b.material(b.pbr(Color(0.5, 0.6, 0.5))));
    b.object(either(c, bumpy_sphere(24)), b.material(b.pbr(Color(0.9, 0.6, 0.3), 0.5, features & kMirrors ? 0.1 : 1)), Transform::translate({-1.2, 0, 0}));
    if (features & kTransmission) b.object(Sphere{{0.6, 0.2, 1}, 0.6}, b.material(b.glass(1.5)));
    GltfPbr pane = b.pbr(Color(0.2, 0.4, 0.9));
    if (features & kAlpha) pane.base_color = b.constant({0.2, 0.4, 0.9, 0.5}), pane.alpha_mode = AlphaMode::blend;
    b.object(either(c, square()), b.material(pane), Transform::translate({1.2, 0.3, 0}) * Transform::scale(Vec3(0.7)));
    if (!(c.without & kPointLights)) b.light(PointLight(), Color(20), Transform::translate({2, 4, 3}));
    if (features & kSampledLights) b.light(AreaLight(), Color(20), Transform::translate({-2, 4, 3}) * Transform::rotate({1, 0, 0}, -0.9));
    b.camera({0.5, 1.2, 6}, {0, 0, 0}, 45);
    if (c.unused)
        for (const UnusedFeature& feature : unused_features())
            if (!feature.as_a_whole) add_feature(b, feature);
    return b.scene;
}

/// All that is counted. By a name that no compiler decorates.
extern "C" [[gnu::noinline]] void kernel_cost_counted(const CompiledScene& scene, const RenderOptions& options, Film& film) { film = render(scene, options).value(); }

int render_case(const Case& c, bool full) {
    CompileOptions options;
    options.full_kernel = full;
    options.threads = 1;
    const auto lean = compiled(scene_of(c)), scene = compiled(scene_of(c), options);
    if (!lean || !scene) return 1;
    RenderOptions o;
    o.width = 40, o.height = 30, o.spp = 1, o.threads = 1;
    Film film;
    kernel_cost_counted(*scene, o, film);
    std::printf("%u %u\n", lean->features, scene->features);
    for (const float value : film.picture.values) std::printf("%08x\n", std::bit_cast<uint32_t>(value));
    return 0;
}

void list(const Case& c) {
    std::printf("%s;%u", c.name, c.features);
    const auto needed = requirements(scene_of(c));
    for (int i = 0; i <= int(Requirement::functions); ++i)
        if (std::none_of(needed.begin(), needed.end(), [i](const RequiredBy& r) { return int(r.what) == i; })) std::printf(";%s", name(Requirement(i)));
    std::printf("\n");
}

int run(int argc, char** argv) {
    if (argc == 2 && std::strcmp(argv[1], "list") == 0) {
        for (const Case& c : kCases) list(c);
        return 0;
    }
    for (const Case& c : kCases)
        if (argc == 3 && std::strcmp(argv[1], c.name) == 0) return render_case(c, std::strcmp(argv[2], "full") == 0);
    return 64;
}

}  // namespace
}  // namespace alidade::test

int main(int argc, char** argv) { return alidade::test::run(argc, argv); }
