// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"
#include "tools/metrics/flip_filters.h"

#include <algorithm>
#include <cmath>

namespace alidade {
namespace {

/// The fit of the ACES film curve that the paper takes, with its factor 0.6: (a x^2 + b x) / (c x^2 + d x + e).
constexpr double kA = 0.6 * 0.6 * 2.51, kB = 0.6 * 0.03, kC = 0.6 * 0.6 * 2.43, kD = 0.6 * 0.59, kE = 0.14;
/// What the brightest (or the median) pixel is to become at the shortest (or longest) exposure.
constexpr double kTarget = 0.85;

float film(float x) {
    x = std::min(x, 1e4f);   // long past white; a square of more may overflow
    return std::min((float(kA) * x * x + float(kB) * x) / (float(kC) * x * x + float(kD) * x + float(kE)), 1.0f);
}

/// What the film curve takes to kTarget: the positive root of a quadratic.
double film_inverse() {
    const double a = kA - kTarget * kC, b = kB - kTarget * kD, c = -kTarget * kE;
    return (-b + std::sqrt(b * b - 4 * a * c)) / (2 * a);
}

struct Exposures {
    double start = 0, stop = 0;
    int count = 2;
    double at(int i) const { return start + (stop - start) * i / (count - 1); }
};

/// Positive luminances of the pixels that count, ascending; and how many are not positive.
struct Luminances {
    std::vector<float> positive;
    size_t dark = 0;

    Luminances(const PicturePair& pair, const std::vector<float>& colors) {
        for (size_t i = 0; i < pair.pixels(); ++i) {
            if (!pair.counts[i]) continue;
            const float y = 0.2126f * colors[3 * i] + 0.7152f * colors[3 * i + 1] + 0.0722f * colors[3 * i + 2];
            if (y > 0) {
                positive.push_back(y);
            } else {
                ++dark;
            }
        }
        std::sort(positive.begin(), positive.end());
    }
    /// Of all that count; where that is 0, of the positive ones, since no exposure shows black.
    double median() const {
        const size_t middle = (positive.size() + dark) / 2;
        return double(middle >= dark ? positive[middle - dark] : positive[positive.size() / 2]);
    }
};

/// From where the reference's brightest pixel is nearly white to where its median is. A black reference shows nothing at any exposure: then the test
/// picture decides, so that a difference is seen.
Exposures exposures(const PicturePair& pair, const std::vector<float>& reference, const std::vector<float>& test) {
    Luminances found(pair, reference);
    if (found.positive.empty()) found = Luminances(pair, test);
    if (found.positive.empty()) return {};
    const double white = film_inverse();
    Exposures range;
    range.start = std::log2(white / double(found.positive.back()));
    range.stop = std::log2(white / found.median());
    range.count = std::max(2, int(std::ceil(range.stop - range.start)));
    return range;
}

/// Light has no negative amounts: they show as black.
std::vector<float> nonnegative(std::vector<float> colors) {
    for (float& value : colors) value = std::max(value, 0.0f);
    return colors;
}

void expose(const std::vector<float>& colors, double exposure, int threads, std::vector<float>& shown) {
    constexpr size_t block = 1 << 16;
    const auto factor = float(std::exp2(exposure));
    parallel_for((colors.size() + block - 1) / block, threads, [&](size_t b) {
        for (size_t i = b * block, end = std::min(colors.size(), i + block); i < end; ++i) shown[i] = film(colors[i] * factor);
    });
}

}  // namespace

/// HDR-FLIP: the largest LDR-FLIP error over exposures at most one stop apart, each tone-mapped. ACES, 67.02 pixels per degree, automatic range.
/// Source   Andersson, Nilsson, Shirley, Akenine-Moeller, "Visualizing Errors in Rendered High Dynamic Range Images", Eurographics Short Papers 2021.
/// Error    as measure_flip.
Measured measure_hdr_flip(const PicturePair& pair) {
    const auto reference = nonnegative(linear_colors(pair, pair.reference)), test = nonnegative(linear_colors(pair, pair.test));
    const Exposures range = exposures(pair, reference, test);
    std::vector<float> shown_reference(reference.size()), shown_test(test.size()), worst(pair.pixels());
    for (int i = 0; i < range.count; ++i) {
        expose(reference, range.at(i), pair.threads, shown_reference);
        expose(test, range.at(i), pair.threads, shown_test);
        const auto map = flip_map(pair.width(), pair.height(), shown_reference, shown_test, pair.threads);
        for (size_t p = 0; p < worst.size(); ++p) worst[p] = std::max(worst[p], map[p]);
    }
    Measured measured = pooled_flip(pair, std::move(worst));
    measured.numbers.push_back({"start_exposure", range.start});
    measured.numbers.push_back({"stop_exposure", range.stop});
    measured.numbers.push_back({"exposures", double(range.count)});
    return measured;
}

}  // namespace alidade
