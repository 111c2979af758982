// SPDX-License-Identifier: Apache-2.0
/// The cells of a uniform grid, and the walk of a ray through them.
#pragma once

#include "accel/local_ray.h"

#include <array>

namespace alidade {

using CellIndex = std::array<int, 3>;

struct CellRange {
    CellIndex low, high;   ///< both included
    double count() const { return double(high[0] - low[0] + 1) * double(high[1] - low[1] + 1) * double(high[2] - low[2] + 1); }
};

/// Boxes are held to overlap a cell that they miss by less than this fraction of its size. It covers the rounding of the walk, see docs/numerics.md, "The grid".
inline constexpr double kCellPad = 0x1p-8;

/// A ray as all lattices of a grid see it.
struct GridRay {
    explicit GridRay(const LocalRay& local) : ray(local), slab_(slab_of<double>(local)) {
        for (int a = 0; a < 3; ++a) step[a] = (ray.dir[a] > 0) - (ray.dir[a] < 0);
    }
    const SlabRay<double>& slab() const { return slab_; }   ///< for box tests

    const LocalRay& ray;
    int step[3];   ///< sign of the direction

  private:
    SlabRay<double> slab_;
};

class Lattice {
  public:
    Lattice() = default;
    Lattice(const Bounds& box, const CellIndex& cells);

    size_t cells() const { return size_t(cells_[0]) * size_t(cells_[1]) * size_t(cells_[2]); }
    const CellIndex& resolution() const { return cells_; }
    size_t number(const CellIndex& i) const { return (size_t(i[2]) * size_t(cells_[1]) + size_t(i[1])) * size_t(cells_[0]) + size_t(i[0]); }
    CellIndex index(size_t number) const;
    double plane(int axis, int i) const { return box_.min[axis] + i * size_[axis]; }
    /// The nearest cell.
    int cell(int axis, double x) const { return int(std::clamp((x - box_.min[axis]) * inverse_size_[axis], 0.0, double(cells_[size_t(axis)] - 1))); }

    const Bounds& box() const { return box_; }
    /// All cells, and the box of some; that of all is box(), to the last bit.
    CellRange all() const { return {{0, 0, 0}, {cells_[0] - 1, cells_[1] - 1, cells_[2] - 1}}; }
    Bounds box_of(const CellRange& range) const;
    /// The cells that `box` overlaps, pad included, and the padded box of one.
    CellRange overlapped(const Bounds& box) const;
    Bounds padded_cell(const CellIndex& i) const;
    /// Probability that a ray which hits the box enters a cell that it hits: areas are what counts.
    double cell_share() const;

    /// Is the rounding of a walk along `ray` less than the pad?
    bool can_walk(const GridRay& ray) const;

  private:
    Bounds box_;
    CellIndex cells_{1, 1, 1};
    Vec3 size_{0}, inverse_size_{0};
};

/// About `count` cells, as near to the shape of `typical` as the box allows. None is so small that its planes, as computed, would not be told apart.
CellIndex grid_resolution(const Bounds& box, const Vec3& typical, double count);

/// A walk from cell to cell in the order of t.
///
/// Method   Amanatides, Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing", 1987; but crossings are not accumulated, each is computed from its plane,
///          so that its error does not grow with the length of the walk.
class LatticeWalk {
  public:
    LatticeWalk(const Lattice& lattice, const GridRay& ray, double start);

    size_t cell() const { return lattice_.number(at_); }
    /// The part of the ray in the cell; the last one has no end.
    double entered() const { return entered_; }
    double left() const { return next_[nearest()]; }
    /// Goes on to the next cell; false if that begins beyond `limit`, or if there is none.
    bool advance(double limit) {
        const int axis = nearest();
        if (!(next_[axis] <= limit) || next_[axis] == kInf) return false;
        entered_ = next_[axis];
        at_[size_t(axis)] += ray_.step[axis];
        next_[axis] = crossing(axis);
        return true;
    }

  private:
    int nearest() const { return next_[0] <= next_[1] ? (next_[0] <= next_[2] ? 0 : 2) : (next_[1] <= next_[2] ? 1 : 2); }

    /// The outermost cells have no outer plane: it would be rounded, and could cut off what lies just inside the bounds. The limit ends the walk there.
    double crossing(int axis) const {
        const int next = at_[size_t(axis)] + ray_.step[axis];
        if (ray_.step[axis] == 0 || next < 0 || next >= lattice_.resolution()[size_t(axis)]) return kInf;
        return (lattice_.plane(axis, at_[size_t(axis)] + (ray_.step[axis] > 0)) - ray_.ray.origin[axis]) * ray_.ray.inverse[axis];
    }

    const Lattice& lattice_;
    const GridRay& ray_;
    CellIndex at_;
    double entered_, next_[3];   ///< next_: where the ray leaves the cell along each axis
};

}  // namespace alidade
