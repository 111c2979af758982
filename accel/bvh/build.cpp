// SPDX-License-Identifier: Apache-2.0
#include "accel/bvh/build.h"

#include "accel/leaf.h"

#include <algorithm>
#include <array>

namespace alidade {

namespace {

constexpr int kBins = 16;

/// Areas are compared in double: those of boxes 2^120 wide do not fit float.
template <class R> double area(const BoundsT<R>& box) { return Bounds{Vec3(box.min), Vec3(box.max)}.half_area(); }

/// Twice the centre: halving would cost a bit of denormal numbers.
template <class R> double centroid(const BoundsT<R>& box, int axis) { return double(box.min[axis]) + double(box.max[axis]); }

template <class R> struct Bin {
    BoundsT<R> box;
    uint32_t count = 0;

    void add(const BoundsT<R>& b, uint32_t n) { box.extend(b), count += n; }
};

/// Maps centroids along one axis to bins; without width, all to the first.
struct Binning {
    double low = kInf, high = -kInf;

    void extend(double c) { low = std::min(low, c), high = std::max(high, c); }
    double width() const { return high - low; }
    int bin(double c) const { return width() > 0 ? std::min(int((c - low) / width() * kBins), kBins - 1) : 0; }
};

struct Split {
    double cost = kInf;   ///< area times blocks, of both sides
    int axis = -1, bin = 0;
    explicit operator bool() const { return axis >= 0; }
};

template <class R> class Builder {
  public:
    using References = std::vector<BvhReference<R>>;

    Builder(References references, const BvhLimits& limits, std::vector<uint32_t>& order, BuildStats& stats)
        : references_(std::move(references)), limits_(limits), order_(order), stats_(stats) {}

    std::vector<BvhNode<R>> build() {
        if (references_.empty()) return {};
        nodes_.reserve(2 * references_.size() / limits_.max_leaf + 1);
        nodes_.emplace_back();
        for (const auto& reference : references_) nodes_[0].box.extend(reference.box);
        std::vector<Task> tasks{{0, 0, uint32_t(references_.size()), 0}};
        while (!tasks.empty()) {
            const Task task = tasks.back();
            tasks.pop_back();
            const uint32_t middle = divide(task);
            if (middle == task.begin) {
                make_leaf(task);
            } else {
                const uint32_t child = make_children(task, middle);
                tasks.push_back({child + 1, middle, task.end, task.depth + 1});
                tasks.push_back({child, task.begin, middle, task.depth + 1});
            }
        }
        nodes_.shrink_to_fit();
        finish_stats();
        return std::move(nodes_);
    }

  private:
    struct Task {
        uint32_t node, begin, end, depth;
        uint32_t size() const { return end - begin; }
    };

    double blocks(uint32_t count) const { return double((count + limits_.block - 1) / limits_.block); }

    /// Orders the references of the task in two parts and returns where the second begins, or task.begin for a leaf.
    uint32_t divide(const Task& task) {
        if (task.size() <= std::min(limits_.block, limits_.max_leaf)) return task.begin;
        std::array<Binning, 3> binnings;
        for (uint32_t i = task.begin; i < task.end; ++i) {
            for (int a = 0; a < 3; ++a) binnings[size_t(a)].extend(centroid(references_[i].box, a));
        }
        const Split split = task.depth < kSahDepth ? best_split(task, binnings) : Split();
        const double own = area(nodes_[task.node].box);
        if (task.size() <= limits_.max_leaf && own * blocks(task.size()) <= own + split.cost) return task.begin;
        if (!split || own == 0) return halve(task, binnings);
        const Binning& binning = binnings[size_t(split.axis)];
        const auto begin = references_.begin() + task.begin;
        return uint32_t(std::partition(begin, references_.begin() + task.end,
                                       [&](const auto& r) { return binning.bin(centroid(r.box, split.axis)) < split.bin; }) -
                        references_.begin());
    }

    Split best_split(const Task& task, const std::array<Binning, 3>& binnings) const {
        std::array<std::array<Bin<R>, kBins>, 3> bins;
        for (uint32_t i = task.begin; i < task.end; ++i) {
            const BoundsT<R>& box = references_[i].box;
            for (int a = 0; a < 3; ++a) bins[size_t(a)][size_t(binnings[size_t(a)].bin(centroid(box, a)))].add(box, 1);
        }
        Split best;
        for (int a = 0; a < 3; ++a) sweep(bins[size_t(a)], a, best);
        return best;
    }

    void sweep(const std::array<Bin<R>, kBins>& bins, int axis, Split& best) const {
        std::array<double, kBins> right_cost{};
        Bin<R> right, left;
        for (int b = kBins - 1; b > 0; --b) {
            right.add(bins[size_t(b)].box, bins[size_t(b)].count);
            right_cost[size_t(b)] = right.count ? area(right.box) * blocks(right.count) : kInf;
        }
        for (int b = 1; b < kBins; ++b) {
            left.add(bins[size_t(b - 1)].box, bins[size_t(b - 1)].count);
            if (left.count == 0) continue;
            const double cost = area(left.box) * blocks(left.count) + right_cost[size_t(b)];
            if (cost < best.cost) best = {cost, axis, b};
        }
    }

    /// Halves the range along the widest spread of centroids: for what the heuristic cannot separate.
    uint32_t halve(const Task& task, const std::array<Binning, 3>& binnings) {
        int axis = 0;
        for (int a = 1; a < 3; ++a) {
            if (binnings[size_t(a)].width() > binnings[size_t(axis)].width()) axis = a;
        }
        const uint32_t middle = task.begin + task.size() / 2;
        std::nth_element(references_.begin() + task.begin, references_.begin() + middle, references_.begin() + task.end, [&](const auto& a, const auto& b) {
            const double ca = centroid(a.box, axis), cb = centroid(b.box, axis);
            return ca != cb ? ca < cb : a.id < b.id;
        });
        return middle;
    }

    uint32_t make_children(const Task& task, uint32_t middle) {
        const auto child = uint32_t(nodes_.size());
        nodes_[task.node].first = child;
        nodes_.resize(nodes_.size() + 2);
        for (uint32_t i = task.begin; i < task.end; ++i) nodes_[child + (i >= middle)].box.extend(references_[i].box);
        return child;
    }

    void make_leaf(const Task& task) {
        while (order_.size() % limits_.block) order_.push_back(kPadding);
        nodes_[task.node].first = uint32_t(order_.size()), nodes_[task.node].count = task.size();
        for (uint32_t i = task.begin; i < task.end; ++i) order_.push_back(references_[i].id);
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
    std::vector<uint32_t>& order_;
    BuildStats& stats_;
    std::vector<BvhNode<R>> nodes_;
};

}  // namespace

template <class R>
std::vector<BvhNode<R>> build_bvh(std::vector<BvhReference<R>> references, const BvhLimits& limits, std::vector<uint32_t>& order, BuildStats& stats) {
    return Builder<R>(std::move(references), limits, order, stats).build();
}

template std::vector<BvhNode<float>> build_bvh(std::vector<BvhReference<float>>, const BvhLimits&, std::vector<uint32_t>&, BuildStats&);
template std::vector<BvhNode<double>> build_bvh(std::vector<BvhReference<double>>, const BvhLimits&, std::vector<uint32_t>&, BuildStats&);

}  // namespace alidade
