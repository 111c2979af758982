// SPDX-License-Identifier: Apache-2.0
#include "scene/shape.h"

#include "core/error_bound.h"

namespace alidade {

namespace {

/// Widened by three roundings: those of centre +- radius and of the widening must not cut anything off.
Bounds bounds_of(const Sphere& s) {
    const double r = std::abs(s.radius);
    const Vec3 rounding = gamma_bound(3) * (glm::abs(s.center) + r);
    return {s.center - r - rounding, s.center + r + rounding};
}

Bounds bounds_of(const Plane&) { return {Vec3(-kInf), Vec3(kInf)}; }

Bounds bounds_of(const Box& box) { return {glm::min(box.a, box.b), glm::max(box.a, box.b)}; }

/// Of the triangles that can be hit: a stray or non-finite vertex does not count.
Bounds bounds_of(const Mesh& mesh) {
    Bounds b;
    const bool exact = !mesh.exact_positions.empty();
    auto position = [&](uint32_t i) { return exact ? mesh.exact_positions[i] : Vec3(mesh.positions[i]); };
    for (const Index3& triangle : mesh.triangles) {
        const Vec3 p[] = {position(triangle.x), position(triangle.y), position(triangle.z)};
        if (!is_finite(p[0]) || !is_finite(p[1]) || !is_finite(p[2])) continue;
        for (const Vec3& corner : p) b.extend(corner + mesh.origin);
    }
    return b;
}

}  // namespace

Bounds bounds(const ShapeGeometry& geometry) {
    return std::visit([](const auto& shape) { return bounds_of(shape); }, geometry);
}

uint32_t slot_count(const ShapeGeometry& geometry) {
    const Mesh* mesh = std::get_if<Mesh>(&geometry);
    if (!mesh || mesh->slots.empty()) return 1;
    return *std::max_element(mesh->slots.begin(), mesh->slots.end()) + 1;
}

}  // namespace alidade
