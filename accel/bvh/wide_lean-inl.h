// SPDX-License-Identifier: Apache-2.0
/// What the traversal of a wide BVH asks with Intersect::robust and fast, compiled once for each target that wide_robust.cpp and wide_fast.cpp include (hwy/foreach_target.h).
#if defined(ALIDADE_WIDE_LEAN_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ALIDADE_WIDE_LEAN_INL
#undef ALIDADE_WIDE_LEAN_INL
#else
#define ALIDADE_WIDE_LEAN_INL
#endif

#include "accel/bvh/wide_lean.h"
#include "accel/bvh/wide_traverse-inl.h"
#include "accel/isa_table.h"
#include "accel/triangles/moller_trumbore-inl.h"
#include "accel/triangles/watertight-inl.h"

HWY_BEFORE_NAMESPACE();
namespace alidade::HWY_NAMESPACE {

/// LeanBoxes, eight at once: the operations are those, in their order.
template <class R, TriangleTest test> class LeanVectorBoxes {
  public:
    HWY_INLINE HWY_ATTR LeanVectorBoxes(const LocalRay& ray, double) {
        const SlabRay<R> slab = slab_of<R>(ray);
        start_ = slab.start(ray.tmin);
        for (int a = 0; a < 3; ++a) {
            near_plane_[a] = size_t(2 * a + slab.negative(a)) * kWide, far_plane_[a] = size_t(2 * a + !slab.negative(a)) * kWide;
            near_origin_[a] = hn::Set(D(), lean_origin<R, test>(slab, ray, a, true)), far_origin_[a] = hn::Set(D(), lean_origin<R, test>(slab, ray, a, false));
            inverse_[a] = hn::Set(D(), slab.inverse(a));
        }
    }

    R limit(double t) const { return SlabRay<R>::limit(t) - start_; }

    HWY_INLINE HWY_ATTR uint32_t enter(const auto& node, R limit, R* entries) const {
        const D d;
        const auto lanes = uint32_t(hn::Lanes(d));
        uint32_t bits = 0;
        for (uint32_t lane = 0; lane < kWide; lane += lanes) {
            const V start = hn::Set(d, start_);
            V near = start, far = hn::Set(d, std::numeric_limits<R>::max());
            for (int a = 0; a < 3; ++a) {
                near = larger(hn::Mul(hn::Sub(load_planes(d, node, a, near_plane_[a] + lane), near_origin_[a]), inverse_[a]), near);
                const V origin = test == TriangleTest::fast ? near_origin_[a] : far_origin_[a];   // the same there: fewer registers
                far = smaller(hn::Mul(hn::Sub(load_planes(d, node, a, far_plane_[a] + lane), origin), inverse_[a]), far);
            }
            const V entry = hn::Sub(near, start);
            hn::Store(entry, d, entries + lane);
            bits |= mask_bits(d, hn::And(hn::Le(near, far), hn::Le(entry, hn::Set(d, limit)))) << lane;
        }
        return bits & node.places();
    }

  private:
    using D = hn::CappedTag<R, kWide>;
    using V = hn::Vec<D>;

    R start_;
    V near_origin_[3], far_origin_[3], inverse_[3];
    size_t near_plane_[3], far_plane_[3];
};

template <class R, TriangleTest test> struct LeanVectorMachine : VectorEntry {
    using Boxes = LeanVectorBoxes<R, test>;
    template <class Leaf> static HWY_INLINE HWY_ATTR decltype(auto) block(const Leaf& leaf, uint32_t number, uint32_t lanes) { return load_block(leaf.blocks(), number, lanes); }
    template <class Leaf> static HWY_INLINE HWY_ATTR uint32_t filter(const Leaf&, const TriangleBlock<R>& block, const auto& ray, bool near) {
        if constexpr (test == TriangleTest::fast) return fast_block(block, ray, near);
        else return watertight_block(block, ray, near);
    }
};

template <class Node, class Leaf> constexpr WideTraversals<Node, Leaf> lean_traversals() { return traversals_of<LeanVectorMachine<typename Node::Real, Leaf::kTest>, Node, Leaf>(); }

}  // namespace alidade::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

#if HWY_ONCE
namespace alidade {
template <class Node, class Leaf>
constexpr IsaRow<WideTraversals<Node, Leaf>> kLeanTraversals[] = {ALIDADE_ISA_ROWS((HWY_NAMESPACE::traversals_of<LeanMachine<typename Node::Real, Leaf::kTest>, Node, Leaf>()), lean_traversals<Node, Leaf>())};
template <class Node, class Leaf> const WideTraversals<Node, Leaf>& lean_traversals(Isa isa) { return chosen(kLeanTraversals<Node, Leaf>, isa); }
}
#endif
