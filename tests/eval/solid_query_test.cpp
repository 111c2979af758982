// SPDX-License-Identifier: Apache-2.0
/// What is asked of subtrees of a scene, beside an oracle that evaluates the operations point by point.
#include "eval/solid_query.h"
#include "tests/core/run_size.h"

#include <gtest/gtest.h>
#include <random>

namespace alidade {
namespace {

/// Random trees of operations on spheres, boxes and tori, moved, turned inside out and clipped.
class RandomSolids {
  public:
    explicit RandomSolids(unsigned seed) : random_(seed) {}

    NodeId node(int depth) {
        Node n;
        n.to_parent = transform();
        n.inverse = chance(6);
        if (depth == 0 || chance(4)) {
            n.what = shape();
        } else {
            static constexpr CsgKind kKinds[] = {CsgKind::union_, CsgKind::merge, CsgKind::intersection, CsgKind::difference};
            n.csg = kKinds[random_() % 4];
            const size_t parts = 2 + random_() % 3;
            for (size_t i = 0; i < parts; ++i) n.children.push_back(node(depth - 1));
        }
        if (chance(5)) n.clips.push_back(node(0));
        return add(std::move(n));
    }

    /// Two levels of references to one node.
    NodeId shared(int depth) {
        const NodeId once = node(depth);
        Node pair;
        pair.csg = CsgKind::union_;
        pair.children = {once, once};
        scene.nodes[once.index].to_parent.translation += Vec3(0.1, 0, 0);
        const NodeId both = add(pair);
        Node turned;
        turned.to_parent = transform();
        turned.children = {both};
        return add(turned);
    }

    double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
    Vec3 point(double size) { return {uniform(-size, size), uniform(-size, size), uniform(-size, size)}; }

    Scene scene;

  private:
    bool chance(unsigned n) { return random_() % n == 0; }
    NodeId add(Node n) {
        scene.nodes.push_back(std::move(n));
        return {uint32_t(scene.nodes.size() - 1)};
    }
    Transform transform() {
        const Vec3 axis = normalized(point(1) + Vec3(0, 0, 1.5));
        return Transform::translate(point(0.4)) * Transform::rotate(axis, uniform(-3, 3)) * Transform::scale({uniform(0.6, 1.4), uniform(0.6, 1.4), -uniform(0.6, 1.4)});
    }
    ShapeId shape() {
        ShapeEntry entry;
        switch (random_() % 4) {
            case 0: entry.geometry = Box{-point(1) - 1.2, point(1) + 1.2}; break;
            case 1: entry.geometry = Torus{Vec3(0), uniform(0.7, 1.3), uniform(0.2, 0.5)}; break;
            case 2: entry.geometry = Plane{point(1) + Vec3(0, 1.5, 0), uniform(-1, 1)}; break;
            default: entry.geometry = Sphere{point(0.5), uniform(0.6, 1.5)}; break;
        }
        scene.shapes.push_back(std::move(entry));
        return {uint32_t(scene.shapes.size() - 1)};
    }

    std::mt19937 random_;
};

/// Point by point, from the definitions (docs/pov-support.md): what clips a solid is not inverted with it.
bool oracle_inside(const Scene& scene, NodeId id, const Vec3& outside, bool inverted = false) {
    const Node& node = scene.nodes[id.index];
    const Vec3 p = inverse(node.to_parent)->point(outside);
    inverted = inverted != node.inverse;
    bool in = false;
    if (const auto* shape = std::get_if<ShapeId>(&node.what)) {
        const ShapeGeometry& geometry = scene.shapes[shape->index].geometry;
        in = find_shape(geometry)->inside(geometry, p) != inverted;
    } else {
        const bool all = (node.csg == CsgKind::intersection || node.csg == CsgKind::difference) != inverted;
        in = all;
        for (const NodeId& child : node.children) {
            const bool taken = node.csg == CsgKind::difference && &child != &node.children.front();
            const bool part = oracle_inside(scene, child, p, inverted != taken);
            in = all ? in && part : in || part;
        }
    }
    for (const NodeId clip : node.clips) in = in && oracle_inside(scene, clip, p);
    return in;
}

/// The root turned inside out or clipped, so that unions show nothing that is inside of them.
NodeId as_merges(Scene& scene, NodeId root) {
    for (Node& node : scene.nodes)
        if (node.csg == CsgKind::union_ || (node.csg == CsgKind::none && !node.children.empty())) node.csg = CsgKind::merge;
    return root;
}

TEST(SolidQuery, PointsAreInsideWhereTheOperationsSaySo) {
    size_t inside = 0, asked = 0;
    for (unsigned seed = 1; seed <= 60; ++seed) {
        RandomSolids make(seed);
        const NodeId root = seed % 4 == 0 ? make.shared(2) : make.node(3);
        MeshAccelerators meshes(make.scene);
        const SolidQuery query(make.scene, root, meshes);
        ASSERT_TRUE(query.complete());
        for (int i = 0; i < 200; ++i, ++asked) {
            const Vec3 p = make.point(2.5);
            const bool want = oracle_inside(make.scene, root, p);
            ASSERT_EQ(query.inside(p), want) << "seed " << seed << " point " << p.x << " " << p.y << " " << p.z;
            inside += want;
        }
    }
    EXPECT_GT(inside, asked / 10);
    EXPECT_LT(inside, asked * 9 / 10);
}

/// Along the ray, the sides of the surface that is found differ, the normal leads out, and nothing changes before it.
TEST(SolidQuery, TheFirstSurfaceIsWhereTheInsideChangesFirst) {
    size_t hits = 0, misses = 0;
    for (unsigned seed = 1; seed <= std::max(test::run_size(30), size_t(6)); ++seed) {
        RandomSolids make(seed);
        const NodeId root = make.node(3);
        as_merges(make.scene, root);
        for (Node& node : make.scene.nodes) node.clips.clear();      // what is clipped has holes
        MeshAccelerators meshes(make.scene);
        const SolidQuery query(make.scene, root, meshes);
        for (int i = 0; i < 40; ++i) {
            Ray ray;
            ray.origin = make.point(4);
            ray.dir = normalized(make.point(1.2) - ray.origin);
            ray.tmin = 1e-4, ray.tmax = 20;
            const auto in = [&](double t) { return oracle_inside(make.scene, root, ray.at(t)); };
            const auto found = query.first(ray);
            const double t = found ? dot(found->point - ray.origin, ray.dir) : ray.tmax;
            const bool start = in(ray.tmin);
            constexpr double kStep = 1e-6, kCoarse = 0.1;
            for (double s = ray.tmin; s < t - kStep; s += kCoarse) ASSERT_EQ(in(s), start) << "seed " << seed << " ray " << i << " at " << s << " of " << t;
            ++(found ? hits : misses);
            if (!found || std::abs(dot(found->normal, ray.dir)) < 0.05) continue;
            ASSERT_EQ(in(t - kStep), start) << "seed " << seed << " ray " << i;
            ASSERT_NE(in(t + kStep), start) << "seed " << seed << " ray " << i;
            ASSERT_EQ(dot(found->normal, ray.dir) > 0, start) << "seed " << seed << " ray " << i << ": the normal leads out";
            ASSERT_NEAR(length(found->normal), 1, 1e-12);
        }
    }
    EXPECT_GT(hits, (hits + misses) / 4);
    EXPECT_GT(misses, (hits + misses) / 24);
}

TEST(SolidQuery, AMeshIsAskedThroughItsAccelerator) {
    Scene scene;
    Mesh mesh;
    for (int y = 0; y <= 100; ++y)
        for (int x = 0; x <= 100; ++x) mesh.positions.emplace_back(float(x), float(y), float((x * 7 + y * 3) % 5) * 0.1f);
    for (uint32_t y = 0; y < 100; ++y)
        for (uint32_t x = 0; x < 100; ++x) {
            const uint32_t a = y * 101 + x;
            mesh.triangles.emplace_back(a, a + 1, a + 101), mesh.triangles.emplace_back(a + 1, a + 102, a + 101);
        }
    ShapeEntry entry;
    entry.geometry = mesh;
    scene.shapes.push_back(entry);
    Node node;
    node.what = ShapeId{0};
    node.to_parent = Transform::translate({1, 2, 3});
    scene.nodes.push_back(node);
    MeshAccelerators meshes(scene);
    const SolidQuery query(scene, NodeId{0}, meshes);
    EXPECT_FALSE(query.inside({51, 52, 3.1}));
    Ray ray;
    ray.origin = {31, 42, 10}, ray.dir = {0, 0, -1};
    const auto found = query.first(ray);
    ASSERT_TRUE(found);
    EXPECT_TRUE(found->facet);
    EXPECT_NEAR(found->point.z, 3 + ((30 * 7 + 40 * 3) % 5) * 0.1, 1e-7);
    EXPECT_GT(found->normal.z, 0.5);
}

/// As POV-Ray has it: what has no inside has none inverted either, and takes away all.
TEST(SolidQuery, WhatATriangleOrAPolygonIsTakenFromHasNoSurface) {
    Polygon polygon;
    polygon.loops = {{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}};
    Mesh mesh;
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}};
    for (const ShapeGeometry& sheet : {ShapeGeometry(polygon), ShapeGeometry(mesh)}) {
        Scene scene;
        scene.shapes.resize(2);
        scene.shapes[0].geometry = Sphere(), scene.shapes[1].geometry = sheet;
        scene.nodes.resize(3);
        scene.nodes[0].csg = CsgKind::difference, scene.nodes[0].children = {NodeId{1}, NodeId{2}};
        scene.nodes[1].what = ShapeId{0}, scene.nodes[2].what = ShapeId{1};
        for (const bool inverse : {false, true}) {
            scene.nodes[2].inverse = inverse;
            MeshAccelerators meshes(scene);
            const SolidQuery query(scene, NodeId{0}, meshes);
            const auto found = query.first(Ray{{0, 0, -5}, {0, 0, 1}});
            ASSERT_TRUE(found);
            EXPECT_NEAR(found->t, 5, 1e-12) << "not the sphere";
            EXPECT_FALSE(query.inside(Vec3(0, 0, 0.5)));
        }
    }
}

TEST(SolidQuery, FlatShapesAreLeftOutAndEndlessReferencesAreRefused) {
    Scene scene;
    ShapeEntry entry;
    entry.geometry = Sphere();
    scene.shapes.push_back(entry);
    Node leaf;
    leaf.what = ShapeId{0};
    leaf.to_parent = Transform::scale({1, 0, 1});
    scene.nodes.push_back(leaf);
    MeshAccelerators meshes(scene);
    const SolidQuery flat(scene, NodeId{0}, meshes);
    EXPECT_TRUE(flat.complete());
    EXPECT_FALSE(flat.inside(Vec3(0)));
    EXPECT_FALSE(flat.first(Ray{{0, 0, -5}, {0, 0, 1}}));
    scene.nodes[0].to_parent = Transform();
    for (uint32_t level = 0; level < 40; ++level) {                  // 2^40 spheres
        Node pair;
        pair.csg = CsgKind::union_;
        pair.children = {NodeId{level}, NodeId{level}};
        scene.nodes.push_back(pair);
    }
    const SolidQuery endless(scene, NodeId{40}, meshes);
    EXPECT_FALSE(endless.complete());
    EXPECT_FALSE(endless.inside(Vec3(0)));
}

}  // namespace
}  // namespace alidade
