// SPDX-License-Identifier: Apache-2.0
/// The traversal of a wide BVH, compiled once for each target that wide_traverse.cpp includes (hwy/foreach_target.h).
#if defined(ALIDADE_WIDE_TRAVERSE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ALIDADE_WIDE_TRAVERSE_INL
#undef ALIDADE_WIDE_TRAVERSE_INL
#else
#define ALIDADE_WIDE_TRAVERSE_INL
#endif

#include "accel/bvh/wide.h"
#include "accel/triangles/edge_filter-inl.h"

HWY_BEFORE_NAMESPACE();
namespace alidade::HWY_NAMESPACE {

/// a > b ? a : b, and so b where one is NaN, as SlabRay::narrow wants it: x86 has an instruction for it, which Highway's Max is.
#if HWY_ARCH_X86
template <class V> HWY_INLINE HWY_ATTR V larger(V a, V b) { return hn::Max(a, b); }
template <class V> HWY_INLINE HWY_ATTR V smaller(V a, V b) { return hn::Min(a, b); }
#else
template <class V> HWY_INLINE HWY_ATTR V larger(V a, V b) { return hn::IfThenElse(hn::Gt(a, b), a, b); }
template <class V> HWY_INLINE HWY_ATTR V smaller(V a, V b) { return hn::IfThenElse(hn::Lt(a, b), a, b); }
#endif

/// A SlabRay, each number in all lanes. The operations below are those of SlabRay::enter, in their order: so is the proof of docs/numerics.md.
template <class R> class VectorBoxes {
  public:
    explicit HWY_ATTR VectorBoxes(const SlabRay<R>& ray) {
        for (int a = 0; a < 3; ++a) {
            near_plane_[a] = 2 * a + ray.negative(a), far_plane_[a] = 2 * a + !ray.negative(a);
            near_origin_[a] = hn::Set(D(), ray.near_origin(a)), far_origin_[a] = hn::Set(D(), ray.far_origin(a)), inverse_[a] = hn::Set(D(), ray.inverse(a));
        }
    }

    HWY_INLINE HWY_ATTR uint32_t enter(const WideNode<R>& node, R start, R limit, R* entries) const {
        const D d;
        const auto lanes = uint32_t(hn::Lanes(d));
        uint32_t bits = 0;
        for (uint32_t lane = 0; lane < kWide; lane += lanes) {
            const V last = hn::Set(d, limit);
            V near = hn::Set(d, start), far = last;
            for (int a = 0; a < 3; ++a) {
                near = larger(hn::Mul(hn::Sub(hn::Load(d, &node.planes[near_plane_[a]][lane]), near_origin_[a]), inverse_[a]), near);
                far = smaller(hn::Mul(hn::Sub(hn::Load(d, &node.planes[far_plane_[a]][lane]), far_origin_[a]), inverse_[a]), far);
            }
            far = hn::Add(far, hn::Mul(hn::Abs(far), hn::Set(d, kSlabPad * kUnitRoundoff<R>)));
            hn::Store(near, d, entries + lane);
            uint8_t stored[8] = {};
            hn::StoreMaskBits(d, hn::And(hn::Le(near, far), hn::Le(near, last)), stored);
            bits |= uint32_t(stored[0]) << lane;
        }
        return bits;
    }

  private:
    using D = hn::CappedTag<R, kWide>;
    using V = hn::Vec<D>;

    V near_origin_[3], far_origin_[3], inverse_[3];
    int near_plane_[3], far_plane_[3];
};

template <class R> struct VectorMachine {
    using Boxes = VectorBoxes<R>;
    template <class Leaf> static HWY_INLINE HWY_ATTR uint32_t filter(const Leaf&, const TriangleBlock<R>& block, const FilterRay<R>& ray) { return filter_block(block, ray); }
};

/// What waits on the stack: where its box is entered, as a float, above the child. Rounding to float is monotone: what is not beyond a limit stays so.
/// As signed integers they are in the order of their entries, but for negative ones among themselves.
struct WideWaiting {
    int64_t key;

    WideWaiting() = default;
    WideWaiting(uint32_t child, float entry) : key(int64_t(uint64_t(std::bit_cast<uint32_t>(entry)) << 32 | child)) {}
    uint32_t child() const { return uint32_t(uint64_t(key)); }
    float entry() const { return std::bit_cast<float>(uint32_t(uint64_t(key) >> 32)); }
};

/// Puts the nearer one last, without a branch.
HWY_INLINE HWY_ATTR void put_in_order(WideWaiting& far, WideWaiting& near) {
    const int64_t a = far.key, b = near.key;
    far.key = a > b ? a : b, near.key = a > b ? b : a;
}

/// Puts the `count` topmost in order, the nearest last.
HWY_INLINE HWY_ATTR void sort_top(WideWaiting* top, uint32_t count) {
    if (count == 3) {
        put_in_order(top[0], top[1]), put_in_order(top[1], top[2]), put_in_order(top[0], top[1]);
    } else if (count == 4) {
        put_in_order(top[0], top[1]), put_in_order(top[2], top[3]), put_in_order(top[0], top[2]), put_in_order(top[1], top[3]), put_in_order(top[1], top[2]);
    } else {
        for (uint32_t i = 1; i < count; ++i) {
            const WideWaiting moved = top[i];
            uint32_t k = i;
            for (; k > 0 && top[k - 1].key < moved.key; --k) top[k] = top[k - 1];
            top[k] = moved;
        }
    }
}

/// Puts the children whose bits are set on the stack, all but one: returns that one, the nearest if `sorted`. One or two are the common case.
template <bool sorted, class R, class Fetch>
HWY_INLINE HWY_ATTR uint32_t take_children(const WideNode<R>& node, uint32_t bits, const R* entries, WideWaiting* stack, uint32_t& waiting, const Fetch& fetch) {
    const auto next = [&]() HWY_ATTR {
        const auto i = uint32_t(std::countr_zero(bits));
        bits &= bits - 1;
        fetch(node.child[i]);
        return WideWaiting(node.child[i], float(entries[i]));
    };
    WideWaiting near = next();
    if (!bits) return near.child();
    WideWaiting far = next();
    if constexpr (sorted) put_in_order(far, near);
    WideWaiting* const top = stack + waiting;
    top[0] = far;
    if (!bits) return ++waiting, near.child();
    top[1] = near;
    uint32_t count = 2;
    do top[count++] = next();
    while (bits);
    if constexpr (sorted) sort_top(top, count);
    waiting += count - 1;
    return top[count - 1].child();
}

/// Nearer children first, where the order matters to the query. A box is skipped only if its padded entry is beyond the padded limit: at an equal t there may
/// be a lower id inside.
template <class Machine, class Query>
HWY_ATTR void wide_traverse(const WideNode<typename Query::Real>* nodes, const LocalRay& ray, Query& query, WorkCounters& work) {
    using R = typename Query::Real;
    WideWaiting stack[(kWide - 1) * kBvhDepth + kWide];
    const auto& slab = slab_of<R>(ray);
    const typename Machine::Boxes boxes(slab);
    const R start = slab.start(ray.tmin);
    R limit = slab.limit(query.limit());
    const auto& leaf = query.leaf();
    uint32_t waiting = 0, current = 0;
    uint64_t tested = 0, filtered = 0;
    const auto fetch = [&](uint32_t child) HWY_ATTR {   // what waits will be asked for soon
        const char* at = WideLeaf::is(child) ? reinterpret_cast<const char*>(&leaf.block(WideLeaf::block(child))) : reinterpret_cast<const char*>(nodes + child);
        for (int line = 0; line < 5; ++line) __builtin_prefetch(at + 64 * line);
    };
    for (;;) {
        if (!WideLeaf::is(current)) {
            const WideNode<R>& node = nodes[current];
            alignas(64) R entries[kWide];
            uint32_t bits = boxes.enter(node, start, limit, entries);
            tested += kWide;
            if (bits) {
                current = take_children<Query::kNearestFirst>(node, bits, entries, stack, waiting, fetch);
                continue;
            }
        } else {
            const uint32_t count = WideLeaf::count(current), block = WideLeaf::block(current);
            filtered += count;
            const uint32_t bits = Machine::filter(leaf, leaf.block(block), query.probe().filter) & ((2u << (count - 1)) - 1);
            if (bits) {
                if (query.decide(block, bits)) break;
                limit = slab.limit(query.limit());
            }
        }
        while (waiting && !(stack[waiting - 1].entry() <= float(limit))) --waiting;
        if (waiting == 0) break;
        current = stack[--waiting].child();
    }
    work.boxes += tested, work.filtered += filtered;
}

}  // namespace alidade::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
