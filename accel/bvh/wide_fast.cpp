// SPDX-License-Identifier: Apache-2.0
/// The traversals of Intersect::fast: a file of their own, since compilers stop inlining in large ones.
#include "accel/bvh/wide_lean.h"
#include "accel/isa_table.h"

// This file is compiled once for each of these targets, by including itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "accel/bvh/wide_fast.cpp"
#include "hwy/foreach_target.h"
#include "accel/bvh/wide_lean-inl.h"

#if HWY_ONCE

namespace alidade {

namespace {

constexpr TriangleTest kTest = TriangleTest::fast;

template <class R> constexpr IsaRow<WideTraversals<R, kTest>> kTraversals[] = {ALIDADE_ISA_ROWS((HWY_NAMESPACE::traversals_of<LeanMachine<R, kTest>, R, kTest>()), lean_traversals<R, kTest>())};

}  // namespace

template <> const WideTraversals<float, kTest>& wide_traversals(Isa isa) { return chosen(kTraversals<float>, isa); }
template <> const WideTraversals<double, kTest>& wide_traversals(Isa isa) { return chosen(kTraversals<double>, isa); }

}  // namespace alidade

#endif
