// SPDX-License-Identifier: Apache-2.0
/// Bounding volume hierarchies of eight children a node.
#pragma once

#include "accel/accelerator.h"
#include "accel/bvh/build.h"
#include "accel/bvh/bvh_file.h"
#include "accel/bvh/compact.h"
#include "accel/bvh/fast_build.h"
#include "accel/bvh/refit.h"
#include "accel/bvh/watertight_boxes.h"
#include "accel/bvh/wide.h"
#include "accel/bvh/wide_group.h"
#include "accel/bvh/wide_nodes.h"
#include "accel/query.h"
#include "accel/shaft.h"
#include "core/parallel.h"

#include <stdexcept>

namespace alidade {

/// Boxes of what goes into the tree, with room for more of them. They are exact: a leaf's Real holds its bounds.
template <class R, class Source> LargeVector<BvhReference<R>> bvh_references(BuildInput<Source>& input, int threads, double growth = 0) {
    LargeVector<BvhReference<R>> references;
    references.reserve(input.ids.size() + size_t(growth * double(input.ids.size())));
    references.resize(input.ids.size());
    for_ranges(input.ids.size(), threads, [&](size_t first, size_t end) {
        for (size_t i = first; i < end; ++i) references[i] = {box_of<R>(input.source, input.ids[i]), input.ids[i]};
    });
    input.ids = {};
    return references;
}

/// How the tree is made: by the surface area heuristic, or fast (bvh/fast_build.h).
enum class BvhBuilder { sah, fast };

/// Twice as many references are what fits in 110 bytes a triangle (tests/accel). Generated architecture takes a third more, the stadium a fiftieth.
inline constexpr double kSplitGrowth = 1.0;
/// Sides without overlap are easier to divide further, which the heuristic does not foresee. In the stadium and among needles a ray meets a third fewer triangles with it than with 1, in the forest 5 % fewer, for 10 %
/// more memory; 1.4 and 2 are no better.
inline constexpr double kPlaneFavour = 1.2;
/// More is built more slowly, and architecture's rays are 1.7 times as fast with this as without.
inline constexpr double kPresplitGrowth = 0.1;

/// Primitives of a set that are as few are always divided by the surface area heuristic: a ray that enters an instance in vain pays for more than the tree gains by being built fast.
inline constexpr size_t kSmallSet = size_t(1) << 16;

/// Eight children a node, as a Node keeps them.
template <class Leaf, class Node> class WideBvh {
    using T = typename Leaf::Real;

  public:
    static constexpr bool kWidensBoxes = true;   ///< for TriangleTest::watertight

    WideBvh(BuildInput<typename Leaf::Source>& input, const AccelOptions& options, BuildStats& stats, BvhBuilder builder = BvhBuilder::sah) : traversals_(wide_traversals<Node, Leaf>(options.isa)), group_(GroupOf<Node, Leaf>::traversal(options.isa)) {
        if (!triangles(input) && input.ids.size() <= kSmallSet) builder = BvhBuilder::sah;
        const double growth = !triangles(input) ? 0 : builder == BvhBuilder::fast ? kPresplitGrowth : kSplitGrowth;
        const double favour = std::is_same_v<Node, CompactNode> ? 1 : kPlaneFavour;   // a compact tree is chosen for its memory
        const bool alone = !triangles(input) && input.ids.size() <= kWide;   // the root has a place for each primitive
        const BvhLimits limits{Leaf::kBlock, alone ? 1 : std::max(4u, Leaf::kBlock), options.isa, growth, options.threads, kSahDepth, favour};
        PhaseClock clock(stats);
        auto references = bvh_references<T>(input, options.threads, growth);
        const auto nodes = builder == BvhBuilder::fast ? build_bvh_fast(std::move(references), limits, input.order, stats, triangles(input)) : build_bvh(std::move(references), limits, input.order, stats, triangles(input));
        clock.ended("divide");
        auto wide = widened(nodes, stats, options.threads, Leaf::kBlock);
        if constexpr (is_watertight<Leaf>) make_watertight<T>(wide, options.threads, input.source, input.order);
        if constexpr (std::is_same_v<Node, CompactNode>) nodes_ = compacted(wide, options.threads);
        else nodes_ = std::move(wide);
        clock.ended("widen");
        if constexpr (std::is_same_v<Leaf, CustomLeaf>) {
            if (nodes_.size() == 1 && places_of(nodes_[0]) == 1 && WideLeaf::is(nodes_[0].child[0])) lone_ = nodes_[0].child[0];
        }
        if (input.order.size() / Leaf::kBlock >= WideLeaf::kMaxBlocks) throw std::length_error("more primitives than the tree can number");
    }

    /// Of nodes that were saved. `watertight`: their boxes are those of make_watertight(), which other tests may have as well.
    WideBvh(LargeArray<Node> nodes, bool watertight, const AccelOptions& options) : nodes_(std::move(nodes)), watertight_(watertight), traversals_(wide_traversals<Node, Leaf>(options.isa)), group_(GroupOf<Node, Leaf>::traversal(options.isa)) {}

    WideTree<Node, Leaf> tree(const Leaf& leaf, const RayBounds& bounds, uint32_t unbounded) const { return {nodes_.data(), leaf, bounds, unbounded, lone_}; }
    const WideTraversals<Node, Leaf>& traversals() const { return traversals_; }
    /// Of rays together, or null.
    GroupTraversal<Node, Leaf> group() const { return group_; }
    size_t bytes() const { return nodes_.bytes(); }

  protected:
    LargeArray<Node> nodes_;
    bool watertight_ = is_watertight<Leaf>;

  private:
    /// To be cut by planes.
    static const TriangleSource<T>* triangles(const BuildInput<typename Leaf::Source>& input) {
        if constexpr (std::is_same_v<typename Leaf::Source, TriangleSource<T>>) return &input.source;
        else return nullptr;
    }

    uint32_t lone_ = 0;   ///< WideTree::lone
    const WideTraversals<Node, Leaf>& traversals_;
    GroupTraversal<Node, Leaf> group_;
};

template <class Leaf> class Bvh;

/// Of a set: instances, closed forms.
template <> class Bvh<CustomLeaf> : public WideBvh<CustomLeaf, WideNode<double>> {
  public:
    using WideBvh<CustomLeaf, WideNode<double>>::WideBvh;

    /// Calls visit(first, count) for the leaves whose boxes the shaft meets, until it returns false; then that is returned.
    template <class Visit> bool visit_shaft(const Shaft& shaft, const Visit& visit) const {
        uint32_t stack[1 + (kWide - 1) * kBvhDepth + kWide] = {0};
        for (uint32_t waiting = 1; waiting > 0;) {
            const WideNode<double>& node = nodes_[stack[--waiting]];
            for (uint32_t i = 0; i < kWide; ++i) {
                const uint32_t child = node.child[i];
                if (vacant(node, i) || !shaft.meets(box_at(node, i))) continue;
                if (!WideLeaf::is(child)) stack[waiting++] = child;
                else if (!visit(WideLeaf::block(child), WideLeaf::count(child))) return false;
            }
        }
        return true;
    }
    template <class Visit> void visit_nodes(const Visit& visit) const { visit_wide(nodes_.view(), CustomLeaf::kBlock, visit); }
};

template <class T, TriangleTest test> class Bvh<TriangleLeaf<T, test>> : public WideBvh<TriangleLeaf<T, test>, WideNode<T>> {
    using Base = WideBvh<TriangleLeaf<T, test>, WideNode<T>>;
    using Base::nodes_, Base::watertight_;

  public:
    using Base::Base;

    template <class Visit> void visit_nodes(const Visit& visit) const { visit_wide(nodes_.view(), kLanes, visit); }
    /// The new cost.
    double refit(TriangleLeaf<T, test>& leaf, const TriangleSource<T>& triangles, int threads) {
        const double cost = refit_wide(nodes_.writable(), leaf.blocks().writable(), triangles, threads);
        watertight_ = is_watertight<TriangleLeaf<T, test>>;
        if (watertight_) make_watertight(nodes_.writable(), threads, leaf.blocks().view());
        return cost;
    }
    tl::expected<void, std::string> save(const std::string& path, const TriangleView& mesh, const TriangleLeaf<T, test>& leaf, const Bounds& bounds, const BuildStats& stats) const {
        return save_bvh<T>(path, mesh, nodes_.view(), leaf.blocks().view(), bounds, stats, watertight_);
    }
};

template <class Leaf> class FastBvh : public Bvh<Leaf> {
  public:
    FastBvh(BuildInput<typename Leaf::Source>& input, const AccelOptions& options, BuildStats& stats) : Bvh<Leaf>(input, options, stats, BvhBuilder::fast) {}
};

/// In little memory over triangles in float; else a Bvh.
template <class Leaf> class CompactBvh : public Bvh<Leaf> {
  public:
    using Bvh<Leaf>::Bvh;
};

template <TriangleTest test> class CompactBvh<TriangleLeaf<float, test, NumberedBlocks>> : public WideBvh<TriangleLeaf<float, test, NumberedBlocks>, CompactNode> {
    using Base = WideBvh<TriangleLeaf<float, test, NumberedBlocks>, CompactNode>;
    using Base::nodes_;

  public:
    using Base::Base;

    /// The leaves by the numbers of their blocks, whose sizes differ.
    void settle(NumberedBlocks& blocks) {
        for (CompactNode& node : nodes_.writable()) {
            for (uint32_t i = 0; i < kWide; ++i)
                if ((node.places() >> i & 1) && WideLeaf::is(node.child[i])) node.child[i] = WideLeaf::make(checked(blocks.number(WideLeaf::block(node.child[i]))), WideLeaf::count(node.child[i]));
        }
        blocks.forget_order();
    }

  private:
    static uint32_t checked(uint32_t number) {
        if (number >= WideLeaf::kMaxBlocks) throw std::length_error("more primitives than the tree can number");
        return number;
    }
};

template <> struct BlocksOf<CompactBvh, float> {
    using Type = NumberedBlocks;
};

}  // namespace alidade
