// SPDX-License-Identifier: Apache-2.0
#include "tools/metrics/noise.h"

#include "tools/metrics/student.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alidade {
namespace {

constexpr int kTile = 16;
constexpr size_t kLeastPixels = 8;
constexpr double kFalseAlarms = 0.01;

/// z of one channel of the tile at (x0, y0); negative if it has too few pixels.
double tile_z(const PicturePair& pair, int x0, int y0, int channel) {
    double sum = 0, squares = 0;
    size_t n = 0;
    const auto each = [&](auto&& see) {
        for (int y = y0; y < std::min(y0 + kTile, pair.height()); ++y)
            for (int x = x0; x < std::min(x0 + kTile, pair.width()); ++x)
                if (pair.counts[size_t(y) * size_t(pair.width()) + size_t(x)]) see(double(pair.test.at(x, y)[channel]) - pair.reference.at(x, y)[channel]);
    };
    each([&](double difference) { sum += difference, ++n; });
    if (n < kLeastPixels) return -1;
    const double mean = sum / double(n);
    each([&](double difference) { squares += (difference - mean) * (difference - mean); });
    if (mean == 0) return 0;
    const double error = std::sqrt(squares / double(n - 1) / double(n));
    return error > 1e-7 * std::abs(mean) ? normal_deviate(mean / error, double(n - 1)) : std::numeric_limits<double>::infinity();
}

}  // namespace

Noise measure_noise(const PicturePair& pair) {
    Noise out;
    size_t tests = 0;
    for (int y = 0; y < pair.height(); y += kTile)
        for (int x = 0; x < pair.width(); x += kTile)
            for (int c = 0; c < pair.reference.channels; ++c) {
                const double z = tile_z(pair, x, y, c);
                if (z < 0) continue;
                ++tests;
                out.largest_z = std::max(out.largest_z, z);
            }
    out.limit = sidak_limit(kFalseAlarms, tests);
    return out;
}

}  // namespace alidade
