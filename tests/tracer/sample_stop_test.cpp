// SPDX-License-Identifier: Apache-2.0
/// When pixels seen through a lens have samples enough, against POV-Ray's counts of rays.
#include "tracer/sample_stop.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

/// R. A. Fisher, "Statistical Methods for Research Workers", table III.
TEST(SampleStop, QuantilesOfChiSquared) {
    struct Row {
        int degrees;
        double probability, value;
    };
    for (const Row& row : {Row{4, 0.1, 1.0636}, {7, 0.1, 2.8331}, {13, 0.1, 7.0415}, {19, 0.1, 11.6509}, {36, 0.1, 25.6433}, {7, 0.9, 12.0170}, {30, 0.5, 29.3360}, {99, 0.1, 81.4493}})
        EXPECT_NEAR(chi_squared_quantile(row.degrees, row.probability) / row.value, 1, 0.01) << row.degrees << " degrees at " << row.probability;
}

/// Samples that a pixel takes, of `all`.
template <class Sample> int taken(const LensNoise& lens, int all, const Sample& sample) {
    RenderOptions options;
    options.lens_noise = lens;
    const SampleStop stop(options, all);
    NoiseEstimate noise;
    for (int n = 1; n < all; ++n) {
        noise.add(sample(n - 1));
        if (stop.enough(noise, n)) return n;
    }
    return all;
}

int taken_where_nothing_varies(int fewest, int all) {
    return taken(LensNoise{1e-4, 0.9, fewest}, all, [](int) { return Color(0.5); });
}

/// The counts are those of POV-Ray 3.7 for an empty picture with `blur_samples fewest, all`.
TEST(SampleStop, LooksWherePovRayDoes) {
    for (const auto& [fewest, all, want] : {std::array{0, 100, 7}, {8, 100, 13}, {14, 100, 19}, {20, 100, 23}, {24, 100, 27}, {32, 100, 35}, {36, 100, 37}, {38, 100, 41}, {70, 100, 73},
                                            {20, 36, 23}, {35, 36, 35}, {36, 36, 36}, {8, 18, 11}, {12, 18, 15}, {16, 18, 18}, {0, 6, 4}, {5, 6, 6}, {0, 2, 2}})
        EXPECT_EQ(taken_where_nothing_varies(fewest, all), want) << fewest << " to " << all << " samples";
}

/// POV-Ray's mean count of a pixel that is black or white by chance (a checker far smaller than the blur) tells how many of the first 7 may be white for
/// it to end there: 7 + 6 P(it goes on).
TEST(SampleStop, EndsWherePovRayDoes) {
    struct Row {
        int all;
        double variance;
        int whites;   ///< of 7: the fewest with which POV-Ray goes on
    };
    for (const Row& row : {Row{50, 0.3, 2}, {100, 0.3, 1}, {37, 0.3, 3}, {19, 0.1, 2}, {20, 0.1, 2}, {37, 0.1, 1}, {19, 0.03, 1}})
        for (int white = 0; white <= 3; ++white) {
            const int n = taken(LensNoise{row.variance, 0.9, 0}, row.all, [&](int i) { return Color(i < white ? 1 : 0); });
            EXPECT_EQ(n == 7, white < row.whites) << white << " of 7 are white, " << row.all << " samples, variance " << row.variance;
        }
}

TEST(SampleStop, WhatIsNotANumberIsNeverEnough) {
    EXPECT_EQ(taken(LensNoise(), 20, [](int i) { return Color(i == 3 ? std::nan("") : 0); }), 20);
    EXPECT_EQ(taken(LensNoise{0, 0.9, 0}, 20, [](int) { return Color(0.5); }), 20) << "nothing is below 0";
}

}  // namespace
}  // namespace alidade
