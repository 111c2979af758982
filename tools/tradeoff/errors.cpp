// SPDX-License-Identifier: Apache-2.0
#include "tools/tradeoff/errors.h"

#include "tools/metrics/metric.h"

#include <algorithm>
#include <cmath>

namespace alidade::tradeoff {
namespace {

constexpr ErrorColumn kColumns[] = {
    {"rmse", "rmse", "value", false, true, 2, "root of the mean squared error of linear values"},
    {"rel_mse", "rel_mse", "value", false, true, 4, "mean of squared error / (squared reference + 0.01), linear"},
    {"psnr", "psnr", "value", false, false, 0, "-10 log10 of the mean squared error of linear values, dB; more is better"},
    {"max_abs", "max_abs", "value", false, true, 0, "the largest difference of linear values"},
    {"ssim", "ssim", "value", true, false, 0, "structural similarity of display values; 1 if equal, more is better"},
    {"flip", "flip", "mean", true, true, 0, "mean perceived difference of display values"},
    {"over4", "over4", "value", true, true, 0, "share of pixels that differ by more than 4/255 of display values"},
};

bool is_finite(const Picture& picture, size_t pixel) {
    const float* values = &picture.values[pixel * size_t(picture.channels)];
    return std::all_of(values, values + picture.channels, [](float value) { return std::isfinite(value); });
}

/// Takes what is no number out of both pictures and out of the count.
void clear_non_finite(PicturePair& pair) {
    const auto channels = size_t(pair.reference.channels);
    for (size_t p = 0; p < pair.pixels(); ++p) {
        if (is_finite(pair.reference, p) && is_finite(pair.test, p)) continue;
        pair.counts[p] = 0;
        for (size_t c = 0; c < channels; ++c) pair.reference.values[p * channels + c] = pair.test.values[p * channels + c] = 0;
    }
}

template <class Change> void change_values(PicturePair& pair, Change&& change) {
    for (Picture* picture : {&pair.reference, &pair.test})
        for (float& value : picture->values) value = change(value);
}

const Metric& metric_of(const ErrorColumn& column) {
    return *std::find_if(metrics().begin(), metrics().end(), [&](const Metric& metric) { return std::string_view(metric.name) == column.metric; });
}

}  // namespace

std::span<const ErrorColumn> error_columns() { return kColumns; }

const ErrorColumn* find_error(std::string_view name) {
    const auto found = std::find_if(std::begin(kColumns), std::end(kColumns), [&](const ErrorColumn& column) { return name == column.name; });
    return found == std::end(kColumns) ? nullptr : found;
}

size_t count_non_finite(const Picture& picture) {
    size_t found = 0;
    for (size_t p = 0; p < size_t(picture.width) * size_t(picture.height); ++p) found += !is_finite(picture, p);
    return found;
}

MeasuredErrors measure_errors(const Picture& reference, const Picture& test, bool clip) {
    MeasuredErrors out;
    PicturePair linear{reference, test, true, std::vector<uint8_t>(size_t(reference.width) * size_t(reference.height), 1), 0};
    out.non_finite = count_non_finite(test);
    clear_non_finite(linear);
    if (std::none_of(linear.counts.begin(), linear.counts.end(), [](uint8_t counts) { return counts != 0; })) return out;
    if (clip) change_values(linear, [](float value) { return std::clamp(value, 0.0F, 1.0F); });
    PicturePair display = linear;
    display.hdr = false;
    change_values(display, [](float value) { return float(linear_to_srgb(std::clamp(double(value), 0.0, 1.0))); });
    for (const ErrorColumn& column : kColumns) {
        const Measured measured = metric_of(column).measure(column.display ? display : linear);
        out.values[column.name] = *measured.find(column.number);
        if (std::string_view(column.name) == "flip") out.flip = measured.map;
    }
    return out;
}

/// Both halves have one variance: their mean is as far from the truth, root mean square, as half of their distance. The largest error, FLIP and shares of
/// pixels keep no such law.
Errors errors_of_halves(const Picture& a, const Picture& b, bool clip) {
    Errors errors = measure_errors(a, b, clip).values;
    for (const ErrorColumn& column : kColumns) {
        if (column.halves > 0) errors[column.name] /= column.halves;
        else errors.erase(column.name);
    }
    return errors;
}

}  // namespace alidade::tradeoff
