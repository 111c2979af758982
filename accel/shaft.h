// SPDX-License-Identifier: Apache-2.0
/// Many rays that go the same way, asked at once: which boxes can any of them meet?
#pragma once

#include "core/bounds.h"

#include <algorithm>
#include <cmath>

namespace alidade {

/// All segments from a point of one box to a point of another. Source   E. Haines and J. Wallace, "Shaft Culling for Efficient Ray-Traced Radiosity",
/// Eurographics Workshop on Rendering 1991; the test is a slab test of the whole pencil of directions.
class Shaft {
  public:
    /// The boxes must be finite and not empty.
    Shaft(const Bounds& from, const Bounds& to) {
        // Far more than what rounding moves a hit or the side of a box by, next to the sizes that the rays are calculated with.
        const double pad = 1e-9 * std::max(std::max(max_abs(from.min), max_abs(from.max)), std::max(max_abs(to.min), max_abs(to.max)));
        from_ = {from.min - Vec3(pad), from.max + Vec3(pad)};
        to_ = {to.min - Vec3(pad), to.max + Vec3(pad)};
        hull_ = {glm::min(from_.min, to_.min), glm::max(from_.max, to_.max)};
        const Vec3 least = to.min - from.max - Vec3(pad), most = to.max - from.min + Vec3(pad);
        for (int a = 0; a < 3; ++a) {
            rising_[a] = most[a] >= 0, falling_[a] = least[a] <= 0;
            over_most_[a] = most[a] == 0 ? kInf : 1 / most[a], over_least_[a] = least[a] == 0 ? -kInf : 1 / least[a];
        }
    }

    /// The boxes, padded: what is convex and holds both holds all of it.
    const Bounds& from() const { return from_; }
    const Bounds& to() const { return to_; }
    /// The box that holds all of it.
    const Bounds& hull() const { return hull_; }

    /// False only if no segment meets the box.
    bool meets(const Bounds& box) const {
        if (!hull_.overlaps(box)) return false;
        double enter = 0, leave = 1;
        for (int a = 0; a < 3; ++a) {
            // At t the pencil covers [from.min + t least, from.max + t most]: its upper end has to reach the box's lower side, its lower end the upper one.
            const double up = (box.min[a] - from_.max[a]) * over_most_[a], down = (box.max[a] - from_.min[a]) * over_least_[a];
            if (rising_[a]) enter = std::max(enter, up);
            else leave = std::min(leave, up);
            if (falling_[a]) enter = std::max(enter, down);
            else leave = std::min(leave, down);
        }
        return enter * (1 - kSlack) <= leave * (1 + kSlack);
    }

  private:
    static constexpr double kSlack = 1e-12;

    Bounds from_, to_, hull_;
    Vec3 over_least_, over_most_;
    bool rising_[3], falling_[3];
};

}  // namespace alidade
