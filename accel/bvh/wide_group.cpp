// SPDX-License-Identifier: Apache-2.0
#include "accel/bvh/wide_group.h"

#include "accel/isa_table.h"

// This file is compiled once for each of these targets, by including itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "accel/bvh/wide_group.cpp"
#include "hwy/foreach_target.h"
#include "accel/bvh/wide_group-inl.h"

HWY_BEFORE_NAMESPACE();
namespace alidade::HWY_NAMESPACE {

template <class R> constexpr auto triangle_group() { return group_of<VectorMachine<R>, WideNode<R>, TriangleLeaf<R>>(); }

}  // namespace alidade::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace alidade {

namespace {

template <class R> constexpr IsaRow<GroupTraversal<WideNode<R>, TriangleLeaf<R>>> kTriangleGroups[] = {ALIDADE_ISA_ROWS(nullptr, triangle_group<R>())};

template <class R> constexpr IsaRow<GroupBoxTest<R>> kBoxTests[] = {ALIDADE_ISA_ROWS(nullptr, box_test_of<R>())};

}  // namespace

template <class R> GroupTraversal<WideNode<R>, TriangleLeaf<R>> GroupOf<WideNode<R>, TriangleLeaf<R>>::traversal(Isa isa) { return chosen(kTriangleGroups<R>, isa); }
template struct GroupOf<WideNode<float>, TriangleLeaf<float>>;
template struct GroupOf<WideNode<double>, TriangleLeaf<double>>;

template <> GroupBoxTest<float> group_box_test(Isa isa) { return chosen(kBoxTests<float>, isa); }
template <> GroupBoxTest<double> group_box_test(Isa isa) { return chosen(kBoxTests<double>, isa); }

}  // namespace alidade

#endif
