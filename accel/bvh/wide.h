// SPDX-License-Identifier: Apache-2.0
/// The BVH of triangles: eight boxes a node, tested at once.
#pragma once

#include "accel/bvh/build.h"
#include "accel/query.h"
#include "accel/triangles/triangle_leaf.h"

namespace alidade {

inline constexpr uint32_t kWide = 8;

/// Eight boxes plane by plane, and what is in them. Places without a child have boxes that no ray enters.
template <class R> struct alignas(64) WideNode {
    R planes[6][kWide];      ///< [2 axis]: lower ends, [2 axis + 1]: upper ends
    uint32_t child[kWide];   ///< an inner node's index, or a WideLeaf
};

/// A block of triangles in a node's place: the highest bit, the block's index, the number of its triangles less one.
struct WideLeaf {
    static constexpr uint32_t kBit = 1u << 31, kCountBits = 3;
    static constexpr size_t kMaxBlocks = size_t(1) << (31 - kCountBits);
    static_assert(kLanes == 1u << kCountBits);

    static constexpr bool is(uint32_t child) { return (child & kBit) != 0; }
    static constexpr uint32_t make(uint32_t block, uint32_t count) { return kBit | block << kCountBits | (count - 1); }
    static constexpr uint32_t block(uint32_t child) { return (child & ~kBit) >> kCountBits; }
    static constexpr uint32_t count(uint32_t child) { return (child & (kLanes - 1)) + 1; }
};

/// The binary tree with the inner nodes between joined, so that the area of all wide nodes is the least that there is. Depth-first order.
/// Replaces the nodes, depth and cost of `stats`. The same for any number of threads.
template <class R> LargeVector<WideNode<R>> widened(const LargeVector<BvhNode<R>>& nodes, BuildStats& stats, int threads = 1);

/// Shows `query` the leaves whose boxes the ray enters.
template <class Query> using WideTraversal = void (*)(const WideNode<typename Query::Real>* nodes, const LocalRay& ray, Query& query, WorkCounters& work);

/// The traversals for each question on one kind of machine. All test the same boxes, bit for bit, in the same order.
template <class R> struct WideTraversals {
    WideTraversal<ClosestQuery<TriangleLeaf<R>>> closest;
    WideTraversal<AnyQuery<TriangleLeaf<R>>> any;
    WideTraversal<AllQuery<TriangleLeaf<R>>> all;

    void operator()(const WideNode<R>* nodes, const LocalRay& ray, ClosestQuery<TriangleLeaf<R>>& query, WorkCounters& work) const { closest(nodes, ray, query, work); }
    void operator()(const WideNode<R>* nodes, const LocalRay& ray, AnyQuery<TriangleLeaf<R>>& query, WorkCounters& work) const { any(nodes, ray, query, work); }
    void operator()(const WideNode<R>* nodes, const LocalRay& ray, AllQuery<TriangleLeaf<R>>& query, WorkCounters& work) const { all(nodes, ray, query, work); }
};

/// Those for these instructions, as edge_filter() chooses.
template <class R> const WideTraversals<R>& wide_traversals(Isa isa);
template <> const WideTraversals<float>& wide_traversals<float>(Isa isa);
template <> const WideTraversals<double>& wide_traversals<double>(Isa isa);

/// Which of the eight boxes the ray enters, not before `start` nor beyond `limit`, and where: SlabRay::enter for each. For tests.
template <class R> using WideBoxTest = uint32_t (*)(const WideNode<R>& node, const SlabRay<R>& ray, R start, R limit, R* entries);
template <class R> WideBoxTest<R> wide_box_test(Isa isa);
template <> WideBoxTest<float> wide_box_test<float>(Isa isa);
template <> WideBoxTest<double> wide_box_test<double>(Isa isa);

}  // namespace alidade
