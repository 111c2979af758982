// SPDX-License-Identifier: Apache-2.0
/// Instruction sets change the speed, never a bit of a hit.
#include "numerics/triangles/compare.h"
#include "numerics/triangles/rays.h"
#include "tests/accel/run_size.h"

#include "hwy/targets.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace alidade::test {

using namespace numerics;

namespace {

TEST(Isa, ScalarIsFirstAndAlwaysThere) {
    ASSERT_FALSE(available_isas().empty());
    EXPECT_EQ(available_isas().front(), Isa::scalar);
}

/// Highway's own library is the oracle; the program does not load it.
TEST(Isa, AreThoseThatHighwayFinds) {
    const int64_t found = hwy::SupportedTargets();
    EXPECT_EQ(machine_has(Isa::sse4), (found & HWY_SSE4) != 0);
    EXPECT_EQ(machine_has(Isa::avx2), (found & HWY_AVX2) != 0);
    EXPECT_EQ(machine_has(Isa::avx512), (found & HWY_AVX3) != 0);
}

TEST(Isa, AllGiveTheHitsOfScalarCode) {
    const size_t count = run_size(150, 15000);
    for (const Mesh& source : {geodesic_sphere(16), soup(2000, 0.1, 7), moved(cube(8), Vec3(1e-6), Vec3(1, 0, -1), "small cube")}) {
        for (const Precision precision : {Precision::float_, Precision::double_}) {
            const Mesh mesh = source.read_at(precision);
            for (const AcceleratorEntry* entry : accelerators_under_test()) {
                const auto scalar = build(*entry, mesh, {precision, Isa::scalar});
                for (const Isa isa : available_isas().subspan(1)) {
                    const auto simd = build(*entry, mesh, {precision, isa});
                    for (size_t i = 0; i < count * ray_classes().size(); ++i) {
                        const RayClass& rays = ray_classes()[i % ray_classes().size()];
                        const Ray ray = rays.make(mesh, RandomKey(11, 0, i, 0));
                        ASSERT_EQ(difference(answers(*simd, ray), answers(*scalar, ray)), "")
                            << alidade::name(isa) << ", " << entry->name << ", " << name(precision) << ", " << mesh.name << ", " << rays.name
                            << ", seed 11, ray " << i << ": " << describe(ray);
                    }
                }
            }
        }
    }
    for (const Isa isa : available_isas()) fmt::print("{} ", alidade::name(isa));
    fmt::print("\n");
}

}  // namespace
}  // namespace alidade::test
