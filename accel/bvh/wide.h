// SPDX-License-Identifier: Apache-2.0
/// The BVH: eight boxes a node, tested at once.
#pragma once

#include "accel/bvh/build.h"
#include "accel/custom_leaf.h"
#include "accel/query.h"
#include "accel/triangles/triangle_leaf.h"

namespace alidade {

inline constexpr uint32_t kWide = 8;

/// Eight boxes plane by plane, and what is in them. Places without a child have boxes that no ray enters.
template <class R> struct alignas(64) WideNode {
    using Real = R;
    R planes[6][kWide];      ///< [2 axis]: lower ends, [2 axis + 1]: upper ends
    uint32_t child[kWide];   ///< an inner node's index, or a WideLeaf

    static constexpr uint32_t places() { return (1u << kWide) - 1; }   ///< bit i: box i is to be tested
    R plane(uint32_t side, uint32_t i) const { return planes[side][i]; }
    void set_box(uint32_t i, const BoundsT<R>& box) {
        for (int a = 0; a < 3; ++a) planes[2 * a][i] = box.min[a], planes[2 * a + 1][i] = box.max[a];
    }
};

/// A block of triangles in a node's place, or some primitives of a set: the highest bit, the index of the block or of the first, the number of them less one.
struct WideLeaf {
    static constexpr uint32_t kBit = 1u << 31, kCountBits = 3;
    static constexpr size_t kMaxBlocks = size_t(1) << (31 - kCountBits);
    static_assert(kLanes == 1u << kCountBits);

    static constexpr bool is(uint32_t child) { return (child & kBit) != 0; }
    static constexpr uint32_t make(uint32_t block, uint32_t count) { return kBit | block << kCountBits | (count - 1); }
    static constexpr uint32_t block(uint32_t child) { return (child & ~kBit) >> kCountBits; }
    static constexpr uint32_t count(uint32_t child) { return (child & (kLanes - 1)) + 1; }
};

/// The binary tree with the inner nodes between joined, so that the area of all wide nodes is the least that there is. Depth-first order.
/// Replaces the nodes, depth and cost of `stats`. The same for any number of threads. Leaves are numbered by their blocks.
template <class R> LargeVector<WideNode<R>> widened(const LargeVector<BvhNode<R>>& nodes, BuildStats& stats, int threads = 1, uint32_t block = kLanes);

/// Pads of an origin, in units of its roundoff. Triangles are met by the ray that boxes see; what a set promises of its primitives is computed from where the caller's ray begins, however far that is
/// (docs/numerics.md, "Sets").
inline constexpr int kTriangleUnits = 4, kSetUnits = 64;
/// What its move to the start may shift an origin by, relatively, for a pad of one unit.
inline constexpr double kMoved = 0x1p-54;
/// The factor that pads far ends.
template <class R, int kUnits = kTriangleUnits> inline constexpr R kWidened = 1 + kUnits / kTriangleUnits * kSlabPad * kUnitRoundoff<R>;

/// Where the end of a slab may be computed by one fused operation, plane * inverse - origin * inverse: where that product is neither infinite nor as small as what a processor is slow with.
template <class R> struct FusedSlab {
    static constexpr R kPad = R(0x1p-100), kLargest = R(0x1p59), kFlatInverse = R(0x1p60);
    static constexpr double kLeastSize = 0x1p-40;   ///< of the bounds: kPad is nothing to it
};
template <> struct FusedSlab<double> {
    static constexpr double kPad = kOriginPad<double>, kLargest = 0x1p480, kFlatInverse = 0x1p240, kLeastSize = 0;
};

/// A ray made ready for tests of eight boxes: a SlabRay that starts where hits begin. None is behind it then, and the pad of far ends is a factor of the inverse
/// (docs/numerics.md, "Eight at once").
template <class R, int kUnits = kTriangleUnits> class WideRay {
    using Fused = FusedSlab<R>;

  public:
    /// `fuses`: does the machine? `size`: twice the greatest extent of the bounds.
    WideRay(const LocalRay& ray, double size, bool fuses) : start_(ray.tmin), fused_(fuses && size >= Fused::kLeastSize && may_fuse(ray)) {
        for (int a = 0; a < 3; ++a) {
            const bool flat = is_flat(ray, a);
            const R o = origin(ray, a), e = pad(ray, a, fused_), outward = ray.dir[a] < 0 && !flat ? -e : e;
            negative_[a] = !flat & (ray.dir[a] < 0);
            near_origin_[a] = o + outward, far_origin_[a] = o - outward;
            near_inverse_[a] = !flat ? R(ray.inverse[a]) : fused_ ? Fused::kFlatInverse : std::numeric_limits<R>::infinity();
            far_inverse_[a] = near_inverse_[a] * kWidened<R, kUnits>;
        }
    }

    /// For hits at up to `t`, a local one: boxes that are entered beyond this are of no use.
    R limit(double t) const { return SlabRay<R>::limit(t - start_); }

    /// Where the ray enters the box, not before its origin; infinity if it misses it or enters beyond `limit`.
    R enter(const BoundsT<R>& box, R limit) const {
        R near = 0, far = limit;
        for (int a = 0; a < 3; ++a) {
            const R first = negative_[a] ? box.max[a] : box.min[a], last = negative_[a] ? box.min[a] : box.max[a];
            SlabRay<R>::narrow(end(first, near_origin_[a], near_inverse_[a]), end(last, far_origin_[a], far_inverse_[a]), near, far);
        }
        return near <= far ? near : std::numeric_limits<R>::infinity();
    }

    /// What the ends of slabs are computed from.
    bool fused() const { return fused_; }
    bool negative(int axis) const { return negative_[axis]; }
    R near_origin(int axis) const { return near_origin_[axis]; }
    R far_origin(int axis) const { return far_origin_[axis]; }
    R near_inverse(int axis) const { return near_inverse_[axis]; }
    R far_inverse(int axis) const { return far_inverse_[axis]; }

  private:
    static bool is_flat(const LocalRay& ray, int a) { return std::abs(ray.dir[a]) < kSmallestSlope<R>; }
    static R origin(const LocalRay& ray, int a) { return R(ray.origin[a] + ray.tmin * ray.dir[a]); }
    /// How far planes are moved out. That of a fused end has a unit for the rounding of its product, and, without slope, for that of kFlatInverse.
    static R pad(const LocalRay& ray, int a, bool fused) {
        const double slope = fused ? 1 / double(Fused::kFlatInverse) : 0;
        const R drift = is_flat(ray, a) ? R(4 * ((std::abs(ray.dir[a]) + (slope + 0x1p-300)) * longest(ray))) : R(0);
        const R units = fused ? kUnits + 1 : kUnits;
        return units * kUnitRoundoff<R> * std::abs(origin(ray, a)) + (R(kUnits * kMoved * std::abs(ray.origin[a])) + ((fused ? Fused::kPad : kOriginPad<R>) + drift));
    }
    /// Bounds the time from the start to anything of interest: a hit's t is within `reach`, of a set but for roundings of where its ray begins, and the start may be before.
    static double longest(const LocalRay& ray) { return ray.reach + std::abs(ray.tmin) + (kUnits == kSetUnits ? 0x1p-48 * max_abs(ray.origin) : 0); }
    static bool may_fuse(const LocalRay& ray) {
        bool may = true;
        for (int a = 0; a < 3; ++a) may &= (is_flat(ray, a) || std::abs(ray.dir[a]) >= 1 / double(Fused::kFlatInverse)) && std::abs(origin(ray, a)) <= Fused::kLargest && pad(ray, a, true) <= Fused::kLargest;
        return may;
    }
    R end(R plane, R origin, R inverse) const { return fused_ ? std::fma(plane, inverse, -(origin * inverse)) : (plane - origin) * inverse; }

    double start_;   ///< local t of its origin
    bool fused_;
    R near_origin_[3], far_origin_[3], near_inverse_[3], far_inverse_[3];
    bool negative_[3];
};

/// What is asked: eight boxes a node, the leaves below, the bounds of all; those of a set that have none stand first in the leaf.
template <class Node, class Leaf> struct WideTree {
    const Node* nodes;
    const Leaf& leaf;
    const RayBounds& bounds;
    uint32_t unbounded;
    uint32_t lone = 0;   ///< of a set: the WideLeaf that is all of the tree, if one is. Its box is `bounds`
};

/// A near ray need not be clipped to the bounds: the boxes of the root are.
template <class Leaf> inline constexpr RayEntry kWideEntry{Leaf::kEntry.moves, Leaf::kEntry.far, false};

/// The three questions (Accelerator's, true if there is a hit) on one kind of machine, compiled whole, from the caller's ray on. Those that fuse (isa.h) test the same boxes, bit for bit, in the same order, and so do the others.
template <class Node, class Leaf> struct WideTraversals {
    bool (*closest)(const WideTree<Node, Leaf>& tree, const Ray& ray, WorkCounters& work, Hit& hit, uint32_t instance);
    bool (*any)(const WideTree<Node, Leaf>& tree, const Ray& ray, WorkCounters& work);
    bool (*all)(const WideTree<Node, Leaf>& tree, const Ray& ray, WorkCounters& work, std::vector<Hit>& hits, uint32_t instance);
};

/// Those for these instructions, as edge_filter() chooses: of WideNodes and packed blocks, of CompactNodes and numbered ones, or of WideNodes and a set.
template <class Node, class Leaf> const WideTraversals<Node, Leaf>& wide_traversals(Isa isa);
template <class R, TriangleTest test> using PackedTraversals = WideTraversals<WideNode<R>, TriangleLeaf<R, test>>;
using SetTraversals = WideTraversals<WideNode<double>, CustomLeaf>;
template <> const SetTraversals& wide_traversals(Isa isa);
template <> const PackedTraversals<float, TriangleTest::exact>& wide_traversals(Isa isa);
template <> const PackedTraversals<double, TriangleTest::exact>& wide_traversals(Isa isa);
template <> const PackedTraversals<float, TriangleTest::watertight>& wide_traversals(Isa isa);
template <> const PackedTraversals<double, TriangleTest::watertight>& wide_traversals(Isa isa);
template <> const PackedTraversals<float, TriangleTest::fast>& wide_traversals(Isa isa);
template <> const PackedTraversals<double, TriangleTest::fast>& wide_traversals(Isa isa);

/// Which of the eight boxes the ray enters, not beyond `limit`, and where: WideRay::enter for each. For tests.
template <class Node> using WideBoxTest = uint32_t (*)(const Node& node, const LocalRay& ray, double size, typename Node::Real limit, typename Node::Real* entries);
template <class Node> WideBoxTest<Node> wide_box_test(Isa isa);
template <> WideBoxTest<WideNode<float>> wide_box_test(Isa isa);
template <> WideBoxTest<WideNode<double>> wide_box_test(Isa isa);
/// The same with the pads of a set.
WideBoxTest<WideNode<double>> wide_set_box_test(Isa isa);

}  // namespace alidade
