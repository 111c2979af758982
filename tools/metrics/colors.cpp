// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"
#include "tools/metrics/metric.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace alidade {
namespace {

/// sRGB's decoding from a table with straight lines between: its steps meet every k / 255, so that 8-bit values are decoded as exactly as floats hold
/// them; between, it is off by at most 3e-8.
class Decoder {
public:
    Decoder() {
        for (size_t i = 0; i < table_.size(); ++i) table_[i] = float(srgb_to_linear(double(i) / kSteps));
    }
    float operator()(float encoded) const {
        const float position = std::clamp(encoded, 0.0f, 1.0f) * kSteps;
        const auto step = std::min(size_t(position), size_t(kSteps) - 1);
        return table_[step] + (position - float(step)) * (table_[step + 1] - table_[step]);
    }

private:
    static constexpr int kSteps = 255 * 16;
    std::array<float, kSteps + 1> table_;
};

float encode(float linear) {
    linear = std::clamp(linear, 0.0f, 1.0f);
    return linear <= 0.0031308f ? linear * 12.92f : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}

/// Every pixel's colour through `curve`, three values a pixel: of two numbers the third is 0.
template <class Curve>
std::vector<float> colors(const PicturePair& pair, const Picture& picture, Curve curve) {
    constexpr size_t block = 1 << 14;
    const size_t count = pair.pixels(), channels = size_t(picture.channels), own = size_t(pair.colors());
    std::vector<float> found(3 * count);
    parallel_for((count + block - 1) / block, pair.threads, [&](size_t b) {
        for (size_t i = b * block, end = std::min(count, i + block); i < end; ++i) {
            const float* in = &picture.values[i * channels];
            if (own == 1) std::fill_n(&found[3 * i], 3, curve(in[0]));
            else
                for (size_t c = 0; c < own; ++c) found[3 * i + c] = curve(in[c]);
        }
    });
    return found;
}

}  // namespace

std::vector<float> display_colors(const PicturePair& pair, const Picture& picture) {
    return pair.hdr ? colors(pair, picture, encode) : colors(pair, picture, [](float value) { return std::clamp(value, 0.0f, 1.0f); });
}

std::vector<float> linear_colors(const PicturePair& pair, const Picture& picture) {
    static const Decoder decode;
    return pair.hdr ? colors(pair, picture, [](float value) { return value; }) : colors(pair, picture, [](float value) { return decode(value); });
}

}  // namespace alidade
