// SPDX-License-Identifier: Apache-2.0
/// Instruction sets change the speed, never a bit of a hit.
#include "accel/triangles/decide.h"
#include "core/draws.h"
#include "numerics/triangles/compare.h"
#include "numerics/triangles/rays.h"
#include "tests/core/run_size.h"

#include "hwy/targets.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>

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

/// Of triangles of any size and shape, needles and points too, and of what overflows: compared as bits.
TEST(Isa, AllGiveTheErrorOfScalarCode) {
    size_t plain = 0;
    const size_t count = run_size(100000, 10000000);
    for (size_t n = 0; n < count; ++n) {
        Draws draws(RandomKey(151, 0, n));
        const double size = draws.below(4) ? 1 : std::ldexp(1.0, int(draws.below(1600)) - 800), thin = draws.below(3) ? 1 : std::ldexp(1.0, -int(draws.below(60)));
        Corners corners;
        for (Vec3& corner : corners) corner = size * draws.in_box(Vec3(-1), Vec3(1)) * Vec3(1, thin, 1);
        if (draws.below(8) == 0) corners[2] = corners[0] + draws.uniform() * (corners[1] - corners[0]);   // but for rounding on the edge: what bounds the error is the corner
        if (draws.below(50) == 0) corners[2] = corners[draws.below(2)];
        Ray ray;
        ray.origin = size * draws.in_box(Vec3(-4), Vec3(4)), ray.dir = draws.direction();
        const double t = size * draws.uniform(-4, 4), want = plane_error(ray, t, corners, Isa::scalar).along_normal;
        for (const Isa isa : available_isas().subspan(1))
            ASSERT_EQ(std::bit_cast<uint64_t>(plane_error(ray, t, corners, isa).along_normal), std::bit_cast<uint64_t>(want)) << alidade::name(isa) << ", seed 151, triangle " << n << ": " << want;
        plain += want > 0 && want < kInf;
    }
    EXPECT_GT(plain, count / 2);
}

TEST(Isa, AllGiveTheHitsOfScalarCode) {
    const size_t count = run_size(150, 15000);
    for (const TriangleMesh& source : {geodesic_sphere(16), soup(2000, 0.1, 7), moved(cube(8), Vec3(1e-6), Vec3(1, 0, -1), "small cube")}) {
        for (const Precision precision : {Precision::float_, Precision::double_}) {
            const TriangleMesh mesh = source.read_at(precision);
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
