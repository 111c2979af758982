// SPDX-License-Identifier: Apache-2.0
#include "accel/bvh/build.h"

#include "accel/leaf.h"

#include <algorithm>
#include <array>
#include <cmath>
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

/// The references of the task in hand end the array: its parts are put in its place, the one that is to be divided next at the end, and may be more than it was.
template <class R> class Builder {
  public:
    using References = LargeVector<BvhReference<R>>;

    Builder(References references, const BvhLimits& limits, std::vector<uint32_t>& order, BuildStats& stats, const TriangleSource<R>* triangles)
        : references_(std::move(references)), limits_(limits), triangles_(triangles), growth_(triangles ? uint32_t(limits.growth * double(references_.size())) : 0),
          passes_(binning_passes<R>(limits.isa)), order_(order), stats_(stats) {
        spare_.reset(static_cast<BvhReference<R>*>(allocate_large((references_.size() + growth_) * sizeof(BvhReference<R>), alignof(BvhReference<R>))));
    }

    LargeVector<BvhNode<R>> build() {
        if (references_.empty()) return {};
        nodes_.reserve(2 * references_.size() / limits_.max_leaf + 1);
        order_.reserve(order_.size() + references_.size() + references_.size() / 2);
        Part<R> all;
        for (const auto& reference : references_) all.add(reference);
        nodes_.emplace_back().box = all.box.box();
        std::vector<Task> tasks{{0, 0, uint32_t(references_.size()), 0, growth_, all.centroids}};
        while (!tasks.empty()) {
            const Task task = tasks.back();
            tasks.pop_back();
            Part<R> left, right;
            const Divided to = divide(task, left, right);
            if (!to) {
                make_leaf(task);
            } else {
                const uint32_t child = make_children(task, left, right), middle = task.begin + to.rights, end = middle + to.lefts;
                const uint32_t rest = task.budget - (to.lefts + to.rights - task.size()), lefts = share(rest, left.box.half_area() * to.lefts, right.box.half_area() * to.rights);
                tasks.push_back({child + 1, task.begin, middle, task.depth + 1, rest - lefts, right.centroids});
                tasks.push_back({child, middle, end, task.depth + 1, lefts, left.centroids});
            }
        }
        nodes_.shrink_to_fit();
        finish_stats();
        return std::move(nodes_);
    }

  private:
    struct Task {
        uint32_t node, begin, end, depth;
        uint32_t budget;   ///< so many more references may be made
        CentroidBounds<R> centroids;
        uint32_t size() const { return end - begin; }
    };
    /// How many references are on each side; none for a leaf. The right ones come first.
    struct Divided {
        uint32_t lefts = 0, rights = 0;
        explicit operator bool() const { return lefts > 0; }
    };

    static uint32_t share(uint32_t of, double a, double b) { return a + b > 0 ? uint32_t(double(of) * (a / (a + b))) : of / 2; }
    double blocks(uint32_t count) const { return double((count + limits_.block - 1) / limits_.block); }
    std::span<BvhReference<R>> range(const Task& task) { return std::span(references_).subspan(task.begin, task.size()); }

    Divided divide(const Task& task, Part<R>& left, Part<R>& right) {
        if (task.size() <= std::min(limits_.block, limits_.max_leaf)) return {};
        const CentroidMap<R> map(task.centroids, std::min(kMostBins, 8 + int(task.size() / 8)));   // small ranges are many: their sweeps would cost more than they find
        const Split split = task.depth < kSahDepth ? best_split(task, map) : Split();
        const double own = area(nodes_[task.node].box);
        if (task.size() <= limits_.max_leaf && own * blocks(task.size()) <= own + split.cost) return {};
        if (!split || own == 0) return halve(task, left, right);
        for (int b = 0; b < map.count; ++b) (b < split.bin ? left : right).box.extend(bins_.box[split.axis][b]);
        if (task.budget > 0 && spatial_splits_promise(task.size(), std::max(left.box.largest(), right.box.largest()), own)) {
            if (const Divided to = divide_space(task, split.cost, left, right)) return to;
        }
        const auto rights = uint32_t(passes_.partition(range(task), spare_.get(), map, split.axis, split.bin, left.centroids, right.centroids));
        return {task.size() - rights, rights};
    }

    /// By a plane, if there is one that costs less than `cost`. Else, or if all turns out to be on one side, changes nothing but the order of the references.
    Divided divide_space(const Task& task, double cost, Part<R>& left, Part<R>& right) {
        ++stats_.split_candidates;
        const SpatialSplit<R> plane = best_plane(std::span<const BvhReference<R>>(range(task)), *triangles_, nodes_[task.node].box, limits_.block);
        if (!(plane.cost < cost)) return {};
        const auto [lefts, rights] = divide_by_plane(range(task), spare_.get(), *triangles_, plane, task.budget);
        const size_t middle = task.begin + rights;
        if (references_.size() < middle + lefts) references_.resize(middle + lefts);
        std::copy(spare_.get(), spare_.get() + lefts, references_.begin() + std::ptrdiff_t(middle));
        if (lefts == 0 || rights == 0) return {};
        left = right = Part<R>();
        for (size_t i = task.begin; i < middle; ++i) right.add(references_[i]);
        for (size_t i = middle; i < middle + lefts; ++i) left.add(references_[i]);
        ++stats_.splits;
        return {uint32_t(lefts), uint32_t(rights)};
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
    Divided halve(const Task& task, Part<R>& left, Part<R>& right) {
        int axis = 0;
        for (int a = 1; a < 3; ++a) {
            if (task.centroids.width(a) > task.centroids.width(axis)) axis = a;
        }
        const auto all = range(task);
        const size_t middle = all.size() / 2;
        std::nth_element(all.begin(), all.begin() + std::ptrdiff_t(middle), all.end(), [&](const auto& a, const auto& b) {
            const R ca = a.centroid(axis), cb = b.centroid(axis);
            return ca != cb ? ca > cb : a.id() > b.id();
        });
        for (size_t i = 0; i < all.size(); ++i) (i < middle ? right : left).add(all[i]);
        return {uint32_t(all.size() - middle), uint32_t(middle)};
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
    const TriangleSource<R>* triangles_;
    uint32_t growth_;
    const BinningPasses<R>& passes_;
    std::vector<uint32_t>& order_;
    BuildStats& stats_;
    LargeVector<BvhNode<R>> nodes_;
    Bins<R> bins_;
    std::unique_ptr<BvhReference<R>[], FreeLarge> spare_;   ///< not touched before it is used
};

}  // namespace

template <class R>
LargeVector<BvhNode<R>> build_bvh(LargeVector<BvhReference<R>> references, const BvhLimits& limits, std::vector<uint32_t>& order, BuildStats& stats,
                                  const TriangleSource<R>* triangles) {
    return Builder<R>(std::move(references), limits, order, stats, triangles).build();
}

template LargeVector<BvhNode<float>> build_bvh(LargeVector<BvhReference<float>>, const BvhLimits&, std::vector<uint32_t>&, BuildStats&, const TriangleSource<float>*);
template LargeVector<BvhNode<double>> build_bvh(LargeVector<BvhReference<double>>, const BvhLimits&, std::vector<uint32_t>&, BuildStats&, const TriangleSource<double>*);

}  // namespace alidade
