// SPDX-License-Identifier: Apache-2.0
#include "accel/bvh/wide.h"

#include "accel/isa_table.h"

// This file is compiled once for each of these targets, by including itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "accel/bvh/wide_traverse.cpp"
#include "hwy/foreach_target.h"
#include "accel/bvh/wide_traverse-inl.h"

HWY_BEFORE_NAMESPACE();
namespace alidade::HWY_NAMESPACE {

template <class R> constexpr PackedTraversals<R, TriangleTest::exact> vector_traversals() { return traversals_of<VectorMachine<R>, WideNode<R>, TriangleLeaf<R>>(); }

}  // namespace alidade::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace alidade {

namespace {

template <class R>
constexpr IsaRow<PackedTraversals<R, TriangleTest::exact>> kTraversals[] = {ALIDADE_ISA_ROWS((HWY_NAMESPACE::traversals_of<ScalarMachine<R>, WideNode<R>, TriangleLeaf<R>>()), vector_traversals<R>())};
template <class R> constexpr IsaRow<WideBoxTest<WideNode<R>>> kBoxTests[] = {ALIDADE_ISA_ROWS((enter_boxes_scalar<WideNode<R>>), enter_boxes<WideNode<R>>)};

}  // namespace

template <> const PackedTraversals<float, TriangleTest::exact>& wide_traversals(Isa isa) { return chosen(kTraversals<float>, isa); }
template <> const PackedTraversals<double, TriangleTest::exact>& wide_traversals(Isa isa) { return chosen(kTraversals<double>, isa); }
template <> WideBoxTest<WideNode<float>> wide_box_test(Isa isa) { return chosen(kBoxTests<float>, isa); }
template <> WideBoxTest<WideNode<double>> wide_box_test(Isa isa) { return chosen(kBoxTests<double>, isa); }

}  // namespace alidade

#endif
