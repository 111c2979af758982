// SPDX-License-Identifier: Apache-2.0
/// BVHs over triangles in files that can be traced where they are mapped: docs/accelerators.md, "Structures in files".
#pragma once

#include "accel/bvh/wide.h"
#include "core/large_array.h"

namespace alidade {

template <class R> struct BvhParts {
    LargeArray<WideNode<R>> nodes;
    LargeArray<TriangleBlock<R>> blocks;
    Bounds bounds;
    BuildStats stats;
    bool watertight = false;   ///< are the boxes those of make_watertight()?
};

/// Errors are sentences.
template <class R>
tl::expected<void, std::string> save_bvh(const std::string& path, const TriangleView& mesh, std::span<const WideNode<R>> nodes, std::span<const TriangleBlock<R>> blocks, const Bounds& bounds, const BuildStats& stats, bool watertight);
/// Nothing in the parts leads out of them, or out of the mesh.
template <class R> tl::expected<BvhParts<R>, std::string> load_bvh(const std::string& path, const TriangleView& mesh);

}  // namespace alidade
