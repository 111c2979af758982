// SPDX-License-Identifier: Apache-2.0
/// Accelerators over primitives that are no triangles: the same answers as brute force over the same set.
#include "core/draws.h"
#include "numerics/triangles/compare.h"
#include "numerics/triangles/rays.h"
#include "tests/core/run_size.h"
#include "tests/accel/toy_set.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alidade::test {

using namespace numerics;

namespace {

constexpr uint64_t kSeed = 91;
using Kind = ToySolid::Kind;

std::vector<ToySolid> with(std::vector<ToySolid> solids, const std::vector<ToySolid>& more) {
    solids.insert(solids.end(), more.begin(), more.end());
    return solids;
}

/// A 4 x 4 x 4 stack of boxes whose faces touch, each of them three times: every entry is a tie.
std::vector<ToySolid> stacked_boxes() {
    std::vector<ToySolid> solids;
    for (int copy = 0; copy < 3; ++copy)
        for (int i = 0; i < 64; ++i) solids.push_back({Kind::box, 0.5 * Vec3(i % 4, i / 4 % 4, i / 16) - Vec3(0.75), Vec3(0.25)});
    return solids;
}

struct NamedSet {
    const char* name;
    std::vector<ToySolid> solids;
    double least_hits;  ///< share of the rays
};

std::vector<NamedSet> sets() {
    const std::vector<ToySolid> planes{{Kind::plane, Vec3(0, 0, 1.5), Vec3(0, 0, 1)}, {Kind::plane, Vec3(-1.5, 0, 0), Vec3(1, 0.2, 0)}};
    const std::vector<ToySolid> bad{{Kind::nan, Vec3(0), Vec3(0)}};
    const std::vector<ToySolid> large{
        {Kind::box, Vec3(0), Vec3(0.9)}, {Kind::sphere, Vec3(0.1, 0, 0), Vec3(0.8)}, {Kind::sphere, Vec3(0), Vec3(1.1)}};
    return {{"one sphere", {{Kind::sphere, Vec3(0), Vec3(1)}}, 0.3},
            {"small solids", random_solids(500, 0.1, 1), 0.5},
            {"overlapping solids", random_solids(200, 0.5, 2), 0.8},
            {"solids in many cells", with(random_solids(300, 0.1, 3), large), 0.6},
            {"stacked boxes", stacked_boxes(), 0.4},
            {"with planes", with(random_solids(100, 0.2, 4), planes), 0.6},
            {"planes alone", planes, 0.6},
            {"one sphere and planes", with(planes, {{Kind::sphere, Vec3(0.3, 0, 0), Vec3(0.6)}}), 0.6},
            {"with NaN bounds", with(bad, with(random_solids(100, 0.3, 5), bad)), 0.4}};
}

/// In [-2, 2]^3, with every restriction of the interval; a third of them axis-parallel at coordinates where faces lie.
Ray ray_at_set(size_t i) {
    static const TriangleMesh box = moved(cube(4), Vec3(1), Vec3(0), "box");
    const RayClass& rays = ray_classes()[i % ray_classes().size()];
    return rays.make(box, RandomKey(kSeed, 0, i, 0));
}

TEST(Sets, EveryAcceleratorAgreesWithBruteForce) {
    const size_t count = run_size(6000, 300000);
    for (NamedSet& named : sets()) {
        const auto set = std::make_shared<ToySet>(named.solids);
        const auto brute = accelerators().front().over_set(set, {});
        for (const AcceleratorEntry* entry : accelerators_under_test()) {
            for (const Precision precision : {Precision::float_, Precision::double_}) {
                const auto accelerator = entry->over_set(set, {precision});
                size_t hits = 0;
                for (size_t i = 0; i < count; ++i) {
                    const Ray ray = ray_at_set(i);
                    const Answers want = answers(*brute, ray);
                    hits += want.first.valid();
                    ASSERT_EQ(difference(answers(*accelerator, ray), want), "") << entry->name << ", " << name(precision) << ", " << named.name
                                                                                << ", seed " << kSeed << ", ray " << i << ": " << describe(ray);
                }
                // Three standard deviations below, for the small samples of a sanitized run.
                EXPECT_GE(double(hits), named.least_hits * double(count) - 1.5 * std::sqrt(double(count))) << named.name << ": the test must exercise hits";
            }
        }
    }
}

/// Brute force over a set is checked by hand: the set itself, asked for all its ids.
TEST(Sets, BruteForceIsTheSetItself) {
    for (NamedSet& named : sets()) {
        const auto set = std::make_shared<ToySet>(named.solids);
        std::vector<uint32_t> ids(named.solids.size());
        for (size_t i = 0; i < ids.size(); ++i) ids[i] = uint32_t(i);
        const auto brute = accelerators().front().over_set(set, {});
        for (size_t i = 0; i < 3000; ++i) {
            const Ray ray = ray_at_set(i);
            WorkCounters work;
            Answers want;
            set->intersect(ids, ray, want.first, work);
            want.occluded = set->occluded(ids, ray, work);
            set->all_hits(ids, ray, want.all, work);
            std::sort(want.all.begin(), want.all.end(), [](const Hit& a, const Hit& b) { return comes_before(a.t, a.instance, a.primitive, b); });
            ASSERT_EQ(difference(answers(*brute, ray), want), "") << named.name << ", seed " << kSeed << ", ray " << i << ": " << describe(ray);
        }
    }
}

/// A box that lies in many cells or leaves is met twice, not once a cell, and the hits are appended to what is there.
TEST(Sets, AllHitsComeOnceAndInOrder) {
    std::vector<ToySolid> solids = random_solids(400, 0.05, 6);
    solids.push_back({Kind::box, Vec3(0), Vec3(0.95)});
    const auto set = std::make_shared<ToySet>(solids);
    for (const AcceleratorEntry& entry : accelerators()) {
        const auto accelerator = entry.over_set(set, {});
        for (size_t i = 0; i < 2000; ++i) {
            const Ray ray = ray_at_set(i);
            std::vector<Hit> hits{Hit{42, 1, 2, 3, 0, 0, {}}};
            WorkCounters work;
            accelerator->all_hits(ray, hits, work);
            ASSERT_EQ(hits.front().t, 42) << entry.name << ": what was there must stay";
            for (size_t k = 2; k < hits.size(); ++k) {
                ASSERT_TRUE(comes_before(hits[k - 1].t, 0, hits[k - 1].primitive, hits[k])) << entry.name << ", hit " << k << ": " << describe(ray);
            }
        }
    }
}

TEST(Sets, WithoutPrimitivesAreNotHit) {
    for (const std::vector<ToySolid>& solids : {std::vector<ToySolid>{}, std::vector<ToySolid>(5, {Kind::nan, Vec3(0), Vec3(0)})}) {
        const auto set = std::make_shared<ToySet>(solids);
        for (const AcceleratorEntry& entry : accelerators()) {
            const auto accelerator = entry.over_set(set, {});
            EXPECT_TRUE(accelerator->bounds().empty()) << entry.name;
            EXPECT_EQ(accelerator->stats().primitives, 0u) << entry.name;
            EXPECT_EQ(accelerator->stats().removed.size(), solids.size()) << entry.name;
            for (size_t i = 0; i < 100; ++i) ASSERT_EQ(difference(answers(*accelerator, ray_at_set(i)), Answers()), "") << entry.name;
        }
    }
}

/// Bounds and removed ids: planes are outside of every box, NaN boxes are reported.
TEST(Sets, ReportBoundsAndRemovedIds) {
    const auto set = std::make_shared<ToySet>(std::vector<ToySolid>{{Kind::sphere, Vec3(1, 2, 3), Vec3(0.5)},
                                                                    {Kind::nan, Vec3(0), Vec3(0)},
                                                                    {Kind::plane, Vec3(0), Vec3(0, 1, 0)},
                                                                    {Kind::box, Vec3(-1), Vec3(0.5)}});
    for (const AcceleratorEntry& entry : accelerators()) {
        const auto accelerator = entry.over_set(set, {});
        EXPECT_THAT(accelerator->stats().removed, testing::ElementsAre(1)) << entry.name;
        EXPECT_EQ(accelerator->stats().primitives, 3u) << entry.name;
        EXPECT_LE(max_abs(accelerator->bounds().min - Vec3(-1.5)), 1e-6) << entry.name;
        EXPECT_LE(max_abs(accelerator->bounds().max - Vec3(1.5, 2.5, 3.5)), 1e-6) << entry.name;
    }
}

/// A ray that is in the bounds of a single leaf is in its box: no node is asked.
TEST(Sets, OfASingleLeafHaveNoBoxesToTest) {
    const std::vector<ToySolid> plane{{Kind::plane, Vec3(0, 0, 1.5), Vec3(0, 0, 1)}};
    for (const size_t count : {1u, 40u}) {
        const auto accelerator = find_accelerator("bvh")->over_set(std::make_shared<ToySet>(with(plane, random_solids(count, 0.8, 9))), {});
        WorkCounters work;
        for (size_t i = 0; i < 2000; ++i) {
            Hit hit;
            accelerator->intersect(ray_at_set(i), hit, work), accelerator->occluded(ray_at_set(i), work);
        }
        EXPECT_EQ(work.boxes == 0, count == 1) << count;
        EXPECT_GT(work.rays, 100u);
    }
}

/// As for triangles: a structure over a set skips most of it.
TEST(Sets, WorkIsAtMostThreePercent) {
    const auto set = std::make_shared<ToySet>(random_solids(4000, 0.03, 7));
    for (const AcceleratorEntry* entry : accelerators_under_test()) {
        const auto accelerator = entry->over_set(set, {});
        WorkCounters work;
        const size_t count = 2000;
        for (size_t i = 0; i < count; ++i) {
            Hit hit;
            accelerator->intersect(ray_at_set(i), hit, work);
        }
        EXPECT_GT(work.primitives, 0u) << entry->name;
        fmt::print("{}: {:.1f} boxes or cells, {:.1f} solids a ray\n", entry->name, double(work.boxes) / double(count), double(work.primitives) / double(count));
        EXPECT_LE(double(work.primitives) / double(count), 0.03 * 4000) << entry->name;
    }
}

/// The boxes of a few primitives fit into a node, so that a ray asks those alone that it may meet, also where all have one centre.
TEST(Sets, OfAFewAreNotAskedTogether) {
    const auto set = std::make_shared<ToySet>(std::vector<ToySolid>{{Kind::sphere, Vec3(0), Vec3(10)}, {Kind::box, Vec3(0), Vec3(0.1, 2, 0.1)}, {Kind::box, Vec3(0), Vec3(2, 0.1, 0.1)}, {Kind::sphere, Vec3(0), Vec3(0.2)}});
    for (const char* name : {"bvh", "hlbvh", "compact"}) {
        const auto accelerator = find_accelerator(name)->over_set(set, {});
        WorkCounters work;
        Hit hit;
        EXPECT_TRUE(accelerator->intersect({Vec3(3, 3, 3), Vec3(-1, -1.1, 0.1)}, hit, work)) << name;
        EXPECT_EQ(work.filtered, 1u) << name;
        EXPECT_EQ(hit.instance, 0u) << name;
    }
}

/// From so far away that a position on the ray is known no better than a cell of a grid: still the same answers, and still not all of the set.
/// Boxes, because theirs are the crossings that keep the promise of PrimitiveSet to the last bit from anywhere.
TEST(Sets, AreNotTestedAllFromAfar) {
    const size_t solids = 4000;
    std::vector<ToySolid> boxes = random_solids(solids, 0.03, 8);
    for (ToySolid& box : boxes) box = {Kind::box, box.center, Vec3(box.size.x)};
    const auto set = std::make_shared<ToySet>(boxes);
    const auto brute = accelerators().front().over_set(set, {});
    for (const AcceleratorEntry* entry : accelerators_under_test()) {
        const auto accelerator = entry->over_set(set, {});
        for (const double distance : {1e6, 1e8, 1e9, 1e10, 1e12, 1e14}) {
            WorkCounters work;
            size_t hits = 0;
            const size_t count = run_size(300, 10000);
            for (size_t i = 0; i < count; ++i) {
                Draws draws(RandomKey(kSeed, 5, i, 0));
                Ray ray;
                ray.origin = distance * draws.direction(), ray.dir = draws.in_box(Vec3(-0.5), Vec3(0.5)) - ray.origin;
                const Answers want = answers(*brute, ray);
                hits += want.first.valid();
                ASSERT_EQ(difference(answers(*accelerator, ray), want), "") << entry->name << ", distance " << distance << ": " << describe(ray);
                Hit hit;
                accelerator->intersect(ray, hit, work);
            }
            EXPECT_GT(hits, count / 2) << "the test must exercise hits";
            if (distance > 1e12) continue;   // there, rounding is as large as the set
            EXPECT_LE(double(work.boxes + work.filtered), 0.1 * double(solids * count)) << entry->name << ", distance " << distance;
        }
    }
}

}  // namespace
}  // namespace alidade::test
