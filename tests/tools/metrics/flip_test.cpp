// SPDX-License-Identifier: Apache-2.0
#include "core/image.h"
#include "tests/tools/metrics/flip_oracle.h"
#include "tests/tools/metrics/pairs.h"
#include "tests/tools/metrics/published.h"
#include "tools/metrics/metric.h"

#include <gtest/gtest.h>
#include <numeric>

namespace alidade {
namespace {

using namespace test;

/// The error of every pixel of two pictures of one colour each.
double flat_error(std::array<float, 3> a, std::array<float, 3> b) {
    const auto measured = measure_flip(paired(constant(16, 9, a), constant(16, 9, b)));
    EXPECT_FLOAT_EQ(float(number(measured, "min")), float(number(measured, "max")));
    EXPECT_NEAR(number(measured, "mean"), number(measured, "weighted_median"), 1e-6);
    return number(measured, "mean");
}

TEST(Flip, OfColorsAloneIsAFormula) {
    EXPECT_NEAR(flat_error({0, 1, 0}, {0, 0, 1}), 1, 1e-6) << "the largest there is, by definition";
    EXPECT_NEAR(flat_error({0, 0, 0}, {1, 1, 1}), 0.96738, 1e-5) << "0.95 + 0.05 (100^0.7 - 0.4 m) / (0.6 m), m the error of green and blue";
    for (const float gray : {0.02f, 0.3f, 0.735f}) {
        const double linear = srgb_to_linear(double(gray));
        EXPECT_NEAR(flat_error({gray, gray, gray}, {1, 1, 1}), color_error({linear, linear, linear}, {1, 1, 1}), 1e-5) << gray;
        EXPECT_NEAR(flat_error({gray, 0, 0}, {0, 0, gray}), color_error({linear, 0, 0}, {0, 0, linear}), 1e-5) << gray;
    }
}

TEST(Flip, OfAPictureAndItselfIsNothing) {
    const auto picture = drawn(33, 21, noise(1));
    const auto measured = measure_flip(paired(picture, picture));
    for (const char* name : {"mean", "weighted_median", "first_weighted_quartile", "third_weighted_quartile", "min", "max"}) {
        EXPECT_EQ(number(measured, name), 0) << name;
    }
}

TEST(Flip, IsSymmetricToTheBit) {
    const auto pair = paired(drawn(70, 90, noise(1)), drawn(70, 90, noise(2)));
    EXPECT_EQ(measure_flip(pair).map, measure_flip(swapped(pair)).map);
}

TEST(Flip, DoesNotDependOnThreads) {
    auto pair = paired(drawn(50, 300, noise(3)), drawn(50, 300, noise(4)));
    pair.threads = 1;
    const auto one = measure_flip(pair);
    pair.threads = 5;
    EXPECT_EQ(one.map, measure_flip(pair).map);
}

/// Sizes around those of strips (64 rows), of blocks of pixels (16) and of filters (21), down to one pixel.
TEST(Flip, IsWhatThePaperWritesAtEveryPixel) {
    const int sizes[][2] = {{1, 1}, {3, 2}, {1, 30}, {17, 1}, {16, 16}, {33, 5}, {9, 70}};
    for (const auto& [width, height] : sizes) {
        for (const float spread : {0.02f, 1.0f}) {
            const auto base = noise(7, 0, 1 - spread), change = noise(8, 0, spread);
            const auto pair = paired(drawn(width, height, base), drawn(width, height, [&](int x, int y) {
                auto rgb = base(x, y);
                for (size_t c = 0; c < 3; ++c) rgb[c] += change(x, y)[c];
                return rgb;
            }));
            const auto map = measure_flip(pair).map;
            const FlipOracle oracle(width, height, linear_colors(pair, pair.reference), linear_colors(pair, pair.test));
            for (int y = 0; y < height; ++y) {
                for (int x = 0; x < width; ++x) {
                    ASSERT_NEAR(double(map[size_t(y * width + x)]), oracle.at(x, y), 2e-5) << width << "x" << height << " at " << x << "," << y << " spread " << spread;
                }
            }
        }
    }
}

TEST(Flip, LeavesOutPixelsThatDoNotCount) {
    auto pair = paired(constant(40, 40, {0.5f, 0.5f, 0.5f}), constant(40, 40, {0.5f, 0.5f, 0.5f}));
    for (int x = 0; x < 12; ++x) {
        pair.test.at(x, 0)[0] = 1;
        pair.counts[size_t(x)] = 0;
    }
    const auto measured = measure_flip(pair);
    EXPECT_EQ(measured.map[0], 0);
    EXPECT_GT(measured.map[40], 0) << "the eye does not keep pixels apart";
    EXPECT_NEAR(number(measured, "mean"), std::accumulate(measured.map.begin(), measured.map.end(), 0.0) / (40 * 40 - 12), 1e-9);
}

TEST(Flip, ReadsGrayAsThreeEqualChannels) {
    Picture a(20, 20, {"Y"}), b(20, 20, {"Y"});
    for (size_t i = 0; i < a.values.size(); ++i) {
        a.values[i] = noise(1)(int(i), 0)[0];
        b.values[i] = noise(2)(int(i), 0)[0];
    }
    const auto spread = [](const Picture& gray) {
        return drawn(20, 20, [&gray](int x, int y) { return std::array{*gray.at(x, y), *gray.at(x, y), *gray.at(x, y)}; });
    };
    EXPECT_EQ(measure_flip(paired(a, b)).map, measure_flip(paired(spread(a), spread(b))).map);
}

/// Of float pictures it compares what a display shows: clipped to 0 .. 1.
TEST(Flip, ClipsFloatPictures) {
    const auto clipped = paired(constant(8, 8, {1, 0, 0.25f}), constant(8, 8, {0, 0, 0}), true);
    const auto beyond = paired(constant(8, 8, {7, -3, 0.25f}), constant(8, 8, {-1, 0, 0}), true);
    EXPECT_EQ(measure_flip(clipped).map, measure_flip(beyond).map);
}

/// Answers of the authors' own program.
TEST(Flip, AgreesWithItsAuthors) {
    const auto published = published_answers("ldr");
    if (published.empty()) GTEST_SKIP() << "no pictures to compare with";
    for (const auto& answer : published) expect_published(measure_flip(paired(answer.reference, answer.test)), answer);
}

}  // namespace
}  // namespace alidade
