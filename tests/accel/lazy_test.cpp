// SPDX-License-Identifier: Apache-2.0
/// Structures that are built at the first ray near them: the answers of those that are there from the beginning, once, and only where they are asked.
#include "accel/lazy.h"
#include "numerics/triangles/compare.h"
#include "numerics/triangles/rays.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace alidade::test {

using namespace numerics;

namespace {

/// A ray beside [-2, 2]^3.
Ray passing_ray() {
    Ray ray;
    ray.origin = {5, 5, 5}, ray.dir = {0, 0, 1};
    return ray;
}

TEST(Lazy, AnswersAsTheStructureItself) {
    for (const auto& [precision, how] : {std::pair(Precision::float_, Intersect::exact), {Precision::double_, Intersect::exact}, {Precision::float_, Intersect::robust}, {Precision::double_, Intersect::robust}, {Precision::float_, Intersect::fast}}) {
        const TriangleMesh mesh = soup(600, 0.3, 7).read_at(precision);
        const AccelOptions options{precision, Isa::best, 1, how};
        for (const AcceleratorEntry& entry : accelerators()) {
            const auto eager = build(entry, mesh, options);
            const auto lazy = over_triangles_lazily(entry, mesh.view(), options);
            EXPECT_EQ(built(*eager), eager.get());
            EXPECT_EQ(lazy->bounds().min, eager->bounds().min) << entry.name;
            EXPECT_EQ(lazy->bounds().max, eager->bounds().max) << entry.name;
            EXPECT_EQ(lazy->stats().primitives, eager->stats().primitives) << entry.name;
            EXPECT_EQ(built(*lazy), nullptr) << entry.name;
            EXPECT_LT(lazy->stats().bytes, 1000u) << entry.name;
            WorkCounters wanted, work;
            size_t hits = 0;
            for (size_t i = 0; i < 500; ++i) {
                const Ray ray = ray_classes().front().make(mesh, RandomKey(62, 0, i, 0));
                EXPECT_EQ(difference(answers(*lazy, ray), answers(*eager, ray)), "") << entry.name << ": " << describe(ray);
                Hit a, b;
                hits += eager->intersect(ray, a, wanted);
                lazy->intersect(ray, b, work);
            }
            EXPECT_GT(hits, 100u);
            EXPECT_EQ(std::pair(work.boxes, work.filtered), std::pair(wanted.boxes, wanted.filtered)) << entry.name;
            ASSERT_NE(built(*lazy), nullptr) << entry.name;
            EXPECT_EQ(lazy->stats().bytes, eager->stats().bytes) << entry.name;
        }
    }
}

/// Where a structure answers at all, one that waits has been built: the first ray may be of any class, through planes, edges and corners of the bounds as well.
TEST(Lazy, MissesNoFirstRay) {
    size_t hits = 0;
    for (const Intersect how : {Intersect::exact, Intersect::robust, Intersect::fast})
        for (const Precision precision : {Precision::float_, Precision::double_}) {
            const TriangleMesh mesh = cube(2).read_at(precision);
            const AccelOptions options{precision, Isa::best, 1, how};
            const auto& entry = *find_accelerator("bvh");
            const auto eager = build(entry, mesh, options);
            for (const RayClass& rays : ray_classes())
                for (size_t i = 0; i < 40; ++i) {
                    const Ray ray = rays.make(mesh, RandomKey(63, 0, i, 0));
                    const auto lazy = over_triangles_lazily(entry, mesh.view(), options);
                    WorkCounters work;
                    Hit a, b;
                    hits += eager->intersect(ray, a, work);
                    lazy->intersect(ray, b, work);
                    EXPECT_EQ(a.t, b.t) << name(how) << ", " << rays.name << ": " << describe(ray);
                    EXPECT_EQ(a.primitive, b.primitive) << name(how) << ", " << rays.name;
                }
        }
    EXPECT_GT(hits, 1000u);
}

TEST(Lazy, WaitsForARayThatEntersTheBox) {
    const TriangleMesh mesh = geodesic_sphere(8).read_at(Precision::float_);
    const auto lazy = over_triangles_lazily(*find_accelerator("bvh"), mesh.view(), {});
    WorkCounters work;
    Hit hit;
    std::vector<Hit> all;
    Ray shadow = passing_ray(), wrong = passing_ray();
    shadow.origin = {0, 0, -5}, shadow.tmax = 1;    // ends before the box
    wrong.origin.x = std::numeric_limits<double>::quiet_NaN();
    for (const Ray& ray : {passing_ray(), shadow, wrong}) {
        EXPECT_FALSE(lazy->intersect(ray, hit, work));
        EXPECT_FALSE(lazy->occluded(ray, work));
        lazy->all_hits(ray, all, work);
    }
    EXPECT_TRUE(all.empty());
    EXPECT_EQ(built(*lazy), nullptr);
    shadow.tmax = 10;
    EXPECT_TRUE(lazy->occluded(shadow, work));
    EXPECT_NE(built(*lazy), nullptr);
}

/// Triangles that cannot be hit are known before anything is built: notes name them at once.
TEST(Lazy, KnowsWhatIsRemoved) {
    TriangleMesh mesh = geodesic_sphere(4).read_at(Precision::float_);
    mesh.triangles[3].y = mesh.triangles[3].x;
    mesh.positions[mesh.triangles[40].z].y = std::numeric_limits<float>::infinity();
    const auto eager = build(*find_accelerator("bvh"), mesh, {});
    const auto lazy = over_triangles_lazily(*find_accelerator("bvh"), mesh.view(), {});
    EXPECT_GT(eager->stats().removed.size(), 3u);
    EXPECT_EQ(lazy->stats().removed, eager->stats().removed);
    EXPECT_EQ(lazy->bounds().max, eager->bounds().max);
}

std::atomic<int> builds = 0;

std::unique_ptr<Accelerator> counted(const TriangleView& mesh, const AccelOptions& options) {
    ++builds;
    return find_accelerator("bvh")->over_triangles(mesh, options);
}

TEST(Lazy, IsBuiltOnceHoweverManyThreadsCome) {
    const TriangleMesh mesh = geodesic_sphere(40).read_at(Precision::float_);
    const AcceleratorEntry entry{"counted", "", counted, nullptr};
    for (int time = 0; time < 10; ++time) {
        builds = 0;
        AccelOptions options;
        options.threads = 2;
        const auto lazy = over_triangles_lazily(entry, mesh.view(), options);
        std::atomic<int> hits = 0;
        std::vector<std::thread> threads;
        for (int i = 0; i < 8; ++i)
            threads.emplace_back([&] {
                Ray ray;
                ray.origin = {0, 0, 5}, ray.dir = {0, 0, -1};
                Hit hit;
                WorkCounters work;
                hits += lazy->intersect(ray, hit, work);
            });
        for (std::thread& thread : threads) thread.join();
        EXPECT_EQ(hits, 8);
        EXPECT_EQ(builds, 1);
    }
}

}  // namespace
}  // namespace alidade::test
