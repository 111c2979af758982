// SPDX-License-Identifier: Apache-2.0
/// Solids in scenes: whatever accelerator finds them, rays meet the same surfaces.
#include "tests/core/draw.h"
#include "tests/tracer/scene_builder.h"
#include "tracer/compiled_scene.h"
#include "tracer/shade_point.h"

#include <pthread.h>

namespace alidade {
namespace {

struct Solids : test::SceneBuilder {
    explicit Solids(uint64_t seed) : draw(seed), plain(material(lambert(Color(0.5)))) {}
    test::Draw draw;
    MaterialId plain;

    Transform anywhere() { return Transform::translate(draw.vector(4)) * Transform::from_quaternion(draw.quaternion()) * Transform::scale(Vec3(draw(0.5, 2))); }

    NodeId random_shape() {
        static const ShapeGeometry kShapes[] = {Sphere(), Box(), Cylinder{Vec3(0, -2, 0), Vec3(0, 2, 0), 0.6, true}, Cylinder{Vec3(-2, 0, 0), Vec3(2, 0, 0), 0.6}, Torus(), Plane{Vec3(0, 1, 0), 0.3}, Disc()};
        Node n;
        n.what = draw.below(10) == 0 ? shape(test::square()) : shape(kShapes[draw.below(std::size(kShapes))]);
        n.materials = {plain};
        n.to_parent = Transform::translate(draw.vector(0.7)) * Transform::from_quaternion(draw.quaternion());
        n.inverse = draw.below(6) == 0;
        return node(n, false);
    }

    NodeId random_node(int levels, bool root) {
        if (levels == 0) return random_shape();
        Node n;
        n.csg = CsgKind(1 + draw.below(4));
        n.inverse = !root && draw.below(6) == 0;
        const uint32_t count = 2 + draw.below(3);
        for (uint32_t i = 0; i < count; ++i) n.children.push_back(random_node(draw.below(2) ? levels - 1 : 0, false));
        if (draw.below(4) == 0) n.clips.push_back(random_shape());
        if (root) n.to_parent = anywhere();
        return node(n, root);
    }

    Ray random_ray() {
        Ray ray;
        ray.origin = draw.vector(draw.below(3) ? 12 : 4);
        ray.dir = (draw.vector(5) - ray.origin) * draw(0.1, 2);
        if (draw.below(4) == 0) ray.tmax = draw(0, 3);
        return ray;
    }
};

void expect_equal(const Hit& a, const Hit& b, const std::string& who) {
    ASSERT_EQ(a.t, b.t) << who;
    ASSERT_EQ(a.instance, b.instance) << who;
    ASSERT_EQ(a.primitive, b.primitive) << who;
    ASSERT_EQ(a.part, b.part) << who;
}

/// Endless parts that bound each other do so wherever they are turned to: a cylinder and two planes across it.
TEST(Solids, EndlessPartsHaveABoxHoweverTheyAreTurned) {
    for (uint64_t seed = 0; seed < 40; ++seed) {
        Solids b(seed);
        const auto part = [&](const ShapeGeometry& geometry) {
            Node n;
            n.what = b.shape(geometry), n.materials = {b.plain};
            return b.node(n, false);
        };
        Node set;
        set.csg = CsgKind::intersection;
        set.to_parent = Transform::translate(b.draw.vector(seed % 2 ? 1e4 : 4)) * Transform::from_quaternion(b.draw.quaternion()) * Transform::scale(Vec3(b.draw(0.5, 2)));
        for (const ShapeGeometry& geometry : {ShapeGeometry(Quadric{{1, 1, 0}, Vec3(0), Vec3(0), -1}), ShapeGeometry(Plane{{0, 0, 1}, 1.5}), ShapeGeometry(Plane{{0, 0, -1}, 0.5})}) set.children.push_back(part(geometry));
        b.node(set);
        b.camera(Vec3(0), {0, 0, 1});
        const auto scene = test::compiled(b.scene);
        ASSERT_TRUE(scene);
        const Bounds box = scene->solids[0].tree.bounds(), true_box = set.to_parent.bounds({{-1, -1, -0.5}, {1, 1, 1.5}});
        ASSERT_TRUE(box.finite()) << seed;
        const double slack = 1e-9 * (1 + max_abs(true_box.max) + max_abs(true_box.min));
        for (int k = 0; k < 3; ++k) EXPECT_TRUE(std::abs(box.min[k] - true_box.min[k]) < slack && std::abs(box.max[k] - true_box.max[k]) < slack) << seed;
        WorkCounters work;
        for (int i = 0; i < 100; ++i) {   // points of the edges and of the surface between them
            const double angle = b.draw(0, 2 * kPi), z = i % 3 == 0 ? -0.5 : i % 3 == 1 ? 1.5 : b.draw(-0.5, 1.5);
            const Vec3 p = set.to_parent.point({std::cos(angle), std::sin(angle), z});
            EXPECT_TRUE(box.contains(p)) << seed;
            const Vec3 out = set.to_parent.vector({std::cos(angle), std::sin(angle), 0});
            Hit hit;
            if (i % 3 == 2) { EXPECT_TRUE(scene->top->intersect(Ray{p + out * 3.0, -out}, hit, work)) << seed; }
        }
    }
}

TEST(Solids, EveryAcceleratorFindsTheSameSurfaces) {
    Solids b(1);
    for (int i = 0; i < 60; ++i) b.random_node(1 + i % 3, true);
    for (int i = 0; i < 20; ++i) b.object(Sphere{b.draw.vector(5), 0.3}, b.plain);
    std::vector<Ray> rays;
    for (int i = 0; i < 2000; ++i) rays.push_back(b.random_ray());
    CompileOptions options;
    options.accel = accelerators()[0].name;
    const auto oracle = test::compiled(b.scene, options);
    ASSERT_GT(oracle->solids.size(), 40u);
    for (const AcceleratorEntry& entry : accelerators()) {
        options.accel = entry.name;
        const auto scene = test::compiled(b.scene, options);
        int found = 0;
        for (const Ray& ray : rays) {
            WorkCounters work;
            Hit want, got;
            const bool any = oracle->top->intersect(ray, want, work);
            ASSERT_EQ(scene->top->intersect(ray, got, work), any) << entry.name;
            ASSERT_EQ(scene->top->occluded(ray, work), any) << entry.name;
            std::vector<Hit> all_want, all_got;
            oracle->top->all_hits(ray, all_want, work), scene->top->all_hits(ray, all_got, work);
            ASSERT_EQ(all_got.size(), all_want.size()) << entry.name;
            for (size_t i = 0; i < all_got.size(); ++i) expect_equal(all_got[i], all_want[i], entry.name);
            if (!any) continue;
            ++found;
            expect_equal(got, want, entry.name);
            expect_equal(got, all_got.front(), "the first of all");
        }
        EXPECT_GT(found, 500) << entry.name;
    }
}

/// A box with a bore: what the bore leaves has the bore's own material, and its normals point into the bore.
TEST(Solids, ACutShowsTheCuttersMaterialTurnedOutwards) {
    Solids b(2);
    Node part;
    part.what = b.shape(Box{Vec3(-1), Vec3(1)});
    part.materials = {b.plain};
    const NodeId box = b.node(part, false);
    part.what = b.shape(Sphere{Vec3(0, 0, 1), 0.5});
    part.materials = {b.material(b.lambert(Color(1, 0, 0)))};
    const NodeId bore = b.node(part, false);
    Node difference;
    difference.csg = CsgKind::difference;
    difference.children = {box, bore};
    b.node(difference);
    b.camera(Vec3(0, 0, 5), Vec3(0), 10);
    RenderOptions options = test::centre_rays(1, {"normal", "albedo", "depth"});
    const Film film = test::rendered(b.scene, options);
    EXPECT_NEAR(test::value(film.picture, 0, 0, "depth.Z"), 4.5, 1e-6);
    EXPECT_NEAR(test::value(film.picture, 0, 0, "normal.Z"), 1, 1e-6);
    EXPECT_EQ(test::value(film.picture, 0, 0, "albedo.R"), 1);
}

/// A solid of glass lets light through by what is solid of it: its parts carry one interior.
TEST(Solids, PartsOfAnObjectShareItsInterior) {
    Solids b(3);
    b.scene.interiors.emplace_back();
    Node part;
    part.materials = {b.plain};
    part.what = b.shape(Sphere());
    const NodeId one = b.node(part, false), two = b.node(part, false);
    Node merge;
    merge.csg = CsgKind::merge;
    merge.interior = InteriorId{0};
    merge.children = {one, two};
    const NodeId whole = b.node(merge);
    b.scene.roots.push_back(whole);   // twice: two objects
    const auto scene = test::compiled(b.scene);
    ASSERT_EQ(scene->instances.size(), 4u);
    EXPECT_EQ(scene->instances[0].carrier, scene->instances[1].carrier);
    EXPECT_EQ(scene->instances[2].carrier, scene->instances[3].carrier);
}

/// What stands too deep is refused, not followed down the stack.
/// The same solid at the same place by other products of transformations, as files place things: its faces are apart by roundings, and still one.
TEST(Solids, ASolidLessItselfPlacedByAnotherWayIsNothing) {
    for (int number = 0; number < 40; ++number) {
        Solids b(uint64_t(20 + number));
        static const ShapeGeometry kShapes[] = {Sphere(), Box(), Cylinder{Vec3(0, -2, 0), Vec3(0, 2, 0), 0.6}, Cone{Vec3(0), Vec3(0, 2, 0), 1, 0.2}, Torus()};
        const ShapeGeometry& geometry = kShapes[size_t(number) % std::size(kShapes)];
        const Transform one = b.anywhere(), two = b.anywhere(), three = Transform::translate(b.draw.vector(20)) * Transform::from_quaternion(b.draw.quaternion());
        const auto placed = [&](const Transform& outer, const Transform& inner) {
            Node leaf;
            leaf.what = b.shape(geometry), leaf.materials = {b.plain}, leaf.to_parent = inner;
            Node around;
            around.children = {b.node(leaf, false)}, around.to_parent = outer;
            return b.node(around, false);
        };
        Node both;
        both.csg = CsgKind::difference;
        both.children = {placed(three * one, two), placed(three, one * two)};
        const NodeId solid = b.node(both);
        const auto nothing = test::compiled(b.scene);
        b.scene.nodes[solid.index].csg = CsgKind::merge;
        const auto merged = test::compiled(b.scene);
        const Bounds box = (three * one * two).bounds(bounds(geometry));
        int met = 0;
        for (int i = 0; i < 500; ++i) {
            Ray ray;
            ray.origin = box.center() + b.draw.vector(20), ray.dir = box.center() + b.draw.vector(0.3) * box.extent() - ray.origin;
            Hit hit, unused;
            WorkCounters work;
            met += merged->top->intersect(ray, unused, work);
            EXPECT_FALSE(nothing->top->intersect(ray, hit, work)) << number << ' ' << i;
        }
        EXPECT_GT(met, 100) << number;
    }
}

TEST(Solids, AreNotDeeperThanTheStack) {
    Solids b(4);
    NodeId below = b.random_shape();
    for (int i = 0; i < 100000; ++i) {
        Node n;
        n.csg = CsgKind::difference;
        n.children = {below};
        below = b.node(n, i == 99999);
    }
    Diagnostics said;
    compile(b.scene, {}, said);
    EXPECT_NE(said.text().find("levels deep"), std::string::npos) << said.text();
}

/// What alternates is as deep as it stands there: the error has the place of the object.
TEST(Solids, ThatAreTooDeepHaveAPlace) {
    Solids b(5);
    b.scene.files.push_back({"deep.pov"});
    NodeId below = b.random_shape();
    constexpr int kLevels = 2400;
    for (int i = 0; i < kLevels; ++i) {
        Node n;
        n.csg = i % 2 ? CsgKind::intersection : CsgKind::merge;
        n.children = {below, b.random_shape()};
        n.from.file = 0, n.from.line = uint32_t(i + 1), n.from.column = 7;
        below = b.node(n, i == kLevels - 1);
    }
    Diagnostics said;
    EXPECT_FALSE(compile(b.scene, {}, said));
    EXPECT_NE(said.text().find("deep.pov:2400:7: error: different set operations stand more than 1000 levels deep"), std::string::npos) << said.text();
}

/// Threads that render have small stacks.
TEST(Solids, WhatIsLaidOpenIsFoundHoweverDeepItStands) {
    test::SceneBuilder b;
    const auto ball = [&](double radius) { Node n; n.what = b.shape(Sphere{Vec3(0), radius}); return n; };
    Node colored = ball(1), box = ball(1);
    colored.materials = {b.material(b.lambert(Color(1)))};
    box.what = b.shape(Box{Vec3(-2, -2, -0.5), Vec3(2)});
    NodeId below = b.node(colored, false);
    constexpr int kLevels = 2000;
    for (int i = 0; i < kLevels; ++i) {
        Node n;
        n.csg = CsgKind::intersection, n.cutaway_textures = true;
        n.children = {below, b.node(i == 0 ? box : ball(3), false)};
        below = b.node(n, i == kLevels - 1);
    }
    const auto scene = test::compiled(b.scene);
    ASSERT_FALSE(scene->cutaways.empty());
    ShadePoint point;
    point.position = Vec3(0, 0, -0.5);
    while (point.instance < scene->instances.size() && scene->instances[point.instance].cutaway == kNoId) ++point.instance;
    ASSERT_LT(point.instance, scene->instances.size());
    std::pair<const CompiledScene*, const ShadePoint*> asked{scene.get(), &point};
    pthread_attr_t small;
    pthread_t thread;
    pthread_attr_init(&small);
    pthread_attr_setstacksize(&small, 128 * 1024);
    static std::vector<uint32_t> open;
    ASSERT_EQ(pthread_create(&thread, &small, [](void* in) -> void* {
        const auto& [s, p] = *static_cast<std::pair<const CompiledScene*, const ShadePoint*>*>(in);
        open = slots_laid_open(*s, *p);
        return nullptr;
    }, &asked), 0);
    pthread_join(thread, nullptr);
    ASSERT_EQ(open.size(), 1u);
    EXPECT_EQ(scene->slots[open[0]].material, colored.materials[0]->index);
}

}  // namespace
}  // namespace alidade
