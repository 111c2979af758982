// SPDX-License-Identifier: Apache-2.0
/// Rays in files, laws of growth, parts of scenes, tables.
#include "core/draws.h"
#include "stress/growth.h"
#include "stress/ray_file.h"
#include "stress/table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>

namespace alidade::test {
namespace {

using testing::HasSubstr;

std::string why_not(std::span<const std::byte> bytes) {
    const auto rays = decode_rays(bytes);
    return rays ? "nothing" : rays.error();
}

std::vector<StressRay> some_rays() {
    Draws draws(RandomKey(1, 2, 3, 4));
    std::vector<StressRay> rays;
    for (int i = 0; i < 100; ++i) {
        const Vec3 origin = draws.in_box(Vec3(-5), Vec3(5)), dir = draws.direction();
        rays.push_back({origin, dir, draws.uniform(), i % 3 ? kInf : draws.uniform(1, 9)});
    }
    return rays;
}

TEST(RayFile, DoublesComeBackAsTheyAre) {
    const auto rays = some_rays();
    const auto back = decode_rays(encode_rays(rays, RayNumbers::float64));
    ASSERT_TRUE(back) << back.error();
    ASSERT_EQ(back->size(), rays.size());
    for (size_t i = 0; i < rays.size(); ++i) {
        EXPECT_EQ((*back)[i].origin, rays[i].origin);
        EXPECT_EQ((*back)[i].dir, rays[i].dir);
        EXPECT_EQ((*back)[i].tmin, rays[i].tmin);
        EXPECT_EQ((*back)[i].tmax, rays[i].tmax);
    }
}

TEST(RayFile, FloatsComeBackRounded) {
    const auto rays = some_rays();
    const auto bytes = encode_rays(rays, RayNumbers::float32);
    EXPECT_EQ(bytes.size(), 24 + rays.size() * 32);
    const auto back = decode_rays(bytes);
    ASSERT_TRUE(back) << back.error();
    for (size_t i = 0; i < rays.size(); ++i) EXPECT_EQ((*back)[i].origin, Vec3(Vec3f(rays[i].origin)));
    EXPECT_EQ(encode_rays(*back, RayNumbers::float32), bytes);
}

/// The format as docs/stress.md has it, byte by byte.
TEST(RayFile, HasTheDocumentedBytes) {
    const auto bytes = encode_rays(std::array{StressRay{Vec3(1, 2, 3), Vec3(0, 0, -1), 0.5, kInf}}, RayNumbers::float32);
    ASSERT_EQ(bytes.size(), 56u);
    EXPECT_EQ(std::memcmp(bytes.data(), "ALIDRAYS", 8), 0);
    std::array<uint32_t, 12> words;
    std::memcpy(words.data(), bytes.data() + 8, sizeof words);
    EXPECT_THAT(words, testing::ElementsAre(1, 4, 1, 0, 0x3f800000, 0x40000000, 0x40400000, 0, 0, 0xbf800000, 0x3f000000, 0x7f800000));
}

TEST(RayFile, WhatIsWrongIsSaidWithItsByte) {
    const auto good = encode_rays(some_rays(), RayNumbers::float64);
    const auto changed = [&](size_t at, uint32_t value) {
        auto bytes = good;
        std::memcpy(&bytes[at], &value, 4);
        return why_not(bytes);
    };
    EXPECT_THAT(changed(0, 0), HasSubstr("byte 0: this is no file of rays"));
    EXPECT_THAT(changed(8, 7), HasSubstr("byte 8: version 7 is not known"));
    EXPECT_THAT(changed(12, 2), HasSubstr("byte 12: numbers of 2 bytes"));
    EXPECT_THAT(changed(16, 101), HasSubstr("byte 16: 101 rays are told, but there are bytes for 100"));
    EXPECT_THAT(changed(20, 0x40000000), HasSubstr("byte 16: ")) << "a count whose bytes overflow";
    EXPECT_THAT(changed(16, 99), HasSubstr("64 bytes behind the last of 99 rays"));
    EXPECT_THAT(changed(24 + 64 * 5 + 4, 0x7ff80000), HasSubstr("byte 344: ray 5: its origin is not finite"));
    EXPECT_THAT(changed(24 + 64 * 5 + 52, 0x7ff80000), HasSubstr("byte 344: ray 5: its tmin or tmax is not a number"));
    auto still = some_rays();
    still[3].dir = Vec3(0);
    EXPECT_THAT(why_not(encode_rays(still, RayNumbers::float64)), HasSubstr("ray 3: its direction is not finite, or zero"));
    EXPECT_THAT(why_not(encode_rays({}, RayNumbers::float32)), HasSubstr("there are no rays"));
    for (size_t size = 0; size < good.size(); size += size < 40 ? 1 : 997) EXPECT_FALSE(decode_rays(std::span(good).first(size))) << size;
}

TEST(PowerLaw, FindsTheExponentThatIsThere) {
    std::vector<double> n, cost;
    for (double x = 1e3; x < 2e7; x *= 3) n.push_back(x), cost.push_back(2.5e-7 * std::pow(x, 1.25));
    const auto law = fit_power_law(n, cost);
    ASSERT_TRUE(law);
    EXPECT_NEAR(law->exponent, 1.25, 1e-12);
    EXPECT_NEAR(law->factor, 2.5e-7, 1e-17);
    EXPECT_NEAR(*law->error, 0, 1e-12);
    EXPECT_EQ(law->points, n.size());
}

/// Noise of a known spread: the standard error is that of repeated experiments.
TEST(PowerLaw, KnowsHowSureItIs) {
    Draws draws(RandomKey(5, 0, 0, 0));
    double squares = 0, errors = 0;
    constexpr int kTrials = 400;
    for (int trial = 0; trial < kTrials; ++trial) {
        std::vector<double> n, cost;
        for (double x = 1e3; x < 2e6; x *= 2) n.push_back(x), cost.push_back(std::pow(x, 0.5) * std::exp(draws.uniform(-0.2, 0.2)));
        const auto law = fit_power_law(n, cost);
        squares += std::pow(law->exponent - 0.5, 2), errors += *law->error;
    }
    EXPECT_NEAR(errors / kTrials, std::sqrt(squares / kTrials), 0.15 * errors / kTrials);
}

TEST(PowerLaw, PassesOverWhatHasNoLogarithm) {
    EXPECT_FALSE(fit_power_law(std::array{10.0, 10.0}, std::array{1.0, 2.0})) << "one size says nothing of growth";
    EXPECT_FALSE(fit_power_law(std::array{10.0, 100.0}, std::array{0.0, 2.0}));
    const auto law = fit_power_law(std::array{10.0, 100.0, 1000.0}, std::array{1.0, 0.0, 100.0});
    ASSERT_TRUE(law);
    EXPECT_NEAR(law->exponent, 1, 1e-12);
    EXPECT_FALSE(law->error) << "two points are met by any law";
}

TEST(PartOfAScene, HasItsFirstTriangles) {
    StressScene scene = find_stress_kind("scan")->make(3000, 1);
    scene.meshes.insert(scene.meshes.begin(), find_stress_kind("soup")->make(100, 1).mesh());
    const StressScene part = part_of(scene, 500);
    const StressMesh& from = scene.meshes[1];
    ASSERT_EQ(part.triangles(), 500u);
    for (size_t i = 0; i < 500; ++i)
        for (int k = 0; k < 3; ++k) EXPECT_EQ(part.mesh().positions[part.mesh().triangles[i][k]], from.positions[from.triangles[i][k]]);
    EXPECT_LT(part.mesh().positions.size(), 600u) << "shared vertices stay shared";
    EXPECT_EQ(part_of(scene, 1 << 20).triangles(), from.triangles.size());
}

TEST(StressTable, SaysWhatWasMeasuredAndWhatWasNot) {
    StressFigures figures;
    figures.triangles = figures.placed_triangles = 1000;
    StressPeerFigures bvh;
    bvh.name = "bvh", bvh.precision = "float", bvh.builds = 1, bvh.build_seconds = {0.002, 0.002, 0.002}, bvh.structure.bytes = 54000, bvh.structure.phases = {{"divide", 0.003}, {"pack", 0.001}}, bvh.structure.nodes = 123;
    StressRayFigures rays;
    rays.rays = "primary", rays.count = 100, rays.hits = 25, rays.rounds = 3, rays.seconds = {1e-4, 0.9e-4, 1.3e-4}, rays.boxes = 12.25;
    bvh.rays = {rays};
    StressPeerFigures grid;
    grid.name = "grid", grid.precision = "double", grid.left_out = "takes about 9 s: 3 s are left";
    figures.peers = {bvh, grid}, figures.checked = {{"primary", "float", 16}};
    const std::string table = stress_table(figures);
    EXPECT_THAT(table, testing::ContainsRegex("bvh +float +0.002 +0.50 +54.0 +- +123 +- +- +divide 75 %, pack 25 %\n"));
    EXPECT_THAT(table, testing::ContainsRegex("primary +bvh +float +1.000 +20 +25 +12.2 +- +- +0\n"));
    EXPECT_THAT(table, HasSubstr("left out: grid in double: takes about 9 s: 3 s are left"));
    EXPECT_THAT(table, HasSubstr("all agree; brute force was asked 16 primary rays"));
    figures.disagreements.push_back({"bvh", "float", "primary", Question::closest, 7, 1, {}, {}, {2.5, 0, 3, 0, 0}});
    EXPECT_THAT(stress_table(figures), HasSubstr("WRONG: bvh in float, primary ray 7: no hit, where triangle 3 of place 0 at t = 2.5"));
}

}  // namespace
}  // namespace alidade::test
