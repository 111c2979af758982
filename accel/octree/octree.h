// SPDX-License-Identifier: Apache-2.0
/// Octree: cells halved along their long axes, deeper where more primitives are. A cell that is mostly empty gives way to the box of what is in it.
#pragma once

#include "accel/accelerator.h"
#include "accel/bvh/watertight_boxes.h"
#include "accel/octree/wide_octree.h"
#include "accel/query.h"

#include <array>

namespace alidade {

struct OctreeNode {
    static constexpr uint32_t kInner = ~uint32_t(0), kShrunk = kInner - 1;
    uint32_t first = 0;   ///< place of a leaf's references, index of the first of eight children, or of the one that stands for a shrunk cell
    uint32_t count = 0;   ///< of references, or kInner, or kShrunk

    bool inner() const { return count == kInner; }
    bool shrunk() const { return count == kShrunk; }
    bool empty() const { return count == 0; }
};

/// A cell's middle planes. An axis that is much shorter than the longest, both measured in typical primitives, is not halved: all of it is the lower half.
struct OctreeSplit {
    OctreeSplit(const Bounds& box, const Vec3& typical);
    /// Child `octant`: bit a is set for the upper half of axis a. Neighbours share their plane exactly.
    Bounds child(const Bounds& box, uint32_t octant) const;
    /// Bit a: does `part`, of the cell, reach into the lower (or upper) half of axis a?
    uint32_t sides(const Bounds& part, bool lower) const;

    Vec3 middle;
    uint32_t halved = 0;   ///< bit a: axis a is
};

inline constexpr uint32_t kOctreeDepth = 48;

/// A cell is shrunk to the box of what is in it if its area is more than this many times as large: a quarter is what one halving leaves.
inline constexpr double kOctreeShrink = 4;

/// Cells hold at most this many references, unless dividing them does not pay.
inline constexpr uint32_t kOctreeLeaf = 8;

/// References are at most this many times the primitives: a cell is not divided if its part of the budget would not suffice.
inline constexpr double kOctreeGrowth = 12;

/// Expected cost of dividing a cell, children with the counts given, in primitive tests of a ray that hits it, which are worth as much as the box tests
/// of the children. Probabilities are ratios of areas.
double octree_division_cost(const Bounds& box, const OctreeSplit& split, const std::array<size_t, 8>& counts);

template <class Leaf> class Octree {
  public:
    Octree(BuildInput<typename Leaf::Source>& input, const AccelOptions&, BuildStats& stats) : box_(input.bounds), typical_(input.typical_extent()) {
        PhaseClock clock(stats);
        std::vector<Task> tasks;
        const double budget = kOctreeGrowth * double(input.ids.size());
        nodes_.emplace_back();
        tasks.push_back({0, 0, 1.0, box_, box_, std::move(input.ids), budget});
        while (!tasks.empty()) {
            Task task = std::move(tasks.back());
            tasks.pop_back();
            shrink(task, stats);
            stats.depth = std::max(stats.depth, size_t(task.depth));
            if (!divide(task, input.source, tasks, stats)) make_leaf(task, input.order, stats);
        }
        nodes_.shrink_to_fit(), boxes_.shrink_to_fit();
        stats.nodes = nodes_.size();
        clock.ended("divide");
    }

    template <class Query> void traverse(const LocalRay& ray, Query& query, WorkCounters& work) const {
        std::array<Cell, 7 * kOctreeDepth + 8> stack;
        const auto slab = slab_of<double>(ray);
        stack[0] = {box_.min, box_.max, ray.tmin, 0};
        for (size_t waiting = 1; waiting > 0;) {
            const Cell cell = stack[--waiting];
            if (cell.entry > query.limit()) continue;
            const OctreeNode node = nodes_[cell.node];
            if (node.inner()) {
                waiting = push_children(cell, node.first, slab, ray.tmin, query.limit(), stack.data(), waiting, work);
            } else if (node.shrunk()) {
                const Shrunk& shrunk = boxes_[node.first];
                ++work.boxes;
                const double entry = slab.enter(shrunk.box, ray.tmin, query.limit());
                if (entry < kInf) stack[waiting++] = {shrunk.box.min, shrunk.box.max, entry, shrunk.node};
            } else if (query.visit(node.first, node.count)) {
                return;
            }
        }
    }
    /// Empty cells are left out.
    template <class Visit> void visit_nodes(const Visit& visit) const { visit_below(TreeNode{0, kNoId, 0, box_}, visit); }
    size_t bytes() const { return nodes_.capacity() * sizeof(OctreeNode) + boxes_.capacity() * sizeof(Shrunk); }

  private:
    using Source = typename Leaf::Source;

    struct Task {
        uint32_t node, depth;
        double probability;   ///< that a ray which hits the root's box hits this one
        Bounds box, used;     ///< used: holds the parts of the primitives in the box
        std::vector<uint32_t> ids;
        double budget;
    };
    /// Of a child, while its parent is divided.
    struct Part {
        std::vector<uint32_t> ids;
        Bounds used;
    };
    struct Shrunk {
        Bounds box;
        uint32_t node;
    };
    struct Cell {   // without initial values: a stack of them costs nothing
        Vec3 min, max;
        double entry;
        uint32_t node;
    };

    template <class Visit> void visit_below(TreeNode shown, const Visit& visit) const {
        const OctreeNode node = nodes_[shown.number];
        std::array<TreeNode, 8> below;
        std::array<uint32_t, 8> children;
        uint32_t count = 0;
        const auto add = [&](uint32_t child, const Bounds& box) { below[count] = {child, shown.number, shown.depth + 1, box}, children[count++] = child; };
        const OctreeSplit split(shown.box, typical_);
        for (uint32_t octant = 0; node.inner() && octant < 8; ++octant)
            if (!nodes_[node.first + octant].empty()) add(node.first + octant, split.child(shown.box, octant));
        if (node.shrunk()) add(boxes_[node.first].node, boxes_[node.first].box);
        shown.children = std::span(children).first(count), shown.leaf = !node.inner() && !node.shrunk();
        visit(shown, node.first, shown.leaf ? node.count : 0);
        for (uint32_t i = 0; i < count; ++i) visit_below(below[i], visit);
    }

    void shrink(Task& task, BuildStats& stats) {
        const double area = task.box.half_area(), used = task.used.half_area();
        if (task.ids.size() <= kOctreeLeaf || !(area > kOctreeShrink * used)) return;
        nodes_[task.node] = {uint32_t(boxes_.size()), OctreeNode::kShrunk};
        boxes_.push_back({task.used, uint32_t(nodes_.size())});
        stats.sah_cost += task.probability;
        task.node = uint32_t(nodes_.size()), task.box = task.used, task.probability *= used / area;
        nodes_.emplace_back();
    }

    /// The children's references. What the middle planes leave on one side only is in the child as it was in the parent.
    static void distribute(const Task& task, const OctreeSplit& split, const Source& source, std::array<Part, 8>& parts) {
        std::array<Bounds, 8> boxes;
        for (uint32_t octant = 0; octant < 8; ++octant) boxes[octant] = split.child(task.box, octant);
        for (const uint32_t id : task.ids) {
            const Bounds part = intersection(source.bounds(id), task.box);
            const uint32_t low = split.sides(part, true), high = split.sides(part, false), one = (low ^ high) == 7;
            for (uint32_t octant = 0; octant < 8; ++octant) {
                if ((octant & ~high) | (~octant & 7 & ~low)) continue;
                const Bounds clipped = one ? part : source.clipped_bounds(id, boxes[octant]);
                if (!clipped.empty()) parts[octant].ids.push_back(id), parts[octant].used.extend(clipped);
            }
        }
    }

    bool divide(const Task& task, const Source& source, std::vector<Task>& tasks, BuildStats& stats) {
        if (task.ids.size() <= kOctreeLeaf || task.depth >= kOctreeDepth) return false;
        const OctreeSplit split(task.box, typical_);
        std::array<Part, 8> parts;
        distribute(task, split, source, parts);
        std::array<size_t, 8> counts{};
        size_t total = 0;
        for (uint32_t octant = 0; octant < 8; ++octant) total += counts[octant] = parts[octant].ids.size();
        if (double(total) > task.budget || octree_division_cost(task.box, split, counts) >= double(task.ids.size())) return false;
        const auto first = uint32_t(nodes_.size());
        nodes_[task.node] = {first, OctreeNode::kInner};
        nodes_.resize(nodes_.size() + 8);
        stats.sah_cost += 8 * task.probability;
        const double area = task.box.half_area();
        for (uint32_t octant = 8; octant-- > 0;) {
            if (counts[octant] == 0) continue;
            const Bounds box = split.child(task.box, octant);
            const double share = area > 0 ? box.half_area() / area : 1;
            tasks.push_back({first + octant, task.depth + 1, task.probability * share, box, parts[octant].used, std::move(parts[octant].ids),
                             task.budget * double(counts[octant]) / double(total)});
        }
        return true;
    }

    void make_leaf(const Task& task, std::vector<uint32_t>& order, BuildStats& stats) {
        nodes_[task.node] = {uint32_t(order.size()), uint32_t(task.ids.size())};
        order.insert(order.end(), task.ids.begin(), task.ids.end());
        ++stats.leaves;
        stats.sah_cost += task.probability * double(task.ids.size());
    }

    /// Pushes the children that the ray may enter, the farthest first: along each axis the half on the side of the origin comes first.
    size_t push_children(const Cell& cell, uint32_t first, const SlabRay<double>& slab, double start, double limit, Cell* stack, size_t waiting,
                         WorkCounters& work) const {
        const Bounds box{cell.min, cell.max};
        const OctreeSplit split(box, typical_);
        double enter[3][2], leave[3][2];
        uint32_t backward = 0;
        for (int a = 0; a < 3; ++a) {
            const double low = box.min[a], high = box.max[a], middle = split.middle[a];
            enter[a][0] = slab.enter_slab(a, low, middle), leave[a][0] = slab.leave_slab(a, low, middle);
            enter[a][1] = slab.enter_slab(a, middle, high), leave[a][1] = slab.leave_slab(a, middle, high);
            backward |= uint32_t(slab.negative(a)) << a;
        }
        for (uint32_t i = 8; i-- > 0;) {
            const uint32_t octant = i ^ backward;
            if (nodes_[first + octant].empty()) continue;
            double near = start, far = limit;
            for (int a = 0; a < 3; ++a) {
                const uint32_t half = octant >> a & 1;
                SlabRay<double>::narrow(enter[a][half], leave[a][half], near, far);
            }
            ++work.boxes;
            if (!(near <= SlabRay<double>::padded(far))) continue;   // a NaN is a miss
            const Bounds child = split.child(box, octant);
            stack[waiting++] = {child.min, child.max, near, first + octant};
        }
        return waiting;
    }

    Bounds box_;
    Vec3 typical_;
    std::vector<OctreeNode> nodes_;
    std::vector<Shrunk> boxes_;
};

/// Over triangles: eight cells a node (octree/wide_octree.h), walked as those of the BVH.
template <class T, TriangleTest test> class Octree<TriangleLeaf<T, test>> {
  public:
    static constexpr bool kWidensBoxes = true;   ///< for TriangleTest::watertight

    Octree(BuildInput<TriangleSource<T>>& input, const AccelOptions& options, BuildStats& stats) : traversals_(wide_traversals<WideNode<T>, TriangleLeaf<T, test>>(options.isa)) {
        PhaseClock clock(stats);
        const Vec3 typical = input.typical_extent();
        std::vector<BvhReference<T>> references;
        references.reserve(input.ids.size());
        for (const uint32_t id : input.ids) references.emplace_back(input.source.box(id), id);
        input.ids = {};
        nodes_ = build_wide_octree<T>(std::move(references), input.source, typical, input.order, stats);
        if constexpr (is_watertight<TriangleLeaf<T, test>>) make_watertight<T>(nodes_, options.threads, input.source, input.order);
        clock.ended("divide");
    }

    WideTree<WideNode<T>, TriangleLeaf<T, test>> tree(const TriangleLeaf<T, test>& leaf, const RayBounds& bounds, uint32_t unbounded) const { return {nodes_.data(), leaf, bounds, unbounded}; }
    const PackedTraversals<T, test>& traversals() const { return traversals_; }
    template <class Visit> void visit_nodes(const Visit& visit) const { visit_wide(std::span<const WideNode<T>>(nodes_), kLanes, visit); }
    size_t bytes() const { return nodes_.capacity() * sizeof(WideNode<T>); }

  private:
    const PackedTraversals<T, test>& traversals_;
    LargeVector<WideNode<T>> nodes_;
};

}  // namespace alidade
