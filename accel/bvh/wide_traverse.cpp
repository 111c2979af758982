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

template <class R> HWY_ATTR uint32_t enter_boxes(const WideNode<R>& node, const LocalRay& ray, R limit, R* entries) {
    return VectorBoxes<R>(ray).enter(node, limit, entries);
}

template <class R> constexpr WideTraversals<R> vector_traversals() { return traversals_of<VectorMachine<R>, R, TriangleTest::exact>(); }

}  // namespace alidade::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace alidade {

namespace {

/// One box after the other, the oracle of the vector versions.
template <class R> class ScalarBoxes {
  public:
    explicit ScalarBoxes(const LocalRay& ray) : ray_(ray) {}

    R limit(double t) const { return ray_.limit(t); }

    uint32_t enter(const WideNode<R>& node, R limit, R* entries) const {
        uint32_t bits = 0;
        for (uint32_t i = 0; i < kWide; ++i) {
            const auto& p = node.planes;
            entries[i] = ray_.enter({{p[0][i], p[2][i], p[4][i]}, {p[1][i], p[3][i], p[5][i]}}, limit);
            if (entries[i] <= limit) bits |= 1u << i;
        }
        return bits;
    }

  private:
    WideRay<R> ray_;
};

template <class R> struct ScalarMachine {
    using Boxes = ScalarBoxes<R>;
    static uint32_t filter(const TriangleLeaf<R>& leaf, const TriangleBlock<R>& block, const FilterRay<R>& ray) { return leaf.filter(block, ray); }
};

template <class R> uint32_t enter_boxes_scalar(const WideNode<R>& node, const LocalRay& ray, R limit, R* entries) {
    return ScalarBoxes<R>(ray).enter(node, limit, entries);
}

template <class R> constexpr IsaRow<WideTraversals<R>> kTraversals[] = {ALIDADE_ISA_ROWS((HWY_NAMESPACE::traversals_of<ScalarMachine<R>, R, TriangleTest::exact>()), vector_traversals<R>())};
template <class R> constexpr IsaRow<WideBoxTest<R>> kBoxTests[] = {ALIDADE_ISA_ROWS(enter_boxes_scalar<R>, enter_boxes<R>)};

}  // namespace

template <> const WideTraversals<float>& wide_traversals<float>(Isa isa) { return chosen(kTraversals<float>, isa); }
template <> const WideTraversals<double>& wide_traversals<double>(Isa isa) { return chosen(kTraversals<double>, isa); }
template <> WideBoxTest<float> wide_box_test<float>(Isa isa) { return chosen(kBoxTests<float>, isa); }
template <> WideBoxTest<double> wide_box_test<double>(Isa isa) { return chosen(kBoxTests<double>, isa); }

}  // namespace alidade

#endif
