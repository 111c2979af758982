// SPDX-License-Identifier: Apache-2.0
/// One lattice over primitives, while a grid is built: how fine, and which cell refers to what.
#pragma once

#include "accel/grid/lattice.h"
#include "accel/leaf.h"

namespace alidade {

/// Cells wanted for each block that the primitives fill, and the most references for each primitive: the resolution is halved until that suffices.
inline constexpr double kCellsPerBlock = 3, kReferencesPerPrimitive = 12;

/// What a block of references costs a ray in steps from one cell to the next, and what the box of a lattice in a cell and the start of a walk there do.
inline constexpr double kBlockSteps = 2, kEntrySteps = 24;

struct GridPlan {
    Lattice lattice;
    std::vector<uint32_t> starts;   ///< where in `ids` the references of each cell begin, and their end
    std::vector<uint32_t> ids;

    std::span<const uint32_t> cell(size_t number) const { return std::span(ids).subspan(starts[number], starts[number + 1] - starts[number]); }
    /// Of a ray that hits the lattice's box, in steps. `block`: references that are looked at at once.
    double cost(uint32_t block) const {
        size_t blocks = 0;
        for (size_t c = 0; c < lattice.cells(); ++c) blocks += blocks_of(cell(c).size(), block);
        return lattice.cell_share() * (double(lattice.cells()) + kBlockSteps * double(blocks));
    }
    static size_t blocks_of(size_t references, uint32_t block) { return (references + block - 1) / block; }
};

/// Plans a lattice for what lies in a box of some primitives: of all of them, or of those that a cell of another lattice refers to.
template <class Source> class GridPlanner {
  public:
    /// `within` holds the parts of the primitives that count.
    GridPlanner(const Source& source, std::span<const uint32_t> ids, const Bounds& within, uint32_t block) : source_(source), ids_(ids), within_(within), block_(block) {
        Vec3 sum(0);
        for (const uint32_t id : ids) {
            const Bounds part = part_of(id);
            if (part.empty()) continue;
            bounds_.extend(part), sum += part.extent();
        }
        const double count = double(ids.size());
        for (int a = 0; a < 3; ++a) {
            const double extent = bounds_.max[a] - bounds_.min[a];
            typical_[a] = extent > 0 ? std::max(sum[a] / count, extent / std::sqrt(count)) : 1;
        }
    }
    /// Of the parts.
    const Bounds& bounds() const { return bounds_; }

    /// With at most `budget` references, if that is possible at all.
    GridPlan plan(double budget) const {
        GridPlan plan;
        plan.lattice = choose_lattice(std::min(budget, kReferencesPerPrimitive * double(ids_.size())));
        std::vector<Reference> references;
        references.reserve(2 * ids_.size());
        for (const uint32_t id : ids_) refer(plan.lattice, id, references);
        plan.starts.assign(plan.lattice.cells() + 1, 0);
        for (const Reference& r : references) ++plan.starts[r.cell + 1];
        for (size_t c = 1; c < plan.starts.size(); ++c) plan.starts[c] += plan.starts[c - 1];
        std::vector<uint32_t> next(plan.starts.begin(), plan.starts.end() - 1);
        plan.ids.resize(references.size());
        for (const Reference& r : references) plan.ids[next[r.cell]++] = r.id;
        return plan;
    }

  private:
    struct Reference {
        uint32_t cell, id;
    };

    Bounds part_of(uint32_t id) const { return intersection(source_.bounds(id), within_); }

    /// None if its part is empty: a primitive that touches only the pad of the cell around.
    CellRange cells_of(const Lattice& lattice, uint32_t id) const {
        const Bounds part = part_of(id);
        return part.empty() ? CellRange{{0, 0, 0}, {-1, -1, -1}} : lattice.overlapped(part);
    }

    Lattice choose_lattice(double most) const {
        CellIndex cells = grid_resolution(bounds_, typical_, kCellsPerBlock / block_ * double(ids_.size()));
        for (;;) {
            const Lattice lattice(bounds_, cells);
            double references = 0;
            for (const uint32_t id : ids_) references += cells_of(lattice, id).count();
            if (lattice.cells() == 1 || references <= most) return lattice;
            for (int& n : cells) n = std::max(1, n / 2);
        }
    }

    void refer(const Lattice& lattice, uint32_t id, std::vector<Reference>& references) const {
        const CellRange range = cells_of(lattice, id);
        const bool one = range.low == range.high;
        CellIndex i;
        for (i[2] = range.low[2]; i[2] <= range.high[2]; ++i[2]) {
            for (i[1] = range.low[1]; i[1] <= range.high[1]; ++i[1]) {
                for (i[0] = range.low[0]; i[0] <= range.high[0]; ++i[0]) {
                    if (one || !source_.clipped_bounds(id, lattice.padded_cell(i)).empty()) references.push_back({uint32_t(lattice.number(i)), id});
                }
            }
        }
    }

    const Source& source_;
    std::span<const uint32_t> ids_;
    Bounds within_, bounds_;
    uint32_t block_;
    Vec3 typical_{1};
};

}  // namespace alidade
