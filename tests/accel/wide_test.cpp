// SPDX-License-Identifier: Apache-2.0
/// Eight boxes at once are eight times one box, bit for bit, and the wide tree holds what the binary one held.
#include "accel/bvh/wide.h"
#include "core/draws.h"
#include "tests/core/run_size.h"

#include <gtest/gtest.h>

#include <algorithm>


namespace alidade::test {
namespace {

template <class R> class Wide : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(Wide, Reals);

/// Boxes and rays that share planes: origins stand on them, many components are 0, so that products of 0 and infinity are among the ends of slabs.
template <class R> R coordinate(Draws& draws) {
    switch (draws.below(6)) {
        case 0: return R(0);
        case 1: return R(int(draws.below(5)) - 2);
        case 2: return R(draws.sign() * std::ldexp(1.0, int(draws.below(200)) - 100));
        default: return R(draws.uniform(-2, 2));
    }
}

template <class R> WideNode<R> random_node(const auto& ray, Draws& draws) {
    WideNode<R> node{};
    for (uint32_t i = 0; i < kWide; ++i) {
        const bool empty = draws.below(10) == 0;
        for (int a = 0; a < 3; ++a) {
            const R x = draws.below(4) ? coordinate<R>(draws) : ray.near_origin(a), y = draws.coin() ? x : coordinate<R>(draws);
            node.planes[2 * a][i] = empty ? std::numeric_limits<R>::infinity() : std::min(x, y);
            node.planes[2 * a + 1][i] = empty ? -std::numeric_limits<R>::infinity() : std::max(x, y);
        }
    }
    return node;
}

Vec3 random_dir(Draws& draws) {
    Vec3 dir(draws.uniform(-1, 1), draws.uniform(-1, 1), draws.uniform(-1, 1));
    for (int a = 0; a < 3; ++a) {
        if (draws.below(3) == 0) dir[a] = draws.coin() ? 0.0 : draws.sign() * std::ldexp(1.0, -int(draws.below(320)));
    }
    dir[int(draws.below(3))] = draws.sign() * draws.uniform(1, 2);
    return dir;
}

template <class R> LocalRay random_ray(Draws& draws) {
    LocalRay ray;
    for (int a = 0; a < 3; ++a) ray.origin[a] = double(coordinate<R>(draws));
    ray.dir = random_dir(draws), ray.inverse = Vec3(1.0) / ray.dir, ray.reach = draws.coin() ? 4 : 1e30;
    ray.tmin = draws.coin() ? 0 : draws.coin() ? -0x1p-200 : draws.uniform(-2, 2);
    return ray;
}

template <class R, int kUnits> void expect_boxes_as_one_at_a_time(WideBoxTest<WideNode<R>> (*box_test)(Isa)) {
    size_t entered = 0, nans = 0, fusing = 0, flat = 0;
    const size_t count = run_size(200000, 10000000);
    for (size_t n = 0; n < count; ++n) {
        Draws draws(RandomKey(31, 0, n, 0));
        const LocalRay local = random_ray<R>(draws);
        const double size = draws.below(4) ? 4 : 0x1p-60;
        const WideRay<R, kUnits> fused(local, size, true), plain(local, size, false);
        const WideNode<R> node = random_node<R>(draws.coin() ? fused : plain, draws);
        const R limit = plain.limit(draws.coin() ? std::numeric_limits<double>::max() : draws.uniform(-1, 4));
        ASSERT_FALSE(plain.fused());
        fusing += fused.fused(), flat += fused.fused() && std::min({std::abs(local.dir.x), std::abs(local.dir.y), std::abs(local.dir.z)}) < kSmallestSlope<R>;
        for (const Isa isa : available_isas()) {
            const WideRay<R, kUnits>& ray = fuses(isa) ? fused : plain;
            alignas(64) R entries[kWide];
            const uint32_t bits = box_test(isa)(node, local, size, limit, entries);
            for (uint32_t i = 0; i < kWide; ++i) {
                BoundsT<R> box;
                for (int a = 0; a < 3; ++a) box.min[a] = node.planes[2 * a][i], box.max[a] = node.planes[2 * a + 1][i];
                const R want = ray.enter(box, limit);
                ASSERT_EQ((bits >> i & 1) != 0, want <= limit) << name(isa) << ", seed 31, node " << n << ", box " << i;
                if (!(want <= limit)) continue;
                ASSERT_EQ(std::signbit(entries[i]), std::signbit(want)) << name(isa) << ", seed 31, node " << n << ", box " << i;
                ASSERT_EQ(entries[i], want) << name(isa) << ", seed 31, node " << n << ", box " << i;
                ++entered;
                for (int a = 0; a < 3; ++a) nans += std::isnan(((ray.negative(a) ? box.max[a] : box.min[a]) - ray.near_origin(a)) * ray.near_inverse(a));
            }
        }
    }
    EXPECT_GT(entered, count / 4) << "the test must exercise entered boxes";
    EXPECT_GT(nans, count / 1000) << "and planes on which a ray without slope runs";
    EXPECT_GT(fusing, count / 8) << "and rays whose ends are fused";
    EXPECT_GT(flat, count / 50) << "and such without slope";
    if (std::is_same_v<R, float>) { EXPECT_LT(fusing, count) << "and others"; }
}

TYPED_TEST(Wide, BoxesAreEnteredAsOneAtATime) { expect_boxes_as_one_at_a_time<TypeParam, kTriangleUnits>(wide_box_test<WideNode<TypeParam>>); }
TEST(WideSet, BoxesAreEnteredAsOneAtATime) { expect_boxes_as_one_at_a_time<double, kSetUnits>(wide_set_box_test); }

/// A number of few bits, so that o + t d of three such is exact in double.
double short_number(Draws& draws, int bits) { return std::ldexp(double(draws.below(1u << bits)) - std::ldexp(0.5, bits), 1 - bits); }

template <class R> R round_down(double x) {
    const R near = R(x);
    return double(near) > x ? std::nextafter(near, -std::numeric_limits<R>::infinity()) : near;
}

/// A ray and a time, and the box of its exact point there, as tight as R allows, or wider on some sides.
template <class R> struct Touched {
    LocalRay ray;
    double t;
    BoundsT<R> box;

    explicit Touched(Draws& draws) {
        const double scale = draws.coin() ? 1 : std::ldexp(1.0, int(draws.below(160)) - 80);
        for (int a = 0; a < 3; ++a) ray.origin[a] = draws.below(6) ? scale * short_number(draws, 22) : 0;
        for (int a = 0; a < 3; ++a) ray.dir[a] = draws.below(4) ? short_number(draws, 12) : draws.coin() ? 0 : std::ldexp(1.0, -int(draws.below(20)));
        ray.dir[int(draws.below(3))] = draws.sign();
        ray.inverse = Vec3(1.0) / ray.dir, ray.tmin = draws.coin() ? 0 : draws.coin() ? scale / 8 : -64 * scale, t = std::max(ray.tmin, 0.0) + scale * (1 + short_number(draws, 8)) * (draws.coin() ? 1 : 0x1p6), ray.reach = t;
        for (int a = 0; a < 3; ++a) {
            const double p = ray.origin[a] + t * ray.dir[a];
            box.min[a] = round_down<R>(p), box.max[a] = -round_down<R>(-p);
            if (draws.coin()) box.min[a] -= R(scale), box.max[a] += R(scale);
        }
    }
};

/// Of exact points, which no rounding may lose (docs/numerics.md, "Eight at once").
template <class R, int kUnits> void expect_boxes_of_points_are_entered() {
    size_t fused = 0;
    const size_t count = run_size(200000, 20000000);
    for (size_t n = 0; n < count; ++n) {
        Draws draws(RandomKey(33, 0, n, 0));
        const Touched<R> one(draws);
        for (const bool fuses : {true, false}) {
            const WideRay<R, kUnits> ray(one.ray, 4, fuses);
            const R limit = ray.limit(one.t);
            ASSERT_LE(ray.enter(one.box, limit), limit) << (fuses ? "fused" : "plain") << ", seed 33, ray " << n;
            fused += ray.fused();
        }
    }
    EXPECT_GT(fused, count / 2);
}

TYPED_TEST(Wide, BoxOfAPointOfTheRayIsEnteredBeforeIt) { expect_boxes_of_points_are_entered<TypeParam, kTriangleUnits>(); }
TEST(WideSet, BoxOfAPointOfTheRayIsEnteredBeforeIt) { expect_boxes_of_points_are_entered<double, kSetUnits>(); }

template <class R> LargeVector<BvhReference<R>> random_references(size_t count, uint64_t seed = 0) {
    LargeVector<BvhReference<R>> references;
    Draws draws(RandomKey(32, 0, count, seed));
    for (uint32_t id = 0; id < count; ++id) {
        const Vec3T<R> a(draws.in_box(Vec3(-1), Vec3(1)));
        references.emplace_back(BoundsT<R>{a, a + Vec3T<R>(draws.in_box(Vec3(0), Vec3(0.1)))}, id);
    }
    return references;
}

template <class R> BoundsT<R> box_of(const WideNode<R>& node, uint32_t i) {
    const auto& p = node.planes;
    return {{p[0][i], p[2][i], p[4][i]}, {p[1][i], p[3][i], p[5][i]}};
}

template <class R> bool holds(const BoundsT<R>& outer, const BoundsT<R>& inner) { return outer.contains(inner.min) && outer.contains(inner.max); }

/// Every reference is in one leaf, inside of all boxes above it; nodes and leaves follow each other in memory as a walk from left to right meets them.
TYPED_TEST(Wide, TreeHoldsEveryReferenceOnce) {
    using R = TypeParam;
    for (const size_t count : {1u, 7u, 9u, 60u, 3000u}) {
        const auto references = random_references<R>(count);
        std::vector<uint32_t> order;
        BuildStats stats;
        const auto nodes = widened(build_bvh<R>(references, {kLanes, kLanes, Isa::best}, order, stats), stats);
        ASSERT_EQ(nodes.size(), stats.nodes);
        size_t seen = 0, next_node = 0;
        uint32_t next_block = 0;
        const auto walk = [&](const auto& self, uint32_t index, const BoundsT<R>& outer) -> void {
            ASSERT_EQ(index, next_node++);
            for (uint32_t i = 0; i < kWide; ++i) {
                const BoundsT<R> box = box_of(nodes[index], i);
                if (box.empty()) continue;
                ASSERT_TRUE(holds(outer, box));
                const uint32_t child = nodes[index].child[i];
                if (!WideLeaf::is(child)) {
                    self(self, child, box);
                    continue;
                }
                ASSERT_EQ(WideLeaf::block(child), next_block++);
                for (uint32_t k = 0; k < WideLeaf::count(child); ++k, ++seen) {
                    const uint32_t id = order.at(size_t(WideLeaf::block(child)) * kLanes + k);
                    ASSERT_LT(id, count);
                    ASSERT_TRUE(holds(box, references[id].box()));
                }
            }
        };
        walk(walk, 0, {Vec3T<R>(R(-2)), Vec3T<R>(R(2))});
        EXPECT_EQ(seen, count);
        EXPECT_EQ(next_node, nodes.size());
        EXPECT_EQ(next_block, stats.leaves);
    }
}

/// All sets of at most eight nodes that stand for a whole subtree.
template <class R> std::vector<std::vector<uint32_t>> cuts(const LargeVector<BvhNode<R>>& nodes, uint32_t node) {
    std::vector<std::vector<uint32_t>> all{{node}};
    if (nodes[node].leaf()) return all;
    for (const auto& left : cuts(nodes, nodes[node].first)) {
        for (const auto& right : cuts(nodes, nodes[node].first + 1)) {
            if (left.size() + right.size() > kWide) continue;
            all.push_back(left);
            all.back().insert(all.back().end(), right.begin(), right.end());
        }
    }
    return all;
}

/// The least area of wide nodes that a subtree can become, by trying everything.
template <class R> double least_area(const LargeVector<BvhNode<R>>& nodes, uint32_t node) {
    if (nodes[node].leaf()) return 0;
    double least = kInf;
    for (const auto& cut : cuts(nodes, node)) {
        if (cut.size() == 1) continue;
        double sum = area(nodes[node].box);
        for (const uint32_t child : cut) sum += least_area(nodes, child);
        least = std::min(least, sum);
    }
    return least;
}

/// No other way to join binary nodes gives wide nodes of less area: a ray meets the fewest.
TYPED_TEST(Wide, NodesHaveTheLeastArea) {
    using R = TypeParam;
    for (const size_t count : {9u, 11u, 13u}) {
        for (uint64_t seed = 0; seed < 20; ++seed) {
            std::vector<uint32_t> order;
            BuildStats stats;
            const auto binary = build_bvh<R>(random_references<R>(count, seed), {1, 1, Isa::best}, order, stats);
            double sum = area(binary[0].box);
            for (const WideNode<R>& node : widened(binary, stats)) {
                for (uint32_t i = 0; i < kWide; ++i) {
                    if (!WideLeaf::is(node.child[i])) sum += area(box_of(node, i));
                }
            }
            EXPECT_NEAR(sum, least_area(binary, 0), 1e-5 * sum) << count << " references, seed " << seed;
        }
    }
}

/// The tree that the scalar passes make, for every instruction set.
TYPED_TEST(Wide, TreeIsTheSameForEveryIsa) {
    using R = TypeParam;
    for (const size_t count : {10u, 100u, 20000u}) {
        const auto references = random_references<R>(count);
        std::vector<uint32_t> want_order;
        BuildStats stats;
        const auto want = build_bvh<R>(references, {kLanes, kLanes, Isa::scalar}, want_order, stats);
        for (const Isa isa : available_isas()) {
            std::vector<uint32_t> order;
            const auto nodes = build_bvh<R>(references, {kLanes, kLanes, isa}, order, stats);
            ASSERT_EQ(nodes.size(), want.size()) << name(isa);
            EXPECT_EQ(order, want_order) << name(isa);
            for (size_t i = 0; i < nodes.size(); ++i) {
                ASSERT_EQ(nodes[i].box.min, want[i].box.min) << name(isa);
                ASSERT_EQ(nodes[i].box.max, want[i].box.max) << name(isa);
            }
        }
    }
}

/// Bins hold what a loop over the references says; the partition is a stable one.
TYPED_TEST(Wide, PassesDoWhatTheyAreNamedFor) {
    using R = TypeParam;
    const auto references = random_references<R>(500);
    CentroidBounds<R> centroids;
    for (const auto& reference : references) centroids.extend(reference);
    const CentroidMap<R> map(centroids, kMostBins);
    for (const Isa isa : available_isas()) {
        Bins<R> bins;
        binning_passes<R>(isa).fill(references, map, bins);
        for (int axis = 0; axis < 3; ++axis) {
            for (int bin = 0; bin < kMostBins; ++bin) {
                BoxEnds<R> box = BoxEnds<R>::none();
                uint32_t count = 0;
                for (const auto& reference : references) {
                    if (map.bin(reference, axis) == bin) box.extend(reference), ++count;
                }
                ASSERT_EQ(bins.count[axis][bin], count) << name(isa);
                if (count == 0) continue;
                ASSERT_EQ(bins.box[axis][bin].box().max, box.box().max) << name(isa);
                ASSERT_EQ(bins.box[axis][bin].box().min, box.box().min) << name(isa);
            }
            auto sorted = references, want = references;
            CentroidBounds<R> left, right;
            const auto is_right = [&](const auto& reference) { return map.bin(reference, axis) >= 7; };
            const auto rights = std::stable_partition(want.begin(), want.end(), is_right) - want.begin();
            binning_passes<R>(isa).scatter(references, sorted.data() + rights, sorted.data(), map, axis, 7, left, right);
            for (size_t i = 0; i < want.size(); ++i) ASSERT_EQ(sorted[i].id(), want[i].id()) << name(isa);
            CentroidBounds<R> of_rights, of_lefts;
            for (std::ptrdiff_t i = 0; i < std::ptrdiff_t(want.size()); ++i) (i < rights ? of_rights : of_lefts).extend(want[size_t(i)]);
            for (int a = 0; a < 3; ++a) {
                EXPECT_EQ(left.low[a], of_lefts.low[a]) << name(isa);
                EXPECT_EQ(left.high[a], of_lefts.high[a]) << name(isa);
                EXPECT_EQ(right.low[a], of_rights.low[a]) << name(isa);
                EXPECT_EQ(right.high[a], of_rights.high[a]) << name(isa);
            }
        }
    }
}

}  // namespace
}  // namespace alidade::test
