// SPDX-License-Identifier: Apache-2.0
#include "accel/bvh/fast_build.h"

#include "accel/bvh/hilbert.h"
#include "accel/bvh/presplit.h"
#include "accel/leaf.h"
#include "core/parallel.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>
#include <vector>

namespace alidade {

namespace {

/// Full leaves that a subtree may hold. With four builds take half longer, with 16 a tenth, and rays no less boxes: what lies above decides.
constexpr uint32_t kTreeletLeaves = 64;
/// References that are divided where it costs least, and no more by bits. With 16 leaves are a fifth emptier, and rays 1 to 5 % slower; with 96 nothing is better.
constexpr uint32_t kSwept = 64;
/// Levels of a subtree that are divided by bits; below they are halved. The tree above has kDepthAbove levels, and 32 of halving.
constexpr uint32_t kBitDepth = 8, kDepthAbove = 40;
/// Levels of a subtree: by bits, of halving what more than kSwept of its 512 references are, and where at least a quarter is on each side of 64, 48, 36 and so on.
constexpr uint32_t kTreeletDepth = kBitDepth + 3 + 8;
static_assert(kTreeletLeaves * 8 == kSwept << 3 && kDepthAbove + 32 + kTreeletDepth <= kBvhDepth);

constexpr int kAxisBits = HilbertCurve::kLevels, kCells = 1 << kAxisBits, kDigitBits = 10, kDigits = 1 << kDigitBits, kPasses = 3;
static_assert(kPasses * kDigitBits == 3 * kAxisBits);

/// [i]: the bits of i with two zeros between them.
constexpr std::array<uint32_t, kCells> spread_bits() {
    std::array<uint32_t, kCells> out{};
    for (uint32_t i = 0; i < kCells; ++i)
        for (int bit = 0; bit < kAxisBits; ++bit) out[i] |= (i >> bit & 1u) << (3 * bit);
    return out;
}
constexpr std::array<uint32_t, kCells> kSpread = spread_bits();

template <class R> [[gnu::always_inline]] inline uint32_t curve_code(const BoxEnds<R>& box, const CentroidMap<R>& map) {
    return HilbertCurve::place(kSpread[size_t(map.bin(box, 0))] << 2 | kSpread[size_t(map.bin(box, 1))] << 1 | kSpread[size_t(map.bin(box, 2))]);
}

/// A reference on the curve.
struct Coded {
    uint32_t code, place;
    friend bool operator<(const Coded& a, const Coded& b) { return a.code != b.code ? a.code < b.code : a.place < b.place; }
};

/// By code, then by place, as they are given. Method: least digit first; stretches are counted, then moved, each by one thread, and are long: each has a counter for every value of a digit.
void sort_codes(LargeVector<Coded>& codes, int threads) {
    if (codes.size() < kRange) return std::sort(codes.begin(), codes.end());
    LargeVector<Coded> other(codes.size());
    const size_t wanted = threads == 1 ? 1 : size_t(4 * (threads > 0 ? threads : hardware_threads())), length = std::max(kRange, (codes.size() + wanted - 1) / wanted);
    std::vector<std::array<uint32_t, kDigits>> next((codes.size() + length - 1) / length);
    for (int shift = 0; shift < kPasses * kDigitBits; shift += kDigitBits) {
        const auto digit = [shift](const Coded& c) { return c.code >> shift & (kDigits - 1); };
        const auto each = [&](size_t stretch, const auto& visit) {
            for (size_t i = stretch * length; i < std::min(codes.size(), (stretch + 1) * length); ++i) visit(codes[i]);
        };
        parallel_for(next.size(), threads, [&](size_t stretch) {
            auto& count = next[stretch];
            count.fill(0);
            each(stretch, [&](const Coded& c) { ++count[digit(c)]; });
        });
        uint32_t sum = 0;
        for (size_t d = 0; d < kDigits; ++d)
            for (auto& stretch : next) sum += std::exchange(stretch[d], sum);
        parallel_for(next.size(), threads, [&](size_t stretch) {
            auto& to = next[stretch];
            each(stretch, [&](const Coded& c) { other[to[digit(c)]++] = c; });
        });
        codes.swap(other);
    }
}

/// Subtrees of one stretch of the curve.
template <class R> class Treelets {
  public:
    /// `cut`: may two references have the same id?
    Treelets(const LargeVector<BvhReference<R>>& references, LargeVector<Coded>& codes, const BvhLimits& limits, bool cut) : references_(references), codes_(codes), limits_(limits), cut_(cut) {
        for (uint32_t i = 0; i <= kSwept; ++i) blocks_[i] = double((i + limits.max_leaf - 1) / limits.max_leaf);
    }

    /// Of the references from `first` on, whose codes differ in no bit above `bit`.
    void add(uint32_t first, uint32_t end, int bit) {
        if (end - first <= kTreeletLeaves * limits_.max_leaf) {
            pad();
            roots.push_back({uint32_t(nodes.size()), uint32_t(order.size()), 0});
            nodes.emplace_back();
            grow(roots.back().node, first, end, bit, 0);
            return;
        }
        const uint32_t middle = divide(first, end, bit);
        const int below = bit - 1;
        add(first, middle, below), add(middle, end, below);
    }

    struct Root {
        uint32_t node, place;   ///< where its nodes and ids begin
        uint32_t depth;         ///< levels below it
    };
    std::vector<BvhNode<R>> nodes;   ///< in depth-first order of pairs; leaves: `first` is a place in `order`
    std::vector<uint32_t> order;     ///< ids, padded to blocks
    std::vector<Root> roots;

  private:
    void grow(uint32_t node, uint32_t first, uint32_t end, int bit, uint32_t depth) {
        if (end - first <= kSwept) {
            for (uint32_t i = first; i < end; ++i) few_[i - first] = references_[codes_[i].place];
            grow_few(node, 0, end - first, true, true, depth);
            return;
        }
        const uint32_t child = uint32_t(nodes.size());
        const uint32_t middle = depth < kBitDepth ? divide(first, end, bit) : first + (end - first) / 2;
        const int below = bit - 1;
        nodes.emplace_back(), nodes.emplace_back();
        grow(child, first, middle, below, depth + 1), grow(child + 1, middle, end, below, depth + 1);
        nodes[node].box = nodes[child].box, nodes[node].box.extend(nodes[child + 1].box);
        nodes[node].first = child;
    }

    /// Of some of few_. Divides them on the curve at the least cost: areas times started blocks. Of the areas the first part of a divided range has those below already, and the second those above.
    void grow_few(uint32_t node, uint32_t first, uint32_t end, bool wants_below, bool wants_above, uint32_t depth) {
        BoxEnds<R> box = BoxEnds<R>::none();
        if (end - first <= limits_.max_leaf) {
            for (uint32_t i = first; i < end; ++i) box.extend(few_[i]);
            nodes[node].box = box.box();
            return make_leaf(nodes[node], first, end, depth);
        }
        if (wants_below)
            for (uint32_t i = first; i < end; ++i) box.extend(few_[i]), below_[i] = box.half_area();
        if (wants_above) {
            box = BoxEnds<R>::none();
            for (uint32_t i = end; i-- > first;) box.extend(few_[i]), above_[i] = box.half_area();
        }
        const uint32_t middle = cheapest(first, end), child = uint32_t(nodes.size());
        nodes[node].box = box.box(), nodes[node].first = child;
        nodes.emplace_back(), nodes.emplace_back();
        grow_few(child, first, middle, false, true, depth + 1), grow_few(child + 1, middle, end, true, false, depth + 1);
    }

    uint32_t cheapest(uint32_t first, uint32_t end) const {
        const uint32_t count = end - first, least = (count + 3) / 4;   // on one side, so that paths are short
        uint32_t best = least;
        double best_cost = kInf;
        for (uint32_t i = least; i <= count - least; ++i)
            if (const double cost = below_[first + i - 1] * blocks_[i] + above_[first + i] * blocks_[count - i]; cost < best_cost) best = i, best_cost = cost;
        return first + best;
    }

    void pad() {
        while (order.size() % limits_.block) order.push_back(kPadding);
    }
    void make_leaf(BvhNode<R>& leaf, uint32_t first, uint32_t end, uint32_t depth) {
        pad();
        leaf.first = uint32_t(order.size());
        for (uint32_t i = first; i < end; ++i) {
            const uint32_t id = few_[i].id();
            if (!cut_ || std::find(order.begin() + leaf.first, order.end(), id) == order.end()) order.push_back(id);   // two parts of one are one
        }
        leaf.count = uint32_t(order.size()) - leaf.first;
        roots.back().depth = std::max(roots.back().depth, depth);
    }

    /// Where the highest bit changes that does; `bit` becomes its number. Where no code differs, they are made anew, of the stretch alone.
    uint32_t divide(uint32_t first, uint32_t end, int& bit) {
        if (codes_[first].code == codes_[end - 1].code && !refine(first, end)) return bit = 0, first + (end - first) / 2;
        bit = 31 - std::countl_zero(codes_[first].code ^ codes_[end - 1].code);
        const uint32_t mask = 1u << bit;
        const auto begin = codes_.begin();
        return uint32_t(std::partition_point(begin + first, begin + end, [mask](const Coded& c) { return !(c.code & mask); }) - begin);
    }

    bool refine(uint32_t first, uint32_t end) {
        CentroidBounds<R> bounds;
        for (uint32_t i = first; i < end; ++i) bounds.extend(references_[codes_[i].place]);
        const CentroidMap<R> map(bounds, kCells);
        for (uint32_t i = first; i < end; ++i) codes_[i].code = curve_code(references_[codes_[i].place], map);
        std::sort(codes_.begin() + first, codes_.begin() + end);
        return codes_[first].code != codes_[end - 1].code;
    }

    const LargeVector<BvhReference<R>>& references_;
    LargeVector<Coded>& codes_;
    BvhLimits limits_;
    bool cut_;
    std::array<double, kSwept + 1> blocks_;        ///< that so many references start
    std::array<BvhReference<R>, kSwept> few_;      ///< the references that are divided now, in their order on the curve
    std::array<double, kSwept> below_, above_;     ///< areas of those from the first of the range to each, and from each to the last
};

template <class R> class FastBuilder {
  public:
    FastBuilder(LargeVector<BvhReference<R>> references, const BvhLimits& limits, std::vector<uint32_t>& order, BuildStats& stats, const TriangleSource<R>* triangles)
        : references_(std::move(references)), limits_(limits), order_(order), stats_(stats), triangles_(triangles) {}

    LargeVector<BvhNode<R>> build() {
        if (references_.empty()) return {};
        make_codes();
        sort_codes(codes_, limits_.threads);
        make_treelets();
        LargeVector<BvhReference<R>> roots;
        roots.reserve(roots_.size());
        for (const auto& [stretch, root] : roots_) roots.emplace_back(stretches_[stretch].nodes[stretches_[stretch].roots[root].node].box, uint32_t(roots.size()));
        BvhLimits above{1, 1, limits_.isa, 0, limits_.threads, kDepthAbove};
        std::vector<uint32_t> places;
        BuildStats ignored;
        references_ = {}, codes_ = {};
        const auto top = build_bvh(std::move(roots), above, places, ignored);
        join(top, places);
        stats_.nodes = nodes_.size();
        return std::move(nodes_);
    }

  private:
    struct Extent {
        BoxEnds<R> box = BoxEnds<R>::none();
        CentroidBounds<R> centroids;
    };
    Extent extent() const {
        std::vector<Extent> parts((references_.size() + kRange - 1) / kRange);
        for_ranges(references_.size(), limits_.threads, [&](size_t first, size_t end) {
            Extent& part = parts[first / kRange];
            binning_passes<R>(limits_.isa).bound(std::span(references_).subspan(first, end - first), part.box, part.centroids);
        });
        Extent all;
        for (const Extent& part : parts) all.box.extend(part.box), all.centroids.extend(part.centroids);
        return all;
    }

    void make_codes() {
        Extent all = extent();
        const size_t whole = references_.size();
        if (triangles_) presplit(references_, all.box, *triangles_, limits_.growth, limits_.threads);
        cut_ = references_.size() > whole;
        if (cut_) all = extent();
        const CentroidMap<R> map(all.centroids, kCells);
        codes_.resize(references_.size());
        for_ranges(references_.size(), limits_.threads, [&](size_t first, size_t end) {
            for (size_t i = first; i < end; ++i) codes_[i] = {curve_code(references_[i], map), uint32_t(i)};
        });
    }

    /// Stretches end where the uppermost bits of codes change, so that they do not depend on threads.
    void make_treelets() {
        constexpr int kAbove = 9;   // bits
        std::vector<uint32_t> begins{0};
        const auto begin = codes_.begin();
        while (begins.back() < codes_.size()) {
            const uint32_t cell = codes_[begins.back()].code >> (30 - kAbove);
            begins.push_back(uint32_t(std::partition_point(begin + begins.back(), codes_.end(), [cell](const Coded& c) { return c.code >> (30 - kAbove) <= cell; }) - begin));
        }
        stretches_.reserve(begins.size());
        for (size_t i = 1; i < begins.size(); ++i) stretches_.emplace_back(references_, codes_, limits_, cut_);
        parallel_for(stretches_.size(), limits_.threads, [&](size_t i) {
            const size_t count = begins[i + 1] - begins[i];
            stretches_[i].nodes.reserve(count / 2 + 2), stretches_[i].order.reserve(count + count / 2 + limits_.block);
            stretches_[i].add(begins[i], begins[i + 1], 30 - kAbove);
        });
        for (uint32_t i = 0; i < stretches_.size(); ++i)
            for (uint32_t root = 0; root < stretches_[i].roots.size(); ++root) roots_.emplace_back(i, root);
    }

    /// All nodes in depth-first order of pairs, and the ids in that of the leaves. `places`: which root each leaf of `top` is.
    void join(const LargeVector<BvhNode<R>>& top, const std::vector<uint32_t>& places) {
        struct From {
            uint32_t node, to, depth;
        };
        size_t count = top.size(), ids = order_.size() + limits_.block * roots_.size();
        for (const auto& stretch : stretches_) count += stretch.nodes.size(), ids += stretch.order.size();
        nodes_.reserve(count), order_.reserve(ids);
        nodes_.emplace_back();
        std::vector<From> waiting{{0, 0, 0}};
        while (!waiting.empty()) {
            const From at = waiting.back();
            waiting.pop_back();
            if (top[at.node].leaf()) {
                put(roots_[places[top[at.node].first]], at.to, at.depth);
                continue;
            }
            const auto child = uint32_t(nodes_.size());
            nodes_[at.to] = top[at.node], nodes_[at.to].first = child;
            waiting.push_back({top[at.node].first + 1, child + 1, at.depth + 1}), waiting.push_back({top[at.node].first, child, at.depth + 1});
            nodes_.emplace_back(), nodes_.emplace_back();
        }
    }

    /// A subtree: its root at `to`, what is below it at the end.
    void put(const std::pair<uint32_t, uint32_t>& which, uint32_t to, uint32_t depth) {
        const Treelets<R>& from = stretches_[which.first];
        const auto& root = from.roots[which.second];
        const bool last = which.second + 1 == from.roots.size();
        const size_t end = last ? from.nodes.size() : from.roots[which.second + 1].node, end_place = last ? from.order.size() : from.roots[which.second + 1].place;
        order_.resize((order_.size() + limits_.block - 1) / limits_.block * limits_.block, kPadding);
        const auto places = uint32_t(order_.size()) - root.place, below = uint32_t(nodes_.size()) - (root.node + 1);
        for (size_t i = root.node; i < end; ++i) {
            BvhNode<R> node = from.nodes[i];
            stats_.leaves += node.leaf();
            node.first += node.leaf() ? places : below;
            if (i == root.node) nodes_[to] = node;
            else nodes_.push_back(node);
        }
        order_.insert(order_.end(), from.order.begin() + root.place, from.order.begin() + std::ptrdiff_t(end_place));
        stats_.depth = std::max(stats_.depth, size_t(depth) + root.depth);
    }

    LargeVector<BvhReference<R>> references_;
    BvhLimits limits_;
    std::vector<uint32_t>& order_;
    BuildStats& stats_;
    const TriangleSource<R>* triangles_;
    LargeVector<Coded> codes_;
    std::vector<Treelets<R>> stretches_;
    bool cut_ = false;   ///< are there more references than ids?
    std::vector<std::pair<uint32_t, uint32_t>> roots_;   ///< stretch, and number in it
    LargeVector<BvhNode<R>> nodes_;
};

}  // namespace

template <class R> LargeVector<BvhNode<R>> build_bvh_fast(LargeVector<BvhReference<R>> references, const BvhLimits& limits, std::vector<uint32_t>& order, BuildStats& stats, const TriangleSource<R>* triangles) {
    return FastBuilder<R>(std::move(references), limits, order, stats, triangles).build();
}

template LargeVector<BvhNode<float>> build_bvh_fast(LargeVector<BvhReference<float>>, const BvhLimits&, std::vector<uint32_t>&, BuildStats&, const TriangleSource<float>*);
template LargeVector<BvhNode<double>> build_bvh_fast(LargeVector<BvhReference<double>>, const BvhLimits&, std::vector<uint32_t>&, BuildStats&, const TriangleSource<double>*);

}  // namespace alidade
