// SPDX-License-Identifier: Apache-2.0
#include "accel/bvh/refit.h"

#include "accel/bvh/wide_nodes.h"
#include "core/parallel.h"

#include <algorithm>

namespace alidade {
namespace {

/// Nodes that one call of a thread handles: some ten thousand triangles.
constexpr size_t kAtOnce = 256;

template <class R> void refit_leaves(WideNode<R>& node, std::span<TriangleBlock<R>> blocks, const TriangleSource<R>& triangles) {
    for (uint32_t i = 0; i < kWide; ++i) {
        if (vacant(node, i) || !WideLeaf::is(node.child[i])) continue;
        TriangleBlock<R>& block = blocks[WideLeaf::block(node.child[i])];
        BoundsT<R> box;
        for (uint32_t lane = 0; lane < WideLeaf::count(node.child[i]); ++lane) {
            block.put(triangles.corners(block.id[lane]), lane);
            box.extend(triangles.box(block.id[lane]));
        }
        set_box(node, i, box);
    }
}

template <class R> double cost_of(std::span<const WideNode<R>> nodes) {
    const double root = area(box_of(nodes[0])), whole = root > 0 ? root : 1;
    const auto share = [&](const BoundsT<R>& box) { return root > 0 ? area(box) / whole : 1; };
    double cost = share(box_of(nodes[0])) * places_of(nodes[0]);
    for (const WideNode<R>& node : nodes) {
        for (uint32_t i = 0; i < kWide; ++i) {
            const uint32_t child = node.child[i];
            if (!vacant(node, i)) cost += share(box_at(node, i)) * (WideLeaf::is(child) ? WideLeaf::count(child) : places_of(nodes[child]));
        }
    }
    return cost;
}

}  // namespace

template <class R> double refit_wide(std::span<WideNode<R>> nodes, std::span<TriangleBlock<R>> blocks, const TriangleSource<R>& triangles, int threads) {
    if (nodes.empty()) return 0;
    parallel_for((nodes.size() + kAtOnce - 1) / kAtOnce, threads, [&](size_t part) {
        for (size_t i = part * kAtOnce; i < std::min(nodes.size(), (part + 1) * kAtOnce); ++i) refit_leaves(nodes[i], blocks, triangles);
    });
    // One thread: there is an inner node for some forty triangles.
    for (size_t n = nodes.size(); n-- > 0;) {
        for (uint32_t i = 0; i < kWide; ++i)
            if (!WideLeaf::is(nodes[n].child[i])) set_box(nodes[n], i, box_of(nodes[nodes[n].child[i]]));
    }
    return cost_of(std::span<const WideNode<R>>(nodes));
}

template double refit_wide(std::span<WideNode<float>>, std::span<TriangleBlock<float>>, const TriangleSource<float>&, int);
template double refit_wide(std::span<WideNode<double>>, std::span<TriangleBlock<double>>, const TriangleSource<double>&, int);

}  // namespace alidade
