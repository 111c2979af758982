// SPDX-License-Identifier: Apache-2.0
#include "accel/bvh/wide.h"

#include <array>
#include <stdexcept>

namespace alidade {

namespace {

/// Nodes of the binary tree that become the places of one wide node, in their order from left to right.
struct Places {
    std::array<uint32_t, kWide> node;
    uint32_t count = 0;

    void open(uint32_t place, uint32_t left) {
        for (uint32_t i = count; i > place + 1; --i) node[i] = node[i - 1];
        node[place] = left, node[place + 1] = left + 1, ++count;
    }
};

template <class R> class Widener {
  public:
    Widener(const LargeVector<BvhNode<R>>& nodes, BuildStats& stats) : nodes_(nodes), stats_(stats), root_area_(area(nodes[0].box)) {}

    LargeVector<WideNode<R>> run() {
        stats_.depth = 0, stats_.sah_cost = 0;
        wide_.reserve(nodes_.size() / kWide + 1);
        emit(0, 0);
        wide_.shrink_to_fit();
        stats_.nodes = wide_.size();
        return std::move(wide_);
    }

  private:
    /// Not deeper than the binary tree: kBvhDepth.
    uint32_t emit(uint32_t root, size_t depth) {
        const auto index = uint32_t(wide_.size());
        wide_.emplace_back();
        const Places places = collect(root);
        stats_.depth = std::max(stats_.depth, depth);
        stats_.sah_cost += share(root) * places.count;
        for (uint32_t i = 0; i < kWide; ++i) {
            const BvhNode<R>* node = i < places.count ? &nodes_[places.node[i]] : nullptr;
            set_box(wide_[index], i, node ? node->box : BoundsT<R>());
            wide_[index].child[i] = WideLeaf::kBit;
            if (!node) continue;
            const uint32_t child = node->leaf() ? WideLeaf::make(node->first / kLanes, node->count) : emit(places.node[i], depth + 1);
            if (node->leaf()) stats_.sah_cost += share(places.node[i]) * node->count;
            wide_[index].child[i] = child;
        }
        return index;
    }

    Places collect(uint32_t root) const {
        Places places;
        places.node[0] = root, places.count = 1;
        if (nodes_[root].leaf()) return places;
        places.open(0, nodes_[root].first);
        while (places.count < kWide) {
            uint32_t largest = kWide;
            double most = -1;
            for (uint32_t i = 0; i < places.count; ++i) {
                const BvhNode<R>& node = nodes_[places.node[i]];
                if (const double a = area(node.box); !node.leaf() && a > most) largest = i, most = a;
            }
            if (largest == kWide) break;
            places.open(largest, nodes_[places.node[largest]].first);
        }
        return places;
    }

    double share(uint32_t node) const { return root_area_ > 0 ? area(nodes_[node].box) / root_area_ : 1; }

    static void set_box(WideNode<R>& node, uint32_t place, const BoundsT<R>& box) {
        for (int a = 0; a < 3; ++a) node.planes[2 * a][place] = box.min[a], node.planes[2 * a + 1][place] = box.max[a];
    }

    const LargeVector<BvhNode<R>>& nodes_;
    BuildStats& stats_;
    double root_area_;
    LargeVector<WideNode<R>> wide_;
};

}  // namespace

template <class R> LargeVector<WideNode<R>> widened(const LargeVector<BvhNode<R>>& nodes, BuildStats& stats) {
    return nodes.empty() ? LargeVector<WideNode<R>>() : Widener<R>(nodes, stats).run();
}

template LargeVector<WideNode<float>> widened(const LargeVector<BvhNode<float>>&, BuildStats&);
template LargeVector<WideNode<double>> widened(const LargeVector<BvhNode<double>>&, BuildStats&);

}  // namespace alidade
