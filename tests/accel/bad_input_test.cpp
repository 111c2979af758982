// SPDX-License-Identifier: Apache-2.0
/// Bad triangles are removed and reported, awkward ones are kept, and neither changes a bit of a hit on the good part. Bad rays hit nothing.
#include "core/draws.h"
#include "numerics/triangles/compare.h"
#include "numerics/triangles/rays.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alidade::test {

using namespace numerics;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr size_t kGood = 1280;

/// Triangles to add to a sphere of 1280 triangles. Those that can be hit lie where no ray of `rays_at_sphere` meets them first.
struct BadPart {
    const char* name;
    std::vector<Vec3> corners;  ///< three a triangle
    bool removed;               ///< must be reported; where false, either will do
};

std::vector<Vec3> repeated(const std::vector<Vec3>& corners, size_t times) {
    std::vector<Vec3> all;
    for (size_t i = 0; i < times; ++i) all.insert(all.end(), corners.begin(), corners.end());
    return all;
}

std::vector<BadPart> bad_parts() {
    const Vec3 a(0.1, 0, 0), b(0, 0.1, 0), c(0, 0, 0.1);
    return {{"none", {}, false},
            {"one NaN coordinate", {a, b, Vec3(0, kNaN, 0)}, true},
            {"NaN alone", {Vec3(kNaN), Vec3(kNaN), Vec3(kNaN)}, true},
            {"infinite vertex", {a, b, Vec3(kInf, 0, 0)}, true},
            {"minus infinite vertex", {Vec3(0, 0, -kInf), a, b}, true},
            {"far at 1e30", {{1e30, 0, 0}, {1e30, 1e30, 0}, {1e30, 0, 1e30}}, false},
            {"far at 3e38", {{3e38, 0, 0}, {3e38, 3e38, 0}, {3e38, 0, 3e38}}, false},
            {"both ends of float", {{-3e38, 3e38, 3e38}, {3e38, 3e38, 3e38}, {3e38, 3e38, -3e38}}, false},
            {"denormal", {{1e-41, 0, 0}, {0, 1e-41, 0}, {0, 0, 1e-41}}, false},
            {"one point", {a, a, a}, true},
            {"two points", {a, b, b}, true},
            {"collinear", {{0.125, 0, 0}, {0.25, 0, 0}, {0.5, 0, 0}}, true},
            {"20,000 identical", repeated({a, b, c}, 20000), false},
            {"20,000 points", repeated({a, a, a}, 20000), true},
            {"1,000 NaN", repeated({a, b, Vec3(kNaN)}, 1000), true}};
}

Mesh with_bad_part(const Mesh& good, const BadPart& bad) {
    std::vector<Vec3> vertices = good.vertices;
    std::vector<Index3> triangles = good.triangles;
    for (size_t i = 0; i < bad.corners.size(); i += 3) {
        const uint32_t first = uint32_t(vertices.size());
        triangles.emplace_back(first, first + 1, first + 2);
        vertices.insert(vertices.end(), bad.corners.begin() + long(i), bad.corners.begin() + long(i) + 3);
    }
    return {bad.name, vertices, triangles};
}

/// From outside the sphere but inside its box, so that the larger box of a bad mesh does not move their origin.
std::vector<Ray> rays_at_sphere(const Mesh& sphere, size_t count) {
    const Bounds box = sphere.bounds();
    Draws draws(RandomKey(31, 0, 0, 0));
    std::vector<Ray> rays;
    while (rays.size() < count) {
        Ray ray;
        ray.origin = draws.in_box(box.min, box.max);
        if (length(ray.origin) < 1.01) continue;
        ray.dir = draws.in_box(box.min, box.max) - ray.origin;
        rays.push_back(ray);
    }
    return rays;
}

std::vector<uint32_t> bad_ids(const BadPart& bad) {
    std::vector<uint32_t> ids(bad.corners.size() / 3);
    for (size_t i = 0; i < ids.size(); ++i) ids[i] = uint32_t(kGood + i);
    return ids;
}

class BadTriangles : public testing::TestWithParam<Precision> {};

TEST_P(BadTriangles, LeaveTheGoodPartAlone) {
    const AccelOptions options{GetParam()};
    const Mesh good = geodesic_sphere(8).read_at(GetParam());
    ASSERT_EQ(good.triangles.size(), kGood);
    const std::vector<Ray> rays = rays_at_sphere(good, 800);
    const auto truth = brute_force(good, GetParam());
    for (const BadPart& bad : bad_parts()) {
        const Mesh mesh = with_bad_part(good, bad);
        for (const AcceleratorEntry& entry : accelerators()) {
            const auto accelerator = build(entry, mesh, options);
            size_t hits = 0;
            for (const Ray& ray : rays) {
                const Hit want = first_hit(*truth, ray), got = first_hit(*accelerator, ray);
                hits += want.valid();
                if (want.valid()) {
                    ASSERT_EQ(difference(got, want), "") << entry.name << ", " << bad.name << ": " << describe(ray);
                } else if (got.valid()) {
                    ASSERT_GE(got.primitive, kGood) << entry.name << ", " << bad.name << ": " << describe(ray);
                }
            }
            EXPECT_GT(hits, rays.size() / 3) << "the test must exercise hits";
        }
    }
}

TEST_P(BadTriangles, AreReportedAndCostNothing) {
    const AccelOptions options{GetParam()};
    const Mesh good = geodesic_sphere(8).read_at(GetParam());
    const std::vector<Ray> rays = rays_at_sphere(good, 300);
    for (const AcceleratorEntry& entry : accelerators()) {
        const auto work_of = [&](const Accelerator& accelerator) {
            WorkCounters work;
            Hit hit;
            for (const Ray& ray : rays) hit = Hit(), accelerator.intersect(ray, hit, work);
            return work.boxes + work.filtered;
        };
        const uint64_t clean_work = work_of(*build(entry, good, options));
        for (const BadPart& bad : bad_parts()) {
            if (!bad.removed) continue;
            const auto accelerator = build(entry, with_bad_part(good, bad), options);
            EXPECT_EQ(accelerator->stats().removed, bad_ids(bad)) << entry.name << ", " << bad.name;
            EXPECT_EQ(accelerator->stats().primitives, kGood) << entry.name << ", " << bad.name;
            EXPECT_LE(work_of(*accelerator), clean_work + clean_work / 10) << entry.name << ", " << bad.name;
            EXPECT_TRUE(accelerator->bounds().finite()) << entry.name << ", " << bad.name;
        }
    }
}

/// Those that are kept are hit as brute force hits them, wherever they are.
TEST_P(BadTriangles, AgreeWithBruteForceWhereKept) {
    const AccelOptions options{GetParam()};
    const Mesh good = geodesic_sphere(4).read_at(GetParam());
    for (const BadPart& bad : bad_parts()) {
        if (bad.corners.size() > 3000) continue;
        const Mesh mesh = with_bad_part(good, bad).read_at(GetParam());
        const auto truth = brute_force(mesh, GetParam());
        for (const AcceleratorEntry* entry : accelerators_under_test()) {
            const auto accelerator = build(*entry, mesh, options);
            for (const RayClass& rays : ray_classes()) {
                for (size_t i = 0; i < 50; ++i) {
                    const Ray ray = rays.make(good, RandomKey(37, 0, i, 0));
                    ASSERT_EQ(difference(answers(*accelerator, ray), answers(*truth, ray)), "")
                        << entry->name << ", " << bad.name << ", " << rays.name << ", ray " << i << ": " << describe(ray);
                }
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Both, BadTriangles, testing::Values(Precision::float_, Precision::double_),
                         [](const auto& info) { return name(info.param); });

TEST(BadMesh, IndicesOutOfRangeAreReported) {
    const Mesh good = geodesic_sphere(8);
    std::vector<Index3> triangles = good.triangles;
    triangles[7] = {0, 1, uint32_t(good.vertices.size())};
    triangles[9] = {kNoId, kNoId, kNoId};
    for (const AcceleratorEntry& entry : accelerators()) {
        for (const Precision precision : {Precision::float_, Precision::double_}) {
            const auto accelerator = entry.over_triangles({good.positions, good.vertices, triangles}, {precision});
            EXPECT_THAT(accelerator->stats().removed, testing::UnorderedElementsAre(7, 9)) << entry.name;
            EXPECT_EQ(accelerator->stats().primitives, kGood - 2) << entry.name;
        }
    }
}

TEST(BadMesh, WithoutAnythingToHitIsNotHit) {
    const Mesh empty("empty", {}, {}), points("vertices without triangles", {Vec3(0), Vec3(1)}, {});
    const Mesh nothing_good = with_bad_part(points, {"", repeated({Vec3(kNaN), Vec3(0), Vec3(1)}, 50), true});
    const Mesh target = geodesic_sphere(1);
    for (const Mesh& mesh : {empty, points, nothing_good}) {
        for (const AcceleratorEntry& entry : accelerators()) {
            const auto accelerator = build(entry, mesh, {});
            EXPECT_EQ(accelerator->stats().primitives, 0u) << entry.name << ", " << mesh.name;
            EXPECT_TRUE(accelerator->bounds().empty()) << entry.name << ", " << mesh.name;
            for (const RayClass& rays : ray_classes()) {
                const Answers got = answers(*accelerator, rays.make(target, RandomKey(41, 0, 0, 0)));
                EXPECT_EQ(difference(got, Answers()), "") << entry.name << ", " << mesh.name << ", " << rays.name;
            }
        }
    }
}

TEST(BadMesh, OfOneTriangleIsHit) {
    const Mesh one("one triangle", {Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(0, 1, 1)}, {Index3(0, 1, 2)});
    Ray ray;
    ray.origin = {0.25, 0.25, -1};
    for (const AcceleratorEntry& entry : accelerators()) {
        const Hit hit = first_hit(*build(entry, one, {}), ray);
        EXPECT_EQ(hit.primitive, 0u) << entry.name;
        EXPECT_EQ(hit.t, 2.0) << entry.name;
        EXPECT_EQ(hit.u, 0.25f) << entry.name;
        EXPECT_EQ(hit.v, 0.25f) << entry.name;
    }
}

std::vector<Ray> bad_rays() {
    Ray good;
    good.origin = {0, 0, -3};
    std::vector<Ray> rays;
    for (const double value : {kNaN, kInf, -kInf}) {
        for (int axis = 0; axis < 3; ++axis) {
            rays.push_back(good), rays.back().dir[axis] = value;
            rays.push_back(good), rays.back().origin[axis] = value;
        }
    }
    rays.push_back(good), rays.back().origin = good.origin - good.dir * 0x1p500, rays.back().tmin = -kInf;   // so far away that nothing is left of the geometry
    rays.push_back(good), rays.back().dir = Vec3(0);
    rays.push_back(good), rays.back().dir = Vec3(-0.0);
    rays.push_back(good), rays.back().dir = Vec3(kInf);
    rays.push_back(good), rays.back().tmin = kNaN;
    rays.push_back(good), rays.back().tmax = kNaN;
    rays.push_back(good), rays.back().tmin = 5, rays.back().tmax = 1;
    rays.push_back(good), rays.back().tmax = -1;
    rays.push_back(good), rays.back().tmin = kInf;
    rays.push_back(good), rays.back().tmin = rays.back().tmax = -kInf;
    return rays;
}

TEST(BadRay, HitsNothing) {
    const Mesh mesh = geodesic_sphere(8);
    for (const AcceleratorEntry& entry : accelerators()) {
        for (const Precision precision : {Precision::float_, Precision::double_}) {
            const auto accelerator = build(entry, mesh, {precision});
            for (const Ray& ray : bad_rays())
                EXPECT_EQ(difference(answers(*accelerator, ray), Answers()), "") << entry.name << ", " << name(precision) << ", " << describe(ray);
        }
    }
}

/// t counts multiples of |dir|, whatever its length: the hit stays, t is divided.
TEST(ExtremeRay, LengthOfTheDirectionDividesT) {
    const Mesh mesh = geodesic_sphere(8).read_at(Precision::float_);
    for (const AcceleratorEntry& entry : accelerators()) {
        const auto accelerator = build(entry, mesh, {});
        for (const double factor : {0x1p-1000, 0x1p-100, 1e-30, 0x1p-3, 1e30, 0x1p100, 0x1p1000}) {
            size_t hits = 0;
            for (const Ray& ray : rays_at_sphere(mesh, 500)) {
                Ray stretched = ray;
                stretched.dir *= factor;
                const Hit want = first_hit(*accelerator, ray), got = first_hit(*accelerator, stretched);
                hits += want.valid();
                ASSERT_EQ(got.primitive, want.primitive) << entry.name << ", factor " << factor << ": " << describe(ray);
                if (!want.valid()) continue;
                ASSERT_NEAR(got.t * factor, want.t, 1e-13) << entry.name << ", factor " << factor << ": " << describe(ray);
            }
            EXPECT_GT(hits, 100u) << "the test must exercise hits";
        }
    }
}

}  // namespace
}  // namespace alidade::test
