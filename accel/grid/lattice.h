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

class Lattice {
  public:
    Lattice() = default;
    Lattice(const Bounds& box, const CellIndex& cells);

    size_t cells() const { return size_t(cells_[0]) * size_t(cells_[1]) * size_t(cells_[2]); }
    const CellIndex& resolution() const { return cells_; }
    size_t number(const CellIndex& i) const { return (size_t(i[2]) * size_t(cells_[1]) + size_t(i[1])) * size_t(cells_[0]) + size_t(i[0]); }
    double plane(int axis, int i) const { return box_.min[axis] + i * size_[axis]; }
    /// The nearest cell.
    int cell(int axis, double x) const { return int(std::clamp((x - box_.min[axis]) * inverse_size_[axis], 0.0, double(cells_[size_t(axis)] - 1))); }

    /// The cells that `box` overlaps, pad included, and the padded box of one.
    CellRange overlapped(const Bounds& box) const;
    Bounds padded_cell(const CellIndex& i) const;

    /// Is the rounding of a walk along `ray` less than the pad?
    bool can_walk(const LocalRay& ray) const;

  private:
    Bounds box_;
    CellIndex cells_{1, 1, 1};
    Vec3 size_{0}, inverse_size_{0};
};

/// About `count` cells, as near to the shape of `typical` as the box allows.
CellIndex grid_resolution(const Bounds& box, const Vec3& typical, double count);

/// A walk from cell to cell in the order of t.
///
/// Method   Amanatides, Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing", 1987; but crossings are not accumulated, each is computed from its plane,
///          so that its error does not grow with the length of the walk.
class LatticeWalk {
  public:
    LatticeWalk(const Lattice& lattice, const LocalRay& ray);

    size_t cell() const { return lattice_.number(at_); }
    /// Goes on to the next cell; false if that begins beyond `limit`, or if there is none.
    bool advance(double limit) {
        const int axis = next_[0] <= next_[1] ? (next_[0] <= next_[2] ? 0 : 2) : (next_[1] <= next_[2] ? 1 : 2);
        if (!(next_[axis] <= limit) || next_[axis] == kInf) return false;
        at_[size_t(axis)] += step_[axis];
        next_[axis] = crossing(axis);
        return true;
    }

  private:
    /// The outermost cells have no outer plane: it would be rounded, and could cut off what lies just inside the bounds. The limit ends the walk there.
    double crossing(int axis) const {
        const int next = at_[size_t(axis)] + step_[axis];
        if (step_[axis] == 0 || next < 0 || next >= lattice_.resolution()[size_t(axis)]) return kInf;
        return (lattice_.plane(axis, at_[size_t(axis)] + (step_[axis] > 0)) - ray_.origin[axis]) * inverse_[axis];
    }

    const Lattice& lattice_;
    const LocalRay& ray_;
    CellIndex at_;
    int step_[3];
    double inverse_[3], next_[3];   ///< next_: where the ray leaves the cell along each axis
};

}  // namespace alidade
