// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"
#include "tools/metrics/flip_color.h"
#include "tools/metrics/flip_filters.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace alidade {
namespace {

using flip::Three;

// Exponents and constants of the paper: colour (section 4.1.3), features (4.2), and how they join (4.3).
constexpr float kColorExponent = 0.7f;
constexpr float kKneeIn = 0.4f, kKneeOut = 0.95f;
constexpr size_t kStripRows = 64;   // fixed: who computes a row changes nothing in it

/// Planes of a strip, filtered along its rows: what the filters across them start from.
enum Plane : size_t { achromatic, red_green, blue_yellow_0, blue_yellow_1, smooth, edge, point, planes };

/// Rows (or one row, shifted) around a pixel's own.
struct Around {
    const float* center;
    std::array<const float*, kMaxTaps> before, after;

    template <class Row>   // `row(i)`: the one at offset i
    Around(const HalfKernel& kernel, Row row) : center(row(0)) {
        assert(kernel.size() <= kMaxTaps);
        for (size_t i = 1; i < kernel.size(); ++i) {
            before[i] = row(-int(i));
            after[i] = row(int(i));
        }
    }
};

/// out[x] = first(center) + the sum over i of k[i] * pair(before_i, center, after_i), all at x. Sums of a block of pixels stay in registers.
template <size_t block, class First, class Pair>
size_t filter_blocks(const HalfKernel& kernel, size_t x, size_t width, const Around& in, float* out, First first, Pair pair) {
    const float* weights = kernel.data();
    const size_t taps = kernel.size();
    for (; x + block <= width; x += block) {
        float center[block], sum[block];
        for (size_t j = 0; j < block; ++j) center[j] = in.center[x + j];
        for (size_t j = 0; j < block; ++j) sum[j] = first(weights[0], center[j]);
        for (size_t i = 1; i < taps; ++i) {
            const float *before = in.before[i] + x, *after = in.after[i] + x, weight = weights[i];
            for (size_t j = 0; j < block; ++j) sum[j] += weight * pair(before[j], center[j], after[j]);
        }
        for (size_t j = 0; j < block; ++j) out[x + j] = sum[j];
    }
    return x;
}

template <class First, class Pair>
void filter(const HalfKernel& kernel, size_t width, const Around& in, float* out, First first, Pair pair) {
    const size_t done = filter_blocks<16>(kernel, 0, width, in, out, first, pair);
    filter_blocks<1>(kernel, done, width, in, out, first, pair);
}

template <class Row>
void even_filter(const HalfKernel& kernel, size_t width, Row row, float* out) {
    filter(kernel, width, Around(kernel, row), out, [](float k, float c) { return k * c; }, [](float b, float, float a) { return b + a; });
}

template <class Row>
void odd_filter(const HalfKernel& kernel, size_t width, Row row, float* out) {
    filter(kernel, width, Around(kernel, row), out, [](float, float) { return 0.0f; }, [](float b, float, float a) { return a - b; });
}

/// For a kernel whose sum is 0: of differences to the centre, so that a constant gives 0 exactly; the square root of features magnifies any rest.
template <class Row>
void zero_sum_filter(const HalfKernel& kernel, size_t width, Row row, float* out) {
    filter(kernel, width, Around(kernel, row), out, [](float, float) { return 0.0f; }, [](float b, float c, float a) { return (b - c) + (a - c); });
}

/// A row of the picture in opponent space, its ends continued by `pad` pixels.
class PaddedRow {
public:
    PaddedRow(size_t width, size_t pad) : width_(width), pad_(pad) {
        for (auto& channel : channels_) channel.resize(width + 2 * pad);
    }
    void fill(const float* rgb) {
        float *y = channels_[0].data() + pad_, *x_y = channels_[1].data() + pad_, *y_z = channels_[2].data() + pad_;
        for (size_t x = 0; x < width_; ++x) {
            const Three color = flip::opponent({rgb[3 * x], rgb[3 * x + 1], rgb[3 * x + 2]});
            y[x] = color.x;
            x_y[x] = color.y;
            y_z[x] = color.z;
        }
        for (auto& channel : channels_) {
            std::fill_n(channel.begin(), pad_, channel[pad_]);
            std::fill_n(channel.end() - std::ptrdiff_t(pad_), pad_, channel[pad_ + width_ - 1]);
        }
    }
    /// The row's pixels as seen from `offset` pixels aside.
    auto from(size_t channel) const {
        return [start = channels_[channel].data() + pad_](int offset) { return start + offset; };
    }

private:
    size_t width_, pad_;
    std::array<std::vector<float>, 3> channels_;
};

using Rows = std::array<std::vector<float>, 4>;

float in_gamut(float value) { return std::min(std::max(value, 0.0f), 1.0f); }

/// From opponent space, with blue-yellow in two parts. __restrict: more rows than compilers compare before they make vectors.
void to_lab(size_t width, const float* y, const float* x_y, const float* y_z0, const float* y_z1, float* __restrict l, float* __restrict a, float* __restrict b) {
    for (size_t x = 0; x < width; ++x) {
        const Three rgb = flip::from_opponent({y[x], x_y[x], y_z0[x] + y_z1[x]});
        const Three lab = flip::hunt_lab({in_gamut(rgb.x), in_gamut(rgb.y), in_gamut(rgb.z)});
        l[x] = lab.x;
        a[x] = lab.y;
        b[x] = lab.z;
    }
}

/// A strip of one picture, its rows filtered along as they are needed. Only those in reach of the filters are kept: they stay in the cache.
class Strip {
public:
    Strip(const FlipFilters& filters, std::span<const float> picture, size_t width, size_t height, size_t first)
        : filters_(filters), picture_(picture), width_(width), height_(height), ring_(2 * filters.radius + 1), next_(first - std::min(first, filters.radius)),
          row_(width, filters.radius) {
        for (auto& plane : planes_) plane.resize(width * std::min(height, ring_));
    }

    /// To be called for every row in order, before it is asked for.
    void reach(size_t y) {
        for (const size_t end = std::min(height_, y + filters_.radius + 1); next_ < end; ++next_) {
            row_.fill(picture_.data() + next_ * width_ * 3);
            filter_along(row_, next_ % ring_ * width_);
        }
    }

    /// Rows of a plane as seen from row y; the border continues.
    auto around(Plane plane, size_t y) const {
        return [this, plane, y](int offset) {
            const auto row = std::clamp(std::ptrdiff_t(y) + offset, std::ptrdiff_t(0), std::ptrdiff_t(height_) - 1);
            return planes_[plane].data() + size_t(row) % ring_ * width_;
        };
    }

    /// The filters across the rows, at row y: of colours, back to linear Rec. 709 and the display's gamut, then to Hunt-adjusted CIELAB.
    void colors(size_t y, Rows& buffer, Rows& lab) const {
        even_filter(filters_.achromatic, width_, around(achromatic, y), buffer[0].data());
        even_filter(filters_.red_green, width_, around(red_green, y), buffer[1].data());
        even_filter(filters_.blue_yellow[0], width_, around(blue_yellow_0, y), buffer[2].data());
        even_filter(filters_.blue_yellow[1], width_, around(blue_yellow_1, y), buffer[3].data());
        to_lab(width_, buffer[0].data(), buffer[1].data(), buffer[2].data(), buffer[3].data(), lab[0].data(), lab[1].data(), lab[2].data());
    }

    /// Strength of edges and of points at row y.
    void features(size_t y, Rows& buffer, std::vector<float>& edges, std::vector<float>& points) const {
        even_filter(filters_.smooth, width_, around(edge, y), buffer[0].data());
        odd_filter(filters_.edge, width_, around(smooth, y), buffer[1].data());
        even_filter(filters_.smooth, width_, around(point, y), buffer[2].data());
        zero_sum_filter(filters_.point, width_, around(smooth, y), buffer[3].data());
        const float *ex = buffer[0].data(), *ey = buffer[1].data(), *px = buffer[2].data(), *py = buffer[3].data();
        for (size_t x = 0; x < width_; ++x) {
            edges[x] = std::sqrt(ex[x] * ex[x] + ey[x] * ey[x]);
            points[x] = std::sqrt(px[x] * px[x] + py[x] * py[x]);
        }
    }

private:
    void filter_along(const PaddedRow& row, size_t at) {
        even_filter(filters_.achromatic, width_, row.from(0), &planes_[achromatic][at]);
        even_filter(filters_.red_green, width_, row.from(1), &planes_[red_green][at]);
        even_filter(filters_.blue_yellow[0], width_, row.from(2), &planes_[blue_yellow_0][at]);
        even_filter(filters_.blue_yellow[1], width_, row.from(2), &planes_[blue_yellow_1][at]);
        even_filter(filters_.smooth, width_, row.from(0), &planes_[smooth][at]);
        odd_filter(filters_.edge, width_, row.from(0), &planes_[edge][at]);
        zero_sum_filter(filters_.point, width_, row.from(0), &planes_[point][at]);
    }
    const FlipFilters& filters_;
    std::span<const float> picture_;
    size_t width_, height_, ring_, next_;
    PaddedRow row_;
    std::array<std::vector<float>, planes> planes_;
};

/// The largest colour error there is, between green and blue (section 4.1.3), before its exponent.
float largest_color_error() {
    static const float largest = std::pow(flip::hyab(flip::hunt_lab({0, 1, 0}), flip::hunt_lab({0, 0, 1})), kColorExponent);
    return largest;
}

/// Colour errors on 0 .. 1: small ones take nearly all of it, since large ones are all alike (section 4.1.3).
float color_error(float hyab, float largest) {
    const float error = std::pow(hyab, kColorExponent), knee = kKneeIn * largest;
    return error < knee ? kKneeOut / knee * error : kKneeOut + (error - knee) / (largest - knee) * (1 - kKneeOut);
}

/// What a strip needs of one picture at one row.
struct RowOf {
    Rows lab;   // three of them
    std::vector<float> edges, points;
    explicit RowOf(size_t width) : edges(width), points(width) {
        for (auto& row : lab) row.resize(width);
    }
    void read(Strip& strip, size_t y, Rows& buffer) {
        strip.reach(y);
        strip.colors(y, buffer, lab);
        strip.features(y, buffer, edges, points);
    }
};

void compare(const RowOf& a, const RowOf& b, size_t width, float* out) {
    const float largest = largest_color_error();
    for (size_t x = 0; x < width; ++x) {
        const float distance = flip::hyab({a.lab[0][x], a.lab[1][x], a.lab[2][x]}, {b.lab[0][x], b.lab[1][x], b.lab[2][x]});
        const float color = std::min(color_error(distance, largest), 1.0f);
        const float feature = std::max(std::abs(a.edges[x] - b.edges[x]), std::abs(a.points[x] - b.points[x]));
        const float amplified = std::min(std::sqrt(feature * 0.70710678118654752f), 1.0f);   // exponent 0.5, of what is at most sqrt(2)
        out[x] = std::pow(color, 1 - amplified);
    }
}

}  // namespace

std::vector<float> flip_map(int width, int height, std::span<const float> reference, std::span<const float> test, int threads) {
    static const FlipFilters filters = flip_filters();
    const auto w = size_t(width), h = size_t(height);
    std::vector<float> map(w * h);
    parallel_for((h + kStripRows - 1) / kStripRows, threads, [&](size_t strip) {
        const size_t first = strip * kStripRows, last = std::min(h, first + kStripRows);
        Strip a(filters, reference, w, h, first), b(filters, test, w, h, first);
        Rows buffer;
        for (auto& row : buffer) row.resize(w);
        RowOf row_a(w), row_b(w);
        for (size_t y = first; y < last; ++y) {
            row_a.read(a, y, buffer);
            row_b.read(b, y, buffer);
            compare(row_a, row_b, w, &map[y * w]);
        }
    });
    return map;
}

Measured pooled_flip(const PicturePair& pair, std::vector<float> map) {
    std::vector<float> counted;
    counted.reserve(map.size());
    double sum = 0;
    for (size_t i = 0; i < map.size(); ++i) {
        if (!pair.counts[i]) {
            map[i] = 0;
            continue;
        }
        counted.push_back(map[i]);
        sum += double(map[i]);
    }
    const auto [low, high] = std::minmax_element(counted.begin(), counted.end());
    const double min = double(*low), max = double(*high), mean = sum / double(counted.size());
    const double shares[] = {0.25, 0.5, 0.75};
    const auto quartiles = weighted_percentiles(std::move(counted), shares);
    return {{{"mean", mean}, {"weighted_median", quartiles[1]}, {"first_weighted_quartile", quartiles[0]},
             {"third_weighted_quartile", quartiles[2]}, {"min", min}, {"max", max}},
            std::move(map)};
}

}  // namespace alidade
