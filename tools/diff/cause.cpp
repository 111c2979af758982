// SPDX-License-Identifier: Apache-2.0
#include "tools/diff/cause.h"

#include "tools/diff/transfer.h"
#include "tools/metrics/regions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace alidade {
namespace {

constexpr double kExplains = 0.9;    // a cause takes away this share of the squared error
constexpr double kMostOf = 0.8;      // a place holds this share of the differing pixels

/// What the causes look at, found once.
struct Difference {
    const PicturePair& pair;
    std::vector<float> sizes;   ///< pixel_differences
    double largest = 0;
    double over = 0;            ///< pixels count as different where their size is greater: a tenth of the largest, or less if few are as different
    size_t pixels = 0;          ///< how many that are

    explicit Difference(const PicturePair& given) : pair(given), sizes(pixel_differences(given)) {
        for (const float size : sizes) largest = std::max(largest, double(size));
        constexpr double kNearlyAll[] = {0.99};
        over = std::min(0.1 * largest, 0.5 * percentiles(sizes, kNearlyAll)[0]);
        for (const float size : sizes) pixels += double(size) > over;
    }
    bool differs(int x, int y) const { return double(sizes[size_t(y) * size_t(pair.width()) + size_t(x)]) > over; }
};

using Found = std::optional<Cause>;

/// Colours as they were before they were multiplied by alpha are equal, alpha is not.
Found alpha(const Difference& all) {
    const PicturePair& pair = all.pair;
    if (!pair.has_alpha()) return std::nullopt;
    const size_t channels = size_t(pair.reference.channels);
    double most = 0, color = 0;
    for (size_t p = 0; p < pair.pixels(); ++p) {
        const float *a = &pair.reference.values[p * channels], *b = &pair.test.values[p * channels];
        const double of_a = a[channels - 1], of_b = b[channels - 1];
        most = std::max(most, std::abs(of_a - of_b));
        if (of_a > 0 && of_b > 0)
            for (size_t c = 0; c + 1 < channels; ++c) color = std::max(color, std::abs(a[c] / of_a - b[c] / of_b) * std::min(of_a, of_b));
    }
    if (most == 0 || color > over_steps(1)) return std::nullopt;
    return Cause{"alpha", fmt::format("alpha differs, by up to {:.4g}; the colours are the same", most)};
}

double squared_error(const PicturePair& pair) {
    double sum = 0;
    for_each_value(pair, [&](double reference, double test, size_t) { sum += (test - reference) * (test - reference); });
    return sum;
}

/// The share of the squared error that is gone if pixel (x, y), channel c of the reference is taken from elsewhere: from(x, y, c) is an index of its values.
template <class From>
double explained_by(const PicturePair& pair, double before, From&& from) {
    double after = 0;
    for (int y = 0; y < pair.height(); ++y)
        for (int x = 0; x < pair.width(); ++x)
            for (int c = 0; c < pair.reference.channels; ++c) {
                const double error = double(pair.test.at(x, y)[c]) - pair.reference.values[from(x, y, c)];
                if (pair.counts[size_t(y) * size_t(pair.width()) + size_t(x)]) after += error * error;
            }
    return 1 - after / before;
}

size_t index(const PicturePair& pair, int x, int y, int c) { return (size_t(y) * size_t(pair.width()) + size_t(x)) * size_t(pair.reference.channels) + size_t(c); }

Found channels(const Difference& all) {
    if (all.pair.colors() != 3) return std::nullopt;
    constexpr std::array<std::array<int, 3>, 5> kOrders = {{{0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
    const double before = squared_error(all.pair);
    for (const auto& order : kOrders)
        if (explained_by(all.pair, before, [&](int x, int y, int c) { return index(all.pair, x, y, c < 3 ? order[size_t(c)] : c); }) >= kExplains)
            return Cause{"channels", fmt::format("channels are swapped: R, G, B of the test are {}, {}, {} of the reference", "RGB"[order[0]], "RGB"[order[1]], "RGB"[order[2]])};
    return std::nullopt;
}

Found mirrored(const Difference& all) {
    const int right = all.pair.width() - 1, bottom = all.pair.height() - 1;
    const double before = squared_error(all.pair);
    const auto turned = [&](bool x_too, bool y_too) {
        return explained_by(all.pair, before, [&](int x, int y, int c) { return index(all.pair, x_too ? right - x : x, y_too ? bottom - y : y, c); }) >= kExplains;
    };
    if (turned(true, false)) return Cause{"mirrored", "left and right are exchanged"};
    if (turned(false, true)) return Cause{"mirrored", "top and bottom are exchanged"};
    if (turned(true, true)) return Cause{"mirrored", "the picture is turned by 180 degrees"};
    return std::nullopt;
}

Found shift(const Difference& all) {
    const std::optional<Shift> found = find_shift(all.pair);
    if (!found || std::hypot(found->x, found->y) < 0.05) return std::nullopt;
    return Cause{"shift", fmt::format("the test is shifted by {:.2f}, {:.2f} pixels (right, down)", found->x, found->y)};
}

Found pixels(const Difference& all) {
    if (all.pixels == 0 || all.pixels > 4 || all.pixels * 4 > all.pair.pixels()) return std::nullopt;
    const size_t first = size_t(std::find_if(all.sizes.begin(), all.sizes.end(), [&](float size) { return double(size) > all.over; }) - all.sizes.begin());
    return Cause{"pixels", fmt::format("{} pixel{} differ{}, the first at {},{}", all.pixels, all.pixels == 1 ? "" : "s", all.pixels == 1 ? "s" : "",
                                       first % size_t(all.pair.width()), first / size_t(all.pair.width()))};
}

/// The first of two neighbouring lines that hold most of the differing pixels, or -1.
int line_of_most(const std::vector<size_t>& in_line, size_t pixels) {
    for (size_t i = 0; i < in_line.size(); ++i)
        if (double(in_line[i] + (i + 1 < in_line.size() ? in_line[i + 1] : 0)) >= kMostOf * double(pixels)) return int(in_line[i] > 0 ? i : i + 1);
    return -1;
}

Found seam(const Difference& all) {
    const int width = all.pair.width(), height = all.pair.height();
    if (all.pixels < 5 || width < 8 || height < 8) return std::nullopt;
    std::vector<size_t> rows(static_cast<size_t>(height)), columns(static_cast<size_t>(width));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if (all.differs(x, y)) ++rows[size_t(y)], ++columns[size_t(x)];
    if (const int y = line_of_most(rows, all.pixels); y >= 0) return Cause{"seam", fmt::format("{} pixels differ, nearly all in the rows {} and {}", all.pixels, y, y + 1)};
    if (const int x = line_of_most(columns, all.pixels); x >= 0) return Cause{"seam", fmt::format("{} pixels differ, nearly all in the columns {} and {}", all.pixels, x, x + 1)};
    return std::nullopt;
}

Found region(const Difference& all) {
    const PixelRegion largest = largest_region(all.pair, all.over);
    const double box = double(largest.x1 - largest.x0) * double(largest.y1 - largest.y0);
    if (double(largest.pixels) < kMostOf * double(all.pixels) || box > 0.5 * double(all.pair.pixels())) return std::nullopt;
    return Cause{"region", fmt::format("{} connected pixels differ, within {},{} .. {},{}", largest.pixels, largest.x0, largest.y0, largest.x1 - 1, largest.y1 - 1)};
}

/// Does the reference change by more than 16/255 in the 3x3 pixels around?
bool on_edge(const PicturePair& pair, int x, int y) {
    for (int c = 0; c < pair.reference.channels; ++c) {
        float least = pair.reference.at(x, y)[c], most = least;
        for (int v = std::max(y - 1, 0); v <= std::min(y + 1, pair.height() - 1); ++v)
            for (int u = std::max(x - 1, 0); u <= std::min(x + 1, pair.width() - 1); ++u)
                least = std::min(least, pair.reference.at(u, v)[c]), most = std::max(most, pair.reference.at(u, v)[c]);
        if (double(most) - least > over_steps(16)) return true;
    }
    return false;
}

Found edges(const Difference& all) {
    size_t edge_pixels = 0, differing = 0;
    for (int y = 0; y < all.pair.height(); ++y)
        for (int x = 0; x < all.pair.width(); ++x)
            if (on_edge(all.pair, x, y)) ++edge_pixels, differing += all.differs(x, y);
    const double share = double(edge_pixels) / double(all.pair.pixels());
    if (double(differing) < kMostOf * double(all.pixels) || share > 0.5) return std::nullopt;
    return Cause{"edges", fmt::format("{} of {} differing pixels lie on edges of the reference", differing, all.pixels)};
}

/// The correlation of the signed difference with that of the pixel to the right or below, whichever is larger.
double neighbour_correlation(const PicturePair& pair) {
    double own = 0, right = 0, below = 0;
    const auto at = [&](int x, int y, int c) { return double(pair.test.at(x, y)[c]) - pair.reference.at(x, y)[c]; };
    for (int c = 0; c < pair.colors(); ++c)
        for (int y = 0; y + 1 < pair.height(); ++y)
            for (int x = 0; x + 1 < pair.width(); ++x) {
                const double here = at(x, y, c);
                own += here * here, right += here * at(x + 1, y, c), below += here * at(x, y + 1, c);
            }
    return own > 0 ? std::max(std::abs(right), std::abs(below)) / own : 1;
}

Found noise(const Difference& all) {
    const double correlation = neighbour_correlation(all.pair);
    if (all.pixels * 50 < all.pair.pixels() || correlation > 0.25) return std::nullopt;
    return Cause{"noise", fmt::format("the difference is scattered: a pixel's has a correlation of {:.2f} with its neighbour's", correlation)};
}

/// One curve from the reference's values to the test's.
Found transfer(const PicturePair& pair) {
    const Transfer best = find_transfer(pair);
    if (best.explained < kExplains) return std::nullopt;
    return Cause{best.name, best.sentence};
}

Cause first_of(const Difference& all, std::initializer_list<Found (*)(const Difference&)> looks) {
    for (const auto look : looks)
        if (auto found = look(all)) return *found;
    return {};
}

/// Linear values as a screen shows them: a bright pixel hides nothing then.
PicturePair shown(const PicturePair& pair) {
    PicturePair out = pair;
    out.hdr = false;
    for (Picture* picture : {&out.reference, &out.test})
        for (float& value : picture->values) value = float(linear_to_srgb(std::clamp(double(value), 0.0, 1.0)));
    return out;
}

}  // namespace

Cause find_cause(const PicturePair& pair) {
    const Difference all(pair);
    if (all.largest == 0) return {};
    if (Cause found = first_of(all, {alpha, pixels, seam, channels, mirrored}); !found.name.empty()) return found;
    if (const Found found = transfer(pair)) return *found;
    const PicturePair displayed = pair.hdr ? shown(pair) : PicturePair();
    const Difference seen(pair.hdr ? displayed : pair);
    if (Cause found = first_of(seen, {shift, region, edges, noise}); !found.name.empty()) return found;
    return {"content", fmt::format("{} pixels differ, with no simple cause", all.pixels)};
}

}  // namespace alidade
