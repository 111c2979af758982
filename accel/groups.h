// SPDX-License-Identifier: Apache-2.0
/// Rays that are asked together, while they go the same way.
#pragma once

#include "core/ray.h"

#include <algorithm>
#include <span>

namespace alidade {

/// As many at once, 4 x 4 pixels, and fewer than which do not pay.
inline constexpr uint32_t kGroup = 16, kLeastGroup = 4;

/// Which groups to ask together, and which ray by ray: where one parts, those around it will. Each that does lets twice as many pass before the next is tried.
class GroupChoice {
  public:
    bool together() {
        if (waiting_ == 0) return true;
        --waiting_;
        return false;
    }
    /// Of the group that was asked.
    void went(bool together) { waiting_ = pause_ = together ? 0 : std::min(2 * pause_ + 1, kMostPause); }

  private:
    static constexpr uint32_t kMostPause = 31;
    uint32_t waiting_ = 0, pause_ = 0;
};

/// Makes `hits` what together(rays, hits), which is false if the rays parted, or one(ray, hit) find, for groups of the rays.
template <class Together, class One> void in_groups(std::span<const Ray> rays, std::span<Hit> hits, const Together& together, const One& one) {
    GroupChoice choice;
    for (size_t i = 0; i < rays.size(); i += kGroup) {
        const size_t count = std::min<size_t>(kGroup, rays.size() - i);
        const auto some = rays.subspan(i, count);
        const auto found = hits.subspan(i, count);
        std::fill(found.begin(), found.end(), Hit());
        if (count < kLeastGroup || !choice.together()) {
            for (size_t k = 0; k < count; ++k) one(some[k], found[k]);
            continue;
        }
        choice.went(together(some, found));
    }
}

}  // namespace alidade
