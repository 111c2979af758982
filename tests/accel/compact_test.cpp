// SPDX-License-Identifier: Apache-2.0
/// The compact BVH: boxes hold the exact ones, and vectors give the bits of scalar code.
#include "accel/bvh/bvh.h"
#include "core/draws.h"
#include "numerics/triangles/meshes.h"
#include "tests/core/run_size.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace alidade::test {

using namespace numerics;

namespace {

/// An interval of floats: of any size, anywhere, also flat and far from 0.
std::pair<float, float> random_interval(Draws& draws) {
    const auto any = [&] { return float(draws.sign() * std::ldexp(draws.uniform(0.5, 1), int(draws.below(268)) - 148)); };
    const float a = draws.below(8) ? any() : 0.0f;
    float b = a;
    switch (draws.below(5)) {
        case 0: break;
        case 1: b = std::nextafter(a, draws.coin() ? 1e38f : -1e38f); break;
        case 2: b = float(double(a) * (1 + draws.uniform(-1e-5, 1e-5))); break;
        default: b = any();
    }
    return std::minmax(a, b);
}

TEST(ByteGrid, PlanesAreAroundWhatTheyStandFor) {
    size_t between = 0;
    const size_t count = run_size(100000, 10000000);
    for (size_t n = 0; n < count; ++n) {
        Draws draws(RandomKey(141, 0, n));
        const auto [low, high] = random_interval(draws);
        ByteGrid grid{};
        grid.lay(1, low, high);
        const float x = std::clamp(float(double(low) + draws.uniform(0, 1) * (double(high) - double(low))), low, high);
        const float below = grid.plane(1, grid.below(1, x)), above = grid.plane(1, grid.above(1, x));
        ASSERT_TRUE(below <= x && x <= above) << "seed 141, " << n << ": " << x << " in " << low << " .. " << high;
        ASSERT_EQ(grid.plane(1, grid.below(1, low)), low);
        ASSERT_GE(grid.plane(1, grid.above(1, high)), high);
        ASSERT_LE(double(above) - double(below), 2 * double(grid.step(1)) + 2 * 0x1p-23 * std::abs(double(x))) << "no wider than it must be";
        ASSERT_LE(double(grid.step(1)), std::max(2.01 * (double(high) - double(low)) / grid.kSteps, double(std::numeric_limits<float>::min()))) << "no coarser than it must be";
        between += below < x && x < above;
    }
    EXPECT_GT(between, count / 10);
}

BoundsT<float> box_of(const auto& node, uint32_t i) { return {{node.plane(0, i), node.plane(2, i), node.plane(4, i)}, {node.plane(1, i), node.plane(3, i), node.plane(5, i)}}; }

std::vector<TriangleMesh> meshes_of_all_sizes() {
    std::vector<TriangleMesh> all = small_meshes();
    for (const TriangleMesh& mesh : {geodesic_sphere(20), torus(50, 40), soup(3000, 0.1, 3), wild_soup(200, 4), battens(100)}) all.push_back(mesh);
    const size_t count = all.size();
    for (size_t i = 0; i < count; ++i) {
        const TriangleMesh mesh = all[i];
        for (const double size : {1e-30, 1e-40, 1e30}) all.push_back(scaled(mesh, size));
        all.push_back(moved(mesh, Vec3(1), Vec3(1e6, -1e6, 1e6), mesh.name + " + 1e6"));
        all.push_back(moved(mesh, Vec3(1, 0, 1), Vec3(0), mesh.name + ", flat"));
    }
    return all;
}

/// Every exact box of the tree is inside of the one that is tested, which is larger by two steps at most; the rest of the tree is the same.
TEST(Compact, BoxesHoldTheExactOnes) {
    size_t boxes = 0;
    for (const TriangleMesh& source : meshes_of_all_sizes()) {
        const TriangleMesh mesh = source.read_at(Precision::float_);
        const TriangleSource<float> triangles(mesh.view());
        std::vector<uint32_t> order;
        LargeVector<BvhReference<float>> references;
        for (uint32_t id = 0; id < triangles.size(); ++id)
            if (triangles.kind(id) == PrimitiveKind::bounded) references.emplace_back(triangles.box(id), id);
        BuildStats stats;
        const auto exact = widened(build_bvh(std::move(references), {kLanes, kLanes}, order, stats), stats);
        const auto made = compacted(exact);
        ASSERT_EQ(made.size(), exact.size());
        for (size_t n = 0; n < made.size(); ++n) {
            for (uint32_t i = 0; i < kWide; ++i) {
                const BoundsT<float> inner = box_of(exact[n], i), outer = box_of(made[n], i);
                ASSERT_EQ(made[n].child[i], exact[n].child[i]);
                ASSERT_EQ(made[n].places() >> i & 1, !inner.empty()) << mesh.name;
                if (inner.empty()) continue;
                ASSERT_TRUE(outer.contains(inner.min) && outer.contains(inner.max)) << mesh.name << ", node " << n << ", box " << i;
                for (int a = 0; a < 3; ++a) {
                    const double slack = double(outer.max[a]) - double(outer.min[a]) - (double(inner.max[a]) - double(inner.min[a]));
                    ASSERT_LE(slack, 2 * double(made[n].grid.step(a)) + 0x1p-22 * std::max(std::abs(outer.min[a]), std::abs(outer.max[a]))) << mesh.name;
                }
                ++boxes;
            }
        }
    }
    EXPECT_GT(boxes, 5000u);
}

/// Blocks keep each triangle's number, and a box that holds it.
TEST(Compact, BoxesOfTrianglesHoldThem) {
    for (const TriangleMesh& source : meshes_of_all_sizes()) {
        const TriangleMesh mesh = source.read_at(Precision::float_);
        const TriangleSource<float> triangles(mesh.view());
        std::vector<uint32_t> order;
        for (uint32_t id = 0; id < triangles.size(); ++id)
            if (triangles.kind(id) == PrimitiveKind::bounded) order.push_back(id);
        const NumberedBlocks blocks(triangles, order, 2);
        for (uint32_t i = 0; i < order.size(); ++i) {
            const uint32_t number = blocks.number(i / kLanes), place = number * kLanes + i % kLanes;
            ASSERT_TRUE(blocks.has_boxes(number)) << "of a small mesh";
            ASSERT_EQ(blocks.id(place), order[i]);
            ASSERT_EQ(blocks.corners(place), triangles.corners(order[i]));
            const BoundsT<float> box = box_of(blocks.boxes(number), i % kLanes), exact = triangles.box(order[i]);
            ASSERT_TRUE(box.contains(exact.min) && box.contains(exact.max)) << mesh.name << ", triangle " << order[i];
        }
    }
}

/// Blocks with corners have those of their triangles, whatever the room; it is kept to, but for the boxes that there are without it.
TEST(Compact, CornersAreThoseOfTheTriangles) {
    size_t kept = 0, stepped = 0, boxed = 0;
    for (const TriangleMesh& source : meshes_of_all_sizes()) {
        const TriangleMesh mesh = source.read_at(Precision::float_);
        const TriangleSource<float> triangles(mesh.view());
        std::vector<uint32_t> order;
        for (uint32_t id = 0; id < triangles.size(); ++id) {
            if (triangles.kind(id) == PrimitiveKind::bounded) order.push_back(id);
            if (id % 5 == 0) order.resize((order.size() + kLanes - 1) / kLanes * kLanes, kPadding);
        }
        const size_t least = NumberedBlocks(triangles, order, 2).bytes();
        for (const size_t room : {size_t(0), size_t(30) * order.size(), size_t(1000) * order.size()}) {
            const NumberedBlocks blocks(triangles, order, 2, false, room);
            EXPECT_LE(blocks.bytes(), std::max(least, room + 32)) << mesh.name;
            for (uint32_t b = 0; b * kLanes < order.size(); ++b) {
                const uint32_t number = blocks.number(b);
                (blocks.has_boxes(number) ? boxed : blocks.is_stepped(number) ? stepped : kept) += 1;
                const TriangleBlock<float> block = blocks[number];
                for (uint32_t lane = 0; lane < kLanes && b * kLanes + lane < order.size() && order[b * kLanes + lane] != kPadding; ++lane) {
                    const uint32_t id = order[b * kLanes + lane];
                    ASSERT_EQ(block.id[lane], id);
                    ASSERT_EQ(blocks.id(number * kLanes + lane), id);
                    ASSERT_EQ(block.corners(lane), triangles.corners(id)) << mesh.name << ", triangle " << id;
                }
            }
        }
    }
    EXPECT_GT(kept, 1000u);
    EXPECT_GT(stepped, 1000u);
    EXPECT_GT(boxed, 1000u);
}

/// Any floats at all come back, bit for bit, also where they are kept whole; those that have few digits, or are near each other, in few bits.
TEST(Compact, StepsAreTheFloats) {
    size_t whole = 0;
    const size_t count = run_size(20000, 1000000);
    for (size_t n = 0; n < count; ++n) {
        Draws draws(RandomKey(145, 0, n));
        std::vector<uint32_t> ids;
        const int kind = int(draws.below(3));
        const double size = std::ldexp(1.0, -int(draws.below(24)));
        const auto coordinate = [&] { return kind == 0 ? random_interval(draws).first : kind == 1 ? float(1.5 + draws.uniform(-0.5, 0.5) * size) : float(int(draws.below(255)) - 100) * 0.125f; };
        std::vector<Vec3f> positions;
        std::vector<Index3> triangles;
        for (uint32_t i = 0; i < 1 + n % 8; ++i) {
            ids.push_back(i), triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
            for (int c = 0; c < 3; ++c) positions.emplace_back(coordinate(), c == 1 && kind == 0 ? -0.0f : coordinate(), coordinate());
        }
        const TriangleView view{positions, {}, triangles};
        alignas(16) std::array<unsigned char, SteppedBlock::kMostBytes + 32> memory{};
        auto& block = *::new (static_cast<void*>(memory.data())) SteppedBlock(view, ids);
        ASSERT_LE(block.bytes(), SteppedBlock::kMostBytes);
        block.fill(view, ids);
        ASSERT_TRUE(std::all_of(memory.begin() + std::ptrdiff_t(block.bytes()), memory.end(), [](unsigned char byte) { return byte == 0; })) << "seed 145, " << n;
        ASSERT_NE(block.grid.exponent[0], 0);
        for (uint32_t lane = 0; lane < ids.size(); ++lane) {
            ASSERT_EQ(block.id(lane), ids[lane]);
            for (size_t corner = 0; corner < 3; ++corner)
                for (int a = 0; a < 3; ++a) ASSERT_EQ(std::bit_cast<uint32_t>(block.coordinate(a, corner, lane)), std::bit_cast<uint32_t>(positions[3 * lane + corner][a])) << "seed 145, " << n;
        }
        for (int a = 0; a < 3; ++a) {
            whole += block.bits[a] == SteppedBlock::kWhole;
            ASSERT_LE(block.bits[a], kind == 0 ? 32 : kind == 1 ? 24 + std::ilogb(size) : 8) << "seed 145, " << n;
        }
    }
    EXPECT_GT(whole, count / 10);
}

bool same(const Hit& a, const Hit& b) { return std::tie(a.t, a.instance, a.primitive, a.part, a.u, a.v) == std::tie(b.t, b.instance, b.primitive, b.part, b.u, b.v); }

/// Meshes that are large enough for corners: answers are those of the BVH, bit for bit.
TEST(Compact, LargeMeshesAreHitAsByTheBvh) {
    const size_t count = run_size(2000, 100000);
    for (const TriangleMesh& source : {geodesic_sphere(50, 0.2), soup(40000, 0.03, 5)}) {
        const TriangleMesh mesh = source.read_at(Precision::float_);
        const double triangles = double(mesh.view().triangles.size());
        for (const Isa isa : available_isas()) {
            for (const Intersect test : {Intersect::exact, Intersect::robust, Intersect::fast}) {
                const auto want = find_accelerator("bvh")->over_triangles(mesh.view(), {.isa = isa, .intersect = test}), got = find_accelerator("compact")->over_triangles(mesh.view(), {.isa = isa, .intersect = test});
                EXPECT_LE(double(got->stats().bytes), 32 * triangles) << mesh.name;
                size_t hits = 0, unlike = 0;
                for (size_t n = 0; n < count; ++n) {
                    Draws draws(RandomKey(144, 0, n));
                    Ray ray;
                    ray.origin = draws.in_box(Vec3(-2), Vec3(2)), ray.dir = draws.in_box(Vec3(-1), Vec3(1)) - ray.origin;
                    WorkCounters work;
                    Hit a, b;
                    got->intersect(ray, a, work), want->intersect(ray, b, work);
                    hits += b.valid(), unlike += !same(a, b) || got->occluded(ray, work) != b.valid();
                }
                EXPECT_GT(hits, count / 10) << mesh.name;
                EXPECT_LE(unlike, test == Intersect::exact ? 0 : count / 500) << mesh.name << ", " << name(isa) << ", " << name(test);
            }
        }
    }
}

CompactNode random_node(Draws& draws) {
    CompactNode node{};
    for (int a = 0; a < 3; ++a) {
        const auto [low, high] = random_interval(draws);
        const bool wild = draws.below(20) == 0;
        node.grid.lay(a, wild ? low : float(draws.uniform(-2, 0)), wild ? high : float(draws.uniform(0, 2)));
        for (uint32_t i = 0; i < kWide; ++i) {
            const auto first = uint8_t(draws.below(256)), last = uint8_t(draws.below(256));
            node.steps[2 * a][i] = std::min(first, last), node.steps[2 * a + 1][i] = std::max(first, last);
        }
    }
    node.grid.places = uint8_t(draws.below(256));
    return node;
}

/// The bits of WideRay::enter for the box that the planes are.
TEST(Compact, BoxesAreEnteredAsOneAtATime) {
    size_t entered = 0;
    const size_t count = run_size(200000, 10000000);
    for (size_t n = 0; n < count; ++n) {
        Draws draws(RandomKey(143, 0, n));
        LocalRay local;
        local.origin = draws.in_box(Vec3(-2), Vec3(2)), local.dir = draws.direction();
        if (draws.below(3) == 0) local.dir[int(draws.below(3))] = 0;
        local.inverse = Vec3(1.0) / local.dir, local.reach = 4, local.tmin = draws.coin() ? 0 : draws.uniform(-2, 2);
        const WideRay<float> fused(local, 4, true), plain(local, 4, false);
        const CompactNode node = random_node(draws);
        const float limit = plain.limit(draws.coin() ? std::numeric_limits<double>::max() : draws.uniform(-1, 4));
        for (const Isa isa : available_isas()) {
            alignas(64) float entries[kWide];
            const uint32_t bits = wide_box_test<CompactNode>(isa)(node, local, 4, limit, entries);
            const WideRay<float>& ray = fuses(isa) ? fused : plain;
            for (uint32_t i = 0; i < kWide; ++i) {
                const float want = ray.enter(box_of(node, i), limit);
                const bool wanted = want <= limit && (node.places() >> i & 1);
                ASSERT_EQ((bits >> i & 1) != 0, wanted) << name(isa) << ", seed 143, node " << n << ", box " << i;
                ASSERT_TRUE(!wanted || entries[i] == want) << name(isa) << ", seed 143, node " << n << ", box " << i;
                entered += wanted;
            }
        }
    }
    EXPECT_GT(entered, count / 10);
}

}  // namespace
}  // namespace alidade::test
