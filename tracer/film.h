// SPDX-License-Identifier: Apache-2.0
/// The picture that a render makes: colour, output layers, and what it cost.
#pragma once

#include "accel/stats.h"
#include "core/image.h"

#include <span>

namespace alidade {

/// An output layer. `channels` are its names in the picture, in order: "depth.Z", "normal.X" ...
struct AovEntry {
    const char* name;
    const char* doc;
    std::span<const char* const> channels;
};
std::span<const AovEntry> aovs();

struct RenderStats {
    uint64_t camera_rays = 0, shadow_rays = 0, secondary_rays = 0;
    uint64_t pixels = 0, pixels_ended_early = 0;   ///< finished; and of them, with fewer samples than asked for (RenderOptions::adaptive)
    WorkCounters work;
    uint64_t texture_reads = 0;   ///< texels, of all pictures: of a filtered texture four a lookup
    double seconds = 0, cpu_seconds = 0;
    size_t tiles = 0, tiles_done = 0;
};

struct Film {
    Picture picture;      ///< R, G, B, then the channels of the asked layers
    RenderStats stats;
    bool complete = true; ///< false: ended by Monitor::stop, some tiles are black
};

}  // namespace alidade
