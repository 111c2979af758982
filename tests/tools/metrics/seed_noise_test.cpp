// SPDX-License-Identifier: Apache-2.0
/// Pictures whose noise is known: how often the test of pixels is wrong, and what it finds.
#include "core/vec.h"
#include "tests/core/run_size.h"
#include "tests/tools/metrics/pairs.h"
#include "tools/metrics/seed_noise.h"
#include "tools/metrics/student.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace alidade::test {
namespace {

constexpr int kSide = 16, kSeeds = 16;
constexpr float kSigma = 0.1F;

/// Student's density, integrated by Simpson's rule from t on; u = 1 / x makes the end finite.
double tail(double t, double degrees) {
    const auto density = [&](double x) {
        const double log = std::lgamma((degrees + 1) / 2) - std::lgamma(degrees / 2) - 0.5 * std::log(degrees * kPi) - (degrees + 1) / 2 * std::log1p(x * x / degrees);
        return std::exp(log);
    };
    constexpr int kSteps = 20000;
    const double h = 1 / t / kSteps;
    double sum = 0;
    for (int i = 1; i <= kSteps; ++i) {
        const double u = i * h, weight = i == kSteps ? 1 : i % 2 ? 4 : 2;
        sum += weight * density(1 / u) / (u * u);
    }
    return sum * h / 3;
}

TEST(Student, DeviatesAreAsRareAsTheirTs) {
    for (const double degrees : {8.0, 15.0, 31.0, 100.0})
        for (const double t : {1.0, 2.5, 5.0, 9.0, 12.0}) {
            const double z = normal_deviate(t, degrees), exact = tail(t, degrees);
            EXPECT_LE(0.5 * std::erfc(1.007 * z / std::sqrt(2.0)), exact) << degrees << " degrees, t " << t;
            EXPECT_GE(0.5 * std::erfc(0.993 * z / std::sqrt(2.0)), exact) << degrees << " degrees, t " << t;
        }
}

TEST(Student, ManyTestsTogetherHaveTheProbabilityOfOne) {
    EXPECT_NEAR(sidak_limit(0.01, 1), 2.5758293, 1e-6);
    for (const double tests : {10.0, 1e4, 1e7}) EXPECT_NEAR(std::exp(tests * std::log1p(-std::erfc(sidak_limit(0.01, size_t(tests)) / std::sqrt(2.0)))), 0.99, 1e-6);
}

using Value = std::function<float(size_t i)>;

Picture picture(const Value& value) {
    Picture out(kSide, kSide, {"R", "G", "B"});
    for (size_t i = 0; i < out.values.size(); ++i) out.values[i] = value(i);
    return out;
}

SeedStatistics statistics(int count, const Value& value) {
    SeedStatistics out;
    for (int i = 0; i < count; ++i) out.add(picture(value));
    return out;
}

SeedNoise tested(const SeedStatistics& ours, const SeedStatistics& reference, ReferenceNoise noise) {
    return test_seeds(ours, reference, noise, std::vector<uint8_t>(kSide * kSide, 1), 1.0 / 255, 0);
}

TEST(SeedStatistics, AreThoseOfTwoPasses) {
    std::mt19937 random(1);
    std::vector<Picture> all;
    SeedStatistics got;
    for (int i = 0; i < kSeeds; ++i) {
        all.push_back(picture([&](size_t) { return 1000 + float(random() % 100); }));
        got.add(all.back());
    }
    for (size_t v = 0; v < got.values(); ++v) {
        double mean = 0, squares = 0;
        for (const Picture& p : all) mean += double(p.values[v]) / kSeeds;
        for (const Picture& p : all) squares += (p.values[v] - mean) * (p.values[v] - mean);
        EXPECT_NEAR(got.mean(v), mean, 1e-9);
        EXPECT_NEAR(got.variance(v), squares / (kSeeds - 1), 1e-6);
    }
}

/// A reference for each kind of what is known of it. Normal noise; the means differ by `bias` deviations in one pixel.
struct Trial {
    ReferenceNoise noise;
    double bias = 0;

    SeedNoise run(uint32_t seed) const {
        std::mt19937 random(seed);
        std::normal_distribution<float> normal(0.5F, kSigma);
        const Value noisy = [&](size_t) { return normal(random); };
        const float moved = float(bias) * kSigma;
        const auto biased = [&](size_t i) { return i / 3 == 100 ? moved : 0; };
        const Value reference = [&](size_t i) { return (noise == ReferenceNoise::none ? 0.5F : normal(random)) + biased(i); };
        const SeedStatistics ours = statistics(kSeeds, noisy);
        return tested(ours, statistics(noise == ReferenceNoise::measured ? kSeeds : 1, reference), noise);
    }
};

/// One in a hundred; of several hundred the number is Poisson's.
TEST(SeedNoise, AlarmsAsOftenAsItSays) {
    if (run_scale() < 1) GTEST_SKIP() << "how often is counted in the ordinary run";
    constexpr int kTrials = 600;   // 6 are expected; more than 15 come once in 2000
    for (const ReferenceNoise noise : {ReferenceNoise::none, ReferenceNoise::like_ours, ReferenceNoise::measured}) {
        int alarms = 0;
        for (uint32_t seed = 0; seed < kTrials; ++seed) alarms += Trial{noise}.run(seed).significant > 0;
        EXPECT_LE(alarms, 15) << int(noise);
        if (noise == ReferenceNoise::none) {
            EXPECT_GE(alarms, 1) << "a test that never alarms finds nothing";
        }
    }
}

/// t exceeds its limit, about 6.5 of 15 degrees: by 6.5 / sqrt(16) deviations of a true reference, 6.5 sqrt(1 + 1/16) of a single one, 5.4 sqrt(2/16) of
/// sixteen; twice as much is found surely.
TEST(SeedNoise, FindsABiasInOnePixel) {
    for (const auto& [noise, bias] : {std::pair(ReferenceNoise::none, 3.5), std::pair(ReferenceNoise::like_ours, 14.0), std::pair(ReferenceNoise::measured, 4.0)})
        for (uint32_t seed = 0; seed < 100; ++seed) {
            const SeedNoise found = Trial{noise, bias}.run(seed);
            EXPECT_GE(found.significant, 1U) << int(noise) << " seed " << seed;
            EXPECT_TRUE(found.marked[100]) << int(noise) << " seed " << seed;
        }
}

/// At the edge of a penumbra a pixel that is dark in all pictures may once be lit. 16 values are not normal there, and t alone takes half of the pictures for others.
TEST(SeedNoise, WhatIsRarelySeenIsNoError) {
    int alarms = 0;
    for (uint32_t seed = 0; seed < 200; ++seed) {
        std::mt19937 random(seed);
        const Value lit = [&](size_t i) { return float(int(random() % 1200) < 100 * std::clamp(int(i / 3 % kSide) - 2, 0, 12)); };
        const SeedStatistics ours = statistics(kSeeds, lit);
        alarms += tested(ours, statistics(1, lit), ReferenceNoise::like_ours).significant > 0;
    }
    EXPECT_LE(alarms, 8);   // 2 are expected at most
}

TEST(SeedNoise, WhereNothingIsRandomValuesAreComparedToARoundingStep) {
    const auto equal = [](float x) { return [x](size_t) { return x; }; };
    const SeedStatistics ours = statistics(kSeeds, equal(0.5F));
    for (const ReferenceNoise noise : {ReferenceNoise::none, ReferenceNoise::like_ours, ReferenceNoise::measured}) {
        const int count = noise == ReferenceNoise::measured ? kSeeds : 1;
        EXPECT_EQ(tested(ours, statistics(count, equal(0.5F + 0.9F / 255)), noise).significant, 0U);
        const SeedNoise other = tested(ours, statistics(count, equal(0.5F + 1.1F / 255)), noise);
        EXPECT_EQ(other.significant, size_t(kSide * kSide));
        EXPECT_TRUE(std::isinf(other.largest_z));
    }
}

TEST(SeedNoise, LeavesOutWhatDoesNotCount) {
    std::vector<uint8_t> counts(kSide * kSide, 1);
    counts[7] = 0;
    const SeedStatistics ours = statistics(kSeeds, [](size_t) { return 0.0F; }), other = statistics(1, [](size_t i) { return i / 3 == 7 ? 1.0F : 0.0F; });
    const SeedNoise found = test_seeds(ours, other, ReferenceNoise::none, counts, 0, 0);
    EXPECT_EQ(found.significant, 0U);
    EXPECT_EQ(found.tests, size_t(3 * (kSide * kSide - 1)));
}

}  // namespace
}  // namespace alidade::test
