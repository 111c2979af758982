// SPDX-License-Identifier: Apache-2.0
#include "accel/bvh/spatial.h"

#include "core/error_bound.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace alidade {

namespace {

/// Not greater than x, in R.
template <class R> R rounded_down(double x) {
    const R near = R(x);
    return double(near) > x ? -std::nextafter(-near, std::numeric_limits<R>::infinity()) : near;
}

/// Holds all of a triangle on one side of a plane.
template <class R> class Hull {
  public:
    /// A corner: exact.
    void corner(const Vec3& p) { low_ = glm::min(low_, p), high_ = glm::max(high_, p); }

    /// Where the edge from a to b crosses the plane, s of the way. The pad is more than the roundings; no point of an edge is outside of the box of its ends.
    void crossing(const Vec3& a, const Vec3& b, double s) {
        const Vec3 p = a + s * (b - a), low = glm::min(a, b), high = glm::max(a, b);
        const Vec3 pad = gamma_bound(24) * glm::max(glm::abs(a), glm::abs(b)) + Vec3(0x1p-1070);
        low_ = glm::min(low_, glm::max(p - pad, low)), high_ = glm::max(high_, glm::min(p + pad, high));
    }

    /// The common part with `box`, and with one side of the plane.
    BoxEnds<R> within(const BoxEnds<R>& box) const {
        BoxEnds<R> part = BoxEnds<R>::none();
        for (int a = 0; a < 3; ++a) {
            part.v[a] = std::min(-rounded_down<R>(low_[a]), box.v[a]);
            part.v[4 + a] = std::min(-rounded_down<R>(-high_[a]), box.v[4 + a]);
        }
        return part;
    }

  private:
    Vec3 low_{kInf}, high_{-kInf};
};

template <class R> bool is_empty(const BoxEnds<R>& box) { return !(box.min(0) <= box.max(0) && box.min(1) <= box.max(1) && box.min(2) <= box.max(2)); }

}  // namespace

template <class R> Parts<R> cut(const Corners& corners, const BoxEnds<R>& box, int axis, R plane) {
    Hull<R> below, above;
    for (size_t i = 0; i < 3; ++i) {
        const Vec3 &a = corners[i], &b = corners[(i + 1) % 3];
        const double at = a[axis] - double(plane), to = b[axis] - double(plane);
        if (at <= 0) below.corner(a);
        if (at >= 0) above.corner(a);
        if ((at < 0 && to > 0) || (at > 0 && to < 0)) {
            const double s = at / (a[axis] - b[axis]);
            below.crossing(a, b, s), above.crossing(a, b, s);
        }
    }
    BoxEnds<R> low = box, high = box;
    low.v[4 + axis] = std::min(low.v[4 + axis], plane), high.v[axis] = std::min(high.v[axis], -plane);
    Parts<R> parts{below.within(low), above.within(high)};
    if (is_empty(parts.below)) parts.below = BoxEnds<R>::none();
    if (is_empty(parts.above)) parts.above = BoxEnds<R>::none();
    return parts;
}

namespace {

template <class R> bool is_none(const BoxEnds<R>& box) { return box.v[0] == -std::numeric_limits<R>::infinity(); }

/// Where the planes across an axis meet a triangle, as far as bins need it: not rounded outwards.
template <class R> class Sections {
  public:
    using Point = std::array<R, 4>;   // four lanes are one vector

    Sections(const Corners& corners, int axis) : axis_(size_t(axis)) {
        for (size_t i = 0; i < 3; ++i) corner_[i] = {R(corners[i].x), R(corners[i].y), R(corners[i].z), R(0)};
        if (corner_[1][axis_] < corner_[0][axis_]) std::swap(corner_[0], corner_[1]);
        if (corner_[2][axis_] < corner_[1][axis_]) std::swap(corner_[1], corner_[2]);
        if (corner_[1][axis_] < corner_[0][axis_]) std::swap(corner_[0], corner_[1]);
        slope_[0] = slope(0, 2), slope_[1] = slope(0, 1), slope_[2] = slope(1, 2);
    }

    /// The box of what a plane meets, moved to the nearest end if it misses.
    BoxEnds<R> at(R plane) const {
        const R at = std::clamp(plane, corner_[0][axis_], corner_[2][axis_]);
        const Point p = along(0, slope_[0], at), q = at < corner_[1][axis_] ? along(0, slope_[1], at) : along(1, slope_[2], at);
        BoxEnds<R> box;
        for (size_t k = 0; k < 4; ++k) box.v[k] = -(p[k] < q[k] ? p[k] : q[k]);
        for (size_t k = 0; k < 4; ++k) box.v[4 + k] = p[k] > q[k] ? p[k] : q[k];
        return box;
    }
    /// The corner that is neither the first nor the last along the axis, and its place there.
    BoxEnds<R> middle() const {
        BoxEnds<R> box;
        for (size_t k = 0; k < 4; ++k) box.v[k] = -corner_[1][k], box.v[4 + k] = corner_[1][k];
        return box;
    }
    R middle_at() const { return corner_[1][axis_]; }

  private:
    Point slope(size_t from, size_t to) const {
        Point s;
        const R width = corner_[to][axis_] - corner_[from][axis_], inverse = width > 0 ? 1 / width : R(0);
        for (size_t k = 0; k < 4; ++k) s[k] = (corner_[to][k] - corner_[from][k]) * inverse;
        return s;
    }
    Point along(size_t from, const Point& slope, R at) const {
        Point p;
        const R s = at - corner_[from][axis_];
        for (size_t k = 0; k < 4; ++k) p[k] = corner_[from][k] + s * slope[k];
        return p;
    }

    size_t axis_;
    Point corner_[3], slope_[3];   ///< in the order of the axis; from the first to the last, to the middle one, and from that to the last
};

/// Slabs of equal width along an axis, and what of the references is in each.
template <class R> class Slabs {
  public:
    Slabs(const BoundsT<R>& box, int axis) : axis_(axis), low_(box.min[axis]), width_((box.max[axis] - low_) / kSpatialBins), inverse_(1 / width_) {
        for (int i = 0; i < kSpatialBins; ++i) bins_[size_t(i)] = {BoxEnds<R>::none(), 0, 0};
    }
    bool divides() const { return plane(1) > low_ && plane(kSpatialBins - 1) > plane(kSpatialBins - 2) && std::isfinite(inverse_); }
    R plane(int i) const { return low_ + R(i) * width_; }

    /// A reference that stands for `weight` of them.
    void add(const BvhReference<R>& reference, uint32_t weight, const TriangleSource<R>& triangles) {
        const int first = slab(reference.min(axis_)), last = slab(reference.max(axis_));
        bins_[size_t(first)].entering += weight, bins_[size_t(last)].leaving += weight;
        if (first == last) return bins_[size_t(first)].box.extend(reference);
        const Sections<R> sections(triangles.corners(reference.id()), axis_);
        const R at = sections.middle_at();
        const int middle = reference.min(axis_) <= at && at <= reference.max(axis_) ? slab(at) : -1;
        BoxEnds<R> low = sections.at(reference.min(axis_));
        for (int i = first; i <= last; ++i) {
            const BoxEnds<R> high = sections.at(i == last ? reference.max(axis_) : plane(i + 1));
            BoxEnds<R> part = low;
            part.extend(high);
            if (i == middle) part.extend(sections.middle());
            for (int k = 0; k < 8; ++k) part.v[k] = reference.v[k] < part.v[k] ? reference.v[k] : part.v[k];
            bins_[size_t(i)].box.extend(part);
            low = high;
        }
    }

    void sweep(uint32_t block, SpatialSplit<R>& best) const {
        std::array<SpatialSide<R>, kSpatialBins + 1> above;
        for (size_t i = kSpatialBins; i-- > 1;) {
            above[i] = above[i + 1];
            if (bins_[i].used()) above[i].box.extend(bins_[i].box), above[i].count += bins_[i].leaving;
        }
        SpatialSide<R> below;
        for (size_t i = 1; i < kSpatialBins; ++i) {
            if (bins_[i - 1].used()) below.box.extend(bins_[i - 1].box), below.count += bins_[i - 1].entering;
            if (below.count == 0 || above[i].count == 0) continue;
            const double cost = below.box.half_area() * blocks(below.count, block) + above[i].box.half_area() * blocks(above[i].count, block);
            if (cost < best.cost) best = {cost, axis_, plane(int(i)), below, above[i]};
        }
    }

  private:
    struct Bin {
        BoxEnds<R> box;
        uint32_t entering, leaving;   ///< references whose first, and last, part is here
        bool used() const { return !is_none(box); }
    };

    static double blocks(uint32_t count, uint32_t block) { return double((count + block - 1) / block); }
    int slab(R x) const { return int(std::clamp((x - low_) * inverse_, R(0), R(kSpatialBins - 1))); }

    int axis_;
    R low_, width_, inverse_;
    std::array<Bin, kSpatialBins> bins_;
};

/// So many of the small ones are looked at, of a node that has more, and so many of the large ones, which are fewer and decide. Large is what has this part of the node's area, and so lies across slabs.
constexpr size_t kSampled = 64;
constexpr double kLargePart = 256;

/// A reference, and how many it stands for.
template <class R> using Sampled = std::pair<const BvhReference<R>*, uint32_t>;

template <class R> std::vector<Sampled<R>> sampled(std::span<const BvhReference<R>> references, double area) {
    const R large = R(std::sqrt(area / kLargePart));
    const auto is_large = [&](const BvhReference<R>& reference) { return size_t(reference.largest() > large); };
    std::array<size_t, 2> count{}, stride{}, seen{};
    for (const BvhReference<R>& reference : references) ++count[is_large(reference)];
    for (size_t i = 0; i < 2; ++i) stride[i] = std::max(size_t(1), count[i] / kSampled);
    std::vector<Sampled<R>> sample;
    sample.reserve(count[0] / stride[0] + count[1] / stride[1] + 2);
    for (const BvhReference<R>& reference : references) {
        const size_t i = is_large(reference);
        if (seen[i]++ % stride[i] == 0) sample.emplace_back(&reference, uint32_t(stride[i]));
    }
    return sample;
}

/// Decides of triangles on the plane, one after the other, what it costs least to do.
template <class R> class Unsplitter {
  public:
    explicit Unsplitter(const SpatialSplit<R>& split) : below_(split.below.box), above_(split.above.box), lows_(split.below.count), highs_(split.above.count) {}

    enum class Side { both, below, above };
    Side side(const BoxEnds<R>& whole, bool may_cut) {
        BoxEnds<R> with_below = below_, with_above = above_;
        with_below.extend(whole), with_above.extend(whole);
        const double low = below_.half_area(), high = above_.half_area(), fewer_lows = std::max(lows_ - 1, 0.0), fewer_highs = std::max(highs_ - 1, 0.0);
        const double split = may_cut ? low * lows_ + high * highs_ : kInf;
        const double to_below = with_below.half_area() * lows_ + high * fewer_highs, to_above = low * fewer_lows + with_above.half_area() * highs_;
        if (split <= to_below && split <= to_above) return Side::both;
        if (to_below <= to_above) return below_ = with_below, highs_ = fewer_highs, Side::below;
        return above_ = with_above, lows_ = fewer_lows, Side::above;
    }

  private:
    BoxEnds<R> below_, above_;
    double lows_, highs_;   ///< estimates, where the node was sampled
};

template <class R> BvhReference<R> part_of(const BvhReference<R>& reference, const BoxEnds<R>& part) { return {part.box(), reference.id()}; }

}  // namespace

template <class R> SpatialSplit<R> best_plane(std::span<const BvhReference<R>> references, const TriangleSource<R>& triangles, const BoundsT<R>& box, uint32_t block) {
    const std::vector<Sampled<R>> sample = sampled(references, area(box));
    SpatialSplit<R> best;
    for (int axis = 0; axis < 3; ++axis) {
        Slabs<R> slabs(box, axis);
        if (!slabs.divides()) continue;
        for (const auto& [reference, weight] : sample) slabs.add(*reference, weight, triangles);
        slabs.sweep(block, best);
    }
    return best;
}

template <class R>
std::pair<size_t, size_t> divide_by_plane(std::span<BvhReference<R>> references, BvhReference<R>* below, const TriangleSource<R>& triangles, const SpatialSplit<R>& split, size_t budget) {
    using Side = typename Unsplitter<R>::Side;
    Unsplitter<R> unsplitter(split);
    size_t highs = 0, lows = 0;
    for (size_t i = 0; i < references.size(); ++i) {
        const BvhReference<R> at = references[i];
        Parts<R> parts{at, at};
        Side side = at.max(split.axis) <= split.plane ? Side::below : Side::above;
        if (at.min(split.axis) < split.plane && at.max(split.axis) > split.plane) {
            parts = cut(triangles.corners(at.id()), at, split.axis, split.plane);
            side = is_none(parts.above) ? Side::below : is_none(parts.below) ? Side::above : unsplitter.side(at, lows + highs < i + budget);
            if (side != Side::both) parts = {at, at};
        }
        if (side != Side::below) references[highs++] = part_of(at, parts.above);
        if (side != Side::above) below[lows++] = part_of(at, parts.below);
    }
    return {lows, highs};
}

template Parts<float> cut(const Corners&, const BoxEnds<float>&, int, float);
template Parts<double> cut(const Corners&, const BoxEnds<double>&, int, double);
template SpatialSplit<float> best_plane(std::span<const BvhReference<float>>, const TriangleSource<float>&, const BoundsT<float>&, uint32_t);
template SpatialSplit<double> best_plane(std::span<const BvhReference<double>>, const TriangleSource<double>&, const BoundsT<double>&, uint32_t);
template std::pair<size_t, size_t> divide_by_plane(std::span<BvhReference<float>>, BvhReference<float>*, const TriangleSource<float>&, const SpatialSplit<float>&, size_t);
template std::pair<size_t, size_t> divide_by_plane(std::span<BvhReference<double>>, BvhReference<double>*, const TriangleSource<double>&, const SpatialSplit<double>&, size_t);

}  // namespace alidade
