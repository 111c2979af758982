// SPDX-License-Identifier: Apache-2.0
/// The traversal of a wide BVH, compiled once for each target that wide_traverse.cpp includes (hwy/foreach_target.h).
#if defined(ALIDADE_WIDE_TRAVERSE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ALIDADE_WIDE_TRAVERSE_INL
#undef ALIDADE_WIDE_TRAVERSE_INL
#else
#define ALIDADE_WIDE_TRAVERSE_INL
#endif

#include "accel/bvh/compact-inl.h"
#include "accel/bvh/wide_scalar.h"
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

/// A WideRay, each number in all lanes. The operations below are those of WideRay::enter, in their order; differences and inverses have the other sign, so
/// that planes are operands from memory.
template <class R, int kUnits = kTriangleUnits> class VectorBoxes {
  public:
    explicit HWY_ATTR VectorBoxes(const LocalRay& ray) : start_(ray.tmin) {
        if (!set_sloped(ray)) set(WideRay<R, kUnits>(ray));
    }

    R limit(double t) const { return SlabRay<R>::limit(t - start_); }

    HWY_INLINE HWY_ATTR uint32_t enter(const auto& node, R limit, R* entries) const {
        const D d;
        const auto lanes = uint32_t(hn::Lanes(d));
        uint32_t bits = 0;
        for (uint32_t lane = 0; lane < kWide; lane += lanes) {
            V near = hn::Zero(d), far = hn::Set(d, limit);
            for (int a = 0; a < 3; ++a) {
                near = larger(hn::Mul(hn::Sub(near_origin_[a], load_planes(d, node, a, near_plane_[a] + lane)), near_inverse_[a]), near);
                far = smaller(hn::Mul(hn::Sub(far_origin_[a], load_planes(d, node, a, far_plane_[a] + lane)), far_inverse_[a]), far);
            }
            hn::Store(near, d, entries + lane);
            bits |= mask_bits(d, hn::Le(near, far)) << lane;
        }
        return bits & node.places();
    }

  private:
    HWY_INLINE HWY_ATTR void set(const WideRay<R, kUnits>& ray) {
        for (int a = 0; a < 3; ++a) set_axis(a, ray.negative(a), ray.near_origin(a), ray.far_origin(a), -ray.near_inverse(a), -ray.far_inverse(a));
    }
    HWY_INLINE HWY_ATTR void set_axis(int a, bool negative, R near_origin, R far_origin, R near_inverse, R far_inverse) {
        const D d;
        near_plane_[a] = size_t(2 * a + negative) * kWide, far_plane_[a] = size_t(2 * a + !negative) * kWide;
        near_origin_[a] = hn::Set(d, near_origin), far_origin_[a] = hn::Set(d, far_origin), near_inverse_[a] = hn::Set(d, near_inverse), far_inverse_[a] = hn::Set(d, far_inverse);
    }

    /// As set(WideRay), the three axes at once, where the machine has vectors of four doubles. False, and nothing done, for rays that are along an axis.
    HWY_INLINE HWY_ATTR bool set_sloped(const LocalRay& ray) {
#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3
        const hn::FixedTag<double, 4> wide;
        const hn::FixedTag<R, 4> d;
        const auto rounded = [&](auto v) HWY_ATTR {
            if constexpr (std::is_same_v<R, float>) return hn::DemoteTo(d, v);
            else return v;
        };
        const auto at = hn::Load(wide, &ray.origin.x), dir = hn::Load(wide, &ray.dir.x);
        uint8_t flat[8] = {};
        hn::StoreMaskBits(wide, hn::Lt(hn::Abs(dir), hn::Set(wide, kSmallestSlope<R>)), flat);
        if (flat[0] & 7) return false;
        const auto o = rounded(hn::Add(at, hn::Mul(hn::Set(wide, start_), dir)));
        const auto moved = hn::Add(rounded(hn::Mul(hn::Abs(at), hn::Set(wide, kUnits * kMoved))), hn::Set(d, kOriginPad<R>));
        const auto e = hn::Add(hn::Mul(hn::Abs(o), hn::Set(d, kUnits * kUnitRoundoff<R>)), moved);
        const auto inverse = rounded(hn::Load(wide, &ray.inverse.x)), outward = hn::CopySign(e, inverse), near_inverse = hn::Neg(inverse);
        alignas(32) R near_origins[4], far_origins[4], near_inverses[4], far_inverses[4];
        hn::Store(hn::Add(o, outward), d, near_origins), hn::Store(hn::Sub(o, outward), d, far_origins);
        hn::Store(near_inverse, d, near_inverses), hn::Store(hn::Mul(near_inverse, hn::Set(d, kWidened<R, kUnits>)), d, far_inverses);
        hn::StoreMaskBits(d, hn::Lt(inverse, hn::Zero(d)), flat);
        for (int a = 0; a < 3; ++a) set_axis(a, flat[0] >> a & 1, near_origins[a], far_origins[a], near_inverses[a], far_inverses[a]);
        return true;
#else
        static_cast<void>(ray);
        return false;
#endif
    }

    using D = hn::CappedTag<R, kWide>;
    using V = hn::Vec<D>;

    V near_origin_[3], far_origin_[3], near_inverse_[3], far_inverse_[3];
    size_t near_plane_[3], far_plane_[3];
    double start_;
};

template <class R> struct VectorMachine {
    using Boxes = VectorBoxes<R>;
    template <class Leaf> static HWY_INLINE HWY_ATTR decltype(auto) block(const Leaf& leaf, uint32_t number, uint32_t lanes) { return load_block(leaf.blocks(), number, lanes); }
    template <class Leaf> static HWY_INLINE HWY_ATTR uint32_t filter(const Leaf&, const TriangleBlock<R>& block, const FilterRay<R>& ray, bool near) { return filter_block(block, ray, near); }
};

/// Of sets, which are shown what is in leaves.
struct VectorSetMachine {
    using Boxes = VectorBoxes<double, kSetUnits>;
};

template <class Node, int kUnits = kTriangleUnits> HWY_ATTR uint32_t enter_boxes(const Node& node, const LocalRay& ray, typename Node::Real limit, typename Node::Real* entries) {
    return VectorBoxes<typename Node::Real, kUnits>(ray).enter(node, limit, entries);
}

/// What waits on the stack: where its box is entered, as a float, above the child. Rounding to float is monotone: what is not beyond a limit stays so.
/// As signed integers they are in the order of their entries, as none is negative.
struct WideWaiting {
    int64_t key;

    WideWaiting() = default;
    WideWaiting(uint32_t child, float entry) : key(int64_t(uint64_t(std::bit_cast<uint32_t>(entry)) << 32 | child)) {}
    uint32_t child() const { return uint32_t(uint64_t(key)); }
    bool near() const { return uint64_t(key) >> 32 == 0; }   ///< does the ray begin in the box?
};

/// The child below all that waits; no leaf (WideLeaf::kMaxBlocks).
inline constexpr uint32_t kNoChild = ~0u;

/// Not less than the key of any child that is entered at up to `limit`.
inline int64_t last_key(float limit) { return WideWaiting(~0u, limit).key; }

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
template <bool sorted, class Node>
HWY_INLINE HWY_ATTR WideWaiting take_children(const Node& node, uint32_t bits, const typename Node::Real* entries, WideWaiting*& top) {
    const auto next = [&]() HWY_ATTR {
        const auto i = size_t(std::countr_zero(bits));
        bits &= bits - 1;
        return WideWaiting(node.child[i], float(entries[i]));
    };
    WideWaiting near = next();
    if (!bits) return near;
    WideWaiting far = next();
    if constexpr (sorted) put_in_order(far, near);
    top[0] = far;
    if (!bits) return ++top, near;
    top[1] = near;
    uint32_t count = 2;
    do top[count++] = next();
    while (bits);
    if constexpr (sorted) sort_top(top, count);
    top += count - 1;
    return *top;
}

/// Nearer children first, where the order matters to the query. A box is skipped only if its padded entry is beyond the padded limit: at an equal t there may
/// be a lower id inside.
template <class Machine, class Node, class Query>
HWY_ATTR void wide_traverse(const Node* nodes, const LocalRay& ray, Query& query, WorkCounters& work) {
    using R = typename Query::Real;
    WideWaiting stack[1 + (kWide - 1) * kBvhDepth + kWide];
    const typename Machine::Boxes boxes(ray);
    R limit = boxes.limit(query.limit());
    int64_t last = last_key(float(limit));
    const auto& leaf = query.leaf();
    WideWaiting* top = stack;
    (top++)->key = std::numeric_limits<int64_t>::min() | kNoChild;
    uint32_t current = 0;
    bool near = false;   // does the ray begin in the box of `current`?
    uint64_t tested = 0, filtered = 0;
    for (;;) {
        if (!WideLeaf::is(current)) {
            const Node& node = nodes[current];
            alignas(64) R entries[kWide];
            const uint32_t bits = boxes.enter(node, limit, entries);
            tested += kWide;
            if (bits) {
                const WideWaiting next = take_children<Query::kNearestFirst>(node, bits, entries, top);
                current = next.child(), near = next.near();
                continue;
            }
        } else if constexpr (std::is_same_v<std::remove_cvref_t<decltype(leaf)>, CustomLeaf>) {
            if (query.visit(WideLeaf::block(current), WideLeaf::count(current))) break;
            limit = boxes.limit(query.limit());
            last = last_key(float(limit));
        } else {
            const uint32_t number = WideLeaf::block(current);
            uint32_t lanes = (2u << (WideLeaf::count(current) - 1)) - 1;
            if constexpr (requires { leaf.blocks().boxes(number); }) {
                alignas(64) R entries[kWide];
                lanes = boxes.enter(leaf.blocks().boxes(number), limit, entries);
                tested += kWide;
            }
            filtered += uint32_t(std::popcount(lanes));
            if (lanes) {
                const auto& block = Machine::block(leaf, number, lanes);
                const uint32_t bits = Machine::filter(leaf, block, query.probe().filter, near) & lanes;
                if (bits) {
                    if (query.decide(block, number, bits)) break;
                    limit = boxes.limit(query.limit());
                    last = last_key(float(limit));
                }
            }
        }
        do --top;
        while (top->key > last);
        current = top->child(), near = top->near();
        if (current == kNoChild) break;
    }
    work.boxes += tested, work.filtered += filtered;
}

/// The walks of a machine for each question.
template <class Machine, class Node, class Leaf> constexpr WideTraversals<Node, Leaf> traversals_of() {
    return {wide_traverse<Machine, Node, ClosestQuery<Leaf>>, wide_traverse<Machine, Node, AnyQuery<Leaf>>, wide_traverse<Machine, Node, AllQuery<Leaf>>};
}

}  // namespace alidade::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
