// SPDX-License-Identifier: Apache-2.0
/// The octree of triangles finds every corner of every triangle through all boxes above, and ends where nothing can be told apart.
#include "accel/octree/wide_octree.h"
#include "numerics/triangles/compare.h"
#include "numerics/triangles/rays.h"
#include "tests/core/run_size.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace alidade::test {

using namespace numerics;

namespace {

template <class R> class OctreeOf : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(OctreeOf, Reals);

template <class R> struct Tree {
    std::vector<uint32_t> order;
    BuildStats stats;
    LargeVector<WideNode<R>> nodes;

    explicit Tree(const TriangleSource<R>& source) {
        std::vector<BvhReference<R>> references;
        for (uint32_t id = 0; id < source.size(); ++id) references.emplace_back(source.box(id), id);
        nodes = build_wide_octree<R>(std::move(references), source, Vec3(1), order, stats);
    }
};

template <class R> BoundsT<R> box_of(const WideNode<R>& node, uint32_t i) {
    const auto& p = node.planes;
    return {{p[0][i], p[2][i], p[4][i]}, {p[1][i], p[3][i], p[5][i]}};
}

template <class R> Bounds in_double(const BoundsT<R>& box) { return {Vec3(box.min), Vec3(box.max)}; }

/// Shows `leaf` each leaf, and what all boxes above it, and its own, have in common.
template <class R, class F> void for_each_leaf(const Tree<R>& tree, const F& leaf) {
    size_t next = 0;
    const auto walk = [&](const auto& self, uint32_t index, const Bounds& above) -> void {
        ASSERT_EQ(index, next++) << "depth first";
        for (uint32_t i = 0; i < kWide; ++i) {
            const Bounds box = in_double(box_of(tree.nodes[index], i));
            if (box.empty()) continue;
            const uint32_t child = tree.nodes[index].child[i];
            const Bounds common = intersection(above, box);
            if (WideLeaf::is(child)) leaf(std::span(tree.order).subspan(size_t(WideLeaf::block(child)) * kLanes, WideLeaf::count(child)), common);
            else self(self, child, common);
        }
    };
    walk(walk, 0, {Vec3(-kInf), Vec3(kInf)});
    EXPECT_EQ(next, tree.nodes.size());
}

std::vector<TriangleMesh> meshes() { return {torus(30, 20), soup(2000, 0.2, 6), battens(150), stadium(4, 1), turned(moved(geodesic_sphere(6), Vec3(1e3, 1, 1), Vec3(0), ""), "needle askew")}; }

TYPED_TEST(OctreeOf, LeavesHoldEveryCorner) {
    using R = TypeParam;
    for (const TriangleMesh& mesh : meshes()) {
        const TriangleSource<R> source(mesh.view());
        const Tree<R> tree(source);
        std::set<std::pair<uint32_t, int>> corners;
        size_t references = 0;
        for_each_leaf(tree, [&](std::span<const uint32_t> ids, const Bounds& box) {
            EXPECT_EQ(std::set<uint32_t>(ids.begin(), ids.end()).size(), ids.size()) << "never twice in one";
            references += ids.size();
            for (const uint32_t id : ids) {
                ASSERT_LT(id, source.size());
                EXPECT_FALSE(intersection(box, source.bounds(id)).empty()) << mesh.name;
                for (int c = 0; c < 3; ++c)
                    if (box.contains(source.corners(id)[size_t(c)])) corners.emplace(id, c);
            }
        });
        EXPECT_EQ(corners.size(), 3 * source.size()) << mesh.name;
        EXPECT_LE(double(references), kTriangleGrowth * double(source.size())) << mesh.name;
        EXPECT_EQ(tree.stats.splits > 0, references > source.size()) << mesh.name;
    }
}

/// Triangles beside each other are cut nowhere; where long ones cross many boxes it pays.
TYPED_TEST(OctreeOf, CutsLargeTrianglesAlone) {
    const auto growth = [](const TriangleMesh& mesh) {
        const TriangleSource<TypeParam> source(mesh.view());
        const std::vector<uint32_t> order = Tree<TypeParam>(source).order;
        return double(order.size() - size_t(std::count(order.begin(), order.end(), kPadding))) / double(source.size());
    };
    EXPECT_LT(growth(torus(60, 40)), 1.2);
    EXPECT_GT(growth(battens(150)), 1.5);
}

/// Many at one place, and triangles in triangles down to the smallest: nothing can be halved for ever, and all are still found.
TYPED_TEST(OctreeOf, EndsWhereNothingCanBeToldApart) {
    std::vector<Vec3> same, nested;
    std::vector<Index3> triangles;
    for (uint32_t i = 0; i < 5000; ++i) {
        const double size = std::ldexp(1.0, -int(i % 100));
        for (const Vec3& p : {Vec3(-1, -1, 0.5), Vec3(1, -1, 0.5), Vec3(0, 1, -0.5)}) same.push_back(p), nested.push_back(size * p);
        triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    constexpr Precision precision = std::is_same_v<TypeParam, float> ? Precision::float_ : Precision::double_;
    for (const TriangleMesh& mesh : {TriangleMesh("one triangle many times", same, triangles), TriangleMesh("triangles in triangles", nested, triangles)}) {
        const TriangleMesh read = mesh.read_at(precision);
        const auto octree = build(*find_accelerator("octree"), read, {precision}), brute = brute_force(read, precision);
        EXPECT_LE(octree->stats().depth, size_t(kWideOctreeDepth + 11)) << mesh.name;
        for (size_t i = 0; i < run_size(30, 3000); ++i) {
            const Ray ray = ray_classes().front().make(read, RandomKey(91, 0, i, 0));
            ASSERT_EQ(difference(answers(*octree, ray), answers(*brute, ray)), "") << mesh.name << ", ray " << i;
        }
    }
}

}  // namespace
}  // namespace alidade::test
