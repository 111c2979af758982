// SPDX-License-Identifier: Apache-2.0
/// What a structure cost to build and what a ray cost to trace. Counters do not lie; seconds on a shared machine do.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace alidade {

/// Added up over rays; each thread has its own and they are summed in a fixed order.
struct WorkCounters {
    uint64_t rays = 0;         ///< rays whose line meets an accelerator's box, at up to tmax where the structure asks that before it walks
    uint64_t boxes = 0;        ///< box tests (BVH), cells or nodes stepped through (grid, octree)
    uint64_t filtered = 0;     ///< primitives looked at: for triangles by the float filter
    uint64_t primitives = 0;   ///< primitives decided in double
    uint64_t exact = 0;        ///< signs that needed exact arithmetic

    WorkCounters& operator+=(const WorkCounters& b) {
        rays += b.rays, boxes += b.boxes, filtered += b.filtered, primitives += b.primitives, exact += b.exact;
        return *this;
    }
};

/// A part of a build. "sort out": which primitives there are, and where; "plan": a grid's cells; "divide": a tree's nodes, or a grid's cells filled; "widen": two children a node become eight; "pack": primitives
/// into leaves; "refit": new positions; "map": a file instead of all that.
struct BuildPhase {
    const char* name;
    double seconds;   ///< on the clock
};

struct BuildStats {
    double seconds = 0;        ///< on the clock; of the last refit, or of loading, where there was one
    std::vector<BuildPhase> phases;   ///< in their order
    size_t primitives = 0;     ///< that can be hit: the given ones less those removed
    size_t references = 0;     ///< entries in leaves or cells; more than `primitives` where one lies in several
    size_t splits = 0;         ///< nodes of a tree that were split in space, so that primitives are in several leaves
    size_t split_candidates = 0;   ///< nodes where that was tried: with primitives large enough to lie across others
    size_t nodes = 0, leaves = 0, depth = 0;
    size_t bytes = 0;          ///< of the finished structure, primitives as packed in leaves included
    double sah_cost = 0;       ///< expected box tests + primitive tests of a ray that hits the box
    std::vector<uint32_t> removed;   ///< ids that no ray can hit: not finite, out of range, without area
};

/// Adds phases to a build's statistics: each from the end of the one before it.
class PhaseClock {
  public:
    explicit PhaseClock(BuildStats& stats) : stats_(stats) {}
    void restart() { begun_ = std::chrono::steady_clock::now(); }   ///< what was before is another's
    void ended(const char* phase) {
        const auto now = std::chrono::steady_clock::now();
        stats_.phases.push_back({phase, std::chrono::duration<double>(now - std::exchange(begun_, now)).count()});
    }

  private:
    BuildStats& stats_;
    std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
};

}  // namespace alidade
