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

/// What is left over at the end belongs to the last whole tile.
int end_of_tile(int begin, int size) { return begin + 2 * kTile > size ? size : begin + kTile; }

/// z of one channel of the tile at (x0, y0); negative if it has too few pixels.
double tile_z(const PicturePair& pair, int x0, int y0, int channel) {
    double sum = 0, squares = 0;
    size_t n = 0;
    const auto each = [&](auto&& see) {
        for (int y = y0; y < end_of_tile(y0, pair.height()); ++y)
            for (int x = x0; x < end_of_tile(x0, pair.width()); ++x)
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

bool differs(const PicturePair& pair) {
    const size_t channels = size_t(pair.reference.channels);
    for (size_t i = 0; i < pair.reference.values.size(); ++i)
        if (pair.counts[i / channels] && pair.reference.values[i] != pair.test.values[i]) return true;
    return false;
}

}  // namespace

Noise measure_noise(const PicturePair& pair) {
    Noise out;
    size_t tests = 0;
    for (int y = 0; y < pair.height(); y = end_of_tile(y, pair.height()))
        for (int x = 0; x < pair.width(); x = end_of_tile(x, pair.width()))
            for (int c = 0; c < pair.reference.channels; ++c) {
                const double z = tile_z(pair, x, y, c);
                if (z < 0) continue;
                ++tests;
                out.largest_z = std::max(out.largest_z, z);
            }
    if (tests == 0 && differs(pair)) out.largest_z = std::numeric_limits<double>::infinity();   // too few pixels to know
    out.limit = sidak_limit(kFalseAlarms, tests);
    return out;
}

}  // namespace alidade
