// SPDX-License-Identifier: Apache-2.0
/// Leaves of triangles, tested by eights: no virtual call. Where the eight come from says `Blocks` (triangles/blocks.h).
#pragma once

#include "accel/triangles/blocks.h"
#include "accel/triangles/kernel.h"

#include <algorithm>
#include <array>
#include <bit>
#include <new>

namespace alidade {

template <class R, TriangleTest test = TriangleTest::exact, class Blocks = PackedBlocks<R>> class TriangleLeaf {
  public:
    using Real = R;
    using Source = TriangleSource<R>;
    static constexpr uint32_t kBlock = kLanes;
    static constexpr TriangleTest kTest = test;
    using Kernel = TriangleKernel<R, test>;
    static constexpr RayEntry kEntry = Kernel::kEntry;

    struct Probe {
        Probe(const TriangleLeaf&, const Ray& r, const LocalRay& l, uint32_t id) : ray(r), local(l), instance(id) {}
        [[gnu::always_inline]] inline void prepare() {
            if (!prepared) make();
        }
        [[gnu::noinline]] void make() { ::new (&kernel) typename Kernel::Ray(ray, local), prepared = true; }   // in a walk of its own it would take the registers of the loop
        const auto& filter() const { return kernel.filter; }

        union {
            typename Kernel::Ray kernel;   ///< once it is prepared
        };
        bool prepared = false;
        const Ray& ray;
        const LocalRay& local;
        uint32_t instance;
        mutable uint32_t place = kPadding;   ///< where the triangle stands that closest() hit last
        mutable std::array<uint32_t, 4> decided{kPadding, kPadding, kPadding, kPadding};   ///< the last ids, of ranges: neighbouring cells of a grid hold the same triangles
        mutable uint32_t decisions = 0;
    };

    TriangleLeaf(const Source& source, const std::vector<uint32_t>& order, const AccelOptions& options) : blocks_(source, order, options.threads, test == TriangleTest::watertight), filter_(Kernel::filter(options.isa)) {}
    TriangleLeaf(Blocks blocks, const AccelOptions& options) : blocks_(std::move(blocks)), filter_(Kernel::filter(options.isa)) {}

    bool closest(const Probe& probe, uint32_t first, uint32_t count, Hit& hit, WorkCounters& work) const {
        bool found = false;
        for_each_block(probe, first, count, work, [&](const TriangleBlock<R>& block, uint32_t number, uint32_t lanes) {
            found |= closest_of(probe, block, number, lanes, probe.local.tmax, hit, work);
            return false;
        });
        return found;
    }
    bool any(const Probe& probe, uint32_t first, uint32_t count, WorkCounters& work) const {
        return for_each_block(probe, first, count, work, [&](const TriangleBlock<R>& block, uint32_t, uint32_t lanes) { return any_of(probe, block, lanes, work); });
    }
    void all(const Probe& probe, uint32_t first, uint32_t count, std::vector<Hit>& hits, WorkCounters& work) const {
        for_each_block(probe, first, count, work, [&](const TriangleBlock<R>& block, uint32_t, uint32_t lanes) {
            all_of(probe, block, lanes, hits, work);
            return false;
        });
    }

    /// The same of the triangles of a block, the one of that number, whose bits are set in `lanes`. Hits beyond `limit`, in local t, would come behind `hit`.
    bool closest_of(const Probe& probe, const TriangleBlock<R>& block, uint32_t number, uint32_t lanes, double limit, Hit& hit, WorkCounters& work) const {
        bool found = false;
        for_each_hit(probe, block, lanes, limit, work, [&](const Found& f) {
            if (!comes_before(f.t, probe.instance, f.id, hit)) return false;
            hit.t = f.t, hit.instance = probe.instance, hit.primitive = f.id, hit.part = 0;
            hit.u = float(f.crossing.u), hit.v = float(f.crossing.v);
            probe.place = number * kLanes + f.lane;
            found = true;
            return false;
        });
        return found;
    }
    /// What of a hit is only computed once, after closest() found it.
    void finish(const Probe& probe, Hit& hit) const {
        if (probe.place != kPadding) hit.error = Kernel::error(probe.ray, hit.t, blocks_.corners(probe.place));
    }
    bool any_of(const Probe& probe, const TriangleBlock<R>& block, uint32_t lanes, WorkCounters& work) const {
        return for_each_hit(probe, block, lanes, probe.local.tmax, work, [](const Found&) { return true; });
    }
    void all_of(const Probe& probe, const TriangleBlock<R>& block, uint32_t lanes, std::vector<Hit>& hits, WorkCounters& work) const {
        for_each_hit(probe, block, lanes, probe.local.tmax, work, [&](const Found& f) {
            hits.push_back(make_hit(probe, f));
            return false;
        });
    }

    uint32_t id(uint32_t place) const { return blocks_.id(place); }
    const Blocks& blocks() const { return blocks_; }
    Blocks& blocks() { return blocks_; }
    uint32_t filter(const TriangleBlock<R>& block, const auto& ray, bool near) const { return filter_(block, ray, near); }
    size_t bytes() const { return blocks_.bytes(); }

  private:
    struct Found {
        double t;   ///< the caller's
        uint32_t id, lane;
        const TriangleCrossing& crossing;
        const Corners& corners;
    };

    /// Calls visit(block, its number, lanes) for each block with triangles of the range that pass the filter, until it returns true; then returns true.
    template <class F> bool for_each_block(const Probe& probe, uint32_t first, uint32_t count, WorkCounters& work, F&& visit) const {
        work.filtered += count;
        for (uint32_t number = first / kLanes, end = first + count; number * kLanes < end; ++number) {
            const uint32_t start = number * kLanes;
            const TriangleBlock<R>& block = blocks_[number];
            uint32_t lanes = filter_(block, probe.filter(), false);
            if (start < first) lanes &= ~uint32_t(0) << (first - start);
            if (end - start < kLanes) lanes &= (1u << (end - start)) - 1;
            lanes = undecided(probe, block, lanes);
            if (lanes && visit(block, number, lanes)) return true;
        }
        return false;
    }

    /// Those of the lanes whose triangles were not decided lately. To decide one again would change nothing.
    static uint32_t undecided(const Probe& probe, const TriangleBlock<R>& block, uint32_t lanes) {
        uint32_t left = 0;
        for (; lanes; lanes &= lanes - 1) {
            const uint32_t lane = uint32_t(std::countr_zero(lanes)), id = block.id[lane];
            if (std::find(probe.decided.begin(), probe.decided.end(), id) != probe.decided.end()) continue;
            probe.decided[probe.decisions++ % probe.decided.size()] = id;
            left |= 1u << lane;
        }
        return left;
    }

    /// Calls found(Found) for each hit among the lanes until it returns true; then returns true.
    template <class F> bool for_each_hit(const Probe& probe, const TriangleBlock<R>& block, uint32_t lanes, double limit, WorkCounters& work, F&& found) const {
        for (; lanes; lanes &= lanes - 1) {
            if (decide_lane(probe, block, uint32_t(std::countr_zero(lanes)), limit, work, found)) return true;
        }
        return false;
    }

    template <class F> static bool decide_lane(const Probe& probe, const TriangleBlock<R>& block, uint32_t lane, double limit, WorkCounters& work, F&& found) {
        ++work.primitives;
        const Corners corners = block.corners(lane);
        const auto crossing = Kernel::crossing(probe.kernel, probe.local, block, lane, corners, limit, work);
        if (!crossing) return false;
        const double t = probe.local.caller_t(crossing->t);
        if (!(t >= probe.ray.tmin && t <= probe.ray.tmax && std::isfinite(t))) return false;
        return found(Found{t, block.id[lane], lane, *crossing, corners});
    }

    static Hit make_hit(const Probe& probe, const Found& f) {
        return {f.t, probe.instance, f.id, 0, float(f.crossing.u), float(f.crossing.v), Kernel::error(probe.ray, f.t, f.corners)};
    }

    Blocks blocks_;
    decltype(Kernel::filter(Isa::best)) filter_;
};

}  // namespace alidade
