// SPDX-License-Identifier: Apache-2.0
/// The traversals over sets of primitives: instances, closed forms.
#include "accel/bvh/wide.h"

#include "accel/isa_table.h"

// This file is compiled once for each of these targets, by including itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "accel/bvh/wide_set.cpp"
#include "hwy/foreach_target.h"
#include "accel/bvh/wide_traverse-inl.h"

HWY_BEFORE_NAMESPACE();
namespace alidade::HWY_NAMESPACE {

constexpr SetTraversals vector_set_traversals() { return traversals_of<VectorSetMachine, WideNode<double>, CustomLeaf>(); }

}  // namespace alidade::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace alidade {

namespace {

struct ScalarSetMachine : ScalarEntry {
    using Boxes = ScalarBoxes<double, kSetUnits>;
};

constexpr IsaRow<SetTraversals> kTraversals[] = {ALIDADE_ISA_ROWS((HWY_NAMESPACE::traversals_of<ScalarSetMachine, WideNode<double>, CustomLeaf>()), vector_set_traversals())};

constexpr IsaRow<WideBoxTest<WideNode<double>>> kBoxTests[] = {ALIDADE_ISA_ROWS((enter_boxes_scalar<WideNode<double>, kSetUnits>), enter_boxes<WideNode<double>, kSetUnits>)};

}  // namespace

template <> const SetTraversals& wide_traversals(Isa isa) { return chosen(kTraversals, isa); }
WideBoxTest<WideNode<double>> wide_set_box_test(Isa isa) { return chosen(kBoxTests, isa); }

}  // namespace alidade

#endif
