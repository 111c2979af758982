// SPDX-License-Identifier: Apache-2.0
/// What is there and not used, or switched off, changes no bit of a picture and nothing of what is built: of every feature that a scene can require.
/// What it costs to trace is counted by kernel_cost_test.py.
#include "tests/tracer/unused_features.h"

#include "tracer/compiled_scene.h"

#include <algorithm>
#include <cstring>
#include <tuple>

namespace alidade::test {
namespace {

SceneBuilder plain() {
    SceneBuilder b;
    Mesh m = square();
    m.positions[2].z = 0.5f;
    b.object(m, b.material(b.pbr(Color(0.9, 0.6, 0.3))), Transform::translate({0.4, 0, 0}));
    b.object(Plane{{0, 1, 0}, -1}, b.material(b.pbr(Color(0.5, 0.6, 0.5))));
    b.light(PointLight(), Color(20), Transform::translate({2, 4, 3}));
    b.camera({0.5, 1.2, 6}, {0, 0, 0}, 45);
    return b;
}

RenderOptions with_layers() {
    RenderOptions o = centre_rays(40, {"depth", "normal", "albedo", "coverage"});
    o.spp = 2;
    return o;
}

bool requires_it(const Scene& scene, Requirement what) {
    const auto all = requirements(scene);
    return std::any_of(all.begin(), all.end(), [&](const RequiredBy& r) { return r.what == what; });
}

TEST(UnusedFeatures, AreAllThatASceneCanRequire) {
    ASSERT_EQ(unused_features().size(), size_t(Requirement::functions) + 1);
    for (size_t i = 0; i < unused_features().size(); ++i) {
        const UnusedFeature& feature = unused_features()[i];
        EXPECT_EQ(feature.what, Requirement(i));
        SceneBuilder b;
        add_feature(b, feature, true);
        EXPECT_TRUE(requires_it(b.scene, feature.what)) << name(feature.what);
        if (feature.as_a_whole) continue;
        SceneBuilder hidden;
        add_feature(hidden, feature);
        EXPECT_FALSE(requires_it(hidden.scene, feature.what)) << name(feature.what);
    }
}

TEST(UnusedFeatures, ChangeNoBitAndBuildNothing) {
    const SceneBuilder base = plain();
    const auto bare = compiled(base.scene);
    const Film wanted = *render(*bare, with_layers());
    EXPECT_GT(wanted.stats.shadow_rays, 500u) << "something is seen";
    for (const UnusedFeature& feature : unused_features()) {
        SceneBuilder b = base;
        add_feature(b, feature);
        const auto scene = compiled(b.scene);
        ASSERT_TRUE(scene) << name(feature.what);
        const CompiledSummary want = summary(*bare), got = summary(*scene);
        EXPECT_EQ(std::tuple(scene->features, got.instances, got.geometries, got.lights, got.images, got.bytes), std::tuple(bare->features, want.instances, want.geometries, want.lights, want.images, want.bytes))
            << name(feature.what);
        EXPECT_EQ(scene->cameras.size(), 1u) << name(feature.what);
        const Film film = *render(*scene, with_layers());
        ASSERT_EQ(film.picture.values.size(), wanted.picture.values.size());
        EXPECT_EQ(std::memcmp(film.picture.values.data(), wanted.picture.values.data(), wanted.picture.values.size() * sizeof(float)), 0) << name(feature.what);
        EXPECT_EQ(film.stats.work.boxes, wanted.stats.work.boxes) << name(feature.what);
    }
}

/// The camera's lens, closed.
TEST(UnusedFeatures, AClosedLensIsNoLens) {
    SceneBuilder b = plain();
    b.scene.cameras[0].aperture = 0.5;
    RenderOptions closed = with_layers();
    closed.aperture = 0;
    EXPECT_EQ(std::memcmp(rendered(b.scene, closed).picture.values.data(), rendered(plain().scene, with_layers()).picture.values.data(), 40 * 40 * 3 * sizeof(float)), 0);
}

}  // namespace
}  // namespace alidade::test
