// SPDX-License-Identifier: Apache-2.0
/// A PatternSignal, ready to be asked.
#pragma once

#include "eval/patterns/registry.h"
#include "eval/patterns/warps.h"

namespace alidade {

/// What a map has at a value: `low`, and `high` where t > 0, as low + t (high - low).
struct MapBlend {
    uint32_t low = 0, high = 0;   ///< indices into the map
    double t = 0;                 ///< in [0, 1)
};

/// What stands at `value`. The entries are taken in their order, sorted or not; of two at one position, the first ends what is below and the second begins what
/// is above. An empty map gives the entry 0.
/// Source   experiments with POV-Ray 3.7
MapBlend look_up(std::span<const MapEntry> map, double value);

class Pattern {
  public:
    /// Or why not: no such pattern, too many parameters, a warp that cannot be undone.
    static tl::expected<Pattern, std::string> make(const PatternSignal& signal);

    /// Where the pattern itself is looked up: all warps and the turbulence undone. The entries of its map are looked up there too.
    Vec3 place(const Vec3& p) const;

    /// The number at a place: after frequency, phase and wave.
    double value_at(const Vec3& place) const;
    double value(const Vec3& p) const { return value_at(place(p)); }

    /// All entries count, by their weights; there is no value.
    bool is_average() const { return !row_->value; }
    const PatternOps& row() const { return *row_; }

  private:
    const PatternOps* row_ = nullptr;
    PatternInput input_;
    std::vector<PreparedWarp> warps_;   ///< in the order in which they are undone
    Wave wave_ = Wave::ramp;
    double wave_exponent_ = 1, frequency_ = 1;
    bool displaced_ = false;
};

}  // namespace alidade
