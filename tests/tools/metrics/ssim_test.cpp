// SPDX-License-Identifier: Apache-2.0
#include "tests/tools/metrics/pairs.h"
#include "tools/metrics/metric.h"

#include <cmath>
#include <gtest/gtest.h>

namespace alidade {
namespace {

using namespace test;

/// One window as the paper writes it: weighted means, then weighted squares of what differs from them. Weights outside the picture are left out.
double window(const PicturePair& pair, size_t channel, int x, int y) {
    double total = 0, mean[2] = {0, 0}, variance[2] = {0, 0}, covariance = 0;
    const auto each = [&](auto use) {
        for (int j = std::max(0, y - 5); j <= std::min(pair.height() - 1, y + 5); ++j) {
            for (int i = std::max(0, x - 5); i <= std::min(pair.width() - 1, x + 5); ++i) {
                const double weight = std::exp(-((i - x) * (i - x) + (j - y) * (j - y)) / (2 * 1.5 * 1.5));
                use(weight, double(pair.reference.at(i, j)[channel]), double(pair.test.at(i, j)[channel]));
            }
        }
    };
    each([&](double w, double, double) { total += w; });
    each([&](double w, double a, double b) { mean[0] += w / total * a; mean[1] += w / total * b; });
    each([&](double w, double a, double b) {
        variance[0] += w / total * (a - mean[0]) * (a - mean[0]);
        variance[1] += w / total * (b - mean[1]) * (b - mean[1]);
        covariance += w / total * (a - mean[0]) * (b - mean[1]);
    });
    return (2 * mean[0] * mean[1] + 1e-4) * (2 * covariance + 9e-4) / ((mean[0] * mean[0] + mean[1] * mean[1] + 1e-4) * (variance[0] + variance[1] + 9e-4));
}

double reference_ssim(const PicturePair& pair, int margin) {
    double sum = 0;
    int count = 0;
    for (int y = margin; y < pair.height() - margin; ++y) {
        for (int x = margin; x < pair.width() - margin; ++x) {
            for (size_t c = 0; c < 3; ++c, ++count) sum += window(pair, c, x, y);
        }
    }
    return sum / count;
}

TEST(Ssim, IsWhatThePaperWrites) {
    const int sizes[][2] = {{11, 11}, {12, 31}, {40, 13}, {20, 70}};
    for (const auto& [width, height] : sizes) {
        for (const float spread : {0.01f, 1.0f}) {
            const auto pair = paired(drawn(width, height, noise(1, 1 - spread, 1)), drawn(width, height, noise(2, 1 - spread, 1)));
            EXPECT_NEAR(number(measure_ssim(pair), "value"), reference_ssim(pair, 5), 1e-10) << width << "x" << height << " spread " << spread;
        }
    }
}

TEST(Ssim, OfSmallPicturesCutsItsWindows) {
    const int sizes[][2] = {{1, 1}, {3, 2}, {10, 40}};
    for (const auto& [width, height] : sizes) {
        const auto pair = paired(drawn(width, height, noise(1)), drawn(width, height, noise(2)));
        EXPECT_NEAR(number(measure_ssim(pair), "value"), reference_ssim(pair, 0), 1e-10) << width << "x" << height;
    }
}

TEST(Ssim, OfAPictureAndItselfIsOneExactly) {
    for (const int size : {1, 7, 11, 64}) {
        const auto picture = drawn(size, size, noise(5));
        EXPECT_EQ(number(measure_ssim(paired(picture, picture)), "value"), 1.0) << size;
        EXPECT_EQ(number(measure_ssim(paired(picture, picture)), "min"), 1.0) << size;
    }
}

TEST(Ssim, OfConstantPicturesIsAFormula) {
    const auto measured = measure_ssim(paired(constant(16, 16, {0.2f, 0.2f, 0.2f}), constant(16, 16, {0.6f, 0.6f, 0.6f})));
    EXPECT_NEAR(number(measured, "value"), (2 * 0.2 * 0.6 + 1e-4) / (0.2 * 0.2 + 0.6 * 0.6 + 1e-4), 1e-7) << "luminance alone: there is no contrast";
}

TEST(Ssim, IsSymmetricAndDoesNotDependOnThreads) {
    auto pair = paired(drawn(50, 200, noise(3)), drawn(50, 200, noise(4)));
    pair.threads = 1;
    const double one = number(measure_ssim(pair), "value");
    EXPECT_EQ(one, number(measure_ssim(swapped(pair)), "value"));
    pair.threads = 5;
    EXPECT_EQ(one, number(measure_ssim(pair), "value"));
}

TEST(Ssim, TakesWindowsAroundPixelsThatCount) {
    auto pair = paired(constant(30, 30, {1, 1, 1}), constant(30, 30, {1, 1, 1}));
    std::fill_n(pair.test.at(0, 0), 15 * 30 * 3, 0.0f);
    std::fill_n(pair.counts.begin(), 20 * 30, 0);
    EXPECT_EQ(number(measure_ssim(pair), "value"), 1.0) << "rows 20 and below see rows 15 and below";
}

/// Of float pictures: display values, so 0.2 is not 0.2.
TEST(Ssim, OfFloatPicturesIsThatOfTheirDisplayValues) {
    const auto linear = paired(drawn(20, 20, noise(1, -0.5f, 1.5f)), drawn(20, 20, noise(2, -0.5f, 1.5f)), true);
    auto shown = linear;
    shown.hdr = false;
    for (Picture* picture : {&shown.reference, &shown.test}) {
        for (float& value : picture->values) value = float(linear_to_srgb(double(std::clamp(value, 0.0f, 1.0f))));
    }
    EXPECT_NEAR(number(measure_ssim(linear), "value"), number(measure_ssim(shown), "value"), 1e-6);
}

}  // namespace
}  // namespace alidade
