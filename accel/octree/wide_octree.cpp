// SPDX-License-Identifier: Apache-2.0
#include "accel/octree/wide_octree.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>

namespace alidade {

namespace {

double blocks(size_t count) { return double((count + kLanes - 1) / kLanes); }

template <class R> struct Cell {
    BoxEnds<R> box = BoxEnds<R>::none();   ///< of what is in it; triangles that were not cut may reach out of the cell
    BoundsT<R> space;                      ///< the cell, which holds the middles of all boxes in it
    std::vector<BvhReference<R>> references;
    double budget = 0;
    bool whole = false;   ///< is not halved any more

    void add(const BvhReference<R>& reference) { references.push_back(reference), box.extend(reference); }
    bool fits() const { return references.size() <= kLanes; }
    double area() const { return box.half_area(); }
    double cost() const { return area() * blocks(references.size()); }
};

/// A plane across a cell, and whether triangles in its way are cut.
template <class R> struct Halving {
    int axis;
    R middle;
    bool cuts;
};

template <class R> class WideOctreeBuilder {
  public:
    WideOctreeBuilder(const TriangleSource<R>& triangles, const Vec3& typical, std::vector<uint32_t>& order, BuildStats& stats)
        : triangles_(triangles), typical_(typical), order_(order), stats_(stats) {}

    LargeVector<WideNode<R>> run(std::vector<BvhReference<R>> references) {
        Cell<R> root;
        for (const BvhReference<R>& reference : references) root.box.extend(reference);
        root.space = root.box.box();
        root.references = std::move(references), root.budget = kTriangleGrowth * double(root.references.size());
        root_area_ = root.area();
        divide(std::move(root), 0);
        stats_.nodes = nodes_.size();
        nodes_.shrink_to_fit();
        return std::move(nodes_);
    }

  private:
    using Cells = std::array<Cell<R>, kWide>;

    /// Makes a node of a cell, and those below; returns its index.
    uint32_t divide(Cell<R> cell, uint32_t depth) {
        Cells cells;
        uint32_t count = 1;
        cells[0] = std::move(cell);
        while (count < kWide) {
            Cell<R>* const next = to_halve(cells, count);
            if (!next) break;
            next->whole = depth == kWideOctreeDepth || !halve(*next, cells[count]);
            count += !next->whole;
        }
        return add_node(cells, count, depth, [&](Cell<R>& part) { return part.whole ? add_blocks(part, depth + 1) : divide(std::move(part), depth + 1); });
    }

    /// The largest of the cells that can be halved, or null.
    static Cell<R>* to_halve(Cells& cells, uint32_t count) {
        Cell<R>* largest = nullptr;
        for (uint32_t i = 0; i < count; ++i) {
            if (!cells[i].whole && !cells[i].fits() && (!largest || cells[i].area() > largest->area())) largest = &cells[i];
        }
        return largest;
    }

    /// Leaves the lower half of a cell in it, and puts the upper half into `upper`. False, and the cell as it was, where no way to do it pays.
    bool halve(Cell<R>& cell, Cell<R>& upper) {
        cell.space = intersection(cell.space, cell.box.box());
        const bool large = spatial_splits_promise(uint32_t(cell.references.size()), double(cell.box.largest()), cell.area());
        for (const int axis : by_length(cell.space)) {
            const R low = cell.space.min[axis], high = cell.space.max[axis], middle = R(0.5 * (double(low) + double(high)));
            if (!(low < middle && middle < high)) continue;
            for (const bool cuts : {large, !large}) {
                if (halve(cell, {axis, middle, cuts}, upper)) return true;
            }
        }
        return false;
    }

    /// The axes, the one first along which a box is longest.
    std::array<int, 3> by_length(const BoundsT<R>& box) const {
        const Vec3 length = (Vec3(box.max) - Vec3(box.min)) / typical_;
        std::array<int, 3> axes{0, 1, 2};
        std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) { return length[a] > length[b]; });
        return axes;
    }

    bool halve(Cell<R>& cell, const Halving<R>& halving, Cell<R>& upper) {
        const auto is_cut = [&](const BvhReference<R>& reference) { return reference.min(halving.axis) < halving.middle && halving.middle < reference.max(halving.axis); };
        const auto cuts = halving.cuts ? std::count_if(cell.references.begin(), cell.references.end(), is_cut) : 0;
        if (double(cell.references.size()) + double(cuts) > cell.budget) return false;
        Cell<R> low, high;
        low.references.reserve(cell.references.size()), high.references.reserve(cell.references.size());
        for (const BvhReference<R>& reference : cell.references) distribute(reference, halving, low, high);
        const size_t lows = low.references.size(), highs = high.references.size(), all = lows + highs;
        if (lows == 0 || highs == 0 || low.cost() + high.cost() + kHalvingCost * cell.area() >= cell.cost()) return false;
        stats_.splits += all > cell.references.size();
        low.space = high.space = cell.space;
        low.space.max[halving.axis] = high.space.min[halving.axis] = halving.middle;
        low.budget = cell.budget * double(lows) / double(all), high.budget = cell.budget - low.budget;
        cell = std::move(low), upper = std::move(high);
        return true;
    }

    void distribute(const BvhReference<R>& reference, const Halving<R>& halving, Cell<R>& low, Cell<R>& high) const {
        const double min = double(reference.min(halving.axis)), max = double(reference.max(halving.axis)), middle = double(halving.middle);
        if (max <= middle) return low.add(reference);
        if (min >= middle) return high.add(reference);
        if (!halving.cuts) return (0.5 * (min + max) < middle ? low : high).add(reference);
        const Parts<R> parts = cut(triangles_.corners(reference.id()), reference, halving.axis, halving.middle);
        for (const auto& [part, half] : {std::pair(&parts.below, &low), std::pair(&parts.above, &high)}) {
            if (part->min(halving.axis) <= part->max(halving.axis)) half->add({part->box(), reference.id()});
        }
    }

    /// Makes a node of a cell that is not halved: of eight blocks, or of eight such nodes.
    uint32_t add_blocks(const Cell<R>& cell, uint32_t depth) {
        size_t part = kLanes;
        while (kWide * part < cell.references.size()) part *= kWide;
        Cells cells;
        for (size_t i = 0; i < cell.references.size(); ++i) cells[i / part].add(cell.references[i]);
        return add_node(cells, uint32_t((cell.references.size() + part - 1) / part), depth, [&](Cell<R>& below) { return add_blocks(below, depth + 1); });
    }

    /// `below`: makes the node of a cell that does not fit into a block.
    template <class Below> uint32_t add_node(Cells& cells, uint32_t count, uint32_t depth, const Below& below) {
        const auto index = uint32_t(nodes_.size());
        nodes_.emplace_back();
        std::memset(&nodes_[index], 0, sizeof(WideNode<R>));   // the bytes between, too: a tree is known by its bytes
        stats_.depth = std::max(stats_.depth, size_t(depth));
        for (uint32_t i = 0; i < kWide; ++i) {
            const BoundsT<R> box = i < count ? cells[i].box.box() : BoundsT<R>();
            for (int a = 0; a < 3; ++a) nodes_[index].planes[2 * a][i] = box.min[a], nodes_[index].planes[2 * a + 1][i] = box.max[a];
            nodes_[index].child[i] = WideLeaf::kBit;
        }
        for (uint32_t i = 0; i < count; ++i) {
            const double share = root_area_ > 0 ? cells[i].area() / root_area_ : 1;
            stats_.sah_cost += share * (cells[i].fits() ? double(cells[i].references.size()) : kWide);
            const uint32_t child = cells[i].fits() ? add_leaf(cells[i]) : below(cells[i]);
            nodes_[index].child[i] = child;
        }
        return index;
    }

    uint32_t add_leaf(const Cell<R>& cell) {
        const size_t block = order_.size() / kLanes;
        if (block >= WideLeaf::kMaxBlocks) throw std::length_error("more triangles than the tree can number");
        for (const BvhReference<R>& reference : cell.references) order_.push_back(reference.id());
        order_.resize((block + 1) * kLanes, kPadding);
        ++stats_.leaves;
        return WideLeaf::make(uint32_t(block), uint32_t(cell.references.size()));
    }

    const TriangleSource<R>& triangles_;
    Vec3 typical_;
    std::vector<uint32_t>& order_;
    BuildStats& stats_;
    double root_area_ = 0;
    LargeVector<WideNode<R>> nodes_;
};

}  // namespace

template <class R>
LargeVector<WideNode<R>> build_wide_octree(std::vector<BvhReference<R>> references, const TriangleSource<R>& triangles, const Vec3& typical, std::vector<uint32_t>& order, BuildStats& stats) {
    if (references.empty()) return {};
    return WideOctreeBuilder<R>(triangles, typical, order, stats).run(std::move(references));
}

template LargeVector<WideNode<float>> build_wide_octree(std::vector<BvhReference<float>>, const TriangleSource<float>&, const Vec3&, std::vector<uint32_t>&, BuildStats&);
template LargeVector<WideNode<double>> build_wide_octree(std::vector<BvhReference<double>>, const TriangleSource<double>&, const Vec3&, std::vector<uint32_t>&, BuildStats&);

}  // namespace alidade
