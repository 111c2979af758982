// SPDX-License-Identifier: Apache-2.0
/// The traversals of Intersect::robust: a file of their own, since compilers stop inlining in large ones.
#include "accel/bvh/wide_lean.h"

// This file is compiled once for each of these targets, by including itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "accel/bvh/wide_robust.cpp"
#include "hwy/foreach_target.h"
#include "accel/bvh/wide_lean-inl.h"

#if HWY_ONCE

namespace alidade {

template <> const PackedTraversals<float, TriangleTest::watertight>& wide_traversals(Isa isa) { return lean_traversals<WideNode<float>, TriangleLeaf<float, TriangleTest::watertight>>(isa); }
template <> const PackedTraversals<double, TriangleTest::watertight>& wide_traversals(Isa isa) { return lean_traversals<WideNode<double>, TriangleLeaf<double, TriangleTest::watertight>>(isa); }

}  // namespace alidade

#endif
