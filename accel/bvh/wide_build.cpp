// SPDX-License-Identifier: Apache-2.0
#include "accel/bvh/wide.h"
#include "core/parallel.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <vector>

namespace alidade {

namespace {

/// Nodes of the binary tree that become the places of one wide node, in their order from left to right.
struct Places {
    std::array<uint32_t, kWide> node;
    uint32_t count = 0;

    void add(uint32_t place) { node[count++] = place; }
    const uint32_t* begin() const { return node.data(); }
    const uint32_t* end() const { return node.data() + count; }
};

/// How a binary subtree becomes `places` of a wide node at the least cost, which is the area of all wide nodes in it: what leaves cost is the same however nodes are joined.
///
/// Method   dynamic programming over the subtrees and 1 to 8 places: Ylitie, Karras, Laine, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs", 2017.
struct Joining {
    std::array<float, kWide> cost{};          ///< [places - 1]
    std::array<uint8_t, kWide> to_left{};     ///< of so many places, those of the left child; 0: the node is a place itself
};

/// Nodes below one that are looked at by one thread. It decides the order of sums, never what is joined.
constexpr uint32_t kAtOnce = 8192;

template <class R> class Widener {
  public:
    Widener(const LargeVector<BvhNode<R>>& nodes, BuildStats& stats, int threads, uint32_t block)
        : nodes_(nodes), stats_(stats), threads_(threads), block_(block), root_area_(area(nodes[0].box)), joinings_(nodes.size()) {
        const std::vector<Below> parts = divided();
        parallel_for(parts.size(), threads, [&](size_t p) {
            for (uint32_t i = parts[p].end; i-- > nodes_[parts[p].node].first;) join(i);   // children come after parents
            join(parts[p].node);
        });
        for (size_t i = upper_.size(); i-- > 0;) join(upper_[i]);
        std::sort(upper_.begin(), upper_.end());
    }

    LargeVector<WideNode<R>> run() {
        plan(0, 0);
        parallel_for(pieces_.size(), threads_, [&](size_t i) { pieces_[i].count = pieces_[i].upper ? 1 : wide_nodes(pieces_[i].root); });
        uint32_t count = 0;
        for (Piece& piece : pieces_) piece.index = count, count += piece.count;
        wide_.resize(count);
        parallel_for(pieces_.size(), threads_, [&](size_t i) {
            uint32_t next = pieces_[i].index;
            if (!pieces_[i].upper) emit(pieces_[i].root, pieces_[i].depth, next, pieces_[i]);
        });
        emit_upper();
        stats_.nodes = count, stats_.depth = 0, stats_.sah_cost = 0;
        for (const Piece& piece : pieces_) stats_.depth = std::max(stats_.depth, piece.deepest), stats_.sah_cost += piece.cost;
        return std::move(wide_);
    }

  private:
    /// A node, and those below it: from its children on to `end`.
    struct Below {
        uint32_t node, end;
    };
    /// One wide node above, or all from one on.
    struct Piece {
        uint32_t root;
        size_t depth;
        bool upper;
        uint32_t count = 0, index = 0;
        size_t deepest = 0;
        double cost = 0;
    };

    /// The subtrees of at most kAtOnce nodes. What is above them goes to upper_, parents first.
    std::vector<Below> divided() {
        std::vector<Below> parts, waiting{{0, uint32_t(nodes_.size())}};
        while (!waiting.empty()) {
            const Below at = waiting.back();
            waiting.pop_back();
            if (nodes_[at.node].leaf()) continue;
            const uint32_t child = nodes_[at.node].first;
            if (at.end - child <= kAtOnce) {
                parts.push_back(at);
                continue;
            }
            upper_.push_back(at.node);
            waiting.push_back({child + 1, at.end}), waiting.push_back({child, nodes_[child + 1].leaf() ? at.end : nodes_[child + 1].first});
        }
        return parts;
    }

    void join(uint32_t node) {
        if (!nodes_[node].leaf()) joinings_[node] = joined(node);
    }

    void plan(uint32_t root, size_t depth) {
        const bool upper = std::binary_search(upper_.begin(), upper_.end(), root);
        pieces_.push_back({root, depth, upper});
        if (!upper) return;
        for (const uint32_t place : places_of(root))
            if (!nodes_[place].leaf()) plan(place, depth + 1);
    }

    uint32_t wide_nodes(uint32_t root) const {
        uint32_t count = 1;
        for (const uint32_t place : places_of(root))
            if (!nodes_[place].leaf()) count += wide_nodes(place);
        return count;
    }

    Places places_of(uint32_t root) const {
        Places places;
        collect(root, kWide, places);
        return places;
    }

    /// From `next` on, which is counted up. Not deeper than the binary tree: kBvhDepth.
    uint32_t emit(uint32_t root, size_t depth, uint32_t& next, Piece& piece) {
        const uint32_t index = next++;
        fill(index, root, depth, piece, [&](uint32_t place) { return emit(place, depth + 1, next, piece); });
        return index;
    }

    /// Pieces stand in the order in which their wide nodes do: those below one that is above follow it.
    void emit_upper() {
        size_t next = 0;
        const auto index_of_next = [&](const auto& self) -> uint32_t {
            Piece& piece = pieces_[next++];
            if (piece.upper) fill(piece.index, piece.root, piece.depth, piece, [&](uint32_t) { return self(self); });
            return piece.index;
        };
        index_of_next(index_of_next);
    }

    template <class Child> void fill(uint32_t index, uint32_t root, size_t depth, Piece& piece, const Child& index_of) {
        const Places places = places_of(root);
        piece.deepest = std::max(piece.deepest, depth);
        std::memset(&wide_[index], 0, sizeof(WideNode<R>));   // the bytes between, too: a tree is known by its bytes
        piece.cost += share(root) * places.count;
        for (uint32_t i = 0; i < kWide; ++i) {
            const BvhNode<R>* node = i < places.count ? &nodes_[places.node[i]] : nullptr;
            wide_[index].set_box(i, node ? node->box : BoundsT<R>());
            wide_[index].child[i] = WideLeaf::kBit;
            if (!node) continue;
            wide_[index].child[i] = node->leaf() ? WideLeaf::make(node->first / block_, node->count) : index_of(places.node[i]);
            if (node->leaf()) piece.cost += share(places.node[i]) * node->count;
        }
    }

    /// The least cost of the children with so many places in all; then whether a place, and a node of its own, is cheaper.
    Joining joined(uint32_t node) const {
        const uint32_t left = nodes_[node].first;
        Joining best = nodes_[left].leaf() ? beside_leaf(joinings_[left + 1]) : nodes_[left + 1].leaf() ? above_leaf(joinings_[left]) : shared_out(joinings_[left], joinings_[left + 1]);
        best.cost[0] = float(share(node)) + best.cost[kWide - 1];
        for (uint32_t i = 1; i < kWide; ++i) {
            if (best.cost[0] < best.cost[i]) best.cost[i] = best.cost[0], best.to_left[i] = 0;
        }
        return best;
    }

    /// Of the ways that cost the same, that with the fewest places on the left.
    static Joining shared_out(const Joining& left, const Joining& right) {
        Joining best;
        best.cost[0] = std::numeric_limits<float>::infinity();
        for (uint32_t places = 2; places <= kWide; ++places) {
            best.cost[places - 1] = best.cost[places - 2], best.to_left[places - 1] = best.to_left[places - 2];
            for (uint32_t lefts = 1; lefts < places; ++lefts) {
                const float cost = left.cost[lefts - 1] + right.cost[places - lefts - 1];
                if (cost < best.cost[places - 1]) best.cost[places - 1] = cost, best.to_left[places - 1] = uint8_t(lefts);
            }
        }
        return best;
    }

    /// The same where the left child is a leaf, as of every other node: it costs nothing and takes one place, and more places never cost the right child more.
    static Joining beside_leaf(const Joining& right) {
        Joining best;
        for (uint32_t i = 1; i < kWide; ++i) best.cost[i] = right.cost[i - 1], best.to_left[i] = 1;
        return best;
    }

    /// And where the right one is a leaf.
    static Joining above_leaf(const Joining& left) {
        Joining best;
        for (uint32_t i = 1; i < kWide; ++i) best.cost[i] = left.cost[i - 1], best.to_left[i] = i == 1 || left.cost[i - 1] < left.cost[i - 2] ? uint8_t(i) : best.to_left[i - 1];
        return best;
    }

    void collect(uint32_t node, uint32_t count, Places& places) const {
        const uint32_t lefts = joinings_[node].to_left[count - 1];
        if (lefts == 0) return places.add(node);
        collect(nodes_[node].first, lefts, places), collect(nodes_[node].first + 1, count - lefts, places);
    }

    double share(uint32_t node) const { return root_area_ > 0 ? area(nodes_[node].box) / root_area_ : 1; }

    const LargeVector<BvhNode<R>>& nodes_;
    BuildStats& stats_;
    int threads_;
    uint32_t block_;
    double root_area_;
    LargeVector<Joining> joinings_;
    std::vector<uint32_t> upper_;
    std::vector<Piece> pieces_;
    LargeVector<WideNode<R>> wide_;
};

}  // namespace

template <class R> LargeVector<WideNode<R>> widened(const LargeVector<BvhNode<R>>& nodes, BuildStats& stats, int threads, uint32_t block) {
    return nodes.empty() ? LargeVector<WideNode<R>>() : Widener<R>(nodes, stats, threads, block).run();
}

template LargeVector<WideNode<float>> widened(const LargeVector<BvhNode<float>>&, BuildStats&, int, uint32_t);
template LargeVector<WideNode<double>> widened(const LargeVector<BvhNode<double>>&, BuildStats&, int, uint32_t);

}  // namespace alidade
