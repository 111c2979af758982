// SPDX-License-Identifier: Apache-2.0
#include "accel/cell_boxes.h"

#include <algorithm>

namespace alidade {
namespace {

constexpr int kCells = 4;   // along each axis

/// With both kinds of its corners, so that the cells are those of every precision. Empty where one is not finite: such a triangle cannot be hit.
Bounds triangle_box(const TriangleView& mesh, const Index3& triangle) {
    Bounds box;
    for (int k = 0; k < 3; ++k) {
        const Vec3 corner(mesh.positions[triangle[k]]), exact = mesh.exact_positions.empty() ? corner : mesh.exact_positions[triangle[k]];
        if (!is_finite(corner) || !is_finite(exact)) return {};
        box.extend(corner), box.extend(exact);
    }
    return box;
}

int cell_along(double at, double from, double size) { return size > 0 ? int(std::clamp((at - from) / size * kCells, 0.0, kCells - 1.0)) : 0; }

}  // namespace

std::vector<Bounds> cell_boxes(const TriangleView& mesh) {
    Bounds all;
    for (const Index3& triangle : mesh.triangles) all.extend(triangle_box(mesh, triangle));
    const Vec3 size = all.extent();
    std::vector<Bounds> cells(kCells * kCells * kCells);
    for (const Index3& triangle : mesh.triangles) {
        const Bounds box = triangle_box(mesh, triangle);
        if (box.empty()) continue;
        const Vec3 middle = box.center();
        size_t cell = 0;
        for (int k = 0; k < 3; ++k) cell = cell * kCells + size_t(cell_along(middle[k], all.min[k], size[k]));
        cells[cell].extend(box);
    }
    std::erase_if(cells, [](const Bounds& box) { return box.empty(); });
    return cells;
}

Bounds placed_bounds(const Transform& to_world, const Bounds& bounds, std::span<const Bounds> cells) {
    const Bounds whole = to_world.bounds(bounds);
    Bounds parts;
    for (const Bounds& cell : cells) parts.extend(to_world.bounds(cell));
    return cells.empty() ? whole : intersection(whole, parts);
}

}  // namespace alidade
