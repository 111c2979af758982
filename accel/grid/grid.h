// SPDX-License-Identifier: Apache-2.0
/// Grid of grids: cells that hold many primitives are lattices of their own, around what is in them.
///
/// Cells     a counting sort of references into one array: Lagae, Dutre, "Compact, Fast and Robust Grids for Ray Tracing", 2008; but the references of each cell begin a block.
/// Levels    Kalojanov, Billeter, Slusallek, "Two-Level Grids for Ray Tracing on GPUs", 2011; here to any depth, and a lattice spans only the primitives
///           in its cell, so that a teapot in a stadium is found in one step.
#pragma once

#include "accel/accelerator.h"
#include "accel/grid/plan.h"
#include "accel/query.h"

namespace alidade {

/// Cells with fewer blocks of references are not divided further, nor are any at the last level.
inline constexpr size_t kGridLeaf = 6;
inline constexpr uint32_t kGridDepth = 8;

/// References of all levels are at most this many times the primitives; a cell's lattice has its share of what is left.
inline constexpr double kGridGrowth = 16;

template <class Leaf> class Grid {
  public:
    Grid(BuildInput<typename Leaf::Source>& input, const AccelOptions&, BuildStats& stats) {
        if (input.ids.empty()) return;
        PhaseClock clock(stats);
        const size_t before = input.order.size();
        const GridPlanner planner(input.source, input.ids, input.bounds, Leaf::kBlock);
        std::vector<Task> tasks;
        tasks.push_back({0, 1, planner.plan(kInf), kGridGrowth * double(input.ids.size())});
        clock.ended("plan");
        parts_.emplace_back();
        while (!tasks.empty()) {
            const Task task = std::move(tasks.back());
            tasks.pop_back();
            add_part(task, input, tasks, stats);
        }
        stats.leaves += input.order.size() > before ? 0 : 1;
        parts_.shrink_to_fit(), cells_.shrink_to_fit();
        clock.ended("divide");
    }

    template <class Query> void traverse(const LocalRay& ray, Query& query, WorkCounters& work) const {
        if (!parts_.empty()) search(parts_.front(), Search<Query>{GridRay(ray), query, work}, ray.tmin, ray.tmax);
    }
    size_t bytes() const { return cells_.capacity() * sizeof(Cell) + parts_.capacity() * sizeof(Part); }

  private:
    using Source = typename Leaf::Source;

    struct Cell {
        static constexpr uint32_t kDivided = ~uint32_t(0);
        uint32_t first = 0;   ///< place of its references, from the start of a block on; or its part
        uint32_t count = 0;   ///< of references, or kDivided

        bool empty() const { return count == 0; }
        bool divided() const { return count == kDivided; }
    };
    struct Part {
        Lattice lattice;
        size_t cells = 0;   ///< its first in cells_
    };
    struct Task {
        uint32_t part, depth;
        GridPlan plan;
        double budget;
    };
    template <class Query> struct Search {
        GridRay ray;
        Query& query;
        WorkCounters& work;
    };

    void add_part(const Task& task, BuildInput<Source>& input, std::vector<Task>& tasks, BuildStats& stats) {
        const Lattice& lattice = task.plan.lattice;
        parts_[task.part].lattice = lattice, parts_[task.part].cells = cells_.size();
        const double area = input.bounds.half_area(), share = lattice.cell_share() * (area > 0 ? lattice.box().half_area() / area : 1);
        double work = double(lattice.cells());
        for (size_t c = 0; c < lattice.cells(); ++c) {
            const std::span<const uint32_t> ids = task.plan.cell(c);
            if (divide(task, c, input, tasks)) {
                cells_.push_back({uint32_t(parts_.size() - 1), Cell::kDivided}), ++work;
                continue;
            }
            cells_.push_back({uint32_t(input.order.size()), uint32_t(ids.size())});
            input.order.insert(input.order.end(), ids.begin(), ids.end());
            input.order.resize((input.order.size() + Leaf::kBlock - 1) / Leaf::kBlock * Leaf::kBlock, kPadding);
            work += double(ids.size()), stats.leaves += !ids.empty();
        }
        stats.nodes += lattice.cells(), stats.depth = std::max(stats.depth, size_t(task.depth)), stats.sah_cost += share * work;
    }

    /// Makes a part of a cell, if that is expected to pay: the box around its primitives is tested, and walked through by the rays that hit it.
    bool divide(const Task& task, size_t cell, const BuildInput<Source>& input, std::vector<Task>& tasks) {
        const std::span<const uint32_t> ids = task.plan.cell(cell);
        if (ids.size() < kGridLeaf * Leaf::kBlock || task.depth == kGridDepth) return false;
        const Bounds within = task.plan.lattice.padded_cell(task.plan.lattice.index(cell));
        const GridPlanner planner(input.source, ids, within, Leaf::kBlock);
        if (planner.bounds().empty()) return false;
        const double area = within.half_area(), share = area > 0 ? planner.bounds().half_area() / area : 1;
        const double budget = task.budget * double(ids.size()) / double(task.plan.ids.size());
        GridPlan plan = planner.plan(budget);
        if (kEntrySteps + share * plan.cost(Leaf::kBlock) >= kBlockSteps * double(GridPlan::blocks_of(ids.size(), Leaf::kBlock)) || double(plan.ids.size()) > budget) return false;
        tasks.push_back({uint32_t(parts_.size()), task.depth + 1, std::move(plan), budget});
        parts_.emplace_back();
        return true;
    }

    /// Shows the query the part's primitives between two t; true to stop.
    template <class Query> bool search(const Part& part, const Search<Query>& to, double from, double until) const {
        if (!part.lattice.can_walk(to.ray)) return search_halves(part, part.lattice.all(), to, from, until);
        LatticeWalk walk(part.lattice, to.ray, from);
        const Cell* const cells = &cells_[part.cells];
        double limit = std::min(until, to.query.limit());
        uint64_t walked = 0;
        bool stopped = false;
        do {
            ++walked;
            const Cell cell = cells[walk.cell()];
            if (cell.empty()) continue;
            stopped = show(cell, to, walk.entered(), std::min(until, walk.left()));
            limit = std::min(until, to.query.limit());
        } while (!stopped && walk.advance(limit));
        to.work.boxes += walked;
        return stopped;
    }

    /// The same where cells are smaller than the rounding of a walk, as they are from very far away: a cell is reached by halving the lattice.
    template <class Query> bool search_halves(const Part& part, const CellRange& range, const Search<Query>& to, double from, double until) const {
        ++to.work.boxes;
        if (to.ray.slab().enter(part.lattice.box_of(range), from, std::min(until, to.query.limit())) == kInf) return false;
        if (range.low == range.high) return show(cells_[part.cells + part.lattice.number(range.low)], to, from, until);
        int axis = 0;
        for (int a = 1; a < 3; ++a) {
            if (range.high[size_t(a)] - range.low[size_t(a)] > range.high[size_t(axis)] - range.low[size_t(axis)]) axis = a;
        }
        CellRange near = range, far = range;
        near.high[size_t(axis)] = (range.low[size_t(axis)] + range.high[size_t(axis)]) / 2;
        far.low[size_t(axis)] = near.high[size_t(axis)] + 1;
        if (to.ray.step[axis] < 0) std::swap(near, far);
        return search_halves(part, near, to, from, until) || search_halves(part, far, to, from, until);
    }

    /// A cell that the ray is in from one t to another, each as the walk around computed it.
    template <class Query> bool show(const Cell& cell, const Search<Query>& to, double from, double until) const {
        if (cell.divided()) return search_part(parts_[cell.first], to, from, until);
        return !cell.empty() && to.query.visit(cell.first, cell.count);
    }

    template <class Query> bool search_part(const Part& part, const Search<Query>& to, double from, double until) const {
        ++to.work.boxes;
        const double start = padded_down(from), end = padded_up(until);
        const double entry = to.ray.slab().enter(part.lattice.box(), start, std::min(end, padded_up(to.query.limit())));
        return entry < kInf && search(part, to, std::max(padded_down(entry), start), end);
    }

    std::vector<Part> parts_;   ///< the first is the whole
    std::vector<Cell> cells_;
};

}  // namespace alidade
