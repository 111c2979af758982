// SPDX-License-Identifier: Apache-2.0
#include "accel/cell_boxes.h"

#include "core/error_bound.h"

#include <algorithm>

namespace alidade {
namespace {

constexpr int kCells = 4;   // along each axis

/// No structure keeps what reaches farther.
constexpr double kFarthest = 0x1p480;

/// With both kinds of its corners, so that the cells are those of every precision. Empty if it is one of those that every structure removes.
Bounds triangle_box(const TriangleView& mesh, const Index3& triangle) {
    const bool exact = mesh.exact_positions.size() == mesh.positions.size();
    Bounds box;
    for (int k = 0; k < 3; ++k) {
        const uint32_t vertex = triangle[k];
        if (vertex >= mesh.positions.size()) return {};
        for (const Vec3& corner : {Vec3(mesh.positions[vertex]), exact ? mesh.exact_positions[vertex] : Vec3(mesh.positions[vertex])}) {
            const Vec3 far = glm::abs(corner);
            if (!(far.x <= kFarthest && far.y <= kFarthest && far.z <= kFarthest)) return {};
            box.extend(corner);
        }
    }
    return box;
}

int cell_along(double at, double from, double size) { return size > 0 ? int(std::clamp((at - from) / size * kCells, 0.0, kCells - 1.0)) : 0; }

}  // namespace

CellBoxes::CellBoxes(const TriangleView& mesh) {
    Bounds all;
    for (const Index3& triangle : mesh.triangles) all.extend(triangle_box(mesh, triangle));
    if (all.empty()) return;
    const Vec3 size = all.extent();
    reach_ = glm::max(glm::abs(all.min), glm::abs(all.max));
    std::vector<Bounds> boxes(kCells * kCells * kCells);
    for (const Index3& triangle : mesh.triangles) {
        const Bounds box = triangle_box(mesh, triangle);
        if (box.empty()) continue;
        const Vec3 middle = box.center();
        size_t cell = 0;
        for (int k = 0; k < 3; ++k) cell = cell * kCells + size_t(cell_along(middle[k], all.min[k], size[k]));
        boxes[cell].extend(box);
    }
    for (const Bounds& box : boxes)
        if (!box.empty()) cells_.push_back({box.center(), box.max * 0.5 - box.min * 0.5});
}

Bounds CellBoxes::placed(const Transform& to_world, const Bounds& bounds) const {
    const Bounds whole = to_world.bounds(bounds);
    if (cells_.empty() || !whole.finite()) return whole;
    const auto& linear = to_world.linear;
    const Vec3 x = glm::abs(linear[0]), y = glm::abs(linear[1]), z = glm::abs(linear[2]);
    Bounds parts;
    for (const Cell& cell : cells_) {
        const Vec3 middle = to_world.point(cell.middle), half = x * cell.half.x + y * cell.half.y + z * cell.half.z;
        parts.extend({middle - half, middle + half});
    }
    // Three roundings of a cell, twelve of a side: of numbers that are no larger than these.
    const Vec3 pad = gamma_bound(16) * (glm::abs(to_world.translation) + x * reach_.x + y * reach_.y + z * reach_.z) + Vec3(0x1p-1070);
    return intersection(whole, Bounds{parts.min - pad, parts.max + pad});
}

}  // namespace alidade
