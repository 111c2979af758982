// SPDX-License-Identifier: Apache-2.0
/// Where samples lie. A number is a function of (seed, frame, pixel, path, dimension, sample), never of a thread; how the samples of a pixel are
/// spread over a dimension is the sampler's choice.
#pragma once

#include "core/random.h"
#include "core/vec.h"

#include <span>
#include <string_view>

namespace alidade {

/// The sample `index` of `count` in one two-dimensional domain, in [0, 1)^2. `domain` is a key that no other domain has.
using SamplePair = Vec2 (*)(RandomKey domain, uint32_t index, uint32_t count);

struct SamplerEntry {
    const char* name;
    const char* doc;
    SamplePair pair;
};
/// The first row is the default.
std::span<const SamplerEntry> samplers();
const SamplerEntry* find_sampler(std::string_view name);

/// One sample of a pixel, on its way along a path. Copied with the ray; `child` names the branch that was taken.
class SampleKey {
  public:
    SampleKey() = default;
    SampleKey(SamplePair pair, RandomKey pixel, uint32_t index, uint32_t count) : pair_(pair), path_(pixel), index_(index), count_(count) {}

    SampleKey child(uint64_t branch) const { return {pair_, path_.child(branch), index_, count_}; }
    Vec2 pair(uint64_t dimension) const {
        const RandomKey domain = path_.child(dimension ^ kDomain);
        return count_ == 1 ? Vec2(domain.uniform(0), domain.uniform(1)) : pair_(domain, index_, count_);   // one sample alone is spread over nothing
    }
    /// Sample `part` of `parts` that this sample takes of one domain: so many more samples of that domain.
    Vec2 pair(uint64_t dimension, uint32_t part, uint32_t parts) const {
        return pair_(path_.child(dimension ^ kDomain), index_ * parts + part, count_ * parts);
    }

  private:
    static constexpr uint64_t kDomain = uint64_t(1) << 63;   // keeps domains and branches apart

    SamplePair pair_ = nullptr;
    RandomKey path_;
    uint32_t index_ = 0, count_ = 1;
};

/// The unit disc from the unit square, areas in proportion.
/// Source   Shirley and Chiu, "A Low Distortion Map Between Disk and Square", JGT 2(3), 1997.
Vec2 concentric_disc(const Vec2& square);

}  // namespace alidade
