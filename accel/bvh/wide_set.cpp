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

/// Most rays go to sets as they are: primitives are asked with the caller's ray anyway, so it is neither scaled nor moved.
struct LeanSetMachine : VectorSetMachine {
    template <class Leaf> static HWY_INLINE HWY_ATTR bool enter(const Ray& ray, const RayBounds& bounds, LocalRay& local) {
        return takes(ray, bounds, local) || VectorSetMachine::enter<Leaf>(ray, bounds, local);
    }

  private:
    /// False, and nothing to be used, for rays that begin before 0 or far away, or have a very small or large component: products with those may overflow or vanish.
    static HWY_INLINE HWY_ATTR bool takes(const Ray& ray, const RayBounds& bounds, LocalRay& local) {
#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3
        using L = RayLanes;
        using V = L::V;
        const L::D d;
        if (!(ray.tmin >= 0 && ray.tmin <= ray.tmax) || bounds.empty()) return false;
        const V dir = L::three(ray.dir, 1), at = L::three(ray.origin, 0), slope = hn::Abs(dir), off = hn::Abs(hn::Sub(hn::Add(at, at), hn::Load(d, bounds.doubled_middle)));
        const auto usual = hn::And(hn::Ge(slope, hn::Set(d, kSmallestSlope<float>)), hn::Le(slope, hn::Set(d, 1 / kSmallestSlope<float>)));
        const auto near = hn::And(hn::Le(off, hn::Set(d, kFar * bounds.doubled_size)), hn::Le(hn::Abs(at), hn::Set(d, kLargestCoordinate<double>)));
        if (!hn::AllTrue(d, hn::And(usual, near))) return false;
        const V inverse = hn::Div(hn::Set(d, 1), dir), e = hn::Add(hn::Mul(hn::Abs(at), hn::Set(d, 4 * kUnitRoundoff<double>)), hn::Set(d, kOriginPad<double>));
        const V a = hn::Mul(hn::Sub(hn::Load(d, bounds.low), hn::Add(at, e)), inverse), b = hn::Mul(hn::Sub(hn::Load(d, bounds.high), hn::Sub(at, e)), inverse);
        const double first = hn::GetLane(hn::MaxOfLanes(d, hn::Min(a, b))), last = SlabRay<double>::padded(hn::GetLane(hn::MinOfLanes(d, hn::Max(a, b))));
        local.tmin = 0, local.tmax = ray.tmax == std::numeric_limits<double>::infinity() ? ray.tmax : local.upper(ray.tmax);
        if (!(first <= last && last >= 0)) local.tmax = -1;
        hn::Store(at, d, &local.origin.x), hn::Store(dir, d, &local.dir.x), hn::Store(inverse, d, &local.inverse.x);
        return true;
#else
        return static_cast<void>(ray), static_cast<void>(bounds), static_cast<void>(local), false;
#endif
    }
};

constexpr SetTraversals vector_set_traversals() { return traversals_of<LeanSetMachine, WideNode<double>, CustomLeaf>(); }

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
