// SPDX-License-Identifier: Apache-2.0
/// POV-Ray's antialiasing (options.h): which rays it takes in a block of pixels, and how it weighs them.
#pragma once

#include "tracer/layers.h"
#include "tracer/options.h"

#include <functional>

namespace alidade {

/// Pixels are compared inside blocks of this size alone: a block is the same whatever is rendered beside it.
inline constexpr int kSupersamplingBlock = 32;

/// One ray: through the point `at` of the pixel (x, y), (0, 0) at its upper left corner, moved at random by up to half of `jitter`. It is the sample `index` of `count` of that pixel.
struct PixelRay {
    int x, y;
    Vec2 at;
    double jitter;
    uint32_t index, count;
};

/// What a block asks of the render.
struct BlockRays {
    std::function<PixelSamples(const PixelRay&)> take;   ///< with one sample
    std::function<Color(const Color&)> comparable;       ///< a colour as it is compared, `Supersampling::gamma` aside
    std::function<bool()> stopped;
};

/// The pixels `wanted` of `block`, row by row, as they are where all of the block is wanted; nothing if the render was stopped.
std::optional<std::vector<PixelSamples>> supersample(const Supersampling& how, const Region& block, const Region& wanted, const BlockRays& rays);

}  // namespace alidade
