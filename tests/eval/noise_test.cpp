// SPDX-License-Identifier: Apache-2.0
/// POV-Ray's own numbers are the oracle: those of a run, where it is installed, those it printed once, where they are at hand, and a few that stand here.
#include "eval/noise/lattice_noise.h"
#include "eval/noise/noise.h"

#include "tests/povray/povray.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <cstring>
#include <random>

using namespace alidade;

namespace {

constexpr NoiseGenerator kGenerators[] = {NoiseGenerator::original, NoiseGenerator::range_corrected, NoiseGenerator::perlin};

/// Inside of cells, on lattice planes, beside them by less and more than POV-Ray's 1e-10, of both signs, and as far as the cells of a million.
std::vector<Vec3> noise_points(size_t count) {
    std::mt19937_64 engine(5);
    const auto uniform = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(engine); };
    const auto coordinate = [&](size_t kind) {
        switch (kind % 6) {
            case 0: return std::round(uniform(-30, 30));
            case 1: return std::round(uniform(-30, 30)) + uniform(-1, 1) * std::pow(10.0, uniform(-14, -8));
            case 2: return uniform(-1e6, 1e6);
            case 3: return std::round(uniform(-1e6, 1e6)) / 8;
            default: return uniform(-10, 10);
        }
    };
    std::vector<Vec3> points = {Vec3(0), Vec3(-0.0), Vec3(1e6), Vec3(-1e6), Vec3(-1e6 - 1e-11, 1e6, 4096), Vec3(-10000, 10000, -4096)};
    while (points.size() < count) {
        const size_t kind = points.size() % 7;   // 6: another kind for each coordinate
        points.push_back(kind < 6 ? Vec3(coordinate(kind), coordinate(kind), coordinate(kind)) : Vec3(coordinate(engine()), coordinate(engine()), coordinate(engine())));
    }
    return points;
}

}  // namespace

/// What the machine does faster it does with the same roundings.
TEST(LatticeNoise, EveryWayGivesTheSameBits) {
    std::vector<Vec3> points = noise_points(20000);
    points.insert(points.end(), {Vec3(2147483646.5, -2147483646.5, 0.25), Vec3(1e15, 0.2, 0.3), Vec3(0.2, -3e9, 0.3), Vec3(-1e-10, -2e-10, -0.0)});
    const auto same = [](const Vec3& a, const Vec3& b) { return std::memcmp(&a, &b, sizeof a) == 0; };
    const LatticeNoise& plain = lattice_noises().front();
    for (const LatticeNoise& way : lattice_noises()) {
        for (size_t i = 0; i + 4 <= points.size(); i += 4) {
            double values[4];
            way.four(&points[i], values);
            for (size_t k = 0; k < 4; ++k) ASSERT_TRUE(same(Vec3(values[k]), Vec3(plain.value(points[i + k])))) << way.name << fmt::format(" {} {} {}", points[i + k].x, points[i + k].y, points[i + k].z);
        }
        for (const Vec3& p : points) {
            ASSERT_TRUE(same(Vec3(way.value(p)), Vec3(plain.value(p)))) << way.name << fmt::format(" {} {} {}", p.x, p.y, p.z);
            ASSERT_TRUE(same(way.vector(p), plain.vector(p))) << way.name << fmt::format(" {} {} {}", p.x, p.y, p.z);
            for (const Octaves& octaves : {Octaves{1, 0.5, 2}, {6, 0.5, 2}, {10, 0.7, 2.3}}) ASSERT_TRUE(same(way.octaves(p, octaves), plain.octaves(p, octaves))) << way.name << fmt::format(" {} {} {}", p.x, p.y, p.z);
        }
    }
}

TEST(Noise, KnownValues) {
    const Vec3 p(0.3, 0.4, 0.5);
    EXPECT_NEAR(noise(p, NoiseGenerator::original), 0.41903169558950404, 1e-15);
    EXPECT_NEAR(noise(p, NoiseGenerator::range_corrected), 0.47587126693338683, 1e-15);
    EXPECT_NEAR(noise(p, NoiseGenerator::perlin), 0.67807530508139957, 1e-15);
    const Vec3 t = vector_turbulence({1.2, 3.4, 5.6}, Turbulence());
    EXPECT_NEAR(t.x, -0.271406373408782, 1e-14);
    EXPECT_NEAR(t.y, 0.115235920083735, 1e-14);
    EXPECT_NEAR(t.z, 0.102795161514693, 1e-14);
}

TEST(Noise, EveryGeneratorIsPovRays) {
    if (!povray_is_installed()) GTEST_SKIP() << "povray is not installed";
    std::vector<Vec3> points = noise_points(21000);
    points.insert(points.end(), {Vec3(2147483646.5, -2147483646.5, 0.25), Vec3(1e15, 0.2, 0.3), Vec3(0.2, -3e9, 0.3)});
    std::vector<std::string> asked;
    for (const Vec3& p : points)
        for (const NoiseGenerator g : kGenerators) asked.push_back(fmt::format("f_noise_generator({:.17g}, {:.17g}, {:.17g}, {})", p.x, p.y, p.z, int(g)));
    const std::vector<double> theirs = povray_values("#include \"functions.inc\"", asked);
    ASSERT_EQ(theirs.size(), 3 * points.size());
    double worst = 0;
    for (size_t i = 0; i < theirs.size(); ++i) {
        const double error = std::fabs(noise(points[i / 3], kGenerators[i % 3]) - theirs[i]);
        ASSERT_LE(error, 1e-9) << asked[i];
        worst = std::max(worst, error);
    }
    RecordProperty("worst", fmt::format("{}", worst));
    EXPECT_LE(worst, 1e-14);
}

TEST(Noise, VectorNoiseAndTurbulenceArePovRays) {
    if (!povray_is_installed()) GTEST_SKIP() << "povray is not installed";
    const std::vector<Vec3> points = noise_points(7000);
    const Turbulence one{Vec3(0), 1, 0.5, 2}, usual, other{Vec3(0), 4, 0.7, 2.3};
    std::string prelude;
    std::vector<std::string> asked;
    for (const Vec3& p : points)
        for (const Turbulence& t : {one, usual, other})
            for (const char c : {'x', 'y', 'z'}) asked.push_back(fmt::format("vturbulence({}, {}, {}, {}).{}", t.lambda, t.omega, t.octaves, pov_text(p), c));
    const std::vector<double> theirs = povray_values(prelude, asked);
    ASSERT_EQ(theirs.size(), 9 * points.size());
    for (size_t i = 0; i < theirs.size(); ++i) {
        const Vec3& p = points[i / 9];
        const Vec3 ours = i % 9 < 3 ? vector_noise(p) : vector_turbulence(p, i % 9 < 6 ? usual : other);
        // Turbulence multiplies the coordinates: where the last octave's cells are counted in 1e7, a rounding of the product is 1e-9 of a cell.
        ASSERT_NEAR(ours[int(i % 3)], theirs[i], 1e-9) << asked[i];
    }
}

TEST(Noise, SharedVectors) {
    int compared = 0;
    for (const PovVector& v : pov_vectors()) {
        double ours = 0;
        if (v.declaration == "f_noise3d(x,y,z)") ours = noise(v.point, NoiseGenerator::range_corrected);
        else if (v.declaration == "f_noise_generator(x,y,z,3)") ours = noise(v.point, NoiseGenerator::perlin);
        else if (v.kind.rfind("vturbulence", 0) == 0) ours = vector_turbulence(v.point, {Vec3(0), 5, 0.6, 2.1})[v.kind.back() - 'x'];
        else continue;
        EXPECT_NEAR(ours, v.value, 2e-15 + 1e-15 * std::fabs(v.value)) << v.declaration;
        ++compared;
    }
    if (!compared) GTEST_SKIP() << "the shared research is not at hand";
    EXPECT_EQ(compared, 180);
}

/// What fits no 32 bits has no cell, but a value all the same: nothing traps, nothing is NaN.
TEST(Noise, CoordinatesWithoutCells) {
    for (const double far : {3e9, -3e9, 1e15, 1e17, -1e17})
        for (const NoiseGenerator g : kGenerators) {
            const double n = noise({far, 0.2, far}, g);
            EXPECT_TRUE(n >= 0 && n <= 1) << far;
        }
    EXPECT_EQ(noise({3e9 + .25, 0.2, 3.5}, NoiseGenerator::perlin), 1);   // as POV-Ray has it
}
