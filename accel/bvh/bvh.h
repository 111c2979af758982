// SPDX-License-Identifier: Apache-2.0
/// Bounding volume hierarchies: binary over any primitives, eight children a node over triangles.
#pragma once

#include "accel/accelerator.h"
#include "accel/bvh/build.h"
#include "accel/bvh/bvh_file.h"
#include "accel/bvh/compact.h"
#include "accel/bvh/fast_build.h"
#include "accel/bvh/refit.h"
#include "accel/bvh/slab_pair.h"
#include "accel/bvh/wide.h"
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

template <class Leaf> class Bvh {
  public:
    using R = typename Leaf::Real;

    Bvh(BuildInput<typename Leaf::Source>& input, const AccelOptions& options, BuildStats& stats, BvhBuilder builder = BvhBuilder::sah) {
        const BvhLimits limits{Leaf::kBlock, std::max(4u, Leaf::kBlock), options.isa, 0, options.threads};
        PhaseClock clock(stats);
        auto references = bvh_references<R>(input, options.threads);
        nodes_ = builder == BvhBuilder::fast ? build_bvh_fast(std::move(references), limits, input.order, stats) : build_bvh(std::move(references), limits, input.order, stats);
        clock.ended("divide");
    }

    /// Nearer child first. A box is skipped only if its padded entry is beyond the padded limit: at an equal t there may be a lower id inside.
    template <class Query> [[gnu::always_inline]] inline void traverse(const LocalRay& ray, Query& query, WorkCounters& work) const {
        struct Waiting {
            uint32_t node;
            R entry;
        };
        Waiting stack[kBvhDepth];
        const auto slab = slab_of<R>(ray);
        const SlabPair<R> pair(slab);
        const R start = slab.start(ray.tmin);
        R limit = slab.limit(query.limit());
        Waiting current{0, start};
        for (uint32_t waiting = 0;;) {
            const BvhNode<R>& node = nodes_[current.node];
            if (!node.leaf()) {
                R entries[2];
                pair.enter(nodes_[node.first].box, nodes_[node.first + 1].box, start, limit, entries);
                Waiting near{node.first, entries[0]}, far{node.first + 1, entries[1]};
                work.boxes += 2;
                if (far.entry < near.entry) std::swap(near, far);
                if (far.entry <= limit) stack[waiting++] = far;
                current = near;
            } else {
                if (query.visit(node.first, node.count)) return;
                limit = slab.limit(query.limit());
                current.entry = std::numeric_limits<R>::infinity();
            }
            while (!(current.entry <= limit)) {
                if (waiting == 0) return;
                current = stack[--waiting];
            }
        }
    }
    /// Calls visit(first, count) for the leaves whose boxes the shaft meets, until it returns false; then that is returned.
    template <class Visit> bool visit_shaft(const Shaft& shaft, const Visit& visit) const {
        uint32_t stack[kBvhDepth + 1] = {0};   // both children of each inner node on the way, less the one that is taken
        for (uint32_t waiting = 1; waiting > 0;) {
            const BvhNode<R>& node = nodes_[stack[--waiting]];
            if (!shaft.meets(Bounds{Vec3(node.box.min), Vec3(node.box.max)})) continue;
            if (!node.leaf()) stack[waiting++] = node.first, stack[waiting++] = node.first + 1;
            else if (!visit(node.first, node.count)) return false;
        }
        return true;
    }
    template <class Visit> void visit_nodes(const Visit& visit) const {
        if (!nodes_.empty()) visit_below(0, kNoId, 0, visit);
    }
    size_t bytes() const { return nodes_.capacity() * sizeof(BvhNode<R>); }

  private:
    template <class Visit> void visit_below(uint32_t number, uint32_t parent, uint32_t depth, const Visit& visit) const {
        const BvhNode<R>& node = nodes_[number];
        const std::array<uint32_t, 2> children{node.first, node.first + 1};
        TreeNode shown{number, parent, depth, {Vec3(node.box.min), Vec3(node.box.max)}};
        shown.leaf = node.leaf();
        if (node.leaf()) return visit(shown, node.first, node.count);
        shown.children = children;
        visit(shown, 0u, 0u);
        for (const uint32_t child : children) visit_below(child, number, depth + 1, visit);
    }

    LargeVector<BvhNode<R>> nodes_;
};

/// Twice as many references are what fits in 110 bytes a triangle (tests/accel). Generated architecture takes a quarter more, the stadium a hundredth.
inline constexpr double kSplitGrowth = 1.0;

/// Eight children a node, as a Node keeps them.
template <class Leaf, class Node> class WideBvh {
    using T = typename Leaf::Real;

  public:
    static constexpr bool kWidensBoxes = true;   ///< for TriangleTest::watertight

    WideBvh(BuildInput<TriangleSource<T>>& input, const AccelOptions& options, BuildStats& stats, BvhBuilder builder = BvhBuilder::sah) : traversals_(wide_traversals<Node, Leaf>(options.isa)) {
        const double growth = builder == BvhBuilder::fast ? 0 : kSplitGrowth;
        const BvhLimits limits{kLanes, kLanes, options.isa, growth, options.threads};
        PhaseClock clock(stats);
        auto references = bvh_references<T>(input, options.threads, growth);
        const auto nodes = builder == BvhBuilder::fast ? build_bvh_fast(std::move(references), limits, input.order, stats) : build_bvh(std::move(references), limits, input.order, stats, &input.source);
        clock.ended("divide");
        if constexpr (std::is_same_v<Node, CompactNode>) nodes_ = compacted(widened(nodes, stats, options.threads), options.threads);
        else nodes_ = widened(nodes, stats, options.threads);
        clock.ended("widen");
        if (input.order.size() / kLanes >= WideLeaf::kMaxBlocks) throw std::length_error("more triangles than the tree can number");
    }

    WideBvh(LargeArray<Node> nodes, const AccelOptions& options) : nodes_(std::move(nodes)), traversals_(wide_traversals<Node, Leaf>(options.isa)) {}

    template <class Query> void traverse(const LocalRay& ray, Query& query, WorkCounters& work) const { traversals_(nodes_.data(), ray, query, work); }
    size_t bytes() const { return nodes_.bytes(); }

  protected:
    LargeArray<Node> nodes_;

  private:
    const WideTraversals<Node, Leaf>& traversals_;
};

template <class T, TriangleTest test> class Bvh<TriangleLeaf<T, test>> : public WideBvh<TriangleLeaf<T, test>, WideNode<T>> {
    using Base = WideBvh<TriangleLeaf<T, test>, WideNode<T>>;
    using Base::nodes_;

  public:
    using Base::Base;

    template <class Visit> void visit_nodes(const Visit& visit) const { visit_wide(nodes_.view(), visit); }
    /// The new cost.
    double refit(TriangleLeaf<T, test>& leaf, const TriangleSource<T>& triangles, int threads) { return refit_wide(nodes_.writable(), leaf.blocks().writable(), triangles, threads); }
    tl::expected<void, std::string> save(const std::string& path, const TriangleView& mesh, const TriangleLeaf<T, test>& leaf, const Bounds& bounds, const BuildStats& stats) const {
        return save_bvh<T>(path, mesh, nodes_.view(), leaf.blocks().view(), bounds, stats);
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
  public:
    using WideBvh<TriangleLeaf<float, test, NumberedBlocks>, CompactNode>::WideBvh;
};

template <> struct BlocksOf<CompactBvh, float> {
    using Type = NumberedBlocks;
};

}  // namespace alidade
