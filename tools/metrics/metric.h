// SPDX-License-Identifier: Apache-2.0
/// How far a picture is from a reference: a visible table. A metric is one file and one row.
#pragma once

#include "core/image.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace alidade {

/// The last channel of a picture that is compared, if it has one.
inline bool has_alpha(const Picture& picture) { return picture.names.back() == "A"; }

/// Two pictures of one size with the same channels (Y, or R, G, B, or R, G of layers of two numbers, then A if either has one), ready to be measured. There is at least one pixel
/// that counts. Where both hold floats, colours are linear and have no bounds (`hdr`); else both are display values, that is sRGB-encoded, 0 .. 1.
/// Colour is premultiplied by alpha (over black): what lies under an alpha of 0 is not seen and not compared.
struct PicturePair {
    Picture reference, test;
    bool hdr = false;
    std::vector<uint8_t> counts;   ///< one a pixel: 0 where the mask says so, or where a value is NaN or infinite (both pictures hold 0 there)
    int threads = 0;               ///< as parallel_for understands it; no number depends on it

    int width() const { return reference.width; }
    int height() const { return reference.height; }
    size_t pixels() const { return size_t(width()) * size_t(height()); }
    bool has_alpha() const { return alidade::has_alpha(reference); }
    int colors() const { return reference.channels - has_alpha(); }   ///< channels that are not alpha
};

/// What a metric says: named numbers, the one that stands for it first ("value", "mean"); a share is a fraction, 0 .. 1.
struct Measured {
    struct Number {
        std::string name;
        double value;
    };
    std::vector<Number> numbers;
    std::vector<float> map;   ///< one error a pixel, for a heat map, 0 .. 1; empty if it has none

    const double* find(const std::string& name) const;
};

struct Metric {
    const char* name;     ///< as --require and the JSON document spell it
    const char* unit;
    const char* doc;      ///< with the source
    enum class For { all, hdr } what;   ///< hdr: measured where PicturePair::hdr, absent elsewhere
    bool symmetric;       ///< the same if reference and test change places
    Measured (*measure)(const PicturePair& pair);
};

std::span<const Metric> metrics();

/// Red, green and blue of each pixel as display values 0 .. 1, interleaved: gray three times, two numbers and 0, alpha left out, linear values clipped and sRGB-encoded.
std::vector<float> display_colors(const PicturePair& pair, const Picture& picture);
/// The same linear and as they are.
std::vector<float> linear_colors(const PicturePair& pair, const Picture& picture);

/// The value at each of `shares` (0 .. 1, ascending) of `values` (any order): the smallest that at least this share of them does not exceed.
std::vector<double> percentiles(std::vector<float> values, std::span<const double> shares);
/// The same weighted by the values themselves: the value at which the ascending cumulative sum reaches this share of the total (Andersson et al. 2020, FLIP).
std::vector<double> weighted_percentiles(std::vector<float> values, std::span<const double> shares);

// The rows' functions, one a file.
Measured measure_max_abs(const PicturePair& pair);
Measured measure_mae(const PicturePair& pair);
Measured measure_rmse(const PicturePair& pair);
Measured measure_psnr(const PicturePair& pair);
Measured measure_rel_mse(const PicturePair& pair);
Measured measure_ssim(const PicturePair& pair);
Measured measure_flip(const PicturePair& pair);
Measured measure_hdr_flip(const PicturePair& pair);
Measured measure_over1(const PicturePair& pair);
Measured measure_over2(const PicturePair& pair);
Measured measure_over4(const PicturePair& pair);
Measured measure_over8(const PicturePair& pair);
Measured measure_percentiles(const PicturePair& pair);
Measured measure_bias(const PicturePair& pair);
Measured measure_envelope(const PicturePair& pair);
Measured measure_region(const PicturePair& pair);

}  // namespace alidade
