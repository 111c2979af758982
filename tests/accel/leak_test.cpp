// SPDX-License-Identifier: Apache-2.0
/// Light never leaks out of a closed surface: a ray from inside, aimed at an edge or a vertex, hits. Issue: 1e7 rays on ten meshes, none missed.
#include "tests/accel/compare.h"
#include "tests/accel/rays.h"
#include "tests/accel/run_size.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace alidade::test {
namespace {

constexpr uint64_t kSeed = 20250303;

struct Case {
    const AcceleratorEntry* entry;
    Precision precision;
    size_t mesh;
};

std::vector<Case> all_cases() {
    std::vector<Case> cases;
    for (const AcceleratorEntry* entry : accelerators_under_test())
        for (const Precision precision : {Precision::float_, Precision::double_})
            for (size_t mesh = 0; mesh < closed_meshes().size(); ++mesh) cases.push_back({entry, precision, mesh});
    return cases;
}

/// The BVH in float, the default of every render, gets the 1e7 rays in any run; the others a hundredth of that, and as many in a full run.
size_t rays_per_mesh(const Case& c) {
    const bool is_default = find_accelerator("bvh") == c.entry && c.precision == Precision::float_;
    return is_default ? run_size(1000000, 10000000) : run_size(10000, 1000000);
}

class ClosedMeshes : public testing::TestWithParam<Case> {};

TEST_P(ClosedMeshes, DoNotLeak) {
    const auto [entry, precision, index] = GetParam();
    const Mesh mesh = closed_meshes()[index].read_at(precision);
    AccelOptions options;
    options.precision = precision;
    const auto accelerator = build(*entry, mesh, options);
    const size_t count = rays_per_mesh(GetParam());
    size_t missed = 0;
    for (size_t i = 0; i < count; ++i) {
        const auto aim = i % 2 ? edge_aimed_from_inside : vertex_aimed_from_inside;
        const Ray ray = aim(mesh, RandomKey(kSeed, 0, i, 0));
        if (first_hit(*accelerator, ray).valid()) continue;
        if (++missed <= 3) ADD_FAILURE() << mesh.name << ", seed " << kSeed << ", ray " << i << ": " << describe(ray);
    }
    EXPECT_EQ(missed, 0u) << "of " << count;
    RecordProperty("rays", std::to_string(count));
    fmt::print("{}: {} rays, {} missed\n", mesh.name, count, missed);
}

INSTANTIATE_TEST_SUITE_P(Registry, ClosedMeshes, testing::ValuesIn(all_cases()), [](const auto& info) {
    return test_name(fmt::format("{}_{}_{}", info.param.entry->name, name(info.param.precision), closed_meshes()[info.param.mesh].name));
});

/// What CSG and interiors rest on: from inside a convex mesh every ray leaves once. A ray through an edge or a vertex may meet several triangles, but
/// all of them at one place.
TEST(ConvexMesh, IsLeftOnceAtOnePlace) {
    const Mesh mesh = geodesic_sphere(4).read_at(Precision::float_);
    for (const AcceleratorEntry& entry : accelerators()) {
        const auto accelerator = build(entry, mesh, {});
        for (size_t i = 0; i < run_size(20000, 1000000); ++i) {
            const auto aim = i % 2 ? edge_aimed_from_inside : vertex_aimed_from_inside;
            const Ray ray = aim(mesh, RandomKey(kSeed, 1, i, 0));
            const std::vector<Hit> hits = all_hits(*accelerator, ray);
            ASSERT_FALSE(hits.empty()) << entry.name << ", ray " << i << ": " << describe(ray);
            ASSERT_NEAR(hits.back().t, hits.front().t, 1e-12) << entry.name << ", ray " << i << ": " << describe(ray);
        }
    }
}

}  // namespace
}  // namespace alidade::test
