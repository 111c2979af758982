// SPDX-License-Identifier: Apache-2.0
#include "accel/bvh/build.h"

#include "accel/leaf.h"

#include <algorithm>
#include <array>
#include <memory>
#include <span>

namespace alidade {

namespace {

struct FreeLarge {
    void operator()(void* memory) const noexcept { free_large(memory); }
};

struct Split {
    double cost = kInf;   ///< area times blocks, of both sides
    int axis = -1, bin = 0;
    explicit operator bool() const { return axis >= 0; }
};

/// One side of a divided range.
template <class R> struct Part {
    BoxEnds<R> box = BoxEnds<R>::none();
    CentroidBounds<R> centroids;

    void add(const BvhReference<R>& reference) { box.extend(reference), centroids.extend(reference); }
};

template <class R> class Builder {
  public:
    using References = LargeVector<BvhReference<R>>;

    Builder(References references, const BvhLimits& limits, std::vector<uint32_t>& order, BuildStats& stats)
        : references_(std::move(references)), limits_(limits), passes_(binning_passes<R>(limits.isa)), order_(order), stats_(stats), spare_(static_cast<BvhReference<R>*>(allocate_large(references_.size() * sizeof(BvhReference<R>), alignof(BvhReference<R>)))) {}

    LargeVector<BvhNode<R>> build() {
        if (references_.empty()) return {};
        nodes_.reserve(2 * references_.size() / limits_.max_leaf + 1);
        order_.reserve(order_.size() + references_.size() + references_.size() / 2);
        Part<R> all;
        for (const auto& reference : references_) all.add(reference);
        nodes_.emplace_back().box = all.box.box();
        std::vector<Task> tasks{{0, 0, uint32_t(references_.size()), 0, all.centroids}};
        while (!tasks.empty()) {
            const Task task = tasks.back();
            tasks.pop_back();
            Part<R> left, right;
            const uint32_t middle = divide(task, left, right);
            if (middle == task.begin) {
                make_leaf(task);
            } else {
                const uint32_t child = make_children(task, left, right);
                tasks.push_back({child + 1, middle, task.end, task.depth + 1, right.centroids});
                tasks.push_back({child, task.begin, middle, task.depth + 1, left.centroids});
            }
        }
        nodes_.shrink_to_fit();
        finish_stats();
        return std::move(nodes_);
    }

  private:
    struct Task {
        uint32_t node, begin, end, depth;
        CentroidBounds<R> centroids;
        uint32_t size() const { return end - begin; }
    };

    double blocks(uint32_t count) const { return double((count + limits_.block - 1) / limits_.block); }
    std::span<BvhReference<R>> range(const Task& task) { return std::span(references_).subspan(task.begin, task.size()); }

    /// Orders the references of the task in two parts and returns where the second begins, or task.begin for a leaf.
    uint32_t divide(const Task& task, Part<R>& left, Part<R>& right) {
        if (task.size() <= std::min(limits_.block, limits_.max_leaf)) return task.begin;
        const CentroidMap<R> map(task.centroids, std::min(kMostBins, 8 + int(task.size() / 8)));   // small ranges are many: their sweeps would cost more than they find
        const Split split = task.depth < kSahDepth ? best_split(task, map) : Split();
        const double own = area(nodes_[task.node].box);
        if (task.size() <= limits_.max_leaf && own * blocks(task.size()) <= own + split.cost) return task.begin;
        if (!split || own == 0) return halve(task, left, right);
        for (int b = 0; b < map.count; ++b) (b < split.bin ? left : right).box.extend(bins_.box[split.axis][b]);
        return task.begin + uint32_t(passes_.partition(range(task), spare_.get(), map, split.axis, split.bin, left.centroids, right.centroids));
    }

    Split best_split(const Task& task, const CentroidMap<R>& map) {
        passes_.fill(range(task), map, bins_);
        Split best;
        for (int a = 0; a < 3; ++a) {
            if (map.divides(a)) sweep(a, map.count, best);
        }
        return best;
    }

    void sweep(int axis, int count, Split& best) const {
        std::array<double, kMostBins> right_cost;
        BoxEnds<R> right = BoxEnds<R>::none(), left = right;
        uint32_t rights = 0, lefts = 0;
        for (int b = count - 1; b > 0; --b) {
            right.extend(bins_.box[axis][b]), rights += bins_.count[axis][b];
            right_cost[size_t(b)] = rights ? right.half_area() * blocks(rights) : kInf;
        }
        for (int b = 1; b < count; ++b) {
            left.extend(bins_.box[axis][b - 1]), lefts += bins_.count[axis][b - 1];
            if (lefts == 0) continue;
            const double cost = left.half_area() * blocks(lefts) + right_cost[size_t(b)];
            if (cost < best.cost) best = {cost, axis, b};
        }
    }

    /// Halves the range along the widest spread of centroids: for what the heuristic cannot separate.
    uint32_t halve(const Task& task, Part<R>& left, Part<R>& right) {
        int axis = 0;
        for (int a = 1; a < 3; ++a) {
            if (task.centroids.width(a) > task.centroids.width(axis)) axis = a;
        }
        const auto all = range(task);
        const size_t middle = all.size() / 2;
        std::nth_element(all.begin(), all.begin() + std::ptrdiff_t(middle), all.end(), [&](const auto& a, const auto& b) {
            const R ca = a.centroid(axis), cb = b.centroid(axis);
            return ca != cb ? ca < cb : a.id() < b.id();
        });
        for (size_t i = 0; i < all.size(); ++i) (i < middle ? left : right).add(all[i]);
        return task.begin + uint32_t(middle);
    }

    uint32_t make_children(const Task& task, const Part<R>& left, const Part<R>& right) {
        const auto child = uint32_t(nodes_.size());
        nodes_[task.node].first = child;
        nodes_.emplace_back().box = left.box.box();
        nodes_.emplace_back().box = right.box.box();
        return child;
    }

    void make_leaf(const Task& task) {
        while (order_.size() % limits_.block) order_.push_back(kPadding);
        nodes_[task.node].first = uint32_t(order_.size()), nodes_[task.node].count = task.size();
        for (const auto& reference : range(task)) order_.push_back(reference.id());
        ++stats_.leaves;
        stats_.depth = std::max(stats_.depth, size_t(task.depth));
    }

    void finish_stats() {
        stats_.nodes = nodes_.size();
        const double root = area(nodes_[0].box);
        for (const auto& node : nodes_) stats_.sah_cost += (root > 0 ? area(node.box) / root : 1) * (node.leaf() ? double(node.count) : 2.0);
    }

    References references_;
    BvhLimits limits_;
    const BinningPasses<R>& passes_;
    std::vector<uint32_t>& order_;
    BuildStats& stats_;
    LargeVector<BvhNode<R>> nodes_;
    Bins<R> bins_;
    std::unique_ptr<BvhReference<R>[], FreeLarge> spare_;   ///< not touched before it is used
};

}  // namespace

template <class R>
LargeVector<BvhNode<R>> build_bvh(LargeVector<BvhReference<R>> references, const BvhLimits& limits, std::vector<uint32_t>& order, BuildStats& stats) {
    return Builder<R>(std::move(references), limits, order, stats).build();
}

template LargeVector<BvhNode<float>> build_bvh(LargeVector<BvhReference<float>>, const BvhLimits&, std::vector<uint32_t>&, BuildStats&);
template LargeVector<BvhNode<double>> build_bvh(LargeVector<BvhReference<double>>, const BvhLimits&, std::vector<uint32_t>&, BuildStats&);

}  // namespace alidade
