// SPDX-License-Identifier: Apache-2.0
#include "accel/bvh/wide.h"

#include <array>
#include <limits>
#include <vector>

namespace alidade {

namespace {

/// Nodes of the binary tree that become the places of one wide node, in their order from left to right.
struct Places {
    std::array<uint32_t, kWide> node;
    uint32_t count = 0;

    void add(uint32_t place) { node[count++] = place; }
};

/// How a binary subtree becomes `places` of a wide node at the least cost, which is the area of all wide nodes in it: what leaves cost is the same however nodes are joined.
///
/// Method   dynamic programming over the subtrees and 1 to 8 places: Ylitie, Karras, Laine, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs", 2017.
struct Joining {
    std::array<float, kWide> cost{};          ///< [places - 1]
    std::array<uint8_t, kWide> to_left{};     ///< of so many places, those of the left child; 0: the node is a place itself
};

template <class R> class Widener {
  public:
    Widener(const LargeVector<BvhNode<R>>& nodes, BuildStats& stats) : nodes_(nodes), stats_(stats), root_area_(area(nodes[0].box)), joinings_(nodes.size()) {
        for (size_t i = nodes.size(); i-- > 0;) {   // children come after parents
            if (!nodes[i].leaf()) joinings_[i] = joined(uint32_t(i));
        }
    }

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
        Places places;
        collect(root, kWide, places);
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

    /// The least cost of the children with so many places in all; then whether a place, and a node of its own, is cheaper.
    Joining joined(uint32_t node) const {
        const Joining &left = joinings_[nodes_[node].first], &right = joinings_[nodes_[node].first + 1];
        Joining best;
        best.cost[0] = std::numeric_limits<float>::infinity();
        for (uint32_t places = 2; places <= kWide; ++places) {
            best.cost[places - 1] = best.cost[places - 2], best.to_left[places - 1] = best.to_left[places - 2];
            for (uint32_t lefts = 1; lefts < places; ++lefts) {
                const float cost = left.cost[lefts - 1] + right.cost[places - lefts - 1];
                if (cost < best.cost[places - 1]) best.cost[places - 1] = cost, best.to_left[places - 1] = uint8_t(lefts);
            }
        }
        best.cost[0] = float(share(node)) + best.cost[kWide - 1];
        for (uint32_t i = 1; i < kWide; ++i) {
            if (best.cost[0] < best.cost[i]) best.cost[i] = best.cost[0], best.to_left[i] = 0;
        }
        return best;
    }

    void collect(uint32_t node, uint32_t count, Places& places) const {
        const uint32_t lefts = joinings_[node].to_left[count - 1];
        if (lefts == 0) return places.add(node);
        collect(nodes_[node].first, lefts, places), collect(nodes_[node].first + 1, count - lefts, places);
    }

    double share(uint32_t node) const { return root_area_ > 0 ? area(nodes_[node].box) / root_area_ : 1; }

    static void set_box(WideNode<R>& node, uint32_t place, const BoundsT<R>& box) {
        for (int a = 0; a < 3; ++a) node.planes[2 * a][place] = box.min[a], node.planes[2 * a + 1][place] = box.max[a];
    }

    const LargeVector<BvhNode<R>>& nodes_;
    BuildStats& stats_;
    double root_area_;
    std::vector<Joining> joinings_;
    LargeVector<WideNode<R>> wide_;
};

}  // namespace

template <class R> LargeVector<WideNode<R>> widened(const LargeVector<BvhNode<R>>& nodes, BuildStats& stats) {
    return nodes.empty() ? LargeVector<WideNode<R>>() : Widener<R>(nodes, stats).run();
}

template LargeVector<WideNode<float>> widened(const LargeVector<BvhNode<float>>&, BuildStats&);
template LargeVector<WideNode<double>> widened(const LargeVector<BvhNode<double>>&, BuildStats&);

}  // namespace alidade
