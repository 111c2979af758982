// SPDX-License-Identifier: Apache-2.0
#include "accel/grid/lattice.h"

namespace alidade {

Lattice::Lattice(const Bounds& box, const CellIndex& cells) : box_(box), cells_(cells) {
    for (int a = 0; a < 3; ++a) {
        size_[a] = (box.max[a] - box.min[a]) / cells[size_t(a)];
        inverse_size_[a] = cells[size_t(a)] > 1 ? 1 / size_[a] : 0;
    }
}

CellRange Lattice::overlapped(const Bounds& box) const {
    CellRange range{};
    for (int a = 0; a < 3; ++a) {
        const double pad = kCellPad * size_[a];
        range.low[size_t(a)] = cell(a, box.min[a] - pad), range.high[size_t(a)] = cell(a, box.max[a] + pad);
    }
    return range;
}

Bounds Lattice::padded_cell(const CellIndex& i) const {
    Bounds padded;
    for (int a = 0; a < 3; ++a) {
        const double pad = kCellPad * size_[a];
        padded.min[a] = plane(a, i[size_t(a)]) - pad, padded.max[a] = plane(a, i[size_t(a)] + 1) + pad;
    }
    return padded;
}

bool Lattice::can_walk(const LocalRay& ray) const {
    for (int a = 0; a < 3; ++a) {
        const double magnitude = std::abs(ray.origin[a]) + std::max(std::abs(box_.min[a]), std::abs(box_.max[a]));
        if (cells_[size_t(a)] > 1 && 64 * kUnitRoundoff<double> * magnitude > 0.5 * kCellPad * size_[a]) return false;
    }
    return true;
}

CellIndex grid_resolution(const Bounds& box, const Vec3& typical, double count) {
    constexpr double most = 4096;
    const Vec3 extent = box.extent() / typical;
    CellIndex cells{1, 1, 1};
    if (!(max_component(extent) > 0)) return cells;
    std::array<bool, 3> divided{extent.x > 0, extent.y > 0, extent.z > 0};
    for (bool again = true; again;) {   // an axis too short for two cells leaves its share to the others
        again = false;
        double log_volume = 0, axes = 0;
        for (int a = 0; a < 3; ++a) {
            if (divided[size_t(a)]) log_volume += std::log(extent[a]), ++axes;
        }
        const double scale = std::exp((std::log(count) - log_volume) / axes);
        for (int a = 0; a < 3; ++a) {
            if (!divided[size_t(a)]) continue;
            cells[size_t(a)] = int(std::clamp(extent[a] * scale, 1.0, most));
            if (cells[size_t(a)] < 2 && axes > 1) divided[size_t(a)] = false, again = true, cells[size_t(a)] = 1;
        }
    }
    return cells;
}

LatticeWalk::LatticeWalk(const Lattice& lattice, const LocalRay& ray) : lattice_(lattice), ray_(ray) {
    for (int a = 0; a < 3; ++a) {
        step_[a] = (ray.dir[a] > 0) - (ray.dir[a] < 0);
        inverse_[a] = step_[a] ? 1 / ray.dir[a] : 0;
        at_[size_t(a)] = lattice.cell(a, ray.origin[a] + ray.tmin * ray.dir[a]);
        next_[a] = crossing(a);
    }
}

}  // namespace alidade
