// SPDX-License-Identifier: Apache-2.0
#include "accel/grid/lattice.h"

namespace alidade {

Lattice::Lattice(const Bounds& box, const CellIndex& cells) : box_(box), cells_(cells) {
    for (int a = 0; a < 3; ++a) {
        size_[a] = (box.max[a] - box.min[a]) / cells[size_t(a)];
        inverse_size_[a] = cells[size_t(a)] > 1 ? 1 / size_[a] : 0;
        const double magnitude = std::max(std::abs(box.min[a]), std::abs(box.max[a]));
        reach_[a] = cells[size_t(a)] > 1 ? 0.5 * kCellPad * size_[a] / (64 * kUnitRoundoff<double>) - magnitude : kInf;
    }
}

CellIndex Lattice::index(size_t number) const {
    const size_t row = number / size_t(cells_[0]);
    return {int(number % size_t(cells_[0])), int(row % size_t(cells_[1])), int(row / size_t(cells_[1]))};
}

Bounds Lattice::box_of(const CellRange& range) const {
    Bounds box;
    for (int a = 0; a < 3; ++a) {
        const int low = range.low[size_t(a)], high = range.high[size_t(a)];
        box.min[a] = plane(a, low), box.max[a] = high + 1 < cells_[size_t(a)] ? plane(a, high + 1) : box_.max[a];
    }
    return box;
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

double Lattice::cell_share() const {
    const double area = box_.half_area(), cell = Bounds{Vec3(0), size_}.half_area();
    return area > 0 ? std::min(1.0, cell / area) : 1;
}

CellIndex grid_resolution(const Bounds& box, const Vec3& typical, double count) {
    const Vec3 extent = box.extent() / typical;
    CellIndex cells{1, 1, 1};
    if (!(max_component(extent) > 0)) return cells;
    Vec3 most(4096);
    for (int a = 0; a < 3; ++a) {   // 2^12 roundings of a plane in a cell: the pad is 16 of them
        const double rounding = kUnitRoundoff<double> * std::max(std::abs(box.min[a]), std::abs(box.max[a]));
        if (rounding > 0) most[a] = std::clamp(box.extent()[a] / (4096 * rounding), 1.0, most[a]);
    }
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
            cells[size_t(a)] = int(std::clamp(extent[a] * scale, 1.0, most[a]));
            if (cells[size_t(a)] < 2 && axes > 1) divided[size_t(a)] = false, again = true, cells[size_t(a)] = 1;
        }
    }
    return cells;
}

}  // namespace alidade
