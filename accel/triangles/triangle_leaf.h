// SPDX-License-Identifier: Apache-2.0
/// Leaves of triangles packed by eights in the order of traversal: no index, no vertex array, no virtual call.
#pragma once

#include "accel/triangles/kernel.h"
#include "accel/triangles/triangle_source.h"
#include "core/large_array.h"
#include "core/parallel.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace alidade {

template <class R, TriangleTest test = TriangleTest::exact> class TriangleLeaf {
  public:
    using Real = R;
    using Source = TriangleSource<R>;
    static constexpr uint32_t kBlock = kLanes;
    using Kernel = TriangleKernel<R, test>;
    static constexpr bool kMovesRay = Kernel::kMovesRay;

    struct Probe : Kernel::Ray {
        Probe(const TriangleLeaf&, const Ray& r, const LocalRay& l, uint32_t id) : Kernel::Ray(r, l), ray(r), local(l), instance(id) {}
        const Ray& ray;
        const LocalRay& local;
        uint32_t instance;
        mutable uint32_t place = kPadding;   ///< where the triangle stands that closest() hit last
        mutable std::array<uint32_t, 4> decided{kPadding, kPadding, kPadding, kPadding};   ///< the last ids, of ranges: neighbouring cells of a grid hold the same triangles
        mutable uint32_t decisions = 0;
    };

    TriangleLeaf(const Source& source, const std::vector<uint32_t>& order, const AccelOptions& options)
        : TriangleLeaf(packed(source, order, options.threads), options) {}
    TriangleLeaf(LargeArray<TriangleBlock<R>> blocks, const AccelOptions& options) : blocks_(std::move(blocks)), filter_(Kernel::filter(options.isa)) {}

    bool closest(const Probe& probe, uint32_t first, uint32_t count, Hit& hit, WorkCounters& work) const {
        bool found = false;
        for_each_block(probe, first, count, work, [&](uint32_t block, uint32_t lanes) {
            found |= closest_of(probe, block, lanes, probe.local.tmax, hit, work);
            return false;
        });
        return found;
    }
    bool any(const Probe& probe, uint32_t first, uint32_t count, WorkCounters& work) const {
        return for_each_block(probe, first, count, work, [&](uint32_t block, uint32_t lanes) { return any_of(probe, block, lanes, work); });
    }
    void all(const Probe& probe, uint32_t first, uint32_t count, std::vector<Hit>& hits, WorkCounters& work) const {
        for_each_block(probe, first, count, work, [&](uint32_t block, uint32_t lanes) {
            all_of(probe, block, lanes, hits, work);
            return false;
        });
    }

    /// The same of the triangles of a block whose bits are set in `lanes`. Hits beyond `limit`, in local t, would come behind `hit`.
    bool closest_of(const Probe& probe, uint32_t block, uint32_t lanes, double limit, Hit& hit, WorkCounters& work) const {
        bool found = false;
        for_each_hit(probe, block, lanes, limit, work, [&](const Found& f) {
            if (!comes_before(f.t, probe.instance, f.id, hit)) return false;
            hit.t = f.t, hit.instance = probe.instance, hit.primitive = f.id, hit.part = 0;
            hit.u = float(f.crossing.u), hit.v = float(f.crossing.v);
            probe.place = block * kLanes + f.lane;
            found = true;
            return false;
        });
        return found;
    }
    /// What of a hit is only computed once, after closest() found it.
    void finish(const Probe& probe, Hit& hit) const {
        if (probe.place != kPadding) hit.error = Kernel::error(probe.ray, hit.t, blocks_[probe.place / kLanes].corners(probe.place % kLanes));
    }
    bool any_of(const Probe& probe, uint32_t block, uint32_t lanes, WorkCounters& work) const {
        return for_each_hit(probe, block, lanes, probe.local.tmax, work, [](const Found&) { return true; });
    }
    void all_of(const Probe& probe, uint32_t block, uint32_t lanes, std::vector<Hit>& hits, WorkCounters& work) const {
        for_each_hit(probe, block, lanes, probe.local.tmax, work, [&](const Found& f) {
            hits.push_back(make_hit(probe, f));
            return false;
        });
    }

    uint32_t id(uint32_t place) const { return blocks_[place / kLanes].id[place % kLanes]; }
    const TriangleBlock<R>& block(uint32_t i) const { return blocks_[i]; }
    uint32_t filter(const TriangleBlock<R>& block, const auto& ray) const { return filter_(block, ray); }
    std::span<const TriangleBlock<R>> blocks() const { return blocks_.view(); }
    std::span<TriangleBlock<R>> writable_blocks() { return blocks_.writable(); }
    size_t bytes() const { return blocks_.bytes(); }

  private:
    static LargeVector<TriangleBlock<R>> packed(const Source& source, const std::vector<uint32_t>& order, int threads) {
        LargeVector<TriangleBlock<R>> blocks((order.size() + kLanes - 1) / kLanes);
        for_ranges(blocks.size(), threads, [&](size_t first, size_t end) {
            for (size_t b = first; b < end; ++b) {
                std::memset(static_cast<void*>(&blocks[b]), 0, sizeof(TriangleBlock<R>));   // where no triangle is, filters read zeros; the bytes between, too: they go to files
                for (size_t place = b * kLanes; place < std::min(order.size(), (b + 1) * kLanes); ++place) {
                    if (order[place] == kPadding) continue;
                    blocks[b].put(source.corners(order[place]), uint32_t(place % kLanes));
                    blocks[b].id[place % kLanes] = order[place];
                }
            }
        });
        return blocks;
    }

    struct Found {
        double t;   ///< the caller's
        uint32_t id, lane;
        const TriangleCrossing& crossing;
        const Corners& corners;
    };

    /// Calls visit(block, lanes) for each block with triangles of the range that pass the filter, until it returns true; then returns true.
    template <class F> bool for_each_block(const Probe& probe, uint32_t first, uint32_t count, WorkCounters& work, F&& visit) const {
        work.filtered += count;
        for (uint32_t block = first / kLanes, end = first + count; block * kLanes < end; ++block) {
            const uint32_t start = block * kLanes;
            uint32_t lanes = filter_(blocks_[block], probe.filter);
            if (start < first) lanes &= ~uint32_t(0) << (first - start);
            if (end - start < kLanes) lanes &= (1u << (end - start)) - 1;
            lanes = undecided(probe, blocks_[block], lanes);
            if (lanes && visit(block, lanes)) return true;
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
    template <class F> bool for_each_hit(const Probe& probe, uint32_t block, uint32_t lanes, double limit, WorkCounters& work, F&& found) const {
        for (; lanes; lanes &= lanes - 1) {
            if (decide_lane(probe, blocks_[block], uint32_t(std::countr_zero(lanes)), limit, work, found)) return true;
        }
        return false;
    }

    template <class F> static bool decide_lane(const Probe& probe, const TriangleBlock<R>& block, uint32_t lane, double limit, WorkCounters& work, F&& found) {
        ++work.primitives;
        const Corners corners = block.corners(lane);
        const auto crossing = Kernel::crossing(probe, probe.local, block, lane, corners, limit, work);
        if (!crossing) return false;
        const double t = probe.local.caller_t(crossing->t);
        if (!(t >= probe.ray.tmin && t <= probe.ray.tmax && std::isfinite(t))) return false;
        return found(Found{t, block.id[lane], lane, *crossing, corners});
    }

    static Hit make_hit(const Probe& probe, const Found& f) {
        return {f.t, probe.instance, f.id, 0, float(f.crossing.u), float(f.crossing.v), Kernel::error(probe.ray, f.t, f.corners)};
    }

    LargeArray<TriangleBlock<R>> blocks_;
    decltype(Kernel::filter(Isa::best)) filter_;
};

}  // namespace alidade
