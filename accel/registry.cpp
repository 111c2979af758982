// SPDX-License-Identifier: Apache-2.0
#include "accel/automatic.h"

namespace alidade {

template <class Leaf> class Brute;
template <class Leaf> class Bvh;
template <class Leaf> class FastBvh;
template <class Leaf> class CompactBvh;
template <class Leaf> class Grid;
template <class Leaf> class Octree;

/// Defined in structure.h, instantiated by each structure's .cpp.
template <template <class> class Structure> std::unique_ptr<Accelerator> over_triangles(const TriangleView& mesh, const AccelOptions& options);
template <template <class> class Structure> std::unique_ptr<Accelerator> over_set(std::shared_ptr<const PrimitiveSet> set, const AccelOptions& options);

static constexpr AcceleratorEntry kTable[] = {
    {"brute", "tests every primitive; the oracle", over_triangles<Brute>, over_set<Brute>},
    {"bvh", "tree of boxes, split by the surface area heuristic over bins; over triangles eight children a node, and cut by planes where that pays", over_triangles<Bvh>, over_set<Bvh>},
    {"hlbvh", "a tree of boxes that is built about twice as fast: sorted along a Hilbert curve, the surface area heuristic only above; large triangles among small ones are cut before", over_triangles<FastBvh>, over_set<FastBvh>},
    {"compact", "a tree as of bvh in half of its memory, over triangles in float: planes of a byte, and corners once for all triangles around them, or in fewer bits, or read where the mesh has them", over_triangles<CompactBvh>, over_set<CompactBvh>},
    {"grid", "grid of cells, walked one by one; crowded cells are grids of their own", over_triangles<Grid>, over_set<Grid>},
    {"octree", "cells halved along their long axes, deeper where more primitives are; over triangles eight cells a node, tested at once", over_triangles<Octree>, over_set<Octree>},
};

tl::expected<void, std::string> Accelerator::save(const std::string& path, const TriangleView&) const { return tl::unexpected("cannot write " + path + ": this structure has no format of files, a BVH over triangles has"); }

std::span<const AcceleratorEntry> accelerators() { return kTable; }

const AcceleratorEntry* find_accelerator(std::string_view name) {
    static constexpr AcceleratorEntry kAuto{"auto", "chooses one of them by what the triangles are, and says why", over_triangles_auto, over_set_auto};
    if (name == kAuto.name) return &kAuto;
    for (const AcceleratorEntry& entry : kTable) {
        if (name == entry.name) return &entry;
    }
    return nullptr;
}

}  // namespace alidade
