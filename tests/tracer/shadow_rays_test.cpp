// SPDX-License-Identifier: Apache-2.0
/// Which surfaces a shadow ray meets, in which order it asks, and when it is spared.
#include "accel/accelerator.h"
#include "tests/tracer/scene_builder.h"
#include "tracer/compiled_scene.h"

namespace alidade::test {
namespace {

/// What comes of the light above to a floor, through panes that leave 3/4 of it and past opaque squares, at these heights.
struct Stack {
    std::vector<double> panes, opaque;
    double brightness(double clearance, const char* accel, bool with_extent) const {
        SceneBuilder b;
        b.object(Plane{{0, 1, 0}, 0}, b.material(b.lambert(Color(1))));
        GltfPbr pane = b.lambert(Color(1));
        pane.base_color = b.constant({1, 1, 1, 0.25});
        pane.alpha_mode = AlphaMode::blend;
        const MaterialId clear = b.material(pane), grey = b.material(b.lambert(Color(0.5)));
        const Transform flat = Transform::rotate({1, 0, 0}, -kPi / 2);
        const auto add = [&](double height, MaterialId material) {
            b.object(square(), material, Transform::translate({0.3, height, 0.1}) * flat);
            b.scene.nodes.back().flags.image = false;
        };
        for (const double height : panes) add(height, clear);
        for (const double height : opaque) add(height, grey);
        b.light(PointLight(), Color(40), Transform::translate({0, 5, 0}));
        if (with_extent) b.scene.lights[0].shadow_grid = ShadowGrid{{0.01, 0, 0}, {0, 0, 0.01}, 2, 2};
        b.camera({4, 1, 0}, {0, 0, 0}, 1);
        b.scene.settings.shadow_clearance = clearance;
        CompileOptions options;
        options.accel = accel;
        return value(rendered(b.scene, centre_rays(1), options).picture, 0, 0, "R");
    }
};

/// Surfaces in the clearance behind the beginning of a ray, or behind the last one that counted, let all light through; those that do not count have none.
TEST(Shadows, SurfacesCountThatAreApart) {
    const struct { Stack stack; double apart, all; } cases[] = {
        {{{1, 1.05}, {}}, 0.75, 0.5625}, {{{1, 1.2}, {}}, 0.5625, 0.5625}, {{{1, 1.06, 1.12}, {}}, 0.5625, 0.421875}, {{{1}, {1.05}}, 0.75, 0}, {{{1}, {1.2}}, 0, 0}, {{{1, 1.06}, {1.12}}, 0, 0},
        {{{1, 1.12}, {1.06, 1.2}}, 0.5625, 0}, {{{0.55}, {0.5}}, 0, 0}, {{{}, {0.05}}, 1, 0}, {{{}, {0.2}}, 0, 0}, {{{0.05}, {0.12}}, 0, 0}, {{{0.05, 2}, {0.06}}, 0.75, 0}};
    for (const AcceleratorEntry& accel : accelerators())
        for (const bool with_extent : {false, true}) {
            const double open = Stack().brightness(0, accel.name, with_extent);
            EXPECT_GT(open, 0.1);
            for (size_t i = 0; i < std::size(cases); ++i) {
                EXPECT_NEAR(cases[i].stack.brightness(0.1, accel.name, with_extent) / open, cases[i].apart, 1e-6) << accel.name << " case " << i << " extent " << with_extent;
                EXPECT_NEAR(cases[i].stack.brightness(0, accel.name, with_extent) / open, cases[i].all, 1e-6) << accel.name << " case " << i << " extent " << with_extent;
            }
        }
}

/// A room with panes and balls of glass, near and in front of what is opaque, parts of sets among it, and a light without and two with something before them.
SceneBuilder glass_before_walls() {
    SceneBuilder b;
    GltfPbr pane = b.lambert(Color(0.75));
    pane.base_color = b.constant(Vec4(1, 0.9, 0.8, 0.25)), pane.alpha_mode = AlphaMode::blend;
    const MaterialId clear = b.material(pane), grey = b.material(b.lambert(Color(0.5)));
    b.object(Plane{{0, 1, 0}, 0}, grey);
    b.object(Sphere{{0, 0, 0}, 1}, grey, Transform::scale({40, 9, 40}));   // the second light is outside of it
    for (int i = 0; i < 12; ++i) {
        const Vec3 at(i % 4 - 1.5, 0.7 + i % 3 * 0.8, i / 4 - 1.0);
        b.object(Sphere{at, 0.3}, i % 2 ? clear : grey);
        if (i % 2 == 0) b.object(Sphere{at, 0.3 + i * 0.01}, clear);   // a skin of glass, as thin as the clearance or thicker
    }
    Node set;
    set.csg = CsgKind::difference;
    for (const double size : {0.4, 0.35}) {
        Node part;
        part.what = b.shape(Box{Vec3(0, 2, 0) - Vec3(size), Vec3(0.2 + size, 2.6, size)});
        part.materials = {grey};
        set.children.push_back(b.node(part, false));
    }
    b.node(set);
    for (const Vec3& at : {Vec3(3, 7, 2), Vec3(-6, 30, 1), Vec3(0.3, 5, -4)}) b.light(PointLight(), Color(40), Transform::translate(at));
    b.camera({1, 3, 6}, {0, 1, 0}, 60);
    b.scene.settings.shadow_clearance = 0.03;
    return b;
}

/// What hid a light is asked first at the next point, but for where layers show the work of each pixel by itself: that changes no bit, and saves work.
TEST(Shadows, ThatWhichHidALightIsAskedAgain) {
    const SceneBuilder b = glass_before_walls();
    for (const AcceleratorEntry& accel : accelerators()) {
        CompileOptions options;
        options.accel = accel.name;
        constexpr int kSize = 64;
        const Film got = rendered(b.scene, centre_rays(kSize), options), want = rendered(b.scene, centre_rays(kSize, {"depth"}), options);
        double dark = 0;
        for (int y = 0; y < kSize; ++y)
            for (int x = 0; x < kSize; ++x)
                for (const char* channel : {"R", "G", "B"}) {
                    const double value_there = value(want.picture, x, y, channel);
                    ASSERT_EQ(value(got.picture, x, y, channel), value_there) << accel.name << ' ' << x << ' ' << y;
                    dark += value_there < 0.01;
                }
        EXPECT_GT(dark, 30) << "there must be shadows";
        EXPECT_LT(got.stats.work.primitives, want.stats.work.primitives) << accel.name;
        RenderOptions otherwise = centre_rays(kSize);
        otherwise.threads = 3, otherwise.tile = 5;
        EXPECT_EQ(rendered(b.scene, otherwise, options).picture.values, got.picture.values) << "what is remembered must not show: " << accel.name;
    }
}

/// Shadow rays are spared for light that no film could hold, and for no other: a light of 1e-30 is dark where one of 1 is.
TEST(Shadows, FaintLightHasThemToo) {
    constexpr int kSize = 48;
    const auto picture = [](double intensity) {
        SceneBuilder b;
        const MaterialId grey = b.material(b.lambert(Color(0.5)));
        b.object(Plane{{0, 1, 0}, 0}, grey);
        b.object(Sphere{{0, 1.5, 0}, 0.5}, grey);
        b.light(PointLight(), Color(intensity), Transform::translate({0, 5, 0}));
        b.camera({0, 4, 3}, {0, 0, 0}, 60);
        return rendered(b.scene, centre_rays(kSize)).picture;
    };
    const Picture faint = picture(1e-30), bright = picture(1);
    int dark = 0;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            const bool is_dark = value(bright, x, y, "R") == 0;
            EXPECT_EQ(value(faint, x, y, "R") == 0, is_dark) << x << ' ' << y;
            dark += is_dark;
        }
    EXPECT_GT(dark, 30);
    EXPECT_LT(dark, kSize * kSize / 2);
}

}  // namespace
}  // namespace alidade::test
