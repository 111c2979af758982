// SPDX-License-Identifier: Apache-2.0
#include "accel/bvh/wide.h"

// This file is compiled once for each of these targets, by including itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "accel/bvh/wide_traverse.cpp"
#include "hwy/foreach_target.h"
#include "accel/bvh/wide_traverse-inl.h"

HWY_BEFORE_NAMESPACE();
namespace alidade::HWY_NAMESPACE {

template <class R> HWY_ATTR uint32_t enter_boxes(const WideNode<R>& node, const SlabRay<R>& ray, R start, R limit, R* entries) {
    return VectorBoxes<R>(ray).enter(node, start, limit, entries);
}

template <class Machine, class R> constexpr WideTraversals<R> traversals_of() {
    return {wide_traverse<Machine, ClosestQuery<TriangleLeaf<R>>>, wide_traverse<Machine, AnyQuery<TriangleLeaf<R>>>, wide_traverse<Machine, AllQuery<TriangleLeaf<R>>>};
}

}  // namespace alidade::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace alidade {

namespace {

/// One box after the other, the oracle of the vector versions.
template <class R> class ScalarBoxes {
  public:
    explicit ScalarBoxes(const SlabRay<R>& ray) : ray_(ray) {}

    uint32_t enter(const WideNode<R>& node, R start, R limit, R* entries) const {
        uint32_t bits = 0;
        for (uint32_t i = 0; i < kWide; ++i) {
            const auto& p = node.planes;
            entries[i] = ray_.enter({{p[0][i], p[2][i], p[4][i]}, {p[1][i], p[3][i], p[5][i]}}, start, limit);
            if (entries[i] <= limit) bits |= 1u << i;
        }
        return bits;
    }

  private:
    const SlabRay<R>& ray_;
};

template <class R> struct ScalarMachine {
    using Boxes = ScalarBoxes<R>;
    static uint32_t filter(const TriangleLeaf<R>& leaf, const TriangleBlock<R>& block, const FilterRay<R>& ray) { return leaf.filter(block, ray); }
};

template <class R> uint32_t enter_boxes_scalar(const WideNode<R>& node, const SlabRay<R>& ray, R start, R limit, R* entries) {
    return ScalarBoxes<R>(ray).enter(node, start, limit, entries);
}

template <class R> struct WideEntry {
    Isa isa;
    WideTraversals<R> traversals;
    WideBoxTest<R> boxes;
};

/// What was compiled, from the plainest to the widest.
template <class R> constexpr WideEntry<R> kWideEntries[] = {
    {Isa::scalar, HWY_NAMESPACE::traversals_of<ScalarMachine<R>, R>(), enter_boxes_scalar<R>},
#if HWY_TARGETS & HWY_SSE4
    {Isa::sse4, N_SSE4::traversals_of<N_SSE4::VectorMachine<R>, R>(), N_SSE4::enter_boxes<R>},
#endif
#if HWY_TARGETS & HWY_AVX2
    {Isa::avx2, N_AVX2::traversals_of<N_AVX2::VectorMachine<R>, R>(), N_AVX2::enter_boxes<R>},
#endif
#if HWY_TARGETS & HWY_AVX3
    {Isa::avx512, N_AVX3::traversals_of<N_AVX3::VectorMachine<R>, R>(), N_AVX3::enter_boxes<R>},
#endif
};

}  // namespace

template <> const WideTraversals<float>& wide_traversals<float>(Isa isa) { return chosen(kWideEntries<float>, isa).traversals; }
template <> const WideTraversals<double>& wide_traversals<double>(Isa isa) { return chosen(kWideEntries<double>, isa).traversals; }
template <> WideBoxTest<float> wide_box_test<float>(Isa isa) { return chosen(kWideEntries<float>, isa).boxes; }
template <> WideBoxTest<double> wide_box_test<double>(Isa isa) { return chosen(kWideEntries<double>, isa).boxes; }

}  // namespace alidade

#endif
