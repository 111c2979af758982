// SPDX-License-Identifier: Apache-2.0
/// Where samples lie. A number is a function of (seed, frame, pixel, path, dimension, sample), never of a thread; how the samples of a pixel are
/// spread over a dimension is the sampler's choice.
#pragma once

#include "core/random.h"
#include "core/vec.h"

#include <array>
#include <span>
#include <string_view>

namespace alidade {

/// Two of the numbers that a sample's light depends on together: they are coordinates of one point, so that all of the points are spread over all of the numbers. Lights are added up, so all of
/// them may have the same two.
enum class Coordinates : uint32_t { pixel, light, lens };

/// Of which samples are taken. `own` is a key that no other domain has; domains of the same `order` take their samples in one order, and differ in their coordinates, or are added up.
struct SampleDomain {
    RandomKey own, order;
    Coordinates coordinates = Coordinates::pixel;

    SampleDomain(RandomKey apart) : own(apart), order(apart) {}
    SampleDomain(RandomKey own_key, RandomKey of_all, Coordinates which) : own(own_key), order(of_all), coordinates(which) {}
};

/// The sample `index` of `count` in one two-dimensional domain, in [0, 1)^2.
using SamplePair = Vec2 (*)(const SampleDomain& domain, uint32_t index, uint32_t count);

/// Samples that follow each other are found together, for less.
inline constexpr uint32_t kSampleBlock = 8;
using SampleBlock = std::array<Vec2, kSampleBlock>;

struct SamplerEntry {
    const char* name;
    const char* doc;
    SamplePair pair;
    void (*block)(const SampleDomain& domain, uint32_t begin, uint32_t count, SampleBlock& out) = nullptr;   ///< what `pair` says of `begin` and those that follow; null: ask that
};
/// The first row is the default.
std::span<const SamplerEntry> samplers();
const SamplerEntry* find_sampler(std::string_view name);
/// The samples from `begin` on, of `count`: the bits of SamplerEntry::pair. What would be behind the last is anything.
void sample_block(const SamplerEntry& sampler, const SampleDomain& domain, uint32_t begin, uint32_t count, SampleBlock& out);

/// One sample of a pixel, on its way along a path. Copied with the ray; `child` names the branch that was taken.
class SampleKey {
  public:
    SampleKey() = default;
    SampleKey(SamplePair pair, RandomKey pixel, uint32_t index, uint32_t count) : pair_(pair), pixel_(pixel), path_(pixel), index_(index), count_(count) {}

    SampleKey child(uint64_t branch) const {
        SampleKey key = *this;
        key.path_ = path_.child(branch);
        return key;
    }
    /// What pair() takes the samples of the pixel itself of.
    static SampleDomain domain(RandomKey pixel, Coordinates which, uint64_t dimension) { return {pixel.child(dimension ^ kDomain), pixel, which}; }

    /// Of a domain that depends on no other.
    Vec2 pair(uint64_t dimension) const { return of(path_.child(dimension ^ kDomain)); }
    Vec2 pair(Coordinates which, uint64_t dimension) const { return of({path_.child(dimension ^ kDomain), pixel_, which}); }
    /// Sample `part` of `parts` that this sample takes of a light: so many more samples of it.
    Vec2 pair_of_light(uint64_t dimension, uint32_t part, uint32_t parts) const {
        return parts == 1 ? pair(Coordinates::light, dimension) : pair_(path_.child(dimension ^ kDomain), index_ * parts + part, count_ * parts);
    }

  private:
    static constexpr uint64_t kDomain = uint64_t(1) << 63;   // keeps domains and branches apart

    Vec2 of(const SampleDomain& domain) const {
        return count_ == 1 ? Vec2(domain.own.uniform(0), domain.own.uniform(1)) : pair_(domain, index_, count_);   // one sample alone is spread over nothing
    }

    SamplePair pair_ = nullptr;
    RandomKey pixel_, path_;
    uint32_t index_ = 0, count_ = 1;
};

/// The unit disc from the unit square, areas in proportion.
/// Source   Shirley and Chiu, "A Low Distortion Map Between Disk and Square", JGT 2(3), 1997.
Vec2 concentric_disc(const Vec2& square);

}  // namespace alidade
