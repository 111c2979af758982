// SPDX-License-Identifier: Apache-2.0
#include "tools/metrics/seed_noise.h"

#include "tools/metrics/student.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alidade {
namespace {

/// The means' difference, as a normal deviate.
double deviate(const SeedStatistics& ours, const SeedStatistics& reference, ReferenceNoise noise, size_t i) {
    const double difference = std::abs(ours.mean(i) - reference.mean(i)), n = ours.count(), m = reference.count();
    const double own = ours.variance(i) / n;
    const double other = noise == ReferenceNoise::like_ours ? ours.variance(i) : noise == ReferenceNoise::measured ? reference.variance(i) / m : 0;
    const double error = std::sqrt(own + other);
    if (!(error > 0)) return std::numeric_limits<double>::infinity();
    const double degrees = noise == ReferenceNoise::measured ? (own + other) * (own + other) / (own * own / (n - 1) + other * other / (m - 1)) : n - 1;
    return normal_deviate(difference / error, degrees);
}

class Test {
  public:
    Test(const SeedStatistics& ours, const SeedStatistics& reference, ReferenceNoise noise, double floor, double share)
        : ours_(ours), reference_(reference), noise_(noise), floor_(floor), share_(share) {}

    double z(size_t i) const {
        const double here = reference_.mean(i), floor = floor_ + share_ * std::max(std::abs(here), std::abs(ours_.mean(i)));
        if (std::abs(ours_.mean(i) - here) <= floor) return 0;
        if (noise_ == ReferenceNoise::like_ours && is_seen_around(i, here, floor)) return 0;
        return deviate(ours_, reference_, noise_, i);
    }

  private:
    /// Does one of our pictures show as much in one of the nine pixels, and is there noise?
    bool is_seen_around(size_t i, double value, double floor) const {
        const size_t channels = size_t(ours_.channels()), pixel = i / channels;
        const int width = ours_.width(), height = int(ours_.values() / channels) / width, px = int(pixel) % width, py = int(pixel) / width;
        double low = std::numeric_limits<double>::infinity(), high = -low;
        bool noisy = false;
        for (int y = std::max(py - 1, 0); y <= std::min(py + 1, height - 1); ++y)
            for (int x = std::max(px - 1, 0); x <= std::min(px + 1, width - 1); ++x) {
                const size_t at = (size_t(y) * size_t(width) + size_t(x)) * channels + i % channels;
                low = std::min(low, double(ours_.low(at))), high = std::max(high, double(ours_.high(at)));
                noisy = noisy || ours_.variance(at) > 0;
            }
        return noisy && value >= low - floor && value <= high + floor;
    }

    const SeedStatistics &ours_, &reference_;
    ReferenceNoise noise_;
    double floor_, share_;
};

}  // namespace

void SeedStatistics::add(const Picture& picture) {
    if (count_ == 0) {
        width_ = picture.width, channels_ = picture.channels;
        mean_.assign(picture.values.size(), 0), squares_ = mean_;
        low_ = high_ = picture.values;
    }
    ++count_;
    for (size_t i = 0; i < mean_.size(); ++i) {
        const double difference = picture.values[i] - mean_[i];
        mean_[i] += difference / count_;
        squares_[i] += difference * (picture.values[i] - mean_[i]);
        low_[i] = std::min(low_[i], picture.values[i]), high_[i] = std::max(high_[i], picture.values[i]);
    }
}

SeedNoise test_seeds(const SeedStatistics& ours, const SeedStatistics& reference, ReferenceNoise noise, const std::vector<uint8_t>& counts, double floor, double share) {
    SeedNoise out;
    const size_t channels = size_t(ours.channels());
    out.tests = channels * size_t(std::count_if(counts.begin(), counts.end(), [](uint8_t c) { return c != 0; }));
    out.limit = sidak_limit(kSeedAlpha, out.tests);
    out.marked.assign(counts.size(), 0);
    const Test test(ours, reference, noise, floor, share);
    for (size_t i = 0; i < ours.values(); ++i) {
        if (!counts[i / channels]) continue;
        const double z = test.z(i);
        out.largest_z = std::max(out.largest_z, z);
        if (z > out.limit) out.marked[i / channels] = 1;
    }
    out.significant = size_t(std::count(out.marked.begin(), out.marked.end(), 1));
    return out;
}

}  // namespace alidade
