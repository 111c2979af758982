// SPDX-License-Identifier: Apache-2.0
/// Structures that are built where rays come: a scene costs what is seen of it, and shows what it shows anyway.
#include "tests/tracer/scene_builder.h"

#include <cstring>

namespace alidade::test {
namespace {

constexpr int kMeshes = 100, kSeen = 10;

Mesh bumpy(int n, double phase) {
    Mesh m;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            const double x = 2.0 * i / n - 1, y = 2.0 * j / n - 1;
            m.positions.push_back(Vec3f(Vec3(x, y, 0.1 * std::sin(9 * x + phase) * std::cos(7 * y))));
            const auto at = uint32_t(j * (n + 1) + i), above = at + uint32_t(n) + 1;
            if (i < n && j < n) m.triangles.push_back({at, at + 1, above}), m.triangles.push_back({at + 1, above + 1, above});
        }
    return m;
}

/// Meshes in a row, each its own; the camera looks at the first ten, and the lamp stands beside it: no shadow ray comes near the others.
Scene row_of_meshes() {
    SceneBuilder b;
    const MaterialId grey = b.material(b.pbr(Color(0.7), 0, 1));
    for (int i = 0; i < kMeshes; ++i) b.object(bumpy(12, i), grey, Transform::translate({2.5 * i, 0, 0}));
    b.light(PointLight(), Color(300), Transform::translate({11, 0, 20}));
    b.camera({11.25, 0, 20}, {11.25, 0, 0}, 62);
    return b.scene;
}

RenderOptions small(int threads) {
    RenderOptions o;
    o.width = 64, o.height = 64, o.spp = 2, o.threads = threads;
    return o;
}

size_t structure_bytes(const CompiledSummary& s) {
    size_t bytes = 0;
    for (size_t i = 1; i < s.structures.size(); ++i) bytes += s.structures[i].second.bytes;   // the first stands over the instances
    return bytes;
}

TEST(Lazy, ATenthThatIsSeenIsATenthThatIsBuilt) {
    const auto eager = compiled(row_of_meshes());
    const Film wanted = *render(*eager, small(1));
    CompileOptions options;
    options.lazy = true;
    for (const char* accel : {"auto", "grid", "octree"})
        for (const int threads : {1, 4}) {
            options.accel = accel;
            const auto lazy = compiled(row_of_meshes(), options);
            EXPECT_EQ(summary(*lazy).waiting, size_t(kMeshes));
            EXPECT_LT(structure_bytes(summary(*lazy)), structure_bytes(summary(*eager)) / 20) << "before a ray, boxes alone";
            const Film film = *render(*lazy, small(threads));
            const CompiledSummary after = summary(*lazy);
            EXPECT_GE(after.waiting, size_t(kMeshes) * 85 / 100) << accel;
            EXPECT_LE(after.waiting, size_t(kMeshes - kSeen));
            CompileOptions same = options;
            same.lazy = false;
            EXPECT_LE(double(structure_bytes(after)), 0.15 * double(structure_bytes(summary(*compiled(row_of_meshes(), same))))) << accel;
            ASSERT_EQ(film.picture.values.size(), wanted.picture.values.size());
            EXPECT_EQ(std::memcmp(film.picture.values.data(), wanted.picture.values.data(), wanted.picture.values.size() * sizeof(float)), 0) << accel << ", " << threads << " threads";
            EXPECT_EQ(film.stats.shadow_rays, wanted.stats.shadow_rays);
        }
    EXPECT_GT(wanted.stats.shadow_rays, 500u) << "something is seen";
}

/// What is seen twice is built once, and lights through glass and solids of meshes ask for theirs, too.
TEST(Lazy, ShowsEverythingThatTheOthersShow) {
    SceneBuilder b;
    const NodeId first = b.object(bumpy(8, 1), b.material(b.pbr(Color(0.9, 0.6, 0.3), 1, 0.1)), Transform::translate({-1.2, 0, 0}));
    Node copy = b.scene.nodes[first.index];
    copy.to_parent = Transform::translate({1.2, 0, -1}) * Transform::rotate({0, 1, 0}, 0.7);
    b.node(copy);
    GltfPbr pane = b.pbr(Color(0.2, 0.4, 0.9));
    pane.base_color = b.constant({0.2, 0.4, 0.9, 0.5}), pane.alpha_mode = AlphaMode::blend;
    b.object(bumpy(5, 2), b.material(pane), Transform::translate({0.3, 0.3, 1.8}) * Transform::scale(Vec3(0.5)));
    b.object(bumpy(5, 3), b.material(b.glass(1.5)), Transform::translate({-0.6, 0.3, 1.8}) * Transform::scale(Vec3(0.5)));
    b.object(Plane{{0, 1, 0}, -1}, b.material(b.pbr(Color(0.7, 0.7, 0.6), 0, 0.4)));
    b.light(PointLight(), Color(20), Transform::translate({2, 4, 3}));
    b.camera({0.5, 1.2, 6}, {0, 0, 0}, 45);
    const Film wanted = rendered(b.scene, small(1));
    CompileOptions options;
    options.lazy = true;
    for (const int threads : {1, 2, 5}) {
        const auto lazy = compiled(b.scene, options);
        const Film film = *render(*lazy, small(threads));
        EXPECT_EQ(film.picture.values, wanted.picture.values);
        EXPECT_EQ(summary(*lazy).waiting, 0u);
        EXPECT_EQ(film.stats.work.boxes, wanted.stats.work.boxes);
    }
}

}  // namespace
}  // namespace alidade::test
