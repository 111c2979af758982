// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"
#include "tools/metrics/metric.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace alidade {
namespace {

constexpr size_t kWindow = 11, kReach = kWindow / 2;
constexpr double kDeviation = 1.5;
constexpr double kC1 = 0.01 * 0.01, kC2 = 0.03 * 0.03;   // (K1 L)^2 and (K2 L)^2 for values of 0 .. 1
constexpr size_t kStripRows = 48;                        // fixed: sums have the same parts on any number of threads

using Kernel = std::array<double, kWindow>;

Kernel gaussian() {
    Kernel kernel;
    double sum = 0;
    for (size_t i = 0; i < kWindow; ++i) sum += kernel[i] = std::exp(-0.5 * std::pow((double(i) - double(kReach)) / kDeviation, 2));
    for (double& weight : kernel) weight /= sum;
    return kernel;
}

/// Means over a window: of both values, of the sum of their squares, of their product.
struct Moments {
    double a, b, squares, product;
};

double similarity(const Moments& m) {
    const double both = m.a * m.b, own = m.a * m.a + m.b * m.b;
    return (2 * both + kC1) * (2 * (m.product - both) + kC2) / ((own + kC1) * (m.squares - own + kC2));
}

struct Pool {
    double sum = 0, min = 1;
    size_t count = 0;

    void add(double value) {
        sum += value;
        min = std::min(min, value);
        ++count;
    }
    void add(const Pool& other) {
        sum += other.sum;
        min = std::min(min, other.min);
        count += other.count;
    }
};

/// Both pictures' display values, three channels interleaved, of which the pair's own count.
struct Values {
    const PicturePair& pair;
    std::vector<float> a, b;
    Kernel kernel = gaussian();
    size_t width, height;

    explicit Values(const PicturePair& p)
        : pair(p), a(display_colors(p, p.reference)), b(display_colors(p, p.test)), width(size_t(p.width())), height(size_t(p.height())) {}
};

/// Rows (or one row, shifted) under a window.
using Rows = std::array<const double*, kWindow>;

/// out[x] = the sum over i of kernel[i] * in[i][x] for the `block` of x that begin at `x`: sums stay in registers. The kernel is the same on both sides.
template <size_t block>
void blur_block(const Kernel& kernel, const Rows& in, size_t x, double* out) {
    double sum[block];
    for (size_t j = 0; j < block; ++j) sum[j] = kernel[kReach] * in[kReach][x + j];
    for (size_t i = 0; i < kReach; ++i) {
        const double *one = in[i] + x, *other = in[kWindow - 1 - i] + x, weight = kernel[i];
        for (size_t j = 0; j < block; ++j) sum[j] += weight * (one[j] + other[j]);
    }
    for (size_t j = 0; j < block; ++j) out[x + j] = sum[j];
}

void blur(const Kernel& kernel, const Rows& in, size_t width, double* out) {
    constexpr size_t block = 8;
    size_t x = 0;
    for (; x + block <= width; x += block) blur_block<block>(kernel, in, x, out);
    for (; x < width; ++x) blur_block<1>(kernel, in, x, out);
}

/// The windows whose first rows are `first` .. `last`, in one channel. Of rows blurred along only the last eleven are kept: they stay in the cache.
class Strip {
public:
    Strip(const Values& values, size_t channel) : values_(values), channel_(channel), columns_(values.width - 2 * kReach) {
        for (auto& row : raw_) row.resize(values.width);
        for (auto& row : blurred_) row.resize(columns_);
        for (auto& plane : along_) plane.resize(kWindow * columns_);
    }

    Pool pooled(size_t first, size_t last) {
        for (size_t y = first; y < first + kWindow - 1; ++y) blur_along(y);
        Pool pool;
        for (size_t y = first; y < last; ++y) {
            blur_along(y + kWindow - 1);
            blur_across(y);
            const uint8_t* counts = &values_.pair.counts[(y + kReach) * values_.width + kReach];
            for (size_t x = 0; x < columns_; ++x) {
                if (counts[x]) pool.add(similarity({blurred_[0][x], blurred_[1][x], blurred_[2][x], blurred_[3][x]}));
            }
        }
        return pool;
    }

private:
    void blur_along(size_t y) {
        const float *a = &values_.a[y * values_.width * 3 + channel_], *b = &values_.b[y * values_.width * 3 + channel_];
        for (size_t x = 0; x < values_.width; ++x) {
            const double va = double(a[3 * x]), vb = double(b[3 * x]);
            raw_[0][x] = va;
            raw_[1][x] = vb;
            raw_[2][x] = va * va + vb * vb;
            raw_[3][x] = va * vb;
        }
        for (size_t p = 0; p < 4; ++p) {
            Rows shifted;
            for (size_t i = 0; i < kWindow; ++i) shifted[i] = raw_[p].data() + i;
            blur(values_.kernel, shifted, columns_, &along_[p][y % kWindow * columns_]);
        }
    }

    void blur_across(size_t y) {
        for (size_t p = 0; p < 4; ++p) {
            Rows rows;
            for (size_t i = 0; i < kWindow; ++i) rows[i] = &along_[p][(y + i) % kWindow * columns_];
            blur(values_.kernel, rows, columns_, blurred_[p].data());
        }
    }

    const Values& values_;
    size_t channel_, columns_;
    std::array<std::vector<double>, 4> raw_, blurred_, along_;
};

Pool whole_windows(const Values& values) {
    if (values.width < kWindow || values.height < kWindow) return {};
    const size_t rows = values.height - 2 * kReach, strips = (rows + kStripRows - 1) / kStripRows;
    const auto channels = size_t(values.pair.colors());
    std::vector<Pool> pools(strips * channels);
    parallel_for(pools.size(), values.pair.threads, [&](size_t i) {
        const size_t first = i / channels * kStripRows;
        pools[i] = Strip(values, i % channels).pooled(first, std::min(rows, first + kStripRows));
    });
    Pool pool;
    for (const Pool& part : pools) pool.add(part);
    return pool;
}

/// The window around a pixel as far as it is inside the picture, its weights scaled to a sum of 1.
double cut_window(const Values& values, size_t channel, size_t x, size_t y) {
    Moments m{};
    double total = 0;
    for (size_t j = y - std::min(y, kReach); j <= std::min(y + kReach, values.height - 1); ++j) {
        for (size_t i = x - std::min(x, kReach); i <= std::min(x + kReach, values.width - 1); ++i) {
            const double weight = values.kernel[j + kReach - y] * values.kernel[i + kReach - x];
            const double a = double(values.a[3 * (j * values.width + i) + channel]), b = double(values.b[3 * (j * values.width + i) + channel]);
            total += weight;
            m.a += weight * a;
            m.b += weight * b;
            m.squares += weight * (a * a + b * b);
            m.product += weight * (a * b);
        }
    }
    return similarity({m.a / total, m.b / total, m.squares / total, m.product / total});
}

Pool cut_windows(const Values& values) {
    const auto channels = size_t(values.pair.colors());
    Pool pool;
    for (size_t y = 0; y < values.height; ++y) {
        for (size_t x = 0; x < values.width; ++x) {
            for (size_t c = 0; c < channels && values.pair.counts[y * values.width + x]; ++c) pool.add(cut_window(values, c, x, y));
        }
    }
    return pool;
}

}  // namespace

/// Structural similarity of display values 0 .. 1: 1 for equal pictures, down to -1; the mean over all channels and all pixels that count and whose
/// 11 x 11 Gaussian window (sigma 1.5) lies inside the picture; `min` is the lowest. If there is no such pixel (a side under 11 pixels), over all pixels
/// that count, with windows cut at the border.
/// Source   Wang, Bovik, Sheikh, Simoncelli, "Image Quality Assessment: From Error Visibility to Structural Similarity", IEEE TIP 13(4), 2004;
///          K1 = 0.01, K2 = 0.03; variances are means of squares, not those of samples.
/// Error    1e-12: double arithmetic, since a small variance is the difference of large means. Held by metrics_test.
Measured measure_ssim(const PicturePair& pair) {
    const Values values(pair);
    Pool pool = whole_windows(values);
    if (!pool.count) pool = cut_windows(values);
    return {{{"value", pool.sum / double(pool.count)}, {"min", pool.min}}, {}};
}

}  // namespace alidade
