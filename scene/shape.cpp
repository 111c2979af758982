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

/// The box of discs of these radii, all perpendicular to `axis`: along each coordinate a disc reaches radius sin(angle to the axis) far.
/// Widened by the roundings of that, of the axis and of the sums.
Bounds bounds_of_discs(const Vec3& a, double radius_a, const Vec3& b, double radius_b, const Vec3& axis) {
    const Vec3 w = normalized(axis), reach(std::hypot(w.y, w.z), std::hypot(w.z, w.x), std::hypot(w.x, w.y));
    Bounds out;
    for (const auto& [center, radius] : {std::pair(a, std::abs(radius_a)), std::pair(b, std::abs(radius_b))}) {
        const Vec3 rounding = gamma_bound(16) * (glm::abs(center) + radius);
        out.extend(center - radius * reach - rounding);
        out.extend(center + radius * reach + rounding);
    }
    return out;
}

Bounds bounds_of(const Disc& d) { return bounds_of_discs(d.center, d.radius, d.center, d.radius, d.normal); }
Bounds bounds_of(const Cylinder& c) { return bounds_of_discs(c.a, c.radius, c.b, c.radius, c.b - c.a); }
Bounds bounds_of(const Cone& c) { return bounds_of_discs(c.a, c.radius_a, c.b, c.radius_b, c.b - c.a); }

Bounds bounds_of(const Torus& t) {
    const double minor = std::abs(t.minor), around = std::abs(t.major) + minor;
    const Vec3 reach(around, minor, around), rounding = gamma_bound(4) * (glm::abs(t.center) + reach);
    return {t.center - reach - rounding, t.center + reach + rounding};
}

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
