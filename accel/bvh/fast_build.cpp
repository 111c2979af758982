// SPDX-License-Identifier: Apache-2.0
#include "accel/bvh/fast_build.h"

#include "accel/bvh/presplit.h"
#include "accel/leaf.h"
#include "core/parallel.h"

#include <algorithm>
#include <array>
#include <bit>
#include <tuple>
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

constexpr int kAxisBits = 10, kCells = 1 << kAxisBits, kDigitBits = 10, kDigits = 1 << kDigitBits, kPasses = 3;
static_assert(kPasses * kDigitBits == 3 * kAxisBits);

/// [i]: the bits of i with two zeros between them.
constexpr std::array<uint32_t, kCells> spread_bits() {
    std::array<uint32_t, kCells> out{};
    for (uint32_t i = 0; i < kCells; ++i)
        for (int bit = 0; bit < kAxisBits; ++bit) out[i] |= (i >> bit & 1u) << (3 * bit);
    return out;
}
constexpr std::array<uint32_t, kCells> kSpread = spread_bits();

template <class R> uint32_t morton_code(const BoxEnds<R>& box, const CentroidMap<R>& map) {
    return kSpread[size_t(map.bin(box, 0))] << 2 | kSpread[size_t(map.bin(box, 1))] << 1 | kSpread[size_t(map.bin(box, 2))];
}

/// A reference on the curve.
struct Coded {
    uint32_t code, place;
    friend bool operator<(const Coded& a, const Coded& b) { return a.code != b.code ? a.code < b.code : a.place < b.place; }
};

/// By code, then by place, as they are given. Method: least digit first; ranges are counted, then moved, each by one thread.
void sort_codes(LargeVector<Coded>& codes, int threads) {
    if (codes.size() < kRange) return std::sort(codes.begin(), codes.end());
    LargeVector<Coded> other(codes.size());
    std::vector<std::array<uint32_t, kDigits>> next((codes.size() + kRange - 1) / kRange);
    for (int shift = 0; shift < kPasses * kDigitBits; shift += kDigitBits) {
        const auto digit = [shift](const Coded& c) { return c.code >> shift & (kDigits - 1); };
        for_ranges(codes.size(), threads, [&](size_t first, size_t end) {
            auto& count = next[first / kRange];
            count.fill(0);
            for (size_t i = first; i < end; ++i) ++count[digit(codes[i])];
        });
        uint32_t sum = 0;
        for (size_t d = 0; d < kDigits; ++d)
            for (auto& range : next) sum += std::exchange(range[d], sum);
        for_ranges(codes.size(), threads, [&](size_t first, size_t end) {
            auto& to = next[first / kRange];
            for (size_t i = first; i < end; ++i) other[to[digit(codes[i])]++] = codes[i];
        });
        codes.swap(other);
    }
}

/// Subtrees of one stretch of the curve.
template <class R> class Treelets {
  public:
    Treelets(const LargeVector<BvhReference<R>>& references, LargeVector<Coded>& codes, const BvhLimits& limits) : references_(references), codes_(codes), limits_(limits) {
        for (uint32_t i = 0; i <= kSwept; ++i) blocks_[i] = double((i + limits.max_leaf - 1) / limits.max_leaf);
    }

    /// Of the references from `first` on, whose codes differ in no bit above `bit`.
    void add(uint32_t first, uint32_t end, int bit) {
        if (end - first <= kTreeletLeaves * limits_.max_leaf) {
            roots.push_back(uint32_t(nodes.size()));
            nodes.emplace_back();
            grow(roots.back(), first, end, bit, 0);
            return;
        }
        const uint32_t middle = divide(first, end, bit);
        const int below = bit - 1;
        add(first, middle, below), add(middle, end, below);
    }

    std::vector<BvhNode<R>> nodes;   ///< leaves: `first` is a place on the curve
    std::vector<uint32_t> roots;

  private:
    void grow(uint32_t node, uint32_t first, uint32_t end, int bit, uint32_t depth) {
        if (end - first <= limits_.max_leaf) {
            BoxEnds<R> box = BoxEnds<R>::none();
            for (uint32_t i = first; i < end; ++i) box.extend(references_[codes_[i].place]);
            nodes[node] = {box.box(), first, end - first};
            return;
        }
        const uint32_t child = uint32_t(nodes.size());
        const uint32_t middle = end - first <= kSwept ? swept(first, end) : depth < kBitDepth ? divide(first, end, bit) : first + (end - first) / 2;
        const int below = bit - 1;
        nodes.emplace_back(), nodes.emplace_back();
        grow(child, first, middle, below, depth + 1), grow(child + 1, middle, end, below, depth + 1);
        nodes[node].box = nodes[child].box, nodes[node].box.extend(nodes[child + 1].box);
        nodes[node].first = child;
    }

    /// Where on the curve a few leaves are divided at the least cost: areas times started blocks.
    uint32_t swept(uint32_t first, uint32_t end) const {
        const uint32_t count = end - first, least = (count + 3) / 4, most = count - least;   // on one side, so that paths are short
        std::array<double, kSwept> above;
        BoxEnds<R> box = BoxEnds<R>::none();
        for (uint32_t i = count; i-- > least;) {
            box.extend(references_[codes_[first + i].place]);
            if (i <= most) above[i] = box.half_area() * blocks_[count - i];
        }
        box = BoxEnds<R>::none();
        uint32_t best = least;
        double best_cost = kInf;
        for (uint32_t i = 1; i <= most; ++i) {
            box.extend(references_[codes_[first + i - 1].place]);
            if (i < least) continue;
            if (const double cost = box.half_area() * blocks_[i] + above[i]; cost < best_cost) best = i, best_cost = cost;
        }
        return first + best;
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
        for (uint32_t i = first; i < end; ++i) codes_[i].code = morton_code(references_[codes_[i].place], map);
        std::sort(codes_.begin() + first, codes_.begin() + end);
        return codes_[first].code != codes_[end - 1].code;
    }

    const LargeVector<BvhReference<R>>& references_;
    LargeVector<Coded>& codes_;
    BvhLimits limits_;
    std::array<double, kSwept + 1> blocks_;   ///< that so many references start
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
        for (const auto& [stretch, node] : roots_) roots.emplace_back(stretches_[stretch].nodes[node].box, uint32_t(roots.size()));
        BvhLimits above{1, 1, limits_.isa, 0, limits_.threads, kDepthAbove};
        std::vector<uint32_t> places;
        BuildStats ignored;
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
        if (references_.size() > whole) all = extent();
        const CentroidMap<R> map(all.centroids, kCells);
        codes_.resize(references_.size());
        for_ranges(references_.size(), limits_.threads, [&](size_t first, size_t end) {
            for (size_t i = first; i < end; ++i) codes_[i] = {morton_code(references_[i], map), uint32_t(i)};
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
        for (size_t i = 1; i < begins.size(); ++i) stretches_.emplace_back(references_, codes_, limits_);
        parallel_for(stretches_.size(), limits_.threads, [&](size_t i) {
            stretches_[i].nodes.reserve((begins[i + 1] - begins[i]) / 2 + 2);
            stretches_[i].add(begins[i], begins[i + 1], 30 - kAbove);
        });
        for (uint32_t i = 0; i < stretches_.size(); ++i)
            for (const uint32_t root : stretches_[i].roots) roots_.emplace_back(i, root);
    }

    /// All nodes in depth-first order of pairs, and the ids in that of the leaves. `places`: which root each leaf of `top` is.
    void join(const LargeVector<BvhNode<R>>& top, const std::vector<uint32_t>& places) {
        struct From {
            uint32_t stretch, node, to, depth;
        };
        constexpr uint32_t kTop = ~0u;
        size_t count = top.size();
        for (const auto& stretch : stretches_) count += stretch.nodes.size();
        nodes_.reserve(count), order_.reserve(order_.size() + references_.size() * 3 / 2);
        nodes_.emplace_back();
        std::vector<From> waiting{{kTop, 0, 0, 0}};
        while (!waiting.empty()) {
            From at = waiting.back();
            waiting.pop_back();
            if (at.stretch == kTop && top[at.node].leaf()) std::tie(at.stretch, at.node) = roots_[places[top[at.node].first]];
            const BvhNode<R>& node = at.stretch == kTop ? top[at.node] : stretches_[at.stretch].nodes[at.node];
            nodes_[at.to] = node;
            if (node.leaf()) {
                make_leaf(nodes_[at.to], at.depth);
                continue;
            }
            const auto child = nodes_[at.to].first = uint32_t(nodes_.size());
            waiting.push_back({at.stretch, node.first + 1, child + 1, at.depth + 1}), waiting.push_back({at.stretch, node.first, child, at.depth + 1});
            nodes_.emplace_back(), nodes_.emplace_back();
        }
    }

    void make_leaf(BvhNode<R>& leaf, uint32_t depth) {
        const size_t place = (order_.size() + limits_.block - 1) / limits_.block * limits_.block;
        order_.resize(place, kPadding);
        const uint32_t first = std::exchange(leaf.first, uint32_t(place));
        for (uint32_t i = 0; i < leaf.count; ++i) {
            const uint32_t id = references_[codes_[first + i].place].id();
            if (std::find(order_.begin() + std::ptrdiff_t(place), order_.end(), id) == order_.end()) order_.push_back(id);   // two parts of one are one
        }
        leaf.count = uint32_t(order_.size() - place);
        ++stats_.leaves;
        stats_.depth = std::max(stats_.depth, size_t(depth));
    }

    LargeVector<BvhReference<R>> references_;
    BvhLimits limits_;
    std::vector<uint32_t>& order_;
    BuildStats& stats_;
    const TriangleSource<R>* triangles_;
    LargeVector<Coded> codes_;
    std::vector<Treelets<R>> stretches_;
    std::vector<std::pair<uint32_t, uint32_t>> roots_;   ///< stretch, node
    LargeVector<BvhNode<R>> nodes_;
};

}  // namespace

template <class R> LargeVector<BvhNode<R>> build_bvh_fast(LargeVector<BvhReference<R>> references, const BvhLimits& limits, std::vector<uint32_t>& order, BuildStats& stats, const TriangleSource<R>* triangles) {
    return FastBuilder<R>(std::move(references), limits, order, stats, triangles).build();
}

template LargeVector<BvhNode<float>> build_bvh_fast(LargeVector<BvhReference<float>>, const BvhLimits&, std::vector<uint32_t>&, BuildStats&, const TriangleSource<float>*);
template LargeVector<BvhNode<double>> build_bvh_fast(LargeVector<BvhReference<double>>, const BvhLimits&, std::vector<uint32_t>&, BuildStats&, const TriangleSource<double>*);

}  // namespace alidade
