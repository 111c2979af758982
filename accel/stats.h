// SPDX-License-Identifier: Apache-2.0
/// What a structure cost to build and what a ray cost to trace. Counters do not lie; seconds on a shared machine do.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace alidade {

/// Added up over rays; each thread has its own and they are summed in a fixed order.
struct WorkCounters {
    uint64_t rays = 0;         ///< rays that entered an accelerator's box
    uint64_t boxes = 0;        ///< box tests (BVH), cells or nodes stepped through (grid, octree)
    uint64_t filtered = 0;     ///< primitives looked at: for triangles by the float filter
    uint64_t primitives = 0;   ///< primitives decided in double
    uint64_t exact = 0;        ///< signs that needed exact arithmetic

    WorkCounters& operator+=(const WorkCounters& b) {
        rays += b.rays, boxes += b.boxes, filtered += b.filtered, primitives += b.primitives, exact += b.exact;
        return *this;
    }
};

struct BuildStats {
    double seconds = 0;
    size_t primitives = 0;     ///< that can be hit: the given ones less those removed
    size_t references = 0;     ///< entries in leaves or cells; more than `primitives` where one lies in several
    size_t splits = 0;         ///< nodes of a tree that were split in space, so that primitives are in several leaves
    size_t split_candidates = 0;   ///< nodes where that was tried: with primitives large enough to lie across others
    size_t nodes = 0, leaves = 0, depth = 0;
    size_t bytes = 0;          ///< of the finished structure, primitives as packed in leaves included
    double sah_cost = 0;       ///< expected box tests + primitive tests of a ray that hits the box
    std::vector<uint32_t> removed;   ///< ids that no ray can hit: not finite, out of range, without area
};

}  // namespace alidade
