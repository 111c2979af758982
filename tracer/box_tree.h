// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/bounds.h"

#include <cstdint>
#include <span>
#include <vector>

namespace alidade {

/// Boxes, of which some may be endless, in a binary tree that halves them by their centers: asks few of many for those that hold a point.
class BoxTree {
  public:
    BoxTree() = default;
    explicit BoxTree(std::span<const Bounds> boxes);

    /// Calls visit(number) for each box that holds `point`, in the order of the tree. How many boxes it asked, those of nodes too.
    template <class Visit>
    size_t holding(const Vec3& point, Visit&& visit) const {
        size_t asked = 0;
        for (size_t n = 0; n < nodes_.size(); ++asked) {
            const Node& node = nodes_[n];
            const bool holds = node.bounds.contains(point);
            if (holds && node.box != kInner) visit(node.box);
            n = holds ? n + 1 : node.next;
        }
        return asked;
    }

  private:
    static constexpr uint32_t kInner = ~uint32_t(0);
    /// In the order of a walk: behind an inner node all that is in it.
    struct Node {
        Bounds bounds;
        uint32_t next = 0;          ///< the node behind what is in this one
        uint32_t box = kInner;      ///< of a leaf
    };
    void add(std::span<const Bounds> boxes, std::span<uint32_t> numbers);

    std::vector<Node> nodes_;
};

}  // namespace alidade
