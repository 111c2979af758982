// SPDX-License-Identifier: Apache-2.0
/// A PatternSignal, ready to be asked.
#pragma once

#include "eval/patterns/registry.h"
#include "eval/patterns/warps.h"

#include <functional>
#include <memory>

namespace alidade {

/// What a map has at a value: `low`, and `high` where t > 0, as low + t (high - low).
struct MapBlend {
    uint32_t low = 0, high = 0;   ///< indices into the map
    double t = 0;                 ///< in [0, 1)
};

/// What stands at `value`. The entries are taken in their order, sorted or not; of two at one position, the first ends what is below and the second begins what
/// is above. An empty map gives the entry 0.
/// Source   experiments with POV-Ray 3.7
template <class Entry> MapBlend look_up(std::span<const Entry> map, double value) {
    if (map.empty()) return {};
    const uint32_t last = uint32_t(map.size() - 1);
    if (value >= map[last].value) return {last, last, 0};
    for (uint32_t i = 0; i <= last; ++i) {
        const double position = map[i].value;
        if (!(position >= value)) continue;
        if (i == 0 || position == value) return {i, i, 0};
        const double before = map[i - 1].value;
        return {i - 1, i, (value - before) / (position - before)};
    }
    return {};   // a NaN, as in POV-Ray
}
inline MapBlend look_up(const std::vector<MapEntry>& map, double value) { return look_up(std::span<const MapEntry>(map), value); }

class SpacePicture;

/// What knows a pattern's number at a place, where its row does not: one of them.
struct PatternSource {
    std::function<double(const Vec3& place)> grey;
    std::shared_ptr<const SpacePicture> picture;

    explicit operator bool() const { return grey || picture; }
};

class Pattern {
  public:
    /// Or why not: no such pattern, too many parameters, a warp that cannot be undone. `source` stands for the signal's own, and must be there where that is.
    static tl::expected<Pattern, std::string> make(const PatternSignal& signal, PatternSource source = {});

    /// Where the pattern itself is looked up: all warps and the turbulence undone. The entries of its map are looked up there too.
    Vec3 place(const Vec3& p) const;

    /// The number at a place: after frequency, phase and wave.
    double value_at(const Vec3& place) const;
    double value(const Vec3& p) const { return value_at(place(p)); }
    /// The same at four places near each other.
    void values_at(const Vec3* places, double* values) const;

    /// All entries count, by their weights; there is no value.
    bool is_average() const { return !row_->value && !row_->relief && !source_; }
    const PatternOps& row() const { return *row_; }
    /// The picture whose colours stand for the map, or null.
    const SpacePicture* shown() const { return row_->colored ? source_.picture.get() : nullptr; }
    const SpacePicture* picture() const { return source_.picture.get(); }
    /// A picture whose values are the heights of a relief, and no number of the pattern.
    bool is_bump_map() const { return source_.picture && row_->embossed; }
    /// The row's own relief, which must be there.
    Vec3 relief(const Vec3& place, const Vec3& n, double amount) const { return row_->relief(place, n, amount, input_); }
    /// How normals come into the space of the pattern, where all transformations of its warps are undone, and back.
    const Mat3& normal_in() const { return normal_in_; }
    const Mat3& normal_out() const { return normal_out_; }

  private:
    double finished(double v) const;

    const PatternOps* row_ = nullptr;
    PatternInput input_;
    PatternSource source_;
    std::vector<PreparedWarp> warps_;   ///< in the order in which they are undone
    Mat3 normal_in_{1.0}, normal_out_{1.0};
    Wave wave_ = Wave::ramp;
    double wave_exponent_ = 1, frequency_ = 1;
    bool displaced_ = false;
};

/// Calls f(entry, share) for the entries of a pattern's map that count at a place: their shares add up to 1. Of two that are blended, the later one comes first, as in POV-Ray.
template <class F> void for_each_share(const std::vector<MapEntry>& map, const Pattern& pattern, const Vec3& place, const F& f) {
    if (pattern.is_average()) {
        double total = 0;
        for (const MapEntry& entry : map) total += entry.value;
        if (total == 0) return;
        for (uint32_t i = 0; i < map.size(); ++i) f(i, map[i].value / total);
        return;
    }
    const MapBlend blend = look_up(map, pattern.value_at(place));
    if (blend.t > 0) f(blend.high, blend.t);
    f(blend.low, 1 - blend.t);
}

}  // namespace alidade
