// SPDX-License-Identifier: Apache-2.0
#include "exporters/meshing/dual_contouring.h"

#include "exporters/meshing/plane_fit.h"

#include <array>
#include <unordered_map>

namespace alidade::meshing {
namespace {

/// The lattice does not stand on the box's own faces, nor at its middle: where surfaces lie in planes of the lattice, lines would run along them.
constexpr Vec3 kShift(0.391, 0.437, 0.413);
/// Cells beyond the box on each side: a face needs the cells around it, and their vertices need not lie where they are cut later.
constexpr int kMargin = 2;
/// Normals in a cell that differ by less than this (40 degrees) belong to one smooth surface.
constexpr double kSmooth = 0.766;

struct Cell {
    std::array<int64_t, 3> at;
    std::vector<uint32_t> crossings;
    uint32_t position = 0;
};

struct EdgeCrossing {
    Vec3 point, normal;
    uint32_t slot;
    int axis;
    std::array<int64_t, 3> at;   ///< the lattice point where the edge begins
    bool outwards;               ///< does the axis lead out of the solid there?
};

class Contour {
  public:
    Contour(const Bounds& box, int cells, const CrossingsOfLine& lines) : lines_(lines) {
        const Vec3 extent = box.extent();
        size_ = max_component(extent) / cells;
        for (int c = 0; c < 3; ++c) count_[size_t(c)] = int64_t(std::ceil(extent[c] / size_)) + 2 * kMargin;
        origin_ = box.min - size_ * (Vec3(kMargin) - 0.5 * kShift);
    }

    TriangleList make() {
        for (int axis = 0; axis < 3; ++axis) cast(axis);
        for (Cell& cell : cells_) cell.position = out_.position(fit(cell));
        for (const EdgeCrossing& crossing : crossings_) add_face(crossing);
        return std::move(out_);
    }

  private:
    using Index = std::array<int64_t, 3>;

    Vec3 point(const Index& at) const { return origin_ + size_ * Vec3(double(at[0]), double(at[1]), double(at[2])); }
    uint64_t key(const Index& cell) const { return uint64_t((cell[2] * count_[1] + cell[1]) * count_[0] + cell[0]); }

    /// The cell's number, which is new if the cell is.
    uint32_t number(const Index& cell) {
        const auto [known, added] = numbers_.try_emplace(key(cell), uint32_t(cells_.size()));
        if (added) cells_.push_back({cell, {}});
        return known->second;
    }

    /// All lines of the lattice along an axis that have cells on all four sides.
    void cast(int axis) {
        const size_t a = size_t(axis), u = (a + 1) % 3, v = (a + 2) % 3;
        Index at{};
        for (at[v] = 1; at[v] < count_[v]; ++at[v])
            for (at[u] = 1; at[u] < count_[u]; ++at[u]) {
                at[a] = 0;
                Vec3 span(0);
                span[axis] = size_ * double(count_[a]);
                add(axis, at, lines_(point(at), span));
            }
    }

    /// An even number of crossings on one edge is none: it ends where it began.
    void add(int axis, Index at, const std::vector<LineCrossing>& crossings) {
        const size_t a = size_t(axis);
        for (size_t i = 0; i < crossings.size();) {
            at[a] = edge_of(crossings[i], a);
            size_t end = i + 1;
            while (end < crossings.size() && edge_of(crossings[end], a) == at[a]) ++end;
            if ((end - i) % 2 == 1 && at[a] >= 0 && at[a] < count_[a]) add(axis, at, crossings[(i + end) / 2]);
            i = end;
        }
    }
    int64_t edge_of(const LineCrossing& crossing, size_t axis) const { return int64_t(std::floor(crossing.t * double(count_[axis]))); }

    void add(int axis, const Index& at, const LineCrossing& crossing) {
        Index begin = at;
        begin[size_t(axis)] = 0;
        Vec3 where = point(begin);
        where[axis] += crossing.t * size_ * double(count_[size_t(axis)]);
        const uint32_t id = uint32_t(crossings_.size());
        crossings_.push_back({where, crossing.normal, crossing.slot, axis, at, crossing.normal[axis] > 0});
        for (const Index& cell : around(crossings_.back())) cells_[number(cell)].crossings.push_back(id);
    }

    /// The four cells at an edge, counter-clockwise seen from where its axis leads.
    std::array<Index, 4> around(const EdgeCrossing& crossing) const {
        const size_t u = (size_t(crossing.axis) + 1) % 3, v = (size_t(crossing.axis) + 2) % 3;
        std::array<Index, 4> out;
        constexpr int64_t kStep[4][2] = {{-1, -1}, {0, -1}, {0, 0}, {-1, 0}};
        for (size_t i = 0; i < 4; ++i) {
            Index cell = crossing.at;
            cell[u] += kStep[i][0], cell[v] += kStep[i][1];
            out[i] = cell;
        }
        return out;
    }

    Vec3 fit(const Cell& cell) const {
        PlaneFit planes;
        for (const uint32_t id : cell.crossings) planes.add(crossings_[id].point, crossings_[id].normal);
        const Vec3 low = point(cell.at);
        return glm::clamp(planes.nearest(), low, low + Vec3(size_));
    }

    /// Of the vertex of a cell, as the surface has it that this crossing belongs to.
    Vec3 normal_at(const Cell& cell, const Vec3& like) const {
        Vec3 sum(0);
        for (const uint32_t id : cell.crossings)
            if (dot(crossings_[id].normal, like) > kSmooth) sum += crossings_[id].normal;
        return normalized(sum);
    }

    void add_face(const EdgeCrossing& crossing) {
        std::array<Index, 4> cells = around(crossing);
        if (!crossing.outwards) std::swap(cells[1], cells[3]);
        std::array<uint32_t, 4> positions, normals;
        for (size_t i = 0; i < 4; ++i) {
            const Cell& cell = cells_[number(cells[i])];
            positions[i] = cell.position, normals[i] = out_.normal(normal_at(cell, crossing.normal));
        }
        out_.quad(positions, normals, crossing.slot);
    }

    const CrossingsOfLine& lines_;
    double size_;
    Vec3 origin_;
    Index count_{};
    std::vector<EdgeCrossing> crossings_;
    std::vector<Cell> cells_;
    std::unordered_map<uint64_t, uint32_t> numbers_;
    TriangleList out_;
};

}  // namespace

TriangleList dual_contour(const Bounds& box, int cells, const CrossingsOfLine& crossings) {
    if (box.empty() || !(max_component(box.extent()) > 0)) return {};
    return Contour(box, cells, crossings).make();
}

}  // namespace alidade::meshing
