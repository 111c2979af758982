// SPDX-License-Identifier: Apache-2.0
#include "accel/bvh/build.h"

#include "accel/bvh/divide.h"
#include "accel/leaf.h"

#include <mutex>

namespace alidade {

namespace {

uint32_t share(uint32_t of, double a, double b) { return a + b > 0 ? uint32_t(double(of) * (a / (a + b))) : of / 2; }

/// Puts the tasks of both children in the place of the last one, the left one at the end. Without `lasting` the left one's is done before the right one's
/// begins: both have the same spare memory, and the right one all of the room.
template <class R> void replace_by_children(std::vector<BvhTask<R>>& tasks, const Divided& to, const Part<R>& left, const Part<R>& right, uint32_t node, bool lasting) {
    tasks.emplace_back();
    BvhTask<R> &r = tasks[tasks.size() - 2], &l = tasks.back();
    const BvhReference<R>* apart = r.spare;
    const uint32_t rest = r.budget - (to.lefts + to.rights - r.count), lefts = share(rest, left.box.half_area() * to.lefts, right.box.half_area() * to.rights);
    l.node = node, l.depth = ++r.depth, l.count = to.lefts, l.room = r.room - to.rights, l.spare_room = r.spare_room, l.budget = lefts, l.first = r.first + to.rights, l.spare = r.spare, l.centroids = left.centroids;
    if (to.lefts + to.rights > r.room) {
        l.room = to.lefts + lefts;
        l.home = room_for_references<R>((lasting ? 2 : 1) * size_t(l.room));
        l.first = l.home.get();
        if (lasting) l.spare = l.first + l.room, l.spare_room = l.room;
    } else {
        l.home = r.home;
        if (lasting) l.spare = r.spare + to.rights, l.spare_room = r.spare_room - to.rights, r.room = r.spare_room = to.rights;
    }
    if (to.apart) std::copy(apart, apart + to.lefts, l.first);
    r.node = node + 1, r.count = to.rights, r.budget = rest - lefts, r.centroids = right.centroids;
}

/// All below one node, on one thread: nodes[0] is the node itself.
template <class R> class Subtree {
  public:
    Subtree(const BvhLimits& limits, const TriangleSource<R>* triangles, std::vector<uint32_t>& order, BuildStats& stats)
        : limits_(limits), divider_(limits, triangles, 1, stats), order_(order), stats_(stats) {}

    LargeVector<BvhNode<R>> build(BvhTask<R> root, const BoundsT<R>& box) {
        nodes_.reserve(2 * size_t(root.count) / limits_.max_leaf + 1);
        order_.reserve(order_.size() + root.count + root.count / 2);
        nodes_.emplace_back().box = box;
        root.node = 0;
        std::vector<BvhTask<R>> tasks{std::move(root)};
        while (!tasks.empty()) {
            BvhTask<R>& task = tasks.back();
            Part<R> left, right;
            const Divided to = divider_.divide(task, nodes_[task.node].box, left, right);
            if (!to) {
                make_leaf(task);
                tasks.pop_back();
                continue;
            }
            const auto child = uint32_t(nodes_.size());
            nodes_[task.node].first = child;
            nodes_.emplace_back().box = left.box.box(), nodes_.emplace_back().box = right.box.box();
            replace_by_children(tasks, to, left, right, child, false);
        }
        return std::move(nodes_);
    }

  private:
    void make_leaf(const BvhTask<R>& task) {
        while (order_.size() % limits_.block) order_.push_back(kPadding);
        nodes_[task.node].first = uint32_t(order_.size()), nodes_[task.node].count = task.count;
        for (const auto& reference : task.references()) order_.push_back(reference.id());
        ++stats_.leaves;
        stats_.depth = std::max(stats_.depth, size_t(task.depth));
    }

    BvhLimits limits_;
    Divider<R> divider_;
    std::vector<uint32_t>& order_;
    BuildStats& stats_;
    LargeVector<BvhNode<R>> nodes_;
};

/// On many threads each child of a large node is a task, and so is each subtree below; nodes with more than a thread's share of the references are divided with all threads in each pass.
/// The parts are put together in the order in which one thread would have made them.
template <class R> class Builder {
  public:
    Builder(LargeVector<BvhReference<R>> references, const BvhLimits& limits, std::vector<uint32_t>& order, BuildStats& stats, const TriangleSource<R>* triangles)
        : references_(std::move(references)), limits_(limits), triangles_(triangles), order_(order), stats_(stats) {}

    LargeVector<BvhNode<R>> build() {
        if (references_.empty()) return {};
        const auto count = uint32_t(references_.size()), growth = triangles_ ? uint32_t(limits_.growth * double(count)) : 0;
        references_.reserve(size_t(count) + growth);
        spare_ = room_for_references<R>(size_t(count) + growth);
        const Part<R> all = whole();
        BvhTask<R> root{0, 0, count, count + growth, count + growth, growth, references_.data(), spare_.get(), all.centroids, {}};
        subtree_size_ = std::max(kLeastSubtree, count / kSubtrees);
        share_ = count / uint32_t(limits_.threads > 0 ? limits_.threads : hardware_threads());
        if (limits_.threads == 1 || count <= subtree_size_) {
            nodes_ = Subtree<R>(limits_, triangles_, order_, stats_).build(std::move(root), all.box.box());
        } else {
            top_.emplace_back().box = all.box.box();
            with_tasks(limits_.threads, [&](Tasks& tasks) { grow(std::move(root), tasks); });
            references_ = {}, spare_.reset();
            join();
        }
        stats_.nodes = nodes_.size();
        return std::move(nodes_);
    }

  private:
    /// So many subtrees at least, of a large mesh, and none worth dividing further. How many there are changes nothing.
    static constexpr uint32_t kSubtrees = 64, kLeastSubtree = 4096;

    struct Below {
        LargeVector<BvhNode<R>> nodes;
        std::vector<uint32_t> order;
        size_t node = 0, rest = 0, place = 0;   ///< where the node, what is below it, and its references go
    };

    Part<R> whole() const {
        const size_t count = references_.size();
        std::vector<Part<R>> parts((count + kRange - 1) / kRange);
        for_ranges(count, limits_.threads, [&](size_t first, size_t end) {
            Part<R> part;
            binning_passes<R>(limits_.isa).bound(std::span(references_).subspan(first, end - first), part.box, part.centroids);
            parts[first / kRange] = part;
        });
        Part<R> all;
        for (const Part<R>& part : parts) all.box.extend(part.box), all.centroids.extend(part.centroids);
        return all;
    }

    /// All below a node of top_. `first` of those that are not divided further is a number in below_.
    void grow(BvhTask<R> task, Tasks& tasks) {
        BuildStats stats;
        while (task.count > subtree_size_) {
            Divider<R> divider(limits_, triangles_, task.count > share_ ? limits_.threads : 1, stats);
            Part<R> left, right;
            const Divided to = divider.divide(task, box_of(task.node), left, right);
            if (!to) break;
            const uint32_t child = add_children(task.node, left.box.box(), right.box.box());
            std::vector<BvhTask<R>> both;
            both.push_back(std::move(task));
            replace_by_children(both, to, left, right, child, true);
            tasks.run([this, right_one = std::move(both[0]), &tasks]() mutable { grow(std::move(right_one), tasks); });
            task = std::move(both[1]);
        }
        Below below;
        const uint32_t node = task.node, count = task.count;
        below.nodes = Subtree<R>(limits_, triangles_, below.order, stats).build(std::move(task), box_of(node));
        const std::scoped_lock lock(mutex_);
        top_[node].first = uint32_t(below_.size()), top_[node].count = count;
        below_.push_back(std::move(below));
        stats_.leaves += stats.leaves, stats_.splits += stats.splits, stats_.split_candidates += stats.split_candidates;
        stats_.depth = std::max(stats_.depth, stats.depth);
    }

    BoundsT<R> box_of(uint32_t node) {
        const std::scoped_lock lock(mutex_);
        return top_[node].box;
    }

    uint32_t add_children(uint32_t node, const BoundsT<R>& left, const BoundsT<R>& right) {
        const std::scoped_lock lock(mutex_);
        const auto child = top_[node].first = uint32_t(top_.size());
        top_.emplace_back().box = left, top_.emplace_back().box = right;
        return child;
    }

    void join() {
        std::vector<std::pair<uint32_t, uint32_t>> waiting{{0, 0}}, made;   // of top_, and where it goes
        size_t nodes = 1, places = order_.size();
        while (!waiting.empty()) {
            const auto [from, to] = waiting.back();
            waiting.pop_back();
            if (!top_[from].leaf()) {
                made.push_back({from, to});
                waiting.push_back({top_[from].first + 1, uint32_t(nodes + 1)}), waiting.push_back({top_[from].first, uint32_t(nodes)});
                top_[from].first = uint32_t(nodes);
                nodes += 2;
                continue;
            }
            Below& below = below_[top_[from].first];
            places = (places + limits_.block - 1) / limits_.block * limits_.block;
            below.node = to, below.rest = nodes, below.place = places;
            nodes += below.nodes.size() - 1, places += below.order.size();
        }
        nodes_.resize(nodes), order_.resize(places, kPadding);
        for (const auto& [from, to] : made) nodes_[to] = top_[from];
        parallel_for(below_.size(), limits_.threads, [&](size_t i) { put(below_[i]); });
    }

    void put(Below& below) {
        for (size_t i = 0; i < below.nodes.size(); ++i) {
            BvhNode<R> node = below.nodes[i];
            node.first += uint32_t(node.leaf() ? below.place : below.rest - 1);
            nodes_[i ? below.rest + i - 1 : below.node] = node;
        }
        std::copy(below.order.begin(), below.order.end(), order_.begin() + std::ptrdiff_t(below.place));
        below = Below();
    }

    LargeVector<BvhReference<R>> references_;
    BvhLimits limits_;
    const TriangleSource<R>* triangles_;
    std::vector<uint32_t>& order_;
    BuildStats& stats_;
    uint32_t subtree_size_ = 0, share_ = 0;
    LargeVector<BvhNode<R>> nodes_;
    std::shared_ptr<BvhReference<R>[]> spare_;
    std::mutex mutex_;   ///< of what follows
    std::vector<BvhNode<R>> top_;
    std::vector<Below> below_;
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
