// SPDX-License-Identifier: Apache-2.0
/// Pairs of pictures for the tests of metrics.
#pragma once

#include "tools/metrics/metric.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <string>

namespace alidade::test {

using ColorAt = std::function<std::array<float, 3>(int x, int y)>;

inline Picture drawn(int width, int height, const ColorAt& color) {
    Picture picture(width, height, {"R", "G", "B"});
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const auto rgb = color(x, y);
            std::copy(rgb.begin(), rgb.end(), picture.at(x, y));
        }
    }
    return picture;
}

inline Picture constant(int width, int height, std::array<float, 3> color) {
    return drawn(width, height, [color](int, int) { return color; });
}

/// Both of one size; every pixel counts.
inline PicturePair paired(Picture reference, Picture test, bool hdr = false) {
    PicturePair pair;
    pair.reference = std::move(reference);
    pair.test = std::move(test);
    pair.hdr = hdr;
    pair.counts.assign(pair.pixels(), 1);
    return pair;
}

/// The same places changed.
inline PicturePair swapped(PicturePair pair) {
    std::swap(pair.reference, pair.test);
    return pair;
}

/// Noise that is the same on every machine.
inline ColorAt noise(uint32_t seed, float low = 0, float high = 1) {
    return [=](int x, int y) {
        std::array<float, 3> rgb;
        for (uint32_t c = 0; c < 3; ++c) {
            uint32_t h = seed * 0x9e3779b9u + uint32_t(x) * 0x85ebca6bu + uint32_t(y) * 0xc2b2ae35u + c * 0x27d4eb2fu;
            h = (h ^ (h >> 15)) * 0x2c1b3c6du;
            h = (h ^ (h >> 12)) * 0x297a2d39u;
            rgb[c] = low + (high - low) * float((h ^ (h >> 15)) >> 8) / float(1 << 24);
        }
        return rgb;
    };
}

inline double number(const Measured& measured, const std::string& name) {
    for (const auto& [key, value] : measured.numbers) {
        if (key == name) return value;
    }
    ADD_FAILURE() << "no number called " << name;
    return 0;
}

}  // namespace alidade::test
