// SPDX-License-Identifier: Apache-2.0
/// Paths through a scene, in the order of a walk.
#pragma once

#include "scene/scene.h"

#include <algorithm>
#include <vector>

namespace alidade {

/// Paths to what something bounds. Of each only what differs from the one before is stored: a thousand bounds inside one another make paths of a thousand nodes to a thousand shapes.
class BoundedPaths {
  public:
    /// `id`: of what stands at its end.
    void add(uint32_t id, const std::vector<NodeId>& path) {
        const auto common = std::mismatch(path.begin(), path.end(), last_.begin(), last_.end()).first;
        ends_.push_back({id, size_t(common - path.begin()), size_t(path.end() - common)});
        rest_.insert(rest_.end(), common, path.end());
        last_ = path;
    }
    bool empty() const { return ends_.empty(); }

    /// Calls f(id, path) for each, as they were added.
    template <class F> void for_each(const F& f) const {
        std::vector<NodeId> path;
        auto at = rest_.begin();
        for (const End& end : ends_) {
            path.resize(end.common);
            path.insert(path.end(), at, at + std::ptrdiff_t(end.rest));
            at += std::ptrdiff_t(end.rest);
            f(end.id, path);
        }
    }

  private:
    struct End {
        uint32_t id = 0;
        size_t common = 0, rest = 0;       ///< nodes that it shares with the path before, and that it has behind them
    };
    std::vector<End> ends_;
    std::vector<NodeId> rest_, last_;
};

}  // namespace alidade
