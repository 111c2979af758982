// SPDX-License-Identifier: Apache-2.0
/// Rays that go the same way, asked together: what they share of a tree is looked at once.
#pragma once

#include "accel/bvh/wide.h"
#include "accel/groups.h"

namespace alidade {

/// Makes hits[i], which are new, the first hit of rays[i], at most kGroup, bit for bit as each by itself; both are as long. False if they went different ways, and would rather be asked one by one.
template <class Node, class Leaf> using GroupTraversal = bool (*)(const WideTree<Node, Leaf>& tree, std::span<const Ray> rays, std::span<Hit> hits, WorkCounters& work, uint32_t instance);

/// The traversal for these instructions; null where rays go one by one: without fused products (isa.h), in compact trees, with other tests than exact ones, and in those of sets, where nothing was gained (bench/results/accel_peers.md).
template <class Node, class Leaf> struct GroupOf {
    static GroupTraversal<Node, Leaf> traversal(Isa) { return nullptr; }
};
template <class R> struct GroupOf<WideNode<R>, TriangleLeaf<R>> {
    static GroupTraversal<WideNode<R>, TriangleLeaf<R>> traversal(Isa isa);
};

/// Of a node's boxes: those that each ray enters by itself, those that the group may, and of each box the rays that the group says enter it.
struct GroupBoxBits {
    uint32_t alone[kGroup], together, rays[kWide];
};
/// For tests. False if the rays make no group.
template <class R> using GroupBoxTest = bool (*)(const WideNode<R>& node, std::span<const LocalRay, kGroup> rays, double size, R limit, GroupBoxBits& bits);
/// Null where there are no groups.
template <class R> GroupBoxTest<R> group_box_test(Isa isa);
template <> GroupBoxTest<float> group_box_test(Isa isa);
template <> GroupBoxTest<double> group_box_test(Isa isa);

}  // namespace alidade
