// SPDX-License-Identifier: Apache-2.0
/// The traversals of the compact BVH for Intersect::exact.
#include "accel/bvh/compact.h"
#include "accel/isa_table.h"

// This file is compiled once for each of these targets, by including itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "accel/bvh/compact_exact.cpp"
#include "hwy/foreach_target.h"
#include "accel/bvh/wide_traverse-inl.h"

HWY_BEFORE_NAMESPACE();
namespace alidade::HWY_NAMESPACE {

constexpr CompactTraversals<TriangleTest::exact> vector_traversals() { return traversals_of<VectorMachine<float>, CompactNode, TriangleLeaf<float, TriangleTest::exact, NumberedBlocks>>(); }

}  // namespace alidade::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace alidade {

namespace {

constexpr IsaRow<CompactTraversals<TriangleTest::exact>> kTraversals[] = {
    ALIDADE_ISA_ROWS((HWY_NAMESPACE::traversals_of<ScalarMachine<float>, CompactNode, TriangleLeaf<float, TriangleTest::exact, NumberedBlocks>>()), vector_traversals())};
constexpr IsaRow<WideBoxTest<CompactNode>> kBoxTests[] = {ALIDADE_ISA_ROWS(enter_boxes_scalar<CompactNode>, enter_boxes<CompactNode>)};

}  // namespace

template <> const CompactTraversals<TriangleTest::exact>& wide_traversals(Isa isa) { return chosen(kTraversals, isa); }
template <> WideBoxTest<CompactNode> wide_box_test(Isa isa) { return chosen(kBoxTests, isa); }

}  // namespace alidade

#endif
