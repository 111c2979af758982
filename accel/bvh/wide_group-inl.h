// SPDX-License-Identifier: Apache-2.0
/// The traversal of a wide BVH by rays that go the same way, compiled once for each target that wide_group.cpp includes (hwy/foreach_target.h).
#if defined(ALIDADE_WIDE_GROUP_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ALIDADE_WIDE_GROUP_INL
#undef ALIDADE_WIDE_GROUP_INL
#else
#define ALIDADE_WIDE_GROUP_INL
#endif

#include "accel/bvh/wide_group.h"
#include "accel/bvh/wide_traverse-inl.h"

#include <optional>

HWY_BEFORE_NAMESPACE();
namespace alidade::HWY_NAMESPACE {

#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3   // where ends are fused

/// Of several rays' ends of slabs on an axis (docs/numerics.md, "Rays together"), each a line over the planes' places (plane * inverse + origin), what none is beyond: of the near ends the lesser of two lines, of the far ends the greater. They meet at `pivot`, where the
/// outermost ray is, and have the least and the greatest slope.
template <class R> struct EndBounds {
    R least_slope, greatest_slope, least_added, greatest_added;

    /// `side`: 1 for near ends, which are bounded from below, -1 for far ones.
    void set(const R* inverse, const R* added, double pivot, double side) {
        double outermost = kInf, size = 0;
        least_slope = greatest_slope = inverse[0];
        for (uint32_t k = 0; k < kGroup; ++k) {
            const double slope = double(inverse[k]), rest = double(added[k]);
            outermost = std::min(outermost, side * (pivot * slope + rest)), size = std::max(size, std::abs(pivot * slope) + std::abs(rest));
            least_slope = std::min(least_slope, inverse[k]), greatest_slope = std::max(greatest_slope, inverse[k]);
        }
        const auto line = [&](R slope) {   // outwards by more than its roundings
            const double rest = side * outermost - pivot * double(slope);
            return R(rest - side * (0x1p-49 * (size + std::abs(pivot * double(slope))) + 2 * double(kUnitRoundoff<R>) * std::abs(rest)));
        };
        least_added = line(least_slope), greatest_added = line(greatest_slope);
    }
};

/// The boxes that any of several rays may enter; and which of them do. A box that one ray enters, the group does: of every plane, its ends bound the rays' own, whose roundings are monotone.
template <class R> class GroupBoxes {
    using Boxes = VectorBoxes<R>;

  public:
    /// Of kGroup rays, near `pivot`. False, and nothing done, if they are not of one octant, or not all fused.
    bool set(const Boxes* const* boxes, const Vec3& pivot) {
        planes_ = boxes[0]->planes_;
        for (uint32_t k = 0; k < kGroup; ++k)
            if (boxes[k]->planes_ != planes_ || !boxes[k]->fused_) return false;
        for (size_t a = 0; a < 3; ++a) {
            for (uint32_t k = 0; k < kGroup; ++k) {
                near_inverse_[a][k] = boxes[k]->near_inverse_[a], near_added_[a][k] = boxes[k]->near_origin_[a];
                far_inverse_[a][k] = boxes[k]->far_inverse_[a], far_added_[a][k] = boxes[k]->far_origin_[a];
            }
            near_[a].set(near_inverse_[a], near_added_[a], pivot[int(a)], 1), far_[a].set(far_inverse_[a], far_added_[a], pivot[int(a)], -1);
        }
        return true;
    }

    HWY_INLINE HWY_ATTR uint32_t enter(const auto& node, R limit, R* entries) const {
        const D d;
        const auto lanes = uint32_t(hn::Lanes(d));
        uint32_t bits = 0;
        for (uint32_t lane = 0; lane < kWide; lane += lanes) {
            V near = hn::Zero(d), far = hn::Set(d, limit);
            for (int a = 0; a < 3; ++a) {
                const V first = load_planes(d, node, a, planes_[a] + lane), last = load_planes(d, node, a, planes_[3 + a] + lane);
                near = larger(smaller(end(first, near_[a].least_slope, near_[a].least_added), end(first, near_[a].greatest_slope, near_[a].greatest_added)), near);
                far = smaller(larger(end(last, far_[a].least_slope, far_[a].least_added), end(last, far_[a].greatest_slope, far_[a].greatest_added)), far);
            }
            hn::Store(near, d, entries + lane);
            bits |= mask_bits(d, hn::Le(near, far)) << lane;
        }
        return bits & node.places();
    }

    /// Which rays enter a node's box, each not beyond its own limit, and where.
    HWY_INLINE HWY_ATTR uint32_t rays_entering(const auto& node, uint32_t place, const R* limits, R* entries) const {
        const D d;
        const auto lanes = uint32_t(hn::Lanes(d));
        uint32_t bits = 0;
        for (uint32_t lane = 0; lane < kGroup; lane += lanes) {
            V near = hn::Zero(d), far = hn::Load(d, limits + lane);
            for (size_t a = 0; a < 3; ++a) {
                const V first = hn::Set(d, node.planes[planes_[a] / kWide][place]), last = hn::Set(d, node.planes[planes_[3 + a] / kWide][place]);
                near = larger(hn::MulAdd(first, hn::Load(d, near_inverse_[a] + lane), hn::Load(d, near_added_[a] + lane)), near);
                far = smaller(hn::MulAdd(last, hn::Load(d, far_inverse_[a] + lane), hn::Load(d, far_added_[a] + lane)), far);
            }
            hn::Store(near, d, entries + lane);
            bits |= mask_bits(d, hn::Le(near, far)) << lane;
        }
        return bits;
    }

  private:
    using D = hn::CappedTag<R, kWide>;
    using V = hn::Vec<D>;
    static HWY_INLINE HWY_ATTR V end(V planes, R slope, R added) { return hn::MulAdd(planes, hn::Set(D(), slope), hn::Set(D(), added)); }

    const size_t* planes_;
    EndBounds<R> near_[3], far_[3];
    alignas(64) R near_inverse_[3][kGroup], near_added_[3][kGroup], far_inverse_[3][kGroup], far_added_[3][kGroup];
};

/// Where boxes of a ray are made, if they are needed.
template <class R> union BoxesRoom {
    BoxesRoom() {}
    VectorBoxes<R> made;
};

/// Rays on their way through a tree together. What they share is asked of the group, what is in a leaf of those alone that enter its box, each as if it were alone.
template <class Machine, class Node, class Leaf> class Group {
    using R = typename Leaf::Real;
    using Query = ClosestQuery<Leaf>;
    using Boxes = typename Machine::Boxes;

  public:
    Group(const WideTree<Node, Leaf>& tree, std::span<const Ray> rays, std::span<Hit> hits, WorkCounters& work) : tree_(tree), rays_(rays), hits_(hits), work_(work) {}

    /// As GroupTraversal; rays that are too few to pay do as well by themselves.
    HWY_ATTR bool trace(uint32_t instance) {
        for (uint32_t k = 0; k < rays_.size(); ++k) begin(k, instance);
        const bool enough = uint32_t(std::popcount(entering_)) >= kLeastGroup, together = enough && make_boxes() && traverse();
        for (uint32_t left = asked_; left; left &= left - 1) {
            const auto k = uint32_t(std::countr_zero(left));
            if (!together && (entering_ >> k & 1)) wide_traverse<Machine>(tree_.nodes, locals_[k], tree_.bounds.doubled_size, *queries_[k], work_);
            queries_[k]->finish();
        }
        return together || !enough;
    }

  private:
    HWY_ATTR void begin(uint32_t k, uint32_t instance) {
        LocalRay& local = locals_[k];
        if (!Machine::template enter<Leaf>(rays_[k], tree_.bounds, local)) return;
        if (tree_.unbounded == 0 && !local.enters_box()) return;
        queries_[k].emplace(tree_.leaf, rays_[k], local, work_, hits_[k], instance);
        asked_ |= 1u << k;
        if (tree_.unbounded) {
            queries_[k]->prepare();
            queries_[k]->visit(0, tree_.unbounded);
        }
        if (local.enters_box()) ++work_.rays, entering_ |= 1u << k;
    }

    HWY_ATTR bool make_boxes() {
        const auto first = uint32_t(std::countr_zero(entering_));
        const Boxes* boxes[kGroup];
        for (uint32_t k = 0; k < kGroup; ++k) {
            const bool enters = entering_ >> k & 1;
            boxes[k] = enters ? ::new (&boxes_[k].made) Boxes(locals_[k], tree_.bounds.doubled_size) : nullptr;
            limits_[k] = enters ? boxes_[k].made.limit(queries_[k]->limit()) : R(-1);   // the others enter nothing
        }
        for (const Boxes*& b : boxes) b = b ? b : &boxes_[first].made;
        return group_.set(boxes, locals_[first].origin);
    }

    /// False if it was left: then each ray has to go its own way, with what it has found.
    HWY_ATTR bool traverse() {
        WideWaiting stack[1 + (kWide - 1) * kBvhDepth + kWide];
        WideWaiting* top = stack;
        R limit = *std::max_element(limits_, limits_ + kGroup);
        uint64_t nodes = 0, leaves = 0, alone = 0;
        bool parted = false;
        uint32_t current = 0;
        for (;;) {
            push_children(current, limit, top);
            ++nodes;
            bool descends = false;
            while (!descends && top != stack) {
                const WideWaiting next = *--top;
                if (next.key > last_key(float(limit))) continue;
                const Node& parent = tree_.nodes[next.child() / kWide];
                const uint32_t place = next.child() % kWide, child = parent.child[place];
                if (!WideLeaf::is(child)) {
                    current = child, descends = true;
                    continue;
                }
                alignas(64) R starts[kGroup];
                const uint32_t entering = group_.rays_entering(parent, place, limits_, starts);
                ++leaves, alone += uint32_t(std::popcount(entering));
                if (entering && visit(child, entering, starts)) limit = *std::max_element(limits_, limits_ + kGroup);
            }
            parted = double(nodes + leaves) > kPatience + kWorth * double(alone);
            if (!descends || parted) break;
        }
        work_.boxes += nodes * kWide + leaves * kGroup;
        return !parted;
    }

    /// Those that a ray may enter, the nearest last. What waits is named by its place, as its box is asked for once more.
    HWY_INLINE HWY_ATTR void push_children(uint32_t number, R limit, WideWaiting*& top) const {
        alignas(64) R entries[kWide];
        WideWaiting* const first = top;
        for (uint32_t bits = group_.enter(tree_.nodes[number], limit, entries); bits; bits &= bits - 1) {
            const auto i = uint32_t(std::countr_zero(bits));
            *top++ = {number * kWide + i, float(entries[i])};
        }
        sort_top(first, uint32_t(top - first));
    }

    /// True if a ray may have found something.
    HWY_INLINE HWY_ATTR bool visit(uint32_t child, uint32_t entering, const R* starts) {
        bool decided = false;
        const uint32_t number = WideLeaf::block(child), lanes = (2u << (WideLeaf::count(child) - 1)) - 1;
        work_.filtered += uint64_t(WideLeaf::count(child)) * uint64_t(std::popcount(entering));
        for (; entering; entering &= entering - 1) {
            const auto k = uint32_t(std::countr_zero(entering));
            Query& query = *queries_[k];
            query.prepare();
            const auto& block = Machine::block(tree_.leaf, number, lanes);
            const uint32_t bits = Machine::filter(tree_.leaf, block, query.probe().filter(), starts[k] == 0) & lanes;
            if (!bits) continue;
            query.decide(block, number, bits);
            shorten(k), decided = true;
        }
        return decided;
    }

    void shorten(uint32_t k) { limits_[k] = boxes_[k].made.limit(queries_[k]->limit()); }

    /// A group goes on together while nodes and leaves, of the group, are fewer than the leaves that its rays see by themselves, times this; but for as many at the beginning. Measured on the generated scenes (bench/results/accel_peers.md).
    static constexpr double kWorth = 1.2, kPatience = 24;

    const WideTree<Node, Leaf>& tree_;
    std::span<const Ray> rays_;
    std::span<Hit> hits_;
    WorkCounters& work_;
    uint32_t asked_ = 0, entering_ = 0;   ///< bits of rays
    alignas(64) R limits_[kGroup];
    GroupBoxes<R> group_;
    BoxesRoom<R> boxes_[kGroup];
    std::optional<Query> queries_[kGroup];
    LocalRay locals_[kGroup];
};

template <class Machine, class Node, class Leaf> HWY_ATTR bool group_answer(const WideTree<Node, Leaf>& tree, std::span<const Ray> rays, std::span<Hit> hits, WorkCounters& work, uint32_t instance) {
    return Group<Machine, Node, Leaf>(tree, rays, hits, work).trace(instance);
}

template <class Machine, class Node, class Leaf> constexpr GroupTraversal<Node, Leaf> group_of() { return group_answer<Machine, Node, Leaf>; }

/// GroupBoxTest.
template <class R> HWY_ATTR bool enter_boxes_together(const WideNode<R>& node, std::span<const LocalRay, kGroup> rays, double size, R limit, GroupBoxBits& bits) {
    alignas(64) R entries[kWide], starts[kGroup], limits[kGroup];
    BoxesRoom<R> rooms[kGroup];
    const VectorBoxes<R>* boxes[kGroup];
    for (uint32_t k = 0; k < kGroup; ++k) {
        boxes[k] = ::new (&rooms[k].made) VectorBoxes<R>(rays[k], size);
        bits.alone[k] = boxes[k]->enter(node, limit, entries);
        limits[k] = limit;
    }
    GroupBoxes<R> group;
    if (!group.set(boxes, rays[0].origin)) return false;
    bits.together = group.enter(node, limit, entries);
    for (uint32_t i = 0; i < kWide; ++i) bits.rays[i] = group.rays_entering(node, i, limits, starts);
    return true;
}

template <class R> constexpr GroupBoxTest<R> box_test_of() { return enter_boxes_together<R>; }

#else

template <class R> constexpr GroupBoxTest<R> box_test_of() { return nullptr; }

template <class Machine, class Node, class Leaf> constexpr GroupTraversal<Node, Leaf> group_of() { return nullptr; }

#endif

}  // namespace alidade::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
