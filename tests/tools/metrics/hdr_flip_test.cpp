// SPDX-License-Identifier: Apache-2.0
#include "tests/tools/metrics/flip_oracle.h"
#include "tests/tools/metrics/pairs.h"
#include "tests/tools/metrics/published.h"
#include "tools/metrics/metric.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

using namespace test;

/// What the film curve makes 0.85, solved by bisection.
double nearly_white() {
    const auto film = [](double x) { return (0.6 * 0.6 * 2.51 * x * x + 0.6 * 0.03 * x) / (0.6 * 0.6 * 2.43 * x * x + 0.6 * 0.59 * x + 0.14); };
    double low = 0, high = 10;
    for (int i = 0; i < 100; ++i) (film((low + high) / 2) < 0.85 ? low : high) = (low + high) / 2;
    return low;
}

TEST(HdrFlip, TakesExposuresFromMaximumAndMedianOfTheReference) {
    // 25 pixels: the darkest 12 have 2^-6, one has 2^-4.5, the brightest 12 have 4.
    const auto reference = drawn(5, 5, [](int x, int y) {
        const int i = 5 * y + x;
        const float value = i < 12 ? 1.0f / 64 : i == 12 ? std::exp2(-4.5f) : 4.0f;
        return std::array{value, value, value};
    });
    const auto measured = measure_hdr_flip(paired(reference, constant(5, 5, {1, 1, 1}), true));
    EXPECT_NEAR(number(measured, "start_exposure"), std::log2(nearly_white()) - 2, 1e-6);
    EXPECT_NEAR(number(measured, "stop_exposure"), std::log2(nearly_white()) + 4.5, 1e-6);
    EXPECT_EQ(number(measured, "exposures"), 7) << "6.5 stops";
}

TEST(HdrFlip, OfConstantPicturesIsAFormula) {
    const auto measured = measure_hdr_flip(paired(constant(6, 4, {2, 2, 2}), constant(6, 4, {0, 0, 0}), true));
    EXPECT_EQ(number(measured, "exposures"), 2);
    EXPECT_EQ(number(measured, "start_exposure"), number(measured, "stop_exposure"));
    EXPECT_NEAR(number(measured, "mean"), color_error({0.85, 0.85, 0.85}, {0, 0, 0}), 1e-5) << "at its one exposure the reference shows as 0.85";
}

TEST(HdrFlip, OfAPictureAndItselfIsNothing) {
    const auto picture = drawn(33, 21, noise(1, -1, 100));
    const auto measured = measure_hdr_flip(paired(picture, picture, true));
    EXPECT_EQ(number(measured, "mean"), 0);
    EXPECT_EQ(number(measured, "max"), 0);
    EXPECT_EQ(number(measured, "weighted_median"), 0);
}

TEST(HdrFlip, TakesNegativeLightForNone) {
    const auto clipped = drawn(20, 20, [](int x, int y) { auto rgb = noise(1, -1, 3)(x, y); for (float& v : rgb) v = std::max(v, 0.0f); return rgb; });
    const auto test = drawn(20, 20, noise(2, 0, 3));
    EXPECT_EQ(measure_hdr_flip(paired(drawn(20, 20, noise(1, -1, 3)), test, true)).map, measure_hdr_flip(paired(clipped, test, true)).map);
}

/// A median of 0 would ask for endless exposures.
TEST(HdrFlip, OfAReferenceThatIsMostlyBlackTakesTheMedianOfTheRest) {
    const auto reference = drawn(10, 10, [](int x, int) { return x < 7 ? std::array{0.0f, 0.0f, 0.0f} : std::array{0.5f, 0.5f, 0.5f}; });
    const auto measured = measure_hdr_flip(paired(reference, constant(10, 10, {0, 0, 0}), true));
    EXPECT_NEAR(number(measured, "stop_exposure"), std::log2(nearly_white() / 0.5), 1e-6);
    EXPECT_EQ(number(measured, "exposures"), 2);
    EXPECT_GT(number(measured, "max"), 0.5);
}

TEST(HdrFlip, OfABlackReferenceTakesTheTestPicture) {
    const auto black = constant(10, 10, {0, 0, 0}), faint = constant(10, 10, {1e-5f, 1e-5f, 1e-5f});
    const auto measured = measure_hdr_flip(paired(black, faint, true));
    EXPECT_NEAR(number(measured, "mean"), color_error({0.85, 0.85, 0.85}, {0, 0, 0}), 1e-5);
    EXPECT_EQ(number(measure_hdr_flip(paired(black, black, true)), "max"), 0);
}

TEST(HdrFlip, BearsTheEndsOfFloat) {
    const auto huge = drawn(9, 9, [](int x, int) { const float v = x < 4 ? 3e38f : x < 6 ? 1e-40f : 1; return std::array{v, v, v}; });
    for (const auto& pair : {paired(huge, constant(9, 9, {1, 1, 1}), true), paired(constant(9, 9, {1, 1, 1}), huge, true)}) {
        const auto measured = measure_hdr_flip(pair);
        EXPECT_TRUE(std::all_of(measured.map.begin(), measured.map.end(), [](float v) { return v >= 0 && v <= 1; }));
        EXPECT_GT(number(measured, "max"), 0.5);
    }
}

TEST(HdrFlip, LeavesOutPixelsThatDoNotCount) {
    auto pair = paired(constant(10, 10, {1, 1, 1}), constant(10, 10, {1, 1, 1}), true);
    for (size_t i = 0; i < 60; ++i) {   // most of them: their zeros are no median
        std::fill_n(&pair.reference.values[3 * i], 3, 0.0f);
        std::fill_n(&pair.test.values[3 * i], 3, 0.0f);
        pair.counts[i] = 0;
    }
    const auto measured = measure_hdr_flip(pair);
    EXPECT_NEAR(number(measured, "stop_exposure"), std::log2(nearly_white()), 1e-6);
    EXPECT_EQ(number(measured, "max"), 0);
}

TEST(HdrFlip, DoesNotDependOnThreads) {
    auto pair = paired(drawn(50, 200, noise(3, 0, 9)), drawn(50, 200, noise(4, 0, 9)), true);
    pair.threads = 1;
    const auto one = measure_hdr_flip(pair);
    pair.threads = 5;
    EXPECT_EQ(one.map, measure_hdr_flip(pair).map);
}

/// Answers of the authors' own program.
TEST(HdrFlip, AgreesWithItsAuthors) {
    const auto published = published_answers("hdr");
    if (published.empty()) GTEST_SKIP() << "no pictures to compare with";
    for (const auto& answer : published) expect_published(measure_hdr_flip(paired(answer.reference, answer.test, true)), answer);
}

}  // namespace
}  // namespace alidade
