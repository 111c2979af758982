// SPDX-License-Identifier: Apache-2.0
/// A wide BVH as a tree: what is at its places, and a walk through all of it.
#pragma once

#include "accel/bvh/wide.h"

#include <array>
#include <span>

namespace alidade {

template <class R> BoundsT<R> box_at(const WideNode<R>& node, uint32_t place) {
    const auto& p = node.planes;
    return {{p[0][place], p[2][place], p[4][place]}, {p[1][place], p[3][place], p[5][place]}};
}

template <class R> void set_box(WideNode<R>& node, uint32_t place, const BoundsT<R>& box) {
    for (int a = 0; a < 3; ++a) node.planes[2 * a][place] = box.min[a], node.planes[2 * a + 1][place] = box.max[a];
}

template <class R> bool vacant(const WideNode<R>& node, uint32_t place) { return node.child[place] == WideLeaf::kBit && box_at(node, place).empty(); }

template <class R> uint32_t places_of(const WideNode<R>& node) {
    uint32_t count = 0;
    for (uint32_t i = 0; i < kWide; ++i) count += !vacant(node, i);
    return count;
}

/// The box of all places; those without a child change nothing.
template <class R> BoundsT<R> box_of(const WideNode<R>& node) {
    BoundsT<R> box;
    for (uint32_t i = 0; i < kWide; ++i) box.extend(box_at(node, i));
    return box;
}

/// Calls visit(TreeNode, first, count), the last two for leaves, for the inner node `shown` and all below it. A leaf is numbered by its block, of `block` places, behind the inner nodes.
template <class R, class Visit> void visit_wide(std::span<const WideNode<R>> nodes, TreeNode shown, uint32_t block, const Visit& visit) {
    const WideNode<R>& node = nodes[shown.number];
    std::array<uint32_t, kWide> places{}, children{};
    uint32_t count = 0;
    for (uint32_t i = 0; i < kWide; ++i) {
        const uint32_t child = node.child[i];
        if (!vacant(node, i)) places[count] = i, children[count++] = WideLeaf::is(child) ? uint32_t(nodes.size()) + WideLeaf::block(child) : child;
    }
    shown.children = std::span(children).first(count);
    visit(shown, 0u, 0u);
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t child = node.child[places[i]];
        const BoundsT<R> box = box_at(node, places[i]);
        TreeNode below{children[i], shown.number, shown.depth + 1, {Vec3(box.min), Vec3(box.max)}};
        below.leaf = WideLeaf::is(child);
        if (below.leaf) visit(below, WideLeaf::block(child) * block, WideLeaf::count(child));
        else visit_wide(nodes, below, block, visit);
    }
}

/// The same from the root on.
template <class R, class Visit> void visit_wide(std::span<const WideNode<R>> nodes, uint32_t block, const Visit& visit) {
    if (nodes.empty()) return;
    const BoundsT<R> box = box_of(nodes[0]);
    visit_wide(nodes, TreeNode{0, kNoId, 0, {Vec3(box.min), Vec3(box.max)}}, block, visit);
}

}  // namespace alidade
