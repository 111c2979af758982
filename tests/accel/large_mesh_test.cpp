// SPDX-License-Identifier: Apache-2.0
/// Where brute force cannot follow, the structures check each other: they share the triangle test, but no line of build or traversal.
#include "numerics/triangles/compare.h"
#include "numerics/triangles/rays.h"
#include "tests/core/run_size.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace alidade::test {

using namespace numerics;

namespace {

constexpr uint64_t kSeed = 20250202;

/// `make(k)` has about k * k times the triangles of `make(1)`.
/// `cost`: how much dearer a ray is here for structures that cannot adapt; there are so many times fewer of them.
struct LargeMesh {
    const char* name;
    TriangleMesh (*make)(double k);
    size_t cost;
};

constexpr LargeMesh kMeshes[] = {
    {"geodesic_sphere", [](double k) { return geodesic_sphere(int(71 * k), 0.2); }, 1},
    {"soup", [](double k) { return soup(int(100000 * k * k), 0.02 / k, 4); }, 2},
    {"cube", [](double k) { return cube(int(90 * k)); }, 1},
    {"stretched_torus", [](double k) { return moved(torus(int(400 * k), int(120 * k)), Vec3(3, 2, 1), Vec3(1e3, 0, -1e4), "torus, stretched, + 1e4"); }, 1},
    {"cube_lattice", [](double k) { return cube_lattice(int(20 * k), int(20 * k), 20); }, 4},
    {"slivers", [](double k) { return slivers(int(20000 * k * k), 1e-3, 5); }, 8},
    {"battens", [](double k) { return battens(int(4000 * k * k)); }, 4},
    {"stadium", [](double k) { return stadium(int(16 * k), 16); }, 20},
};

class LargeMeshes : public testing::TestWithParam<std::tuple<size_t, Precision>> {};

/// 2e5 rays over all meshes and both precisions; 1e7 in a full run.
TEST_P(LargeMeshes, AllAcceleratorsAgree) {
    const auto [index, precision] = GetParam();
    const TriangleMesh mesh = kMeshes[index].make(std::max(0.25, std::min(1.0, std::sqrt(run_scale())))).read_at(precision);
    AccelOptions options;
    options.precision = precision;
    std::vector<std::unique_ptr<Accelerator>> structures;
    const auto entries = accelerators_under_test();
    for (const AcceleratorEntry* entry : entries) structures.push_back(build(*entry, mesh, options));
    const size_t cases = 2 * std::size(kMeshes);
    const size_t count = run_size(300000, 17000000) / cases / kMeshes[index].cost / ray_classes().size() + 1;
    size_t hits = 0, differences = 0;
    for (const RayClass& rays : ray_classes()) {
        for (size_t i = 0; i < count && differences < 3; ++i) {
            const Ray ray = rays.make(mesh, RandomKey(kSeed, 0, i, 0));
            const Answers want = answers(*structures[0], ray);
            hits += want.first.valid();
            for (size_t k = 1; k < structures.size(); ++k) {
                const std::string what = difference(answers(*structures[k], ray), want);
                if (what.empty()) continue;
                ++differences;
                ADD_FAILURE() << entries[k]->name << " (got) and " << entries[0]->name << " (want): " << mesh.name << ", " << name(precision) << ", "
                              << rays.name << ", seed " << kSeed << ", ray " << i << ": " << describe(ray) << "\n"
                              << what;
            }
        }
    }
    EXPECT_GT(hits, count * ray_classes().size() / 2) << "the test must exercise hits";
    RecordProperty("rays", std::to_string(count * ray_classes().size()));
    fmt::print("{}: {} rays, {} hits\n", mesh.name, count * ray_classes().size(), hits);
}

INSTANTIATE_TEST_SUITE_P(Registry, LargeMeshes,
                         testing::Combine(testing::Range(size_t(0), std::size(kMeshes)), testing::Values(Precision::float_, Precision::double_)),
                         [](const auto& info) {
                             return std::string(kMeshes[std::get<0>(info.param)].name) + "_" + name(std::get<1>(info.param));
                         });

}  // namespace
}  // namespace alidade::test
