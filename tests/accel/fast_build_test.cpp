// SPDX-License-Identifier: Apache-2.0
/// The fast builder: the invariants of a tree on easy and on hopeless references, and what its trees cost rays beside those of the surface area heuristic.
#include "accel/bvh/fast_build.h"
#include "accel/bvh/hilbert.h"
#include "accel/leaf.h"
#include "accel/triangles/edge_filter.h"
#include "core/draws.h"
#include "numerics/triangles/compare.h"
#include "numerics/triangles/rays.h"
#include "tests/core/run_size.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace alidade::test {

using namespace numerics;
namespace {

template <class R> class FastBuild : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(FastBuild, Reals);

/// Each cell of a cube has a place of its own, and cells that follow each other share a side; what is below a cell is together.
TEST(Hilbert, CellsThatFollowEachOtherAreNeighbours) {
    constexpr uint32_t kBits = 5, kCount = 1u << 3 * kBits, kBelow = 3 * (HilbertCurve::kLevels - kBits);
    std::vector<uint32_t> at(kCount, kCount);
    for (uint32_t cell = 0; cell < kCount; ++cell) {
        const uint32_t place = HilbertCurve::place(cell << kBelow) >> kBelow;
        ASSERT_LT(place, kCount);
        ASSERT_EQ(at[place], kCount) << place;
        at[place] = cell;
    }
    const auto coordinate = [](uint32_t cell, uint32_t axis) {
        int x = 0;
        for (uint32_t bit = 0; bit < kBits; ++bit) x |= int(cell >> (3 * bit + axis) & 1) << bit;
        return x;
    };
    for (uint32_t i = 1; i < kCount; ++i) {
        int apart = 0;
        for (uint32_t axis = 0; axis < 3; ++axis) apart += std::abs(coordinate(at[i], axis) - coordinate(at[i - 1], axis));
        ASSERT_EQ(apart, 1) << "at " << i;
    }
    for (uint32_t i = 0; i < 64; ++i) EXPECT_EQ(HilbertCurve::place(0x2ad3b5c0 | i) >> 6, HilbertCurve::place(0x2ad3b5c0) >> 6);
}

struct Spread {
    const char* name;
    Vec3 (*at)(uint32_t id);
};

/// Hopeless: all codes are the same, again and again.
const Spread kSpreads[] = {
    {"random", [](uint32_t id) { Draws draws(RandomKey(71, 0, id, 0)); return draws.in_box(Vec3(-1), Vec3(1)); }},
    {"a point", [](uint32_t) { return Vec3(3); }},
    {"a line", [](uint32_t id) { return Vec3(id, 0, 0); }},
    {"two far crowds", [](uint32_t id) { Draws draws(RandomKey(72, 0, id, 0)); return draws.in_box(Vec3(0), Vec3(1e-3)) + Vec3(id % 2 ? 1e6 : 0); }},
    {"powers of two", [](uint32_t id) { return Vec3(std::exp2(-double(id % 100)), std::exp2(double(id % 90)), 0); }},
};

template <class R> LargeVector<BvhReference<R>> references_of(const Spread& spread, uint32_t count) {
    LargeVector<BvhReference<R>> references;
    for (uint32_t id = 0; id < count; ++id) {
        const Vec3T<R> low(spread.at(id));
        references.emplace_back(BoundsT<R>{low, low + Vec3T<R>(R(0.01) * R(id % 7))}, id);
    }
    return references;
}

template <class R> bool holds(const BoundsT<R>& outer, const BoundsT<R>& inner) { return outer.contains(inner.min) && outer.contains(inner.max); }

/// Every reference is in one leaf, boxes hold their children, nodes come in depth-first order of pairs, and no path is too long for a stack.
TYPED_TEST(FastBuild, TreesHoldEveryReferenceOnce) {
    using R = TypeParam;
    for (const Spread& spread : kSpreads) {
        for (const uint32_t count : {1u, 8u, 9u, 16u, 17u, 200u, 5000u, 30000u}) {
            const auto references = references_of<R>(spread, count);
            for (const BvhLimits& limits : {BvhLimits{kLanes, kLanes}, BvhLimits{1, 4}}) {
                std::vector<uint32_t> order{7};
                BuildStats stats;
                const auto nodes = build_bvh_fast<R>(references, limits, order, stats);
                std::vector<int> seen(count, 0);
                size_t next = 1, leaves = 0;
                const auto walk = [&](const auto& self, uint32_t index, uint32_t depth) -> void {
                    const BvhNode<R>& node = nodes[index];
                    ASSERT_LE(depth, kBvhDepth);
                    if (!node.leaf()) {
                        ASSERT_EQ(node.first, next) << spread.name;
                        next += 2;
                        ASSERT_TRUE(holds(node.box, nodes[node.first].box) && holds(node.box, nodes[node.first + 1].box));
                        self(self, node.first, depth + 1), self(self, node.first + 1, depth + 1);
                        return;
                    }
                    ++leaves;
                    ASSERT_EQ(node.first % limits.block, 0u);
                    ASSERT_LE(node.count, limits.max_leaf);
                    for (uint32_t i = node.first; i < node.first + node.count; ++i) {
                        ++seen.at(order.at(i));
                        ASSERT_TRUE(holds(node.box, references[order[i]].box()));
                    }
                };
                walk(walk, 0, 0);
                EXPECT_EQ(next, nodes.size());
                EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), std::ptrdiff_t(count)) << spread.name;
                EXPECT_EQ(std::tuple(stats.nodes, stats.leaves), std::tuple(nodes.size(), leaves));
                EXPECT_EQ(order.front(), 7u) << "what was there stays";
            }
        }
    }
}

/// Loss is bounded where no spatial splits are: a ray's tests are at most a tenth more.
TEST(FastTree, RaysTakeLittleMoreThanInTheBestTree) {
    if (run_scale() < 1) GTEST_SKIP() << "work is counted in the ordinary run";
    for (const TriangleMesh& mesh : {geodesic_sphere(71, 0.2), soup(100000, 0.02, 4), torus(300, 200)}) {
        WorkCounters work[2];
        size_t i = 0;
        for (const char* name : {"bvh", "hlbvh"}) {
            const auto accelerator = build(*find_accelerator(name), mesh, {});
            for (size_t k = 0; k < 2000; ++k) {
                Hit hit;
                accelerator->intersect(ray_classes().front().make(mesh, RandomKey(51, 0, k, 0)), hit, work[i]);
            }
            ++i;
        }
        const double boxes = double(work[1].boxes) / double(work[0].boxes), filtered = double(work[1].filtered) / double(work[0].filtered);
        fmt::print("{}: {:.3f} of the boxes, {:.3f} of the triangles\n", mesh.name, boxes, filtered);
        EXPECT_LE(boxes, 1.1) << mesh.name;
        EXPECT_LE(filtered, 1.4) << mesh.name << ": leaves are fuller, and eight triangles are tested at once";
    }
}

}  // namespace
}  // namespace alidade::test
