// SPDX-License-Identifier: Apache-2.0
/// Every row of the registry: what holds for all of them, and answers in closed form.
#include <gtest/gtest.h>

#include "tests/tools/metrics/pairs.h"
#include "tools/metrics/noise.h"

#include <cmath>
#include <map>

namespace alidade::test {
namespace {

/// What a metric says of equal pictures.
double at_equal(const std::string& name) { return name == "ssim" ? 1 : name == "psnr" ? INFINITY : 0; }

double first(const Metric& metric, const PicturePair& pair) { return metric.measure(pair).numbers.at(0).value; }

class EveryMetric : public testing::TestWithParam<size_t> {
  protected:
    const Metric& metric() const { return metrics()[GetParam()]; }
    bool hdr() const { return metric().what == Metric::For::hdr; }
};

TEST_P(EveryMetric, IsAtItsBestForEqualPictures) {
    for (const int side : {1, 2, 7, 12, 40}) {
        const Picture picture = drawn(side, side + 1, noise(3, 0, hdr() ? 5 : 1));
        EXPECT_EQ(first(metric(), paired(picture, picture, hdr())), at_equal(metric().name)) << metric().name << " of side " << side;
    }
}

TEST_P(EveryMetric, IsNotAtItsBestForOthers) {
    const PicturePair pair = paired(drawn(40, 30, noise(1)), drawn(40, 30, noise(2, 0.1F, 0.7F)), hdr());
    EXPECT_NE(first(metric(), pair), at_equal(metric().name)) << metric().name;
}

TEST_P(EveryMetric, IsSymmetricWhereItSaysSo) {
    const PicturePair pair = paired(drawn(40, 30, noise(1, 0.1F, 0.9F)), drawn(40, 30, noise(2, 0.3F, 0.6F)), hdr());
    const double there = first(metric(), pair), back = first(metric(), swapped(pair));
    if (metric().symmetric) {
        EXPECT_NEAR(there, back, 1e-6 * std::abs(there)) << metric().name;
    } else {
        EXPECT_NE(there, back) << metric().name;
    }
}

TEST_P(EveryMetric, LeavesOutWhatDoesNotCount) {
    PicturePair pair = paired(drawn(40, 30, noise(1)), drawn(40, 30, noise(1)), hdr());
    for (int x = 0; x < 40; ++x) {   // as the loader leaves pixels that it takes out of the count: 0 in both
        pair.counts[size_t(x)] = 0;
        for (Picture* picture : {&pair.reference, &pair.test}) std::fill_n(picture->at(x, 0), 3, 0.0F);
    }
    EXPECT_EQ(first(metric(), pair), at_equal(metric().name)) << metric().name;
    const double share = first(metric(), paired(constant(40, 30, {0, 0, 0}), constant(40, 30, {1, 1, 1}), hdr()));
    PicturePair half = paired(constant(40, 30, {0, 0, 0}), constant(40, 30, {1, 1, 1}), hdr());
    for (size_t p = 0; p < half.pixels(); p += 2) half.counts[p] = 0;
    if (std::string(metric().name) == "region") return;   // which counts pixels
    EXPECT_NEAR(first(metric(), half), share, 1e-9 + 1e-6 * std::abs(share)) << metric().name;
}

TEST_P(EveryMetric, DoesNotDependOnTheThreads) {
    PicturePair pair = paired(drawn(150, 70, noise(1)), drawn(150, 70, noise(2)), hdr());
    pair.threads = 1;
    const Measured alone = metric().measure(pair);
    pair.threads = 3;
    const Measured together = metric().measure(pair);
    ASSERT_EQ(alone.numbers.size(), together.numbers.size());
    for (size_t i = 0; i < alone.numbers.size(); ++i) EXPECT_EQ(alone.numbers[i].value, together.numbers[i].value) << metric().name << "." << alone.numbers[i].name;
    EXPECT_EQ(alone.map, together.map);
}

TEST_P(EveryMetric, KnowsNoNaN) {
    for (const float level : {0.0F, 1e-30F, 1.0F, 1000.0F})
        for (const Measured::Number& each : metric().measure(paired(constant(9, 5, {level, 0, level}), constant(9, 5, {0, level, 0}), true)).numbers)
            EXPECT_FALSE(std::isnan(each.value)) << metric().name << "." << each.name << " at " << level;
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryMetric, testing::Range<size_t>(0, metrics().size()), [](const auto& info) { return std::string(metrics()[info.param].name); });

/// One number of one metric for one pair.
struct Known {
    const char* metric;
    const char* number;
    double value;
};

void expect_known(const PicturePair& pair, std::initializer_list<Known> all) {
    for (const Known& known : all)
        for (const Metric& metric : metrics())
            if (std::string(metric.name) == known.metric) {
                EXPECT_NEAR(number(metric.measure(pair), known.number), known.value, 1e-6) << known.metric << "." << known.number;
            }
}

/// Half of the pixels are 0.1 lower in red and 0.2 higher in green.
TEST(ClosedForm, StepsInHalfOfThePixels) {
    const auto color = [](int x, int) { return std::array<float, 3>{x < 10 ? 0.4F : 0.5F, x < 10 ? 0.7F : 0.5F, 0.5F}; };
    expect_known(paired(constant(20, 10, {0.5F, 0.5F, 0.5F}), drawn(20, 10, color)),
                 {{"max_abs", "value", 0.2}, {"max_abs", "x", 0}, {"max_abs", "y", 0}, {"max_abs", "channel", 1}, {"max_abs", "reference", 0.5}, {"max_abs", "test", 0.7},
                  {"mae", "value", 0.05}, {"rmse", "value", std::sqrt(0.05 / 6)}, {"psnr", "value", -10 * std::log10(0.05 / 6)},
                  {"rel_mse", "value", 0.05 / 6 / 0.26}, {"over8", "value", 0.5}, {"over8", "pixels", 100}, {"percentiles", "p50", 0}, {"percentiles", "p95", 0.2},
                  {"bias", "value", 0.1}, {"bias", "R", -0.05}, {"bias", "G", 0.1}, {"bias", "B", 0}, {"envelope", "value", 0.5}, {"region", "pixels", 100},
                  {"region", "share", 0.5}, {"region", "x0", 0}, {"region", "x1", 10}, {"region", "y1", 10}});
}

/// Differences of just so many 8-bit steps are not over as many.
TEST(ClosedForm, StepsOfEightBits) {
    for (int from = 0; from < 240; ++from) {
        const auto level = [](int k) { return std::array<float, 3>{float(k / 255.0), 0, 0}; };
        for (const auto& [steps, name] : std::map<int, const char*>{{1, "over1"}, {2, "over2"}, {4, "over4"}, {8, "over8"}}) {
            expect_known(paired(constant(2, 1, level(from)), constant(2, 1, level(from + steps))), {{name, "value", 0}});
            expect_known(paired(constant(2, 1, level(from)), constant(2, 1, level(from + steps + 1))), {{name, "value", 1}});
        }
    }
}

/// An edge that lies a pixel further is within the range around it, except where there was no edge.
TEST(ClosedForm, EnvelopeForgivesEdges) {
    const auto edge_at = [](int at) { return [at](int x, int) { return x < at ? std::array<float, 3>{0, 0, 0} : std::array<float, 3>{1, 1, 1}; }; };
    expect_known(paired(drawn(20, 10, edge_at(10)), drawn(20, 10, edge_at(11))), {{"envelope", "value", 0}, {"over8", "value", 0.05}});
    expect_known(paired(drawn(20, 10, edge_at(10)), drawn(20, 10, edge_at(12))), {{"envelope", "value", 0.05}, {"over8", "value", 0.1}});
}

/// Sets that touch by a corner are one; the largest is told, not the first.
TEST(ClosedForm, LargestRegion) {
    const char* rows[] = {"#.......", "........", "...#..#.", "....##..", "........"};
    const auto color = [&](int x, int y) { return rows[y][x] == '#' ? std::array<float, 3>{1, 1, 1} : std::array<float, 3>{0, 0, 0}; };
    expect_known(paired(constant(8, 5, {0, 0, 0}), drawn(8, 5, color)),
                 {{"region", "pixels", 4}, {"region", "x0", 3}, {"region", "y0", 2}, {"region", "x1", 7}, {"region", "y1", 4}});
}

/// Of pairs that differ by noise alone about one in a hundred is taken for more; a bias of a third of the noise's deviation never passes.
TEST(NoiseTest, AlarmsAsOftenAsItSays) {
    constexpr int kPairs = 300;
    int alarms = 0, missed = 0;
    for (uint32_t seed = 0; seed < kPairs; ++seed) {
        const PicturePair pair = paired(drawn(64, 64, noise(2 * seed + 1)), drawn(64, 64, noise(2 * seed + 2)));
        const Noise honest = measure_noise(pair);
        alarms += honest.largest_z >= honest.limit;
        const auto shifted = [&](int x, int y) {
            auto rgb = noise(2 * seed + 2)(x, y);
            if (x < 16 && y < 16) rgb[1] += 0.16F;
            return rgb;
        };
        const Noise biased = measure_noise(paired(pair.reference, drawn(64, 64, shifted)));
        missed += biased.largest_z < biased.limit;
    }
    EXPECT_LE(alarms, 10);   // 3 are expected; more than 10 come once in 2000
    EXPECT_LE(missed, kPairs / 20);
}

TEST(NoiseTest, AConstantIsNoNoise) {
    const Noise found = measure_noise(paired(constant(32, 32, {0.5F, 0.5F, 0.5F}), constant(32, 32, {0.5F, 0.5625F, 0.5F})));
    EXPECT_GE(found.largest_z, found.limit);
    EXPECT_EQ(measure_noise(paired(constant(32, 32, {0.5F, 0.5F, 0.5F}), constant(32, 32, {0.5F, 0.5F, 0.5F}))).largest_z, 0);
}

}  // namespace
}  // namespace alidade::test
