// SPDX-License-Identifier: Apache-2.0
/// Spatial splits: the parts of a triangle hold all of it, exactly; the tree finds every point of every triangle; and no hit differs by a bit.
#include "accel/bvh/bvh.h"
#include "accel/bvh/presplit.h"
#include "core/draws.h"
#include "numerics/triangles/compare.h"
#include "numerics/triangles/rational.h"
#include "numerics/triangles/rays.h"
#include "tests/core/run_size.h"
#include "tests/accel/test_name.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

namespace alidade::test {

using namespace numerics;

namespace {

template <class R> class Spatial : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(Spatial, Reals);

/// A sliver or any other triangle; corners are numbers of type R.
template <class R> Corners random_triangle(Draws& draws, double scale, double offset) {
    Corners corners;
    const double width = draws.coin() ? 1 : std::pow(10.0, draws.uniform(-6, 0));
    const Vec3 from = draws.in_box(Vec3(-1), Vec3(1)), to = draws.in_box(Vec3(-1), Vec3(1));
    const Vec3 ends[] = {from, to, from + width * draws.in_box(Vec3(-1), Vec3(1))};
    for (size_t i = 0; i < 3; ++i) {
        for (int a = 0; a < 3; ++a) corners[i][a] = double(R(scale * (ends[i][a] + offset)));
        if (i && draws.below(4) == 0) corners[i][int(draws.below(3))] = corners[0][int(draws.below(3))];   // edges along planes
    }
    return corners;
}

template <class R> BoxEnds<R> box_of(const Corners& corners) {
    Bounds box;
    for (const Vec3& p : corners) box.extend(p);
    return BvhReference<R>({Vec3T<R>(box.min), Vec3T<R>(box.max)}, 0);
}

template <class R> bool holds(const BoxEnds<R>& box, const RationalVec& p) {
    for (int a = 0; a < 3; ++a) {
        if (!(std::isfinite(box.min(a)) && Rational(double(box.min(a))) <= p[size_t(a)] && p[size_t(a)] <= Rational(double(box.max(a))))) return false;
    }
    return true;
}

/// Of a triangle, exactly: corners, points of edges, and inner ones.
std::vector<RationalVec> points_of(const Corners& corners, int steps) {
    std::vector<RationalVec> points;
    const RationalVec c[] = {rational(corners[0]), rational(corners[1]), rational(corners[2])};
    for (int i = 0; i <= steps; ++i) {
        for (int k = 0; i + k <= steps; ++k) {
            RationalVec p;
            for (size_t a = 0; a < 3; ++a) p[a] = (c[0][a] * i + c[1][a] * k + c[2][a] * (steps - i - k)) / steps;
            points.push_back(p);
        }
    }
    return points;
}

/// Where the edges cross a plane: the points that rounding could lose.
std::vector<RationalVec> crossings(const Corners& corners, int axis, double plane) {
    std::vector<RationalVec> points;
    for (size_t i = 0; i < 3; ++i) {
        const RationalVec a = rational(corners[i]), b = rational(corners[(i + 1) % 3]);
        const auto on = size_t(axis);
        if ((a[on] < plane) == (b[on] < plane)) continue;
        const Rational s = (plane - a[on]) / (b[on] - a[on]);
        RationalVec p;
        for (size_t k = 0; k < 3; ++k) p[k] = a[k] + s * (b[k] - a[k]);
        points.push_back(p);
    }
    return points;
}

constexpr std::pair<double, double> kPlaces[] = {{1, 0}, {1e-30, 0}, {1e30, 0}, {1, 1e5}, {1e-3, 1e5}};   // scale, offset

/// Parts of parts of parts, by planes anywhere and on vertices: what was in the whole is in one of them. Rational arithmetic says where the points are.
TYPED_TEST(Spatial, PartsHoldAllOfTheTriangle) {
    using R = TypeParam;
    size_t cuts = 0;
    for (const auto& [scale, offset] : kPlaces) {
        for (size_t n = 0; n < run_size(1500, 100000); ++n) {
            Draws draws(RandomKey(71, 0, n, 0));
            const Corners corners = random_triangle<R>(draws, scale, offset);
            std::vector<BoxEnds<R>> boxes{box_of<R>(corners)};
            std::vector<RationalVec> points = points_of(corners, 5);
            for (int level = 0; level < 3; ++level) {
                std::vector<BoxEnds<R>> parts;
                for (const BoxEnds<R>& box : boxes) {
                    const int axis = int(draws.below(3));
                    const R plane = draws.below(4) ? R(box.min(axis) + draws.uniform() * (double(box.max(axis)) - double(box.min(axis)))) : R(corners[draws.below(3)][axis]);
                    if (!(box.min(axis) < plane && plane < box.max(axis))) {
                        parts.push_back(box);
                        continue;
                    }
                    ++cuts;
                    for (const RationalVec& p : crossings(corners, axis, double(plane))) points.push_back(p);
                    const Parts<R> both = cut(corners, box, axis, plane);
                    EXPECT_LE(both.below.max(axis), plane);
                    EXPECT_GE(both.above.min(axis), plane);
                    parts.push_back(both.below), parts.push_back(both.above);
                }
                boxes = parts;
            }
            for (const RationalVec& p : points)
                ASSERT_TRUE(std::any_of(boxes.begin(), boxes.end(), [&](const auto& box) { return holds(box, p); })) << "seed 71, triangle " << n << ", scale " << scale << ", offset " << offset;
        }
    }
    EXPECT_GT(cuts, run_size(1500, 100000) * 10);
}

/// A part is no larger than the exact one but for a few roundings of the coordinates.
TYPED_TEST(Spatial, PartsAreTight) {
    using R = TypeParam;
    for (const auto& [scale, offset] : kPlaces) {
        for (size_t n = 0; n < run_size(1000, 100000); ++n) {
            Draws draws(RandomKey(72, 0, n, 0));
            const Corners corners = random_triangle<R>(draws, scale, offset);
            const BoxEnds<R> box = box_of<R>(corners);
            const int axis = int(draws.below(3));
            const R plane = R(double(box.min(axis)) + draws.uniform() * (double(box.max(axis)) - double(box.min(axis))));
            if (!(box.min(axis) < plane && plane < box.max(axis))) continue;
            std::vector<RationalVec> below = crossings(corners, axis, double(plane));
            for (const Vec3& c : corners) {
                if (c[axis] <= double(plane)) below.push_back(rational(c));
            }
            const BoxEnds<R> got = cut(corners, box, axis, plane).below;
            for (int a = 0; a < 3; ++a) {
                double low = kInf, high = -kInf, size = 0;
                for (const RationalVec& p : below) low = std::min(low, p[size_t(a)].get_d()), high = std::max(high, p[size_t(a)].get_d());
                for (const Vec3& c : corners) size = std::max(size, std::abs(c[a]));
                const double slack = size * (4 * double(kUnitRoundoff<R>) + 64 * kUnitRoundoff<double>) + 1e-44;
                EXPECT_GE(double(got.min(a)), low - slack) << "seed 72, triangle " << n;
                EXPECT_LE(double(got.max(a)), high + slack) << "seed 72, triangle " << n;
            }
        }
    }
}

struct SplitTree {
    std::vector<uint32_t> order;
    BuildStats stats;
};

template <class R> LargeVector<BvhNode<R>> split_tree(const TriangleMesh& mesh, const BvhLimits& limits, SplitTree& tree, BvhBuilder builder = BvhBuilder::sah) {
    const TriangleSource<R> source(mesh.view());
    LargeVector<BvhReference<R>> references;
    for (uint32_t id = 0; id < source.size(); ++id) {
        const Bounds box = source.bounds(id);
        references.emplace_back(BoundsT<R>{Vec3T<R>(box.min), Vec3T<R>(box.max)}, id);
    }
    return builder == BvhBuilder::fast ? build_bvh_fast<R>(std::move(references), limits, tree.order, tree.stats, &source) : build_bvh<R>(std::move(references), limits, tree.order, tree.stats, &source);
}

template <class R> TriangleMesh read_as(const TriangleMesh& mesh) { return mesh.read_at(std::is_same_v<R, float> ? Precision::float_ : Precision::double_); }

/// No leaf names a triangle twice, and the budget is kept.
template <class R> void expect_tree_holds(const TriangleMesh& mesh, const LargeVector<BvhNode<R>>& nodes, const SplitTree& tree, double growth) {
    const size_t references = tree.order.size() - size_t(std::count(tree.order.begin(), tree.order.end(), kPadding));
    EXPECT_GT(references, mesh.triangles.size()) << mesh.name;
    EXPECT_LE(double(references), (1 + growth) * double(mesh.triangles.size())) << mesh.name;
    std::vector<std::vector<BoxEnds<R>>> boxes(mesh.triangles.size());
    for (const BvhNode<R>& node : nodes) {
        const auto begin = tree.order.begin() + (node.leaf() ? node.first : 0);
        EXPECT_EQ(std::set<uint32_t>(begin, begin + node.count).size(), node.count);
        for (uint32_t i = 0; i < node.count; ++i) boxes[begin[i]].push_back(BvhReference<R>(node.box, 0));
    }
    for (size_t id = 0; id < boxes.size(); ++id) {
        const Corners corners{mesh.corner(id, 0), mesh.corner(id, 1), mesh.corner(id, 2)};
        const int steps = boxes[id].size() == 1 ? 1 : 7;   // one box is convex: it holds what has its corners in it
        for (const RationalVec& p : points_of(corners, steps))
            ASSERT_TRUE(std::any_of(boxes[id].begin(), boxes[id].end(), [&](const auto& box) { return holds(box, p); })) << mesh.name << ", triangle " << id;
    }
}

/// Each point of each triangle is in a leaf that names the triangle.
TYPED_TEST(Spatial, LeavesHoldEveryPointOfEveryTriangle) {
    using R = TypeParam;
    for (const TriangleMesh& source : {battens(150), turned(moved(geodesic_sphere(5), Vec3(1e2, 1, 1), Vec3(0), ""), "needle askew"), moved(battens(100), Vec3(1e2), Vec3(1e5), "far battens")}) {
        const TriangleMesh mesh = read_as<R>(source);
        for (const double growth : {0.2, 0.75, 3.0}) {
            SplitTree tree;
            const auto nodes = split_tree<R>(mesh, {kLanes, kLanes, Isa::best, growth}, tree);
            EXPECT_GT(tree.stats.splits, 0u) << source.name;
            expect_tree_holds<R>(mesh, nodes, tree, growth);
        }
    }
}

/// Small triangles, and `large` among them that reach far.
TriangleMesh unlike(int large, const Vec3& scale, const Vec3& offset, int small = 4000) {
    TriangleMesh mesh = soup(small, 0.01, 3);
    Draws draws(RandomKey(5, 0, 0, 0));
    for (int i = 0; i < large; ++i) {
        const auto first = uint32_t(mesh.vertices.size());
        for (int k = 0; k < 3; ++k) mesh.vertices.push_back(draws.in_box(Vec3(-1), Vec3(1)));
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return moved(mesh, scale, offset, "unlike");
}

TYPED_TEST(Spatial, WhatIsCutBeforeAFastBuildIsHeldToo) {
    using R = TypeParam;
    for (const TriangleMesh& source : {unlike(60, Vec3(1), Vec3(0)), unlike(300, Vec3(1e-30), Vec3(0)), unlike(60, Vec3(1), Vec3(1e5)), unlike(20, Vec3(1e25, 1e22, 1), Vec3(0)), unlike(200, Vec3(1), Vec3(0), 20000)}) {
        const TriangleMesh mesh = read_as<R>(source);
        for (const double growth : {0.1, 0.75, 3.0}) {
            SplitTree tree, threads;
            const auto nodes = split_tree<R>(mesh, {kLanes, kLanes, Isa::best, growth}, tree, BvhBuilder::fast);
            expect_tree_holds<R>(mesh, nodes, tree, growth);
            split_tree<R>(mesh, {kLanes, kLanes, Isa::scalar, growth, 3}, threads, BvhBuilder::fast);
            EXPECT_EQ(tree.order, threads.order);
        }
    }
    if (std::is_same_v<R, double>) {   // as wide as a mesh may be: areas do not fit float
        const TriangleMesh mesh = unlike(60, Vec3(0x1p478), Vec3(0));
        SplitTree tree;
        const auto nodes = split_tree<R>(mesh, {kLanes, kLanes, Isa::best, 0.5}, tree, BvhBuilder::fast);
        EXPECT_GT(tree.order.size() - size_t(std::count(tree.order.begin(), tree.order.end(), kPadding)), mesh.triangles.size() * 5 / 4);
    }
    for (const TriangleMesh& source : {soup(4000, 0.01, 3), geodesic_sphere(30), torus(80, 40)}) {
        SplitTree tree;
        split_tree<R>(read_as<R>(source), {kLanes, kLanes, Isa::best, 1}, tree, BvhBuilder::fast);
        EXPECT_EQ(tree.order.size() - size_t(std::count(tree.order.begin(), tree.order.end(), kPadding)), source.triangles.size()) << "nothing is cut where sizes are alike";
    }
}

/// All cuts that the budget allows are made: each next plane is a finer one.
TYPED_TEST(Spatial, TheBudgetOfCutsIsSpent) {
    using R = TypeParam;
    const TriangleMesh mesh = read_as<R>(unlike(60, Vec3(1), Vec3(1e3)));
    const TriangleSource<R> source(mesh.view());
    LargeVector<BvhReference<R>> references;
    BoxEnds<R> all = BoxEnds<R>::none();
    for (uint32_t id = 0; id < source.size(); ++id) references.emplace_back(source.box(id), id), all.extend(references.back());
    const double growth = 0.75, budget = growth * double(references.size());
    const size_t whole = references.size();
    presplit<R>(references, all, source, growth, 1);
    EXPECT_LE(double(references.size() - whole), budget);
    EXPECT_GE(double(references.size() - whole), 0.95 * budget);
}

/// Rays of a tree that is built fast find no other hits for the cuts, and need fewer tests.
TEST(Presplit, RaysMeetTheSameTriangles) {
    const TriangleMesh mesh = unlike(60, Vec3(1), Vec3(0)).read_at(Precision::float_);
    const auto fast = build(*find_accelerator("hlbvh"), mesh, {}), brute = build(*find_accelerator("brute"), mesh, {});
    WorkCounters with, unused;
    for (const RayClass& rays : ray_classes()) {
        for (uint64_t n = 0; n < run_size(300, 10000); ++n) {
            const Ray ray = rays.make(mesh, RandomKey(52, 0, n, 0));
            Hit a, b;
            ASSERT_EQ(fast->intersect(ray, a, with), brute->intersect(ray, b, unused)) << rays.name << " " << n;
            ASSERT_TRUE(a.t == b.t && a.primitive == b.primitive) << rays.name << " " << n;
            std::vector<Hit> all, wanted;
            fast->all_hits(ray, all, with), brute->all_hits(ray, wanted, unused);
            ASSERT_EQ(all.size(), wanted.size()) << "each once: " << rays.name << " " << n;
        }
    }
}

TYPED_TEST(Spatial, TreeIsTheSameForEveryIsa) {
    using R = TypeParam;
    const TriangleMesh mesh = battens(400);
    SplitTree want;
    const auto nodes = split_tree<R>(mesh, {kLanes, kLanes, Isa::scalar, 0.75}, want);
    for (const Isa isa : available_isas()) {
        SplitTree tree;
        const auto got = split_tree<R>(mesh, {kLanes, kLanes, isa, 0.75}, tree);
        ASSERT_EQ(tree.order, want.order) << name(isa);
        ASSERT_EQ(got.size(), nodes.size());
        for (size_t i = 0; i < got.size(); ++i) ASSERT_TRUE(got[i].box.min == nodes[i].box.min && got[i].box.max == nodes[i].box.max) << name(isa);
    }
}

/// The planes of all boxes of a split tree, by axis, and those that halve the whole and its halves, as an octree's.
template <class R> std::array<std::vector<double>, 3> planes_of(const TriangleMesh& mesh) {
    SplitTree tree;
    const auto nodes = split_tree<R>(mesh, {kLanes, kLanes, Isa::best, kSplitGrowth}, tree);
    std::array<std::vector<double>, 3> planes;
    for (size_t a = 0; a < 3; ++a) {
        for (const auto& node : nodes) planes[a].insert(planes[a].end(), {double(node.box.min[int(a)]), double(node.box.max[int(a)])});
        const double low = double(nodes[0].box.min[int(a)]), high = double(nodes[0].box.max[int(a)]), middle = Bounds{Vec3(low), Vec3(high)}.center().x;
        for (size_t i = 0; i < nodes.size() / 4; ++i) planes[a].insert(planes[a].end(), {middle, Bounds{Vec3(low), Vec3(middle)}.center().x, Bounds{Vec3(middle), Vec3(high)}.center().x});
    }
    return planes;
}

/// A ray through a point where an edge crosses a plane of a box; it may run in that plane.
Ray ray_along_planes(const TriangleMesh& mesh, const std::array<std::vector<double>, 3>& planes, Draws& draws) {
    const int axis = int(draws.below(3)), k = int(draws.below(3));
    const uint32_t triangle = draws.below(mesh.triangles.size());
    const Vec3 a = mesh.corner(triangle, k), b = mesh.corner(triangle, (k + 1) % 3);
    const double plane = planes[size_t(axis)][draws.below(planes[size_t(axis)].size())], width = b[axis] - a[axis];
    Vec3 target = a + (width != 0 ? std::clamp((plane - a[axis]) / width, 0.0, 1.0) : 0.5) * (b - a);
    if (draws.coin()) target = 0.75 * target + 0.25 * mesh.corner(triangle, (k + 2) % 3), target[axis] = plane;
    const Bounds box = mesh.bounds();
    Ray ray;
    ray.origin = draws.in_box(box.min - box.extent(), box.max + box.extent());
    if (draws.coin()) ray.origin[axis] = target[axis];
    if (draws.coin()) {   // grazing: t is as far off as it may be
        const Vec3 normal = normalized(cross(normalized(b - a), normalized(mesh.corner(triangle, (k + 2) % 3) - a)));
        ray.origin = target + draws.uniform(-1, 1) * (b - a) + draws.uniform(-1, 1) * (mesh.corner(triangle, (k + 2) % 3) - a) + std::pow(10.0, -draws.uniform(1, 8)) * length(b - a) * normal;
    }
    ray.dir = target - ray.origin;
    return ray;
}

class SplitMeshes : public testing::TestWithParam<std::tuple<double, double>> {};

/// Split trees give the answers of brute force, bit for bit, to rays at the planes that cut: the first hit, any hit, and all hits, each once. So do the others.
TEST_P(SplitMeshes, AgreeWithBruteForceAtThePlanes) {
    const auto [scale, offset] = GetParam();
    size_t hits = 0;
    const size_t count = run_size(1500, 300000);
    for (const Precision precision : {Precision::float_, Precision::double_}) {
        for (const TriangleMesh& source : {battens(100), turned(moved(geodesic_sphere(5), Vec3(1e2, 1, 1), Vec3(0), ""), "needle askew"), stadium(4, 1)}) {
            const TriangleMesh mesh = moved(source, Vec3(scale), Vec3(offset), source.name).read_at(precision);
            const auto brute = brute_force(mesh, precision);
            const auto planes = precision == Precision::float_ ? planes_of<float>(mesh) : planes_of<double>(mesh);
            for (const AcceleratorEntry* entry : accelerators_under_test()) {
                const auto accelerator = build(*entry, mesh, {precision});
                EXPECT_GE(accelerator->stats().splits, std::string_view(entry->name) == "bvh" ? 1u : 0u) << mesh.name;
                for (size_t i = 0; i < count; ++i) {
                    Draws draws(RandomKey(73, 0, i, 0));
                    Ray ray = ray_along_planes(mesh, planes, draws);
                    Answers want = answers(*brute, ray);
                    hits += want.first.valid();
                    if (want.first.valid() && draws.coin()) ray.tmin = ray.tmax = want.first.t, want = answers(*brute, ray);   // boxes may not end before the computed t
                    ASSERT_EQ(difference(answers(*accelerator, ray), want), "") << entry->name << ", " << mesh.name << ", " << name(precision) << ", seed 73, ray " << i << ": " << describe(ray);
                }
            }
        }
    }
    EXPECT_GT(hits, count * 6) << "the test must exercise hits";
}

INSTANTIATE_TEST_SUITE_P(Places, SplitMeshes, testing::Values(std::tuple(1.0, 0.0), std::tuple(1e-30, 0.0), std::tuple(1e30, 0.0), std::tuple(1e2, 1e5)),
                         [](const auto& info) { return test_name(fmt::format("{:.0e}_{:.0e}", std::get<0>(info.param), std::get<1>(info.param))); });

/// Spatial splits are tried where they pay, and cost nothing elsewhere.
TEST(SplitChoice, FollowsTheTriangles) {
    const auto stats = [](const TriangleMesh& mesh) { return build(*find_accelerator("bvh"), mesh, {})->stats(); };
    for (const TriangleMesh& mesh : {geodesic_sphere(40, 0.1), torus(200, 100), soup(30000, 0.03, 4), cube(40), moved(cube(40), Vec3(1, 30, 1e-2), Vec3(0), "box")}) {
        const BuildStats built = stats(mesh);
        EXPECT_EQ(built.splits, 0u) << mesh.name;
        EXPECT_LE(built.split_candidates, built.nodes / 1000) << mesh.name;
        EXPECT_EQ(built.references, built.primitives) << mesh.name;
    }
    for (const TriangleMesh& mesh : {battens(1000), slivers(2000, 1e-3, 5), turned(moved(geodesic_sphere(40), Vec3(1e3, 1, 1), Vec3(0), ""), "needle askew")}) {
        const BuildStats built = stats(mesh);
        EXPECT_GT(built.splits, 3u) << mesh.name;
        EXPECT_LE(built.splits, built.split_candidates) << mesh.name;
        EXPECT_GT(built.references, built.primitives) << mesh.name;
        EXPECT_LE(double(built.references), (1 + kSplitGrowth) * double(built.primitives)) << mesh.name;
        EXPECT_LE(double(built.bytes), 110.0 * double(built.primitives)) << mesh.name;
        fmt::print("{}: {} spatial splits of {} tried, {:.2f} references a triangle, {:.1f} bytes\n", mesh.name, built.splits, built.split_candidates,
                   double(built.references) / double(built.primitives), double(built.bytes) / double(built.primitives));
    }
}

}  // namespace
}  // namespace alidade::test
