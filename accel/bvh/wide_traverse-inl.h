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
#include "accel/local_ray-inl.h"
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

/// Where the first planes of the near ends of three axes stand in a node, then those of the far ends, by the signs of a direction: bit a is set if axis a is negative.
inline constexpr auto kPlaneOrders = [] {
    std::array<std::array<size_t, 6>, 8> orders{};
    for (size_t signs = 0; signs < 8; ++signs)
        for (size_t a = 0; a < 3; ++a) {
            const size_t negative = signs >> a & 1;
            orders[signs][a] = (2 * a + negative) * kWide, orders[signs][3 + a] = (2 * a + 1 - negative) * kWide;
        }
    return orders;
}();

#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3
inline constexpr bool kFuses = true;
#else
inline constexpr bool kFuses = false;
#endif

template <class R> class GroupBoxes;

/// A WideRay: the operations are those of WideRay::enter, in their order.
template <class R, int kUnits = kTriangleUnits> class VectorBoxes {
  public:
    HWY_INLINE HWY_ATTR VectorBoxes(const LocalRay& ray, double size) : start_(ray.tmin) {
        if (!set_sloped(ray, size)) set(WideRay<R, kUnits>(ray, size, kFuses));
    }

    R limit(double t) const { return SlabRay<R>::limit(t - start_); }

    HWY_INLINE HWY_ATTR uint32_t enter(const auto& node, R limit, R* entries) const {
        if constexpr (!kFuses) return enter_by<false>(node, limit, entries);
        if (fused_) [[likely]] return enter_by<true>(node, limit, entries);
        return enter_unfused(node, limit, entries);
    }

  private:
    friend class GroupBoxes<R>;

    template <bool fused> HWY_INLINE HWY_ATTR uint32_t enter_by(const auto& node, R limit, R* entries) const {
        const D d;
        const auto lanes = uint32_t(hn::Lanes(d));
        const auto end = [&](V planes, R origin, R inverse) HWY_ATTR {
            if constexpr (fused) return hn::MulAdd(planes, hn::Set(d, inverse), hn::Set(d, origin));
            else return hn::Mul(hn::Sub(planes, hn::Set(d, origin)), hn::Set(d, inverse));
        };
        uint32_t bits = 0;
        for (uint32_t lane = 0; lane < kWide; lane += lanes) {
            V near = hn::Zero(d), far = hn::Set(d, limit);
            for (int a = 0; a < 3; ++a) {
                near = larger(end(load_planes(d, node, a, planes_[a] + lane), near_origin_[a], near_inverse_[a]), near);
                far = smaller(end(load_planes(d, node, a, planes_[3 + a] + lane), far_origin_[a], far_inverse_[a]), far);
            }
            hn::Store(near, d, entries + lane);
            bits |= mask_bits(d, hn::Le(near, far)) << lane;
        }
        return bits & node.places();
    }
    /// Not among the nodes of most rays.
    HWY_NOINLINE HWY_ATTR uint32_t enter_unfused(const auto& node, R limit, R* entries) const { return enter_by<false>(node, limit, entries); }

    HWY_NOINLINE HWY_ATTR void set(const WideRay<R, kUnits>& ray) {
        uint32_t negative = 0;
        fused_ = ray.fused();
        for (int a = 0; a < 3; ++a) {
            near_inverse_[a] = ray.near_inverse(a), far_inverse_[a] = ray.far_inverse(a);
            near_origin_[a] = fused_ ? -(ray.near_origin(a) * near_inverse_[a]) : ray.near_origin(a), far_origin_[a] = fused_ ? -(ray.far_origin(a) * far_inverse_[a]) : ray.far_origin(a);
            negative |= uint32_t(ray.negative(a)) << a;
        }
        planes_ = kPlaneOrders[negative].data();
    }

    /// As set(WideRay), the three axes at once, of a ray that is along no axis and whose ends are fused. False, and nothing done, for others.
    HWY_INLINE HWY_ATTR bool set_sloped(const LocalRay& ray, double size) {
#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3
        using Fused = FusedSlab<R>;
        const hn::FixedTag<double, 4> wide;
        const hn::FixedTag<R, 4> d;
        const auto rounded = [&](auto v) HWY_ATTR {
            if constexpr (std::is_same_v<R, float>) return hn::DemoteTo(d, v);
            else return v;
        };
        const auto at = hn::Load(wide, &ray.origin.x), dir = hn::Load(wide, &ray.dir.x);
        const auto o = rounded(hn::Add(at, hn::Mul(hn::Set(wide, start_), dir)));
        const auto moved = hn::Add(rounded(hn::Mul(hn::Abs(at), hn::Set(wide, kUnits * kMoved))), hn::Set(d, Fused::kPad));
        const auto e = hn::Add(hn::Mul(hn::Abs(o), hn::Set(d, (kUnits + 1) * kUnitRoundoff<R>)), moved);
        const uint32_t others = mask_bits(wide, hn::Lt(hn::Abs(dir), hn::Set(wide, 1 / double(Fused::kFlatInverse)))) | mask_bits(d, hn::Gt(hn::Max(hn::Abs(o), e), hn::Set(d, Fused::kLargest)));
        if ((others & 7) != 0 || size < Fused::kLeastSize) return false;
        const auto inverse = hn::IfThenElse(hn::FirstN(d, 3), rounded(hn::Load(wide, &ray.inverse.x)), hn::Set(d, 1)), outward = hn::CopySign(e, inverse);
        const auto far_inverse = hn::Mul(inverse, hn::Set(d, kWidened<R, kUnits>));
        hn::Store(hn::Neg(hn::Mul(hn::Add(o, outward), inverse)), d, near_origin_), hn::Store(hn::Neg(hn::Mul(hn::Sub(o, outward), far_inverse)), d, far_origin_);
        hn::Store(inverse, d, near_inverse_), hn::Store(far_inverse, d, far_inverse_);
        planes_ = kPlaneOrders[mask_bits(d, hn::Lt(inverse, hn::Zero(d))) & 7].data();
        fused_ = true;
        return true;
#else
        static_cast<void>(ray), static_cast<void>(size);
        return false;
#endif
    }

    /// Of sets four at once: what is below them is in float, and vectors of 512 bits slow down what follows (-mprefer-vector-width in cmake/folder.cmake).
    using D = hn::CappedTag<R, kUnits == kSetUnits ? 4 : kWide>;
    using V = hn::Vec<D>;

    alignas(32) R near_origin_[4], far_origin_[4], near_inverse_[4], far_inverse_[4];   // spread over lanes where they are used: to read one of them to all lanes is no slower. Fused: what is added, -(origin inverse)
    const size_t* planes_;
    double start_;
    bool fused_;
};

/// Makes the ray ready, in vectors. False: it hits nothing.
struct VectorEntry {
    template <class Leaf> static HWY_INLINE HWY_ATTR bool enter(const Ray& ray, const RayBounds& bounds, LocalRay& local) {
        constexpr double largest = kLargestCoordinate<typename Leaf::Real>;
#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3
        if (ray.tmin <= ray.tmax && !bounds.empty() && local_ray_lanes(ray, bounds, kWideEntry<Leaf>, largest, local)) return true;
#endif
        if (!can_hit(ray, largest)) return false;
        if (!bounds.empty()) local = local_ray(ray, bounds, kWideEntry<Leaf>, Isa::scalar);
        return true;
    }
};

template <class R> struct VectorMachine : VectorEntry {
    using Boxes = VectorBoxes<R>;
    template <class Leaf> static HWY_INLINE HWY_ATTR decltype(auto) block(const Leaf& leaf, uint32_t number, uint32_t lanes) { return load_block(leaf.blocks(), number, lanes); }
    template <class Leaf> static HWY_INLINE HWY_ATTR uint32_t filter(const Leaf&, const TriangleBlock<R>& block, const FilterRay<R>& ray, bool near) { return filter_block(block, ray, near); }
};

/// Of sets, which are shown what is in leaves.
struct VectorSetMachine : VectorEntry {
    using Boxes = VectorBoxes<double, kSetUnits>;
};

template <class Node, int kUnits = kTriangleUnits> HWY_ATTR uint32_t enter_boxes(const Node& node, const LocalRay& ray, double size, typename Node::Real limit, typename Node::Real* entries) {
    return VectorBoxes<typename Node::Real, kUnits>(ray, size).enter(node, limit, entries);
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

/// Of the lowest bit.
template <class Node> HWY_INLINE HWY_ATTR WideWaiting child_at(const Node& node, uint32_t bits, const typename Node::Real* entries) {
    const auto i = size_t(std::countr_zero(bits));
    return {node.child[i], float(entries[i])};
}

/// Puts the children whose bits are set on the stack, all but one: returns that one, the nearest if `sorted`. One or two are the common case.
template <bool sorted, class Node>
HWY_INLINE HWY_ATTR WideWaiting take_children(const Node& node, uint32_t bits, const typename Node::Real* entries, WideWaiting*& top) {
    WideWaiting near = child_at(node, bits, entries);
    bits &= bits - 1;
    if (!bits) return near;
    WideWaiting far = child_at(node, bits, entries);
    bits &= bits - 1;
    if constexpr (sorted) put_in_order(far, near);
    top[0] = far;
    if (!bits) return ++top, near;
    top[1] = near;
    uint32_t count = 2;
    for (; bits; bits &= bits - 1) top[count++] = child_at(node, bits, entries);
    if constexpr (sorted) sort_top(top, count);
    top += count - 1;
    return *top;
}

/// Begins to read a node or the triangles of a leaf: what of them is read first.
template <class Node, class Leaf> HWY_INLINE HWY_ATTR void fetch(const Node* nodes, const Leaf& leaf, uint32_t child) {
    const void* what = nullptr;
    if (!WideLeaf::is(child)) what = &nodes[child];
    else if constexpr (requires { leaf.blocks(); }) what = leaf.blocks().address(WideLeaf::block(child));
    else return;
    const auto* const bytes = static_cast<const char*>(what);
    __builtin_prefetch(bytes), __builtin_prefetch(bytes + 64), __builtin_prefetch(bytes + 128);
}

/// Nearer children first, where the order matters to the query. `size`: as of WideRay. A box is skipped only if its padded entry is beyond the padded limit: at an equal t there may
/// be a lower id inside.
template <class Machine, class Node, class Query>
HWY_INLINE HWY_ATTR void wide_traverse(const Node* nodes, const LocalRay& ray, double size, Query& query, WorkCounters& work) {
    using R = typename Query::Real;
    WideWaiting stack[1 + (kWide - 1) * kBvhDepth + kWide];
    const typename Machine::Boxes boxes(ray, size);
    R limit = boxes.limit(query.limit());
    int64_t last = last_key(float(limit));
    const auto& leaf = query.leaf();
    WideWaiting* top = stack;
    (top++)->key = std::numeric_limits<int64_t>::min();   // below all that waits; its child is the root, which is there to be fetched
    uint32_t current = 0;
    bool near = false;   // does the ray begin in the box of `current`?
    uint64_t tested = 0, filtered = 0;
    for (;;) {
        if (!WideLeaf::is(current)) {
            const Node& node = nodes[current];
            __builtin_prefetch(node.child);   // asked for only once the boxes are tested
            alignas(64) R entries[kWide];
            const uint32_t bits = boxes.enter(node, limit, entries);
            tested += kWide;
            if (bits) {
                const WideWaiting next = take_children<Query::kNearestFirst>(node, bits, entries, top);
                fetch(nodes, leaf, top[-1].child());   // its turn may come after that of `next`
                current = next.child(), near = next.near();
                continue;
            }
        } else if constexpr (std::is_same_v<std::remove_cvref_t<decltype(leaf)>, CustomLeaf>) {
            if (query.visit(WideLeaf::block(current), WideLeaf::count(current))) break;
            limit = boxes.limit(query.limit());
            last = last_key(float(limit));
        } else {
            query.prepare();
            const uint32_t number = WideLeaf::block(current);
            uint32_t lanes = (2u << (WideLeaf::count(current) - 1)) - 1;
            if constexpr (requires { leaf.blocks().boxes(number); }) {
                if (leaf.blocks().has_boxes(number)) {
                    alignas(64) R entries[kWide];
                    lanes = boxes.enter(leaf.blocks().boxes(number), limit, entries);
                    tested += kWide;
                }
            }
            filtered += uint32_t(std::popcount(lanes));
            if (lanes) {
                const auto& block = Machine::block(leaf, number, lanes);
                const uint32_t bits = Machine::filter(leaf, block, query.probe().filter(), near) & lanes;
                if (bits) {
                    if (query.decide(block, number, bits)) break;
                    limit = boxes.limit(query.limit());
                    last = last_key(float(limit));
                }
            }
        }
        do --top;
        while (top->key > last);
        if (top == stack) break;
        current = top->child(), near = top->near();
    }
    work.boxes += tested, work.filtered += filtered;
}

template <class Machine, class Query, class Node, class Leaf, class... Results> HWY_ATTR bool wide_answer(const WideTree<Node, Leaf>& tree, const Ray& ray, WorkCounters& work, Results... results) {
    LocalRay local;
    if (!Machine::template enter<Leaf>(ray, tree.bounds, local)) return false;
    if (tree.unbounded == 0 && !local.enters_box()) return false;
    Query query(tree.leaf, ray, local, work, std::forward<Results>(results)...);
    if (tree.unbounded) {
        query.prepare();
        if (query.visit(0, tree.unbounded)) return query.finish();
    }
    if (local.enters_box()) {
        ++work.rays;
        if constexpr (std::is_same_v<Leaf, CustomLeaf>) {
            if (tree.lone) return query.visit(WideLeaf::block(tree.lone), WideLeaf::count(tree.lone)), query.finish();   // in the bounds the ray is in the leaf's box
        }
        wide_traverse<Machine>(tree.nodes, local, tree.bounds.doubled_size, query, work);
    }
    return query.finish();
}

/// The questions of a machine.
template <class Machine, class Node, class Leaf> constexpr WideTraversals<Node, Leaf> traversals_of() {
    return {wide_answer<Machine, ClosestQuery<Leaf>, Node, Leaf, Hit&, uint32_t>, wide_answer<Machine, AnyQuery<Leaf>, Node, Leaf>, wide_answer<Machine, AllQuery<Leaf>, Node, Leaf, std::vector<Hit>&, uint32_t>};
}

}  // namespace alidade::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
