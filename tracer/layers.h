// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tracer/integrators/integrator.h"

#include <tl/expected.hpp>

namespace alidade {

/// The samples of one pixel, added up.
struct PixelSamples {
    PixelSamples() {}   // as FirstHit

    Color radiance{0};
    FirstHit sum;             ///< of the samples that hit: depth, normal, albedo, uv; coverage of all
    uint32_t instance = kNoId, material = kNoId;   ///< of the first sample that hit
    int samples = 0, hits = 0;
    uint64_t work = 0;        ///< box and primitive tests of the pixel

    /// `material` is that of the first hit's slot.
    void add(const Color& radiance, const FirstHit& first, uint32_t material = kNoId);
    void add(const PixelSamples& more);
};

/// The output layers that a picture has beside colour, in the order asked for.
class Layers {
  public:
    /// An unknown name is a sentence that lists the known ones.
    static tl::expected<Layers, std::string> parse(const std::vector<std::string>& names, bool with_alpha = false);
    bool any() const { return !rows_.empty(); }
    std::vector<std::string> channels() const;   ///< R, G, B, with alpha A, then the layers'
    /// Writes the pixel's values, in the order of channels().
    void write(const PixelSamples& pixel, double exposure_scale, float* out) const;

  private:
    std::vector<size_t> rows_;   // of the table
    bool alpha_ = false;
};

}  // namespace alidade
