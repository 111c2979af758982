// SPDX-License-Identifier: Apache-2.0
/// Shadows, alpha, cameras, transforms: who sees what.
#include "accel/accelerator.h"
#include "tests/core/draw.h"
#include "tests/tracer/scene_builder.h"
#include "tracer/compiled_scene.h"
#include "tracer/cameras.h"
#include "tracer/sampler.h"
#include "tracer/shade_point.h"

namespace alidade::test {
namespace {

/// What stops light is found by the structure over that alone as by the one over everything, and with less work.
TEST(Visibility, OpaqueThingsAreFoundAmongThemselves) {
    SceneBuilder b;
    Draw draw(1);
    const MaterialId stone = b.material(b.lambert(Color(0.5))), glass = b.material(b.glass(1.5));
    for (int i = 0; i < 200; ++i) b.object(Sphere{draw.vector(10), draw(0.5, 2)}, i % 3 ? glass : stone);
    b.light(PointLight(), Color(1));
    b.camera({0, 0, 30}, {0, 0, 0});
    const auto scene = compiled(b.scene);
    ASSERT_TRUE(scene && scene->opaques);
    WorkCounters among_all, among_themselves;
    int hidden = 0;
    for (int i = 0; i < 3000; ++i) {
        Ray ray{draw.vector(12), draw.vector(1)};
        ray.mask = kMaskOpaque, ray.tmax = draw(1, 20);
        const bool occluded = scene->top->occluded(ray, among_all);
        ASSERT_EQ(scene->opaques->occluded(ray, among_themselves), occluded) << i;
        hidden += occluded;
    }
    EXPECT_TRUE(hidden > 300 && hidden < 2700) << hidden;
    EXPECT_LT(among_themselves.boxes, among_all.boxes * 3 / 4);
}

/// Where little is clear, there is no second structure over nearly everything.
TEST(Visibility, AFewFiltersShareTheStructureOfAll) {
    SceneBuilder b;
    const MaterialId stone = b.material(b.lambert(Color(0.5))), glass = b.material(b.glass(1.5));
    for (int i = 0; i < 9; ++i) b.object(Sphere{Vec3(3.0 * i, 0, 0), 1}, i == 4 ? glass : stone);
    b.camera({0, 0, 30}, {0, 0, 0});
    const auto scene = compiled(b.scene);
    ASSERT_TRUE(scene);
    EXPECT_TRUE(scene->filters && !scene->opaques);
}

TEST(Cameras, FrameOfAPictureThatFits) {
    SceneBuilder b;
    b.camera({1, 2, 3}, {1, 2, 0}, 90);
    const CameraRays rays(b.scene.cameras[0], 100, 100);
    EXPECT_EQ(rays.at(50, 50).dir, Vec3(0, 0, -1));
    EXPECT_LT(length(rays.at(0, 0).dir - normalized(Vec3(-1, 1, -1))), 1e-15) << "top left";
    EXPECT_LT(length(rays.at(100, 100).dir - normalized(Vec3(1, -1, -1))), 1e-15) << "bottom right";
    EXPECT_EQ(rays.at(7, 9).origin, Vec3(1, 2, 3));
}

TEST(Cameras, FitsKeepPixelsSquareOrStretchThem) {
    Camera c;
    c.right = {2, 0, 0};
    c.up = {0, 1, 0};
    auto corner = [&](Fit fit, int w, int h) {
        c.fit = fit;
        const Vec3 d = CameraRays(c, w, h).at(w, 0).dir;
        return Vec2(d.x / -d.z, d.y / -d.z);
    };
    auto near = [](Vec2 a, Vec2 b) { return std::abs(a.x - b.x) + std::abs(a.y - b.y) < 1e-14; };
    EXPECT_TRUE(near(corner(Fit::stretch, 100, 100), {1, 0.5}));
    EXPECT_TRUE(near(corner(Fit::show_all, 100, 100), {1, 1})) << "more above and below";
    EXPECT_TRUE(near(corner(Fit::show_all, 400, 100), {2, 0.5})) << "more at the sides";
    EXPECT_TRUE(near(corner(Fit::height, 100, 100), {0.5, 0.5}));
}

TEST(Cameras, OrthographicRaysAreParallel) {
    Camera c;
    c.projection = Projection::orthographic;
    c.right = {4, 0, 0};
    c.up = {0, 2, 0};
    const CameraRays rays(c, 40, 20);
    EXPECT_EQ(rays.at(0, 0).origin, Vec3(-2, 1, 0));
    EXPECT_EQ(rays.at(0, 0).dir, rays.at(33, 2).dir);
}

TEST(Cameras, FramingCameraSeesTheWholeBox) {
    for (const Bounds& box : {Bounds{Vec3(-1), Vec3(1)}, Bounds{Vec3(1e6, 0, 0), Vec3(1e6 + 1, 3, 0.1)}, Bounds{Vec3(-1e-6), Vec3(1e-6)}}) {
        const Camera c = framing_camera(box);
        for (int k = 0; k < 8; ++k) {
            const Vec3 corner(k & 1 ? box.max.x : box.min.x, k & 2 ? box.max.y : box.min.y, k & 4 ? box.max.z : box.min.z), d = corner - c.location;
            const double along = dot(d, c.direction);
            EXPECT_GT(along, 0);
            EXPECT_LE(std::abs(dot(d, c.right)) / along / dot(c.right, c.right), 0.5 + 1e-9);
            EXPECT_LE(std::abs(dot(d, c.up)) / along / dot(c.up, c.up), 0.5 + 1e-9);
        }
    }
}

/// The part of the unit square [x, x + 1] x [y, y + 1] where a * x + b * y < c; a > 0 and b > 0. Integrated over y, exactly: the integrand is piecewise linear.
double area_below(double x, double y, double a, double b, double c) {
    const auto width = [&](double v) { return std::clamp((c - b * v) / a - x, 0.0, 1.0); };
    double cuts[] = {y, std::clamp((c - a * (x + 1)) / b, y, y + 1), std::clamp((c - a * x) / b, y, y + 1), y + 1}, sum = 0;
    for (int i = 0; i < 3; ++i) sum += (cuts[i + 1] - cuts[i]) * (width(cuts[i]) + width(cuts[i + 1])) / 2;
    return sum;
}

/// Each pixel of a slanted edge is as bright as the part of it that the surface covers.
TEST(Antialiasing, AnEdgePixelIsItsCoveredArea) {
    const double angle = 0.3;
    SceneBuilder b;
    GltfPbr lamp = b.lambert(Color(0));
    lamp.emissive = b.constant(Vec4(1));
    // The square's edge x = 1, moved to the origin and turned: the covered side has x cos + y sin < 0.
    b.object(square(), b.material(lamp), Transform::rotate({0, 0, 1}, angle) * Transform::scale({5, 5, 1}) * Transform::translate({-1, 0, 0}));
    b.camera({0, 0, 10}, {0, 0, 0}, 10);
    for (const SamplerEntry& sampler : samplers()) {
        double errors[2] = {};
        for (int round = 0; round < 2; ++round) {
            RenderOptions o = centre_rays(16);
            o.spp = round ? 1024 : 16;
            o.sampler = sampler.name;
            const Film film = rendered(b.scene, o);
            for (int y = 0; y < 16; ++y)
                for (int x = 0; x < 16; ++x) {
                    // In pixels: x to the right, rows upwards.
                    const double want = area_below(x - 8, 7 - y, std::cos(angle), std::sin(angle), 0);
                    errors[round] = std::max(errors[round], std::abs(value(film.picture, x, y, "R") - want));
                }
        }
        EXPECT_LT(errors[1], 0.06) << sampler.name;
        EXPECT_LT(errors[1], errors[0] / 3) << sampler.name << ": 64 times the samples";
    }
}

/// The shadow of a sphere on a plane, pixel by pixel: dark exactly where the segment to the light passes within the radius.
TEST(Shadows, OfASphereByClosedForm) {
    SceneBuilder b;
    b.object(Plane{{0, 1, 0}, 0}, b.material(b.lambert(Color(1))));
    const Vec3 centre(0, 1, 0), light(1, 4, 1);
    b.object(Sphere{centre, 0.5}, b.material(b.lambert(Color(1))));
    b.light(PointLight(), Color(30), Transform::translate(light));
    b.camera({3, 6, 3}, {-0.5, 0, -0.5}, 50);
    constexpr int kSize = 96;
    const Film film = rendered(b.scene, centre_rays(kSize, {"depth", "normal"}));
    const CameraRays rays(b.scene.cameras[0], kSize, kSize);
    int dark = 0, lit = 0;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            const double depth = value(film.picture, x, y, "depth.Z");
            if (!(std::abs(value(film.picture, x, y, "normal.Y") - 1) < 1e-9) || depth > 50) continue;   // the plane alone
            const Ray ray = rays.at(x + 0.5, y + 0.5);
            const Vec3 p = ray.at(-ray.origin.y / ray.dir.y), d = normalized(light - p);
            const double miss = length(cross(centre - p, d));
            if (std::abs(miss - 0.5) < 1e-6) continue;
            (miss < 0.5 ? dark : lit)++;
            EXPECT_EQ(value(film.picture, x, y, "R") == 0, miss < 0.5) << x << ' ' << y;
        }
    EXPECT_GT(dark, 50);
    EXPECT_GT(lit, 500);
}

TEST(Alpha, BlendShowsTheBackgroundAndMaskCutsOut) {
    for (const auto& [mode, alpha, there] : {std::tuple{AlphaMode::blend, 0.25, 0.25}, {AlphaMode::mask, 0.4, 0.0}, {AlphaMode::mask, 0.6, 1.0},
                                             {AlphaMode::opaque, 0.3, 1.0}, {AlphaMode::blend, 0.0, 0.0}}) {
        for (const char* integrator : {"whitted", "cast"}) {
            SceneBuilder b;
            GltfPbr m = b.pbr(Color(0));
            m.base_color = b.constant({0, 0, 0, alpha});
            m.emissive = b.constant(Vec4(1));
            m.alpha_mode = mode;
            m.ior = 1;
            b.object(square(), b.material(m));
            b.scene.atmosphere.background = Color(0, 0.5, 0);
            b.camera({0, 0, 3}, {0, 0, 0}, 10);
            RenderOptions o = centre_rays(1, {"coverage"});
            o.integrator = integrator;
            const Film film = rendered(b.scene, o);
            EXPECT_NEAR(value(film.picture, 0, 0, "R"), there, 1e-6) << integrator;
            EXPECT_NEAR(value(film.picture, 0, 0, "G"), there + 0.5 * (1 - there), 1e-6) << integrator;
            EXPECT_NEAR(value(film.picture, 0, 0, "coverage.Y"), there, 1e-6) << integrator;
        }
    }
}

/// Cut-out leaves do not use up the recursion limit: behind a hundred of them the lamp is seen, and covers the pixel.
TEST(Alpha, LayersDoNotCountAsRecursion) {
    for (const char* integrator : {"whitted", "cast"}) {
        SceneBuilder b;
        GltfPbr leaf = b.pbr(Color(1)), lamp = b.pbr(Color(0));
        leaf.base_color = b.constant({1, 1, 1, 0});
        leaf.alpha_mode = AlphaMode::mask;
        lamp.emissive = b.constant(Vec4(0.5));
        const MaterialId leaves = b.material(leaf);
        for (int i = 0; i < 100; ++i) b.object(square(), leaves, Transform::translate({0, 0, 1 + 0.01 * i}));
        b.object(square(), b.material(lamp));
        b.camera({0, 0, 4}, {0, 0, 0}, 10);
        RenderOptions o = centre_rays(1, {"coverage", "depth"});
        o.integrator = integrator;
        o.max_depth = 2;
        const Film film = rendered(b.scene, o);
        EXPECT_NEAR(value(film.picture, 0, 0, "R"), 0.5, 1e-6) << integrator;
        EXPECT_EQ(value(film.picture, 0, 0, "coverage.Y"), 1) << integrator;
        EXPECT_NEAR(value(film.picture, 0, 0, "depth.Z"), 4, 1e-6) << integrator;
    }
}

/// A shadow ray multiplies what it passes: two panes of alpha 1/4 and one of glass.
TEST(Alpha, ShadowRaysMultiplyFilters) {
    auto brightness = [](int panes, bool glass) {
        SceneBuilder b;
        b.object(Plane{{0, 1, 0}, 0}, b.material(b.lambert(Color(1))));
        GltfPbr pane = b.lambert(Color(1));
        pane.base_color = b.constant({1, 1, 1, 0.25});
        pane.alpha_mode = AlphaMode::blend;
        const MaterialId m = b.material(pane), g = b.material(b.glass(1));
        const Transform flat = Transform::rotate({1, 0, 0}, -kPi / 2);
        for (int i = 0; i < panes; ++i) b.object(square(), m, Transform::translate({0, 1.0 + i, 0}) * flat);
        if (glass) b.object(square(), g, Transform::translate({0, 0.5, 0}) * flat);
        b.light(DirectionalLight(), Color(1), flat);
        b.camera({4, 1, 0}, {0, 0, 0}, 1);
        return value(rendered(b.scene, centre_rays(1)).picture, 0, 0, "R");
    };
    const double open = brightness(0, false);
    EXPECT_GT(open, 0.1);
    EXPECT_NEAR(brightness(1, false) / open, 0.75, 1e-6);
    EXPECT_NEAR(brightness(2, false) / open, 0.5625, 1e-6);
    EXPECT_NEAR(brightness(2, true) / open, 0.5625, 1e-6);
}

/// A sphere scaled to an ellipsoid: the normal is the gradient, not the scaled normal.
TEST(Transforms, NormalsOfAnEllipsoid) {
    SceneBuilder b;
    const Vec3 axes(2, 0.5, 1);
    b.object(Sphere{}, b.material(b.lambert(Color(1))), Transform::scale(axes));
    b.camera({1, 1, 6}, {0, 0, 0}, 40);
    constexpr int kSize = 48;
    const Film film = rendered(b.scene, centre_rays(kSize, {"normal", "depth"}));
    const CameraRays rays(b.scene.cameras[0], kSize, kSize);
    int seen = 0;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            if (std::isinf(value(film.picture, x, y, "depth.Z"))) continue;
            const Ray ray = rays.at(x + 0.5, y + 0.5);
            const Vec3 p = ray.at(value(film.picture, x, y, "depth.Z"));
            const Vec3 want = normalized(p / (axes * axes));
            const Vec3 got(value(film.picture, x, y, "normal.X"), value(film.picture, x, y, "normal.Y"), value(film.picture, x, y, "normal.Z"));
            EXPECT_LT(length(got - want), 1e-5) << x << ' ' << y;
            ++seen;
        }
    EXPECT_GT(seen, 200);
}

/// Transforms in a chain of nodes are those of their product, for every shape; a node with two parents is seen twice.
TEST(Transforms, NestedInstancesEqualFlatOnes) {
    const Transform a = Transform::translate({0.3, 0, 0}) * Transform::rotate({0, 1, 0}, 0.4), c = Transform::scale({0.5, 0.7, 0.5});
    const Transform left = Transform::translate({-0.8, 0, 0}), right = Transform::translate({0.8, 0.1, 0});
    for (const ShapeGeometry& g : std::vector<ShapeGeometry>{Sphere{}, Box{}, square()}) {
        SceneBuilder flat, nested;
        for (SceneBuilder* b : {&flat, &nested}) {
            b->light(DirectionalLight(), Color(2), Transform::rotate({1, 0, 0}, -0.5));
            b->camera({0, 1, 6}, {0, 0, 0}, 40);
        }
        const MaterialId m = flat.material(flat.lambert(Color(0.8)));
        for (const Transform& place : {left, right}) flat.object(g, m, place * a * c);
        const MaterialId n = nested.material(nested.lambert(Color(0.8)));
        Node leaf, middle;
        leaf.what = nested.shape(g);
        leaf.to_parent = c;
        middle.to_parent = a;
        middle.materials = {n};   // inherited
        middle.children = {nested.node(leaf, false)};
        const NodeId shared = nested.node(middle, false);
        for (const Transform& place : {left, right}) {
            Node parent;
            parent.to_parent = place;
            parent.children = {shared};
            nested.node(parent);
        }
        const Film one = rendered(flat.scene, centre_rays(40, {"coverage"})), two = rendered(nested.scene, centre_rays(40, {"coverage"}));
        double sum = 0;
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 40; ++x) {
                EXPECT_NEAR(value(one.picture, x, y, "R"), value(two.picture, x, y, "R"), 1e-6);
                sum += value(two.picture, x, y, "coverage.Y");
            }
        EXPECT_GT(sum, 30);
        EXPECT_EQ(summary(*compiled(nested.scene)).geometries, 1u) << "stored once";
        EXPECT_EQ(summary(*compiled(nested.scene)).instances, 2u);
    }
}

}  // namespace
}  // namespace alidade::test
