// SPDX-License-Identifier: Apache-2.0
/// How a node's references are divided among two children.
#pragma once

#include "accel/bvh/build.h"
#include "core/parallel.h"

#include <algorithm>
#include <array>
#include <memory>
#include <span>

namespace alidade {

struct FreeLarge {
    void operator()(void* memory) const noexcept { free_large(memory); }
};

/// Memory for references, not touched before it is used.
template <class R> std::shared_ptr<BvhReference<R>[]> room_for_references(size_t count) {
    return {static_cast<BvhReference<R>*>(allocate_large(count * sizeof(BvhReference<R>), alignof(BvhReference<R>))), FreeLarge()};
}

/// A node that is to be divided, and its references.
template <class R> struct BvhTask {
    uint32_t node = 0, depth = 0, count = 0;
    uint32_t room = 0, spare_room = 0;   ///< so many references have a place from `first` on, and from `spare` on: never less than `count`
    uint32_t budget = 0;   ///< so many more may be made
    BvhReference<R> *first = nullptr, *spare = nullptr;   ///< spare: to work with
    CentroidBounds<R> centroids;
    std::shared_ptr<BvhReference<R>[]> home;   ///< keeps the references where there was no room beside the others

    std::span<BvhReference<R>> references() const { return {first, count}; }
    void swap_memory() { std::swap(first, spare), std::swap(room, spare_room); }
};

/// One side of a divided range.
template <class R> struct Part {
    BoxEnds<R> box = BoxEnds<R>::none();
    CentroidBounds<R> centroids;

    void add(const BvhReference<R>& reference) { box.extend(reference), centroids.extend(reference); }
};

/// How many references are on each side; none for a leaf. The right ones come first.
struct Divided {
    uint32_t lefts = 0, rights = 0;
    bool apart = false;   ///< the left ones begin the task's spare memory; else they follow the right ones
    explicit operator bool() const { return lefts > 0; }
};

/// What is divided is the same for any number of threads, bit for bit: bins are joined, and parts follow each other, in the order of the references.
template <class R> class Divider {
  public:
    Divider(const BvhLimits& limits, const TriangleSource<R>* triangles, int threads, BuildStats& stats)
        : limits_(limits), triangles_(triangles), passes_(binning_passes<R>(limits.isa)), threads_(threads), stats_(stats) {}

    /// May exchange the task's memory with its spare.
    Divided divide(BvhTask<R>& task, const BoundsT<R>& box, Part<R>& left, Part<R>& right) {
        if (task.count <= std::min(limits_.block, limits_.max_leaf)) return {};
        const CentroidMap<R> map(task.centroids, std::min(kMostBins, 8 + int(task.count / 8)));   // small ranges are many: their sweeps would cost more than they find
        const Split split = task.depth < limits_.sah_depth ? best_split(task, map) : Split();
        const double own = area(box);
        if (task.count <= limits_.max_leaf && own * blocks(task.count) <= own + split.cost) return {};
        if (!split || own == 0) return halve(task, left, right);
        for (int b = 0; b < map.count; ++b) (b < split.bin ? left : right).box.extend(bins_.box[split.axis][b]);
        if (task.budget > 0 && spatial_splits_promise(task.count, std::max(left.box.largest(), right.box.largest()), own)) {
            if (const Divided to = divide_space(task, box, split.cost, left, right)) return to;
        }
        const auto rights = uint32_t(partition(task, map, split, left.centroids, right.centroids));
        return {task.count - rights, rights};
    }

  private:
    struct Split {
        double cost = kInf;   ///< area times blocks, of both sides
        int axis = -1, bin = 0;
        explicit operator bool() const { return axis >= 0; }
    };

    double blocks(uint32_t count) const { return double((count + limits_.block - 1) / limits_.block); }
    bool uses_threads(const BvhTask<R>& task) const { return threads_ != 1 && task.count >= 2 * kRange; }

    /// By a plane, if there is one that costs less than `cost`, or than plane_favour times as much and leaves one side clearly fewer. Else, or if all turns out to be on one side, changes nothing but the order of the references.
    Divided divide_space(const BvhTask<R>& task, const BoundsT<R>& box, double cost, Part<R>& left, Part<R>& right) {
        ++stats_.split_candidates;
        const SpatialSplit<R> plane = best_plane(std::span<const BvhReference<R>>(task.references()), *triangles_, box, limits_.block);
        const bool divides = std::min(plane.below.count, plane.above.count) < task.count / 4 * 3;   // else it would use up the budget
        if (!(plane.cost < (divides ? limits_.plane_favour : 1) * cost)) return {};
        const auto [lefts, rights] = divide_by_plane(task.references(), task.spare, *triangles_, plane, task.budget);
        if (rights == 0) std::copy(task.spare, task.spare + lefts, task.first);
        if (lefts == 0 || rights == 0) return {};
        left = right = Part<R>();
        passes_.bound({task.first, rights}, right.box, right.centroids);
        passes_.bound({task.spare, lefts}, left.box, left.centroids);
        ++stats_.splits;
        return {uint32_t(lefts), uint32_t(rights), true};
    }

    Split best_split(const BvhTask<R>& task, const CentroidMap<R>& map) {
        fill(task, map);
        Split best;
        for (int a = 0; a < 3; ++a) {
            if (map.divides(a)) sweep(a, map.count, best);
        }
        return best;
    }

    void fill(const BvhTask<R>& task, const CentroidMap<R>& map) {
        if (!uses_threads(task)) return passes_.fill(task.references(), map, bins_);
        chunk_bins_.resize((task.count + kRange - 1) / kRange);
        for_ranges(task.count, threads_, [&](size_t first, size_t end) { passes_.fill(task.references().subspan(first, end - first), map, chunk_bins_[first / kRange]); });
        bins_ = chunk_bins_.front();
        for (size_t i = 1; i < chunk_bins_.size(); ++i) {
            for (int a = 0; a < 3; ++a) {
                for (int b = 0; b < map.count; ++b) bins_.box[a][b].extend(chunk_bins_[i].box[a][b]), bins_.count[a][b] += chunk_bins_[i].count[a][b];
            }
        }
    }

    /// On one thread, spare memory is used for the left ones alone down to this depth: of what is never touched there is none, and it would be as much as the references are.
    static constexpr uint32_t kInPlaceDepth = 2;

    /// The right ones, then the left ones, each in their order. May exchange the task's memory with its spare. Returns how many are right.
    size_t partition(BvhTask<R>& task, const CentroidMap<R>& map, const Split& split, CentroidBounds<R>& left, CentroidBounds<R>& right) {
        if (!uses_threads(task)) {
            uint32_t rights = 0;
            for (int b = split.bin; b < map.count; ++b) rights += bins_.count[split.axis][b];
            if (task.depth < kInPlaceDepth) {
                passes_.scatter(task.references(), task.spare, task.first, map, split.axis, split.bin, left, right);
                std::copy(task.spare, task.spare + (task.count - rights), task.first + rights);
            } else {
                passes_.scatter(task.references(), task.spare + rights, task.spare, map, split.axis, split.bin, left, right);
                task.swap_memory();
            }
            return rights;
        }
        struct Chunk {
            size_t lefts = 0, rights = 0;   ///< in the chunks before
            CentroidBounds<R> left, right;
        };
        std::vector<Chunk> chunks(chunk_bins_.size() + 1);
        for (size_t i = 0; i < chunk_bins_.size(); ++i) {
            size_t of_chunk[2] = {0, 0};
            for (int b = 0; b < map.count; ++b) of_chunk[b >= split.bin] += chunk_bins_[i].count[split.axis][b];
            chunks[i + 1].lefts = chunks[i].lefts + of_chunk[0], chunks[i + 1].rights = chunks[i].rights + of_chunk[1];
        }
        const size_t rights = chunks.back().rights;
        for_ranges(task.count, threads_, [&](size_t first, size_t end) {
            Chunk& chunk = chunks[first / kRange];
            passes_.scatter(task.references().subspan(first, end - first), task.spare + rights + chunk.lefts, task.spare + chunk.rights, map, split.axis, split.bin, chunk.left, chunk.right);
        });
        task.swap_memory();
        for (const Chunk& chunk : chunks) left.extend(chunk.left), right.extend(chunk.right);
        return rights;
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
    Divided halve(const BvhTask<R>& task, Part<R>& left, Part<R>& right) {
        int axis = 0;
        for (int a = 1; a < 3; ++a) {
            if (task.centroids.width(a) > task.centroids.width(axis)) axis = a;
        }
        const auto all = task.references();
        const size_t middle = all.size() / 2;
        std::nth_element(all.begin(), all.begin() + std::ptrdiff_t(middle), all.end(), [&](const auto& a, const auto& b) {
            const R ca = a.centroid(axis), cb = b.centroid(axis);
            return ca != cb ? ca > cb : a.id() > b.id();
        });
        for (size_t i = 0; i < all.size(); ++i) (i < middle ? right : left).add(all[i]);
        return {uint32_t(all.size() - middle), uint32_t(middle)};
    }

    BvhLimits limits_;
    const TriangleSource<R>* triangles_;
    const BinningPasses<R>& passes_;
    int threads_;
    BuildStats& stats_;
    Bins<R> bins_;
    std::vector<Bins<R>> chunk_bins_;   ///< of the chunks of the last fill that used threads
};

}  // namespace alidade
