// SPDX-License-Identifier: Apache-2.0
/// POV-Ray's lights with a form, against closed forms. (tests/scenes/pov_pictures_test.cpp compares whole pictures with POV-Ray.)
#include "tests/core/draw.h"
#include "tests/tracer/scene_builder.h"
#include "tracer/integrators/shadow_grid.h"
#include "tracer/lights.h"

namespace alidade::test {
namespace {

ShadowGrid grid_of(int size1, int size2, int adaptive = -1) {
    ShadowGrid grid;
    grid.size1 = size1, grid.size2 = size2, grid.adaptive = adaptive;
    return grid;
}

/// The mean over a grid, and how many of its points were asked.
template <class Value> double mean_of(const ShadowGrid& grid, Value value, int* asked = nullptr) {
    GridScratch seen;
    return GridMean(grid, seen, [&](int u, int v) {
        if (asked) ++*asked;
        return Color(value(u, v));
    })().x;
}

/// Of three points along an axis the one in the middle belongs to both halves.
TEST(GridMean, WeightsOfThreeByThree) {
    const double along[] = {0.25, 0.5, 0.25};
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) EXPECT_DOUBLE_EQ(mean_of(grid_of(3, 3), [&](int u, int v) { return u == i && v == k; }), along[i] * along[k]) << i << " " << k;
}

/// Halves are mirror images, so that a value that grows evenly has its mean in the middle.
TEST(GridMean, OfALinearValueIsThatOfTheCentre) {
    for (int n = 1; n <= 17; ++n)
        for (int m : {1, 2, 5, 8}) EXPECT_NEAR(mean_of(grid_of(n, m), [](int u, int v) { return 3.0 * u - v; }), 1.5 * (n - 1) - 0.5 * (m - 1), 1e-12) << n << " by " << m;
}

TEST(GridMean, AsksWhatItNeedsAndNothingTwice) {
    int asked = 0;
    EXPECT_EQ(mean_of(grid_of(9, 9, 0), [](int, int) { return 1; }, &asked), 1);
    EXPECT_EQ(asked, 4) << "equal corners";
    asked = 0;
    EXPECT_EQ(mean_of(grid_of(9, 9, 2), [](int, int) { return 1; }, &asked), 1);
    EXPECT_EQ(asked, 25) << "divided twice: every second point";
    asked = 0;
    mean_of(grid_of(9, 9), [](int u, int) { return u % 2; }, &asked);
    EXPECT_EQ(asked, 81);
}

/// Of equal values it is that value, bit for bit, however they are added up.
TEST(GridMean, OfEqualValuesIsExact) {
    Draw draw(5);
    for (int i = 0; i < 2000; ++i) {
        const double value = draw(-1, 1) * std::exp2(draw(-40, 40));
        for (const int adaptive : {-1, 1}) EXPECT_EQ(mean_of(grid_of(1 + i % 7, 1 + i % 5, adaptive), [&](int, int) { return value; }), value);
    }
}

/// Each mean asks for itself, whatever the scratch holds of those before: of grids larger and smaller, and after the rounds were counted once around.
TEST(GridMean, ForgetsTheLastOne) {
    GridScratch seen;
    for (int i = 0; i < 12; ++i) {
        if (i == 6) seen.round = std::numeric_limits<uint32_t>::max() - 1;
        const int size = i % 3 + 2;
        EXPECT_EQ(GridMean(grid_of(size, size), seen, [&](int, int) { return Color(i); })().x, i);
    }
}

PlacedLight cylinder_light() {
    Light l;
    l.kind = CylinderLight{1, 3, 2};
    l.intensity = Color(8, 4, 2);
    l.inverse_square = false;
    return {l, Transform::translate({0, 0, 5})};
}

TEST(CylinderLights, FallOffAcrossTheAxis) {
    const PlacedLight light = cylinder_light();
    const auto at = [&](double x, double z) { return illuminate(light, Vec3(x, 0, z), {}).irradiance.x; };
    EXPECT_DOUBLE_EQ(at(0, 0), 8);
    EXPECT_EQ(at(0, 6), 0) << "behind the light";
    EXPECT_EQ(at(3, 0), 0);
    EXPECT_DOUBLE_EQ(at(0.5, 0), 8 * std::pow(1 - 0.5 / 3, 2)) << "inside of the radius the tightness alone dims";
    const double q = 1 - 2.0 / 3, u = q / (1 - 1.0 / 3);
    EXPECT_NEAR(at(2, -7), 8 * q * q * (3 * u * u - 2 * u * u * u), 1e-12);
    const Illumination aside = illuminate(light, Vec3(1, 2, 0), {});
    EXPECT_EQ(aside.direction, Vec3(0, 0, 1)) << "parallel";
    EXPECT_DOUBLE_EQ(aside.distance, 5);
}

/// A plane under a half plane, lit by a square light: how much of the light is seen changes linearly over the penumbra.
Scene penumbra(bool jitter) {
    SceneBuilder b;
    b.object(Plane{{0, 0, 1}, 0}, b.material(b.lambert(Color(1))));
    b.object(Box{{0, -50, 1}, {50, 50, 1.0001}}, b.material(b.lambert(Color(1))));
    b.light(PointLight(), Color(10), Transform::translate({0, 0, 2}));
    b.scene.lights[0].shadow_grid = grid_of(8, 1);
    b.scene.lights[0].shadow_grid->axis1 = {1, 0, 0};
    b.scene.lights[0].shadow_grid->jitter = jitter;
    b.camera({0, 0, 0.9}, {0, 0, 0}, 60);
    return b.scene;
}

RenderOptions sampled(int spp, int threads, int tile) {
    RenderOptions o;
    o.width = o.height = 24;
    o.spp = spp, o.threads = threads, o.tile = tile;
    return o;
}

/// Points are spread over cells of the size of a step, so over the light and half a step more: its steps vanish in the mean.
TEST(Jitter, FillsTheStepsBetweenPoints) {
    const Scene scene = penumbra(true);
    Scene open = scene;
    open.lights[0].shadow_grid.reset();
    open.nodes[1].flags.visible = false;
    const Film soft = rendered(scene, sampled(256, 1, 16)), lit = rendered(open, sampled(256, 1, 16));
    const double reach = 0.5 + 0.5 / 7;   // of the light from its centre, with jitter
    int between = 0;
    for (int x = 0; x < 24; ++x) {
        // From the point p the ray to the light's point a meets the half plane's edge where p + (a - p) / 2 = 0.
        const double p = 2 * 0.9 * std::tan(30 * kPi / 180) * (x + 0.5 - 12) / 24, seen = std::clamp((reach - p) / (2 * reach), 0.0, 1.0);
        between += seen > 0.05 && seen < 0.95;
        EXPECT_NEAR(soft.picture.at(x, 12)[0] / lit.picture.at(x, 12)[0], seen, 0.03) << x;
    }
    EXPECT_GT(between, 10) << "the test must look at the penumbra";
}

TEST(Jitter, ThreadsAndTilesDoNotShow) {
    const Scene scene = penumbra(true);
    const Film one = rendered(scene, sampled(4, 1, 16)), other = rendered(scene, sampled(4, 3, 5));
    EXPECT_EQ(one.picture.values, other.picture.values);
    EXPECT_NE(one.picture.values, rendered(penumbra(false), sampled(4, 1, 16)).picture.values);
}

/// A box less a ball, hung into the light's way.
void add_cut_box(SceneBuilder& b, MaterialId material) {
    Node whole;
    whole.csg = CsgKind::difference;
    for (const ShapeGeometry& part : {ShapeGeometry(Box{{0, 1.6, -0.6}, {0.8, 2, 0.2}}), ShapeGeometry(Sphere{{0.4, 1.8, -0.2}, 0.35})}) {
        Node n;
        n.what = b.shape(part);
        n.materials = {material};
        whole.children.push_back(b.node(n, false));
    }
    b.node(whole);
}

/// What holds the whole scene: a ball, much stretched, a box and a drum; and a wall with a clip around it, whose planes and hole few of the rays come near to.
void surround(SceneBuilder& b, MaterialId material) {
    b.object(Sphere{Vec3(0), 1}, material, Transform::rotate({0, 0, 1}, 0.7) * Transform::scale({1e4, 2e4, 3e4}));
    b.object(Box{{-40, -1, -40}, {40, 30, 40}}, material, Transform::rotate({0, 1, 0}, 0.2));
    b.object(Cylinder{{0, -2, 0}, {0, 20, 0}, 30}, material);
    Node whole;
    whole.csg = CsgKind::difference;
    for (const ShapeGeometry& part : {ShapeGeometry(Plane{{0, 0, 1}, -1.2}), ShapeGeometry(Box{{-0.5, 0.5, -9}, {0.5, 1.5, 9}})}) {
        Node n;
        n.what = b.shape(part);
        n.materials = {material};
        whole.children.push_back(b.node(n, false));
    }
    Node clip;
    clip.what = b.shape(Box{{-10, -1, -10}, {10, 10, 10}});
    whole.clips.push_back(b.node(clip, false));
    b.node(whole);
}

/// A room with a grid of light among things of all kinds: opaque and clear, bounded and endless (one plane cuts the light), whole and cut, seen by shadow rays or not.
Scene room(ShadowGrid grid) {
    SceneBuilder b;
    const MaterialId plain = b.material(b.lambert(Color(0.8))), clear = b.material(b.glass(1.2));
    b.object(Plane{{0, 1, 0}, 0}, plain);
    b.object(Plane{{-0.3, 0.1, -1}, -3}, plain, Transform::rotate({0, 1, 0}, 0.3));
    b.object(Plane{{1, 0, 0}, 0.3}, clear);
    for (int i = 0; i < 40; ++i) {
        const Vec3 at(-2 + 0.61 * (i % 7), 0.4 + 0.35 * (i / 7), -1.5 + 0.47 * (i % 5));
        const Transform turned = Transform::translate(at) * Transform::rotate(normalized(Vec3(1, i % 3, 0.5)), i) * Transform::scale(Vec3(0.2 + 0.01 * i, 0.1, 0.15));
        if (i % 3 == 0) b.object(Sphere{Vec3(0), 1}, i % 2 ? clear : plain, turned);
        else if (i % 3 == 1) b.object(Box{Vec3(-1), Vec3(1)}, plain, turned);
        else b.object(square(), plain, turned);
        if (i % 11 == 0) b.scene.nodes.back().flags.shadow = false;
    }
    b.object(Quadric{Vec3(1, 1, -1), Vec3(0), Vec3(0), -0.05}, plain, Transform::translate({1.2, 0.5, 1}));   // an endless hyperboloid
    add_cut_box(b, plain);
    surround(b, plain);
    b.light(PointLight(), Color(40), Transform::translate({0.5, 3.5, -0.5}) * Transform::rotate({1, 0, 0}, 0.4));
    b.scene.lights[0].shadow_grid = grid;
    b.scene.lights[0].shadow_grid->axis1 = {1.5, 0, 0}, b.scene.lights[0].shadow_grid->axis2 = {0, 0, 1};
    b.camera({-1, 2, 6}, {0, 0.8, 0}, 50);
    return b.scene;
}

/// What can hide a light from a point is found once for all of its points: the picture is that of rays which each ask brute force.
TEST(Occluders, AreThoseThatEachRayFinds) {
    for (int kind = 0; kind < 4; ++kind) {
        ShadowGrid grid = grid_of(5, 4, kind == 1 ? 1 : -1);
        grid.jitter = kind == 1, grid.circular = kind >= 2, grid.orient = kind == 3;
        const Scene scene = room(grid);
        RenderOptions o = centre_rays(48);
        o.max_depth = 4;
        CompileOptions each, once;
        each.accel = "brute", once.accel = "bvh";
        const Film want = rendered(scene, o, each), got = rendered(scene, o, once);
        EXPECT_EQ(want.picture.values, got.picture.values) << "kind " << kind;
        EXPECT_EQ(want.stats.shadow_rays, got.stats.shadow_rays);
        EXPECT_LT(double(got.stats.work.filtered), 0.25 * double(want.stats.work.filtered));
    }
}

/// A floor under a light, in a ball, and a wall behind all that is seen, with a hole, clipped: no shadow ray can meet anything, so nothing is asked.
TEST(Occluders, AreNotWhatSurroundsAndWhatIsStoodOn) {
    const auto scene = [](bool shadows) {
        SceneBuilder b;
        const MaterialId plain = b.material(b.lambert(Color(1)));
        b.object(Plane{{0, 1, 0}, 0}, plain);
        b.object(Plane{{0, 1, 0}, -3}, plain);
        b.object(Sphere{Vec3(0), 1}, plain, Transform::scale(Vec3(1e5)));
        const auto part = [&](ShapeGeometry shape) {
            Node n;
            n.what = b.shape(std::move(shape)), n.materials = {plain};
            return b.node(n, false);
        };
        Node wall;
        wall.csg = CsgKind::difference;
        wall.children = {part(Plane{{0, 0, 1}, -20}), part(Sphere{{0, 0, -20}, 3})};
        wall.clips = {part(Box{{-40, -2, -40}, {40, 50, 40}})};
        b.node(wall);
        b.light(PointLight(), Color(40), Transform::translate({0, 3, 0}));
        b.scene.lights[0].shadowless = !shadows;
        b.scene.lights[0].shadow_grid = grid_of(4, 4);
        b.scene.lights[0].shadow_grid->axis1 = {1, 0, 0}, b.scene.lights[0].shadow_grid->axis2 = {0, 0, 1};
        b.camera({0, 2, 2}, {0, 0, 0}, 60);   // which sees the floor alone
        return b.scene;
    };
    const Film lit = rendered(scene(false), centre_rays(32)), asked = rendered(scene(true), centre_rays(32));
    EXPECT_EQ(lit.picture.values, asked.picture.values);
    EXPECT_GT(asked.stats.shadow_rays, 5000u);
    EXPECT_EQ(lit.stats.work.primitives, asked.stats.work.primitives);
}

/// Where nothing so near counts that it could be one place with what is stood on, that is left in solids, too: a room of two planes, one half of it cut away.
TEST(Occluders, AreNotPartsOfSolidsThatAreStoodOn) {
    const auto primitives = [](double clearance, bool shadows) {
        SceneBuilder b;
        const MaterialId plain = b.material(b.lambert(Color(1)));
        b.scene.settings.shadow_clearance = clearance;
        Node room;
        room.csg = CsgKind::union_;
        for (const Plane& plane : {Plane{{0, 1, 0}, 0}, Plane{{0, 0, 1}, -8}}) {
            Node n;
            n.what = b.shape(plane), n.materials = {plain};
            room.children.push_back(b.node(n, false));
        }
        Node clip;
        clip.what = b.shape(Box{{-40, -2, -40}, {40, 50, 40}});
        room.clips = {b.node(clip, false)};
        b.node(room);
        b.light(PointLight(), Color(40), Transform::translate({0, 3, 0}));
        b.scene.lights[0].shadowless = !shadows;
        b.scene.lights[0].shadow_grid = grid_of(4, 4);
        b.scene.lights[0].shadow_grid->axis1 = {1, 0, 0}, b.scene.lights[0].shadow_grid->axis2 = {0, 0, 1};
        b.camera({0, 2, 2}, {0, 0, -6}, 60);   // which sees both
        const Film film = rendered(b.scene, centre_rays(32));
        EXPECT_TRUE(!shadows || film.stats.shadow_rays > 5000);
        return film.stats.work.primitives;
    };
    EXPECT_EQ(primitives(0.001, true), primitives(0.001, false));
    EXPECT_GT(primitives(0, true), primitives(0, false)) << "without a clearance it is not known";
}

/// In a solid, faces at one place are one: a plane that is stood on counts with those beside it. Rooms of planes, with a floor that is there twice, and looked at along an edge.
TEST(Occluders, OfSolidsWhoseFacesMeetUnderThePoint) {
    for (int i = 0; i < 8; ++i) {
        const double twice = std::array{0.0, 7e-14, 2e-13, 1.0}[size_t(i % 4)];
        SceneBuilder b;
        b.scene.settings.shadow_clearance = i < 4 ? 0 : 0.001;
        const MaterialId plain = b.material(b.lambert(Color(1)));
        Node room;
        room.csg = CsgKind::intersection, room.inverse = true;
        for (const Plane& plane : {Plane{{0, -1, 0}, 1}, Plane{{0, -1, 0}, 1 - twice}, Plane{{0, 1, 0}, 3}, Plane{{1, 0, 0}, 4}, Plane{{-1, 0, 0}, 4}, Plane{{0, 0, 1}, 9}, Plane{{0, 0, -1}, 4}}) {
            Node n;
            n.what = b.shape(plane), n.materials = {plain};
            room.children.push_back(b.node(n, false));
        }
        b.node(room);
        b.light(PointLight(), Color(40), Transform::translate({0.5, 2, 0}));
        b.scene.lights[0].shadow_grid = grid_of(4, 4);
        b.scene.lights[0].shadow_grid->axis1 = {1, 0, 0}, b.scene.lights[0].shadow_grid->axis2 = {0, 0, 1};
        b.camera({0, -1 + (twice == 1 ? 1 : 0), 6}, {0, -1 + (twice == 1 ? 1 : 0), -4}, 60);
        CompileOptions each, once;
        each.accel = "brute", once.accel = "bvh";
        EXPECT_EQ(rendered(b.scene, centre_rays(33), each).picture.values, rendered(b.scene, centre_rays(33), once).picture.values) << i;
        b.scene.cameras.clear(), b.scene.nodes.pop_back(), b.scene.roots.pop_back();
        b.camera({0, 1, 6}, {0, -0.5, 0}, 60);
        EXPECT_EQ(rendered(b.scene, centre_rays(33), each).picture.values, rendered(b.scene, centre_rays(33), once).picture.values) << i;
    }
}

/// Where a point is known far less well than the shaft is wide, rays begin and end beside it: what is just behind the light is in their way.
TEST(Occluders, ReachAsFarAsRays) {
    SceneBuilder b;
    b.object(Plane{{0, 1, 0}, -1e11}, b.material(b.lambert(Color(1))), Transform::translate({0, 1e11, 0}));
    b.object(Box{{-5, 3.00002, -5}, {5, 3.1, 5}}, b.material(b.lambert(Color(1))));
    b.light(PointLight(), Color(40), Transform::translate({0, 3, 0}));
    b.scene.lights[0].shadow_grid = grid_of(4, 4);
    b.scene.lights[0].shadow_grid->axis1 = {1, 0, 0}, b.scene.lights[0].shadow_grid->axis2 = {0, 0, 1};
    b.camera({0, 2, 6}, {0, 0.3, 0}, 50);
    CompileOptions each, once;
    each.accel = "brute", once.accel = "bvh";
    EXPECT_EQ(rendered(b.scene, centre_rays(32), each).picture.values, rendered(b.scene, centre_rays(32), once).picture.values);
}

TEST(Supersampling, ThreadsAndTilesDoNotShow) {
    const Scene scene = penumbra(true);
    for (int method : {1, 2}) {
        RenderOptions o = sampled(1, 1, 16);
        o.width = 70, o.height = 40;
        o.supersampling = Supersampling{.method = method, .threshold = 0.01, .jitter = 1};
        const Film one = rendered(scene, o);
        o.threads = 3, o.tile = 7;
        EXPECT_EQ(one.picture.values, rendered(scene, o).picture.values) << "method " << method;
    }
}

/// Where nothing differs, method 1 takes the rays through the centres and those beside its blocks, method 2 those through the corners.
TEST(Supersampling, TakesNoRaysWhereNothingDiffers) {
    SceneBuilder b;
    b.object(Plane{{0, 0, 1}, 0}, b.material(b.lambert(Color(1))));
    b.light(DirectionalLight(), Color(1));
    b.camera({0, 0, 1}, {0, 0, 0});
    RenderOptions o = sampled(1, 1, 16);
    o.width = 64, o.height = 32;
    const Film plain = rendered(b.scene, o);
    for (int method : {1, 2}) {
        o.supersampling = Supersampling{.method = method, .depth = 4};
        const Film film = rendered(b.scene, o);
        EXPECT_EQ(film.picture.values, plain.picture.values);
        EXPECT_EQ(film.stats.camera_rays, method == 1 ? 2u * (32 * 32 + 64) : 2u * 33 * 33);
        EXPECT_EQ(film.stats.pixels, 64u * 32);
    }
}

/// So does POV-Ray's method 2: jitter moves the points by which pixels are divided alone.
TEST(Supersampling, JitterLeavesTheCornersOfPixels) {
    const Scene scene = penumbra(false);
    RenderOptions o = sampled(1, 1, 16);
    const auto picture = [&](double threshold, double jitter) {
        o.supersampling = Supersampling{.method = 2, .threshold = threshold, .jitter = jitter};
        return rendered(scene, o).picture.values;
    };
    EXPECT_EQ(picture(1e3, 0), picture(1e3, 1)) << "nothing is divided";
    EXPECT_NE(picture(0.01, 0), picture(0.01, 1));
}

TEST(Supersampling, RefusesWhatIsNotThere) {
    SceneBuilder b;
    const auto scene = compiled(b.scene);
    for (const Supersampling& s : {Supersampling{.method = 3}, Supersampling{.depth = 0}, Supersampling{.depth = 10}, Supersampling{.gamma = 0}}) {
        RenderOptions o = sampled(1, 1, 16);
        o.supersampling = s;
        EXPECT_FALSE(render(*scene, o));
    }
}

}  // namespace
}  // namespace alidade::test
