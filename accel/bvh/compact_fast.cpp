// SPDX-License-Identifier: Apache-2.0
/// The traversals of the compact BVH for Intersect::fast.
#include "accel/bvh/compact.h"
#include "accel/bvh/wide_lean.h"

// This file is compiled once for each of these targets, by including itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "accel/bvh/compact_fast.cpp"
#include "hwy/foreach_target.h"
#include "accel/bvh/wide_lean-inl.h"

#if HWY_ONCE

namespace alidade {

template <> const CompactTraversals<TriangleTest::fast>& wide_traversals(Isa isa) { return lean_traversals<CompactNode, TriangleLeaf<float, TriangleTest::fast, NumberedBlocks>>(isa); }

}  // namespace alidade

#endif
