// SPDX-License-Identifier: Apache-2.0
/// Uniform grid.
///
/// Cells     a counting sort of references into one array, one index a cell: Lagae, Dutre, "Compact, Fast and Robust Grids for Ray Tracing", 2008.
#pragma once

#include "accel/grid/lattice.h"
#include "accel/query.h"

namespace alidade {

/// Cells wanted for each primitive, and the most references for each: the resolution is halved until that suffices.
inline constexpr double kCellsPerPrimitive = 4, kReferencesPerPrimitive = 12;

template <class Leaf> class Grid {
  public:
    Grid(BuildInput<typename Leaf::Source>& input, int, BuildStats& stats) : offset_(uint32_t(input.order.size())) {
        if (input.ids.empty()) return;
        lattice_ = choose_lattice(input);
        fill(input);
        finish_stats(input.bounds, stats);
    }

    template <class Query> void traverse(const LocalRay& ray, Query& query, WorkCounters& work) const {
        if (!lattice_.can_walk(ray)) {   // from very far away: cells are smaller than the rounding of positions
            query.visit(offset_, starts_.back());
            return;
        }
        LatticeWalk walk(lattice_, ray);
        do {
            ++work.boxes;
            const size_t cell = walk.cell();
            const uint32_t first = starts_[cell], count = starts_[cell + 1] - first;
            if (count && query.visit(offset_ + first, count)) return;
        } while (walk.advance(query.limit()));
    }
    size_t bytes() const { return starts_.capacity() * sizeof(uint32_t); }

  private:
    using Source = typename Leaf::Source;
    struct Reference {
        uint32_t cell, id;
    };

    static Lattice choose_lattice(const BuildInput<Source>& input) {
        CellIndex cells = grid_resolution(input.bounds, input.typical_extent(), kCellsPerPrimitive * double(input.ids.size()));
        for (;;) {
            const Lattice lattice(input.bounds, cells);
            double references = 0;
            for (const uint32_t id : input.ids) references += lattice.overlapped(input.source.bounds(id)).count();
            if (lattice.cells() == 1 || references <= kReferencesPerPrimitive * double(input.ids.size())) return lattice;
            for (int& n : cells) n = std::max(1, n / 2);
        }
    }

    void fill(BuildInput<Source>& input) {
        std::vector<Reference> references;
        for (const uint32_t id : input.ids) refer(input.source, id, references);
        starts_.assign(lattice_.cells() + 1, 0);
        for (const Reference& r : references) ++starts_[r.cell + 1];
        for (size_t c = 1; c < starts_.size(); ++c) starts_[c] += starts_[c - 1];
        std::vector<uint32_t> next(starts_.begin(), starts_.end() - 1);
        input.order.resize(offset_ + references.size());
        for (const Reference& r : references) input.order[offset_ + next[r.cell]++] = r.id;
    }

    void refer(const Source& source, uint32_t id, std::vector<Reference>& references) const {
        const CellRange range = lattice_.overlapped(source.bounds(id));
        const bool one = range.low == range.high;
        CellIndex i;
        for (i[2] = range.low[2]; i[2] <= range.high[2]; ++i[2]) {
            for (i[1] = range.low[1]; i[1] <= range.high[1]; ++i[1]) {
                for (i[0] = range.low[0]; i[0] <= range.high[0]; ++i[0]) {
                    if (one || !source.clipped_bounds(id, lattice_.padded_cell(i)).empty()) references.push_back({uint32_t(lattice_.number(i)), id});
                }
            }
        }
    }

    /// A ray that hits the box visits as many cells as their areas are of the box's, and the references in them.
    void finish_stats(const Bounds& box, BuildStats& stats) const {
        const double area = box.half_area(), cell = lattice_.padded_cell({0, 0, 0}).half_area();
        stats.nodes = lattice_.cells();
        for (size_t c = 0; c + 1 < starts_.size(); ++c) stats.leaves += starts_[c + 1] > starts_[c];
        stats.depth = 1;
        stats.sah_cost = (area > 0 ? std::min(1.0, cell / area) : 1.0) * double(stats.nodes + starts_.back());
    }

    uint32_t offset_;
    Lattice lattice_;
    std::vector<uint32_t> starts_;   ///< of the cells' references, and their end
};

}  // namespace alidade
