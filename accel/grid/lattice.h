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

    double cell_size(int axis) const { return size_[axis]; }

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
    bool can_walk(const GridRay& ray) const {
        const Vec3& o = ray.ray.origin;
        return std::abs(o.x) <= reach_.x && std::abs(o.y) <= reach_.y && std::abs(o.z) <= reach_.z;
    }

  private:
    Bounds box_;
    CellIndex cells_{1, 1, 1};
    Vec3 size_{0}, inverse_size_{0};
    Vec3 reach_{0};   ///< of origins: 64 u (|origin| + |bounds|) is at most half the pad, see docs/numerics.md, "The grid"
};

/// About `count` cells, as near to the shape of `typical` as the box allows. None is so small that its planes, as computed, would not be told apart.
CellIndex grid_resolution(const Bounds& box, const Vec3& typical, double count);

/// A walk from cell to cell in the order of t.
///
/// Method   Amanatides, Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing", 1987; but crossings are not accumulated, each is computed from the number of its plane,
///          so that its error does not grow with the length of the walk.
class LatticeWalk {
  public:
    LatticeWalk(const Lattice& lattice, const GridRay& ray, double start) : entered_(start) {
        const CellIndex& cells = lattice.resolution();
        size_t stride = 1;
        for (int a = 0; a < 3; ++a) {
            const auto i = size_t(a);
            const int at = lattice.cell(a, ray.ray.origin[a] + start * ray.ray.dir[a]), step = ray.step[a];
            cell_ += size_t(at) * stride, stride_[i] = ptrdiff_t(stride) * step, stride *= size_t(cells[i]);
            planes_left_[i] = step > 0 ? cells[i] - 1 - at : step < 0 ? at : 0;
            first_[i] = (lattice.box().min[a] - ray.ray.origin[a]) * ray.ray.inverse[a], spacing_[i] = lattice.cell_size(a) * ray.ray.inverse[a];
            plane_[i] = step > 0 ? at + 1 : at, step_[i] = step;
            next_[i] = planes_left_[i] > 0 ? crossing(i) : kInf;
        }
    }

    size_t cell() const { return cell_; }
    /// The part of the ray in the cell; the last one has no end.
    double entered() const { return entered_; }
    double left() const { return std::min(next_[0], std::min(next_[1], next_[2])); }
    /// Goes on to the next cell; false if that begins beyond `limit`, which is finite, or if there is none.
    [[gnu::always_inline]] inline bool advance(double limit) {
        if (next_[0] <= next_[1]) return next_[0] <= next_[2] ? step<0>(limit) : step<2>(limit);
        return next_[1] <= next_[2] ? step<1>(limit) : step<2>(limit);
    }

  private:
    double crossing(size_t a) const { return first_[a] + plane_[a] * spacing_[a]; }

    /// The outermost cells have no outer plane: it would be rounded, and could cut off what lies just inside the bounds. The limit ends the walk there.
    template <size_t a> [[gnu::always_inline]] inline bool step(double limit) {
        if (!(next_[a] <= limit)) return false;
        entered_ = next_[a], cell_ += size_t(stride_[a]), plane_[a] += step_[a];
        next_[a] = --planes_left_[a] > 0 ? crossing(a) : kInf;
        return true;
    }

    size_t cell_ = 0;
    ptrdiff_t stride_[3];
    int planes_left_[3];   ///< inner planes ahead
    double entered_;
    double plane_[3], step_[3], first_[3], spacing_[3];   ///< the next plane's number; what is added to it; the t of plane 0, and from one to the next
    double next_[3];                                      ///< where the ray leaves the cell along each axis
};

}  // namespace alidade
