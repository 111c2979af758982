// SPDX-License-Identifier: Apache-2.0
#include "scene/shape.h"

#include "core/error_bound.h"

namespace alidade {

namespace {

const Bounds kAllSpace{Vec3(-kInf), Vec3(kInf)};

/// Widened by three roundings: those of centre +- radius and of the widening must not cut anything off.
Bounds bounds_of(const Sphere& s) {
    const double r = std::abs(s.radius);
    const Vec3 rounding = gamma_bound(3) * (glm::abs(s.center) + r);
    return {s.center - r - rounding, s.center + r + rounding};
}

Bounds bounds_of(const Plane&) { return kAllSpace; }

Bounds bounds_of(const Box& box) { return {glm::min(box.a, box.b), glm::max(box.a, box.b)}; }

/// The box of discs of these radii, all perpendicular to `axis`: along each coordinate a disc reaches radius sin(angle to the axis) far.
/// Widened by the roundings of that, of the axis and of the sums.
Bounds bounds_of_discs(const Vec3& a, double radius_a, const Vec3& b, double radius_b, const Vec3& axis) {
    const Vec3 w = normalized(axis), reach(std::sqrt(w.y * w.y + w.z * w.z), std::sqrt(w.z * w.z + w.x * w.x), std::sqrt(w.x * w.x + w.y * w.y));
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

/// An ellipsoid along the axes, or a cylinder along one of them: sum of squares_i (x_i - center_i)^2 = square, over the axes that have a square at all. Widened by the roundings
/// of `square`, a difference, and of the sums.
Bounds bounds_of(const Quadric& q) {
    if (q.products != Vec3(0) || !is_finite(q.squares) || !is_finite(q.linear)) return kAllSpace;
    double square = -q.constant, magnitude = std::abs(q.constant);
    for (int i = 0; i < 3; ++i) {
        if (q.squares[i] < 0 || (q.squares[i] == 0 && q.linear[i] != 0)) return kAllSpace;
        if (q.squares[i] == 0) continue;
        const double part = q.linear[i] * q.linear[i] / (4 * q.squares[i]);
        square += part, magnitude += part;
    }
    square = std::max(0.0, square + gamma_bound(8) * magnitude);
    Bounds out = kAllSpace;
    for (int i = 0; i < 3; ++i) {
        if (q.squares[i] == 0) continue;
        const double center = -q.linear[i] / (2 * q.squares[i]), reach = std::sqrt(square / q.squares[i]), rounding = gamma_bound(4) * (std::abs(center) + reach);
        if (!std::isfinite(center) || !std::isfinite(reach)) continue;
        out.min[i] = center - reach - rounding, out.max[i] = center + reach + rounding;
    }
    return out;
}

Bounds bounds_of(const Polynomial&) { return kAllSpace; }

Bounds bounds_of(const Polygon& polygon) {
    Bounds b;
    for (const auto& loop : polygon.loops)
        for (const Vec3& p : loop) b.extend(p);
    return b;
}

/// Of the control points, which hold the curves between them.
Bounds bounds_of(const Extrusion& e) {
    Bounds b;
    for (const Outline& outline : e.outlines)
        for (const Vec2& p : outline.points) b.extend(Vec3(p.x, p.y, e.bottom)), b.extend(Vec3(p.x, p.y, e.top));
    return b;
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

/// Along the area of the first loop, in the sense of its first corner; of the others, if it has none; along the first corner, if none has, as that
/// of a loop that crosses itself to a figure of eight. Loops are relative to their first point.
/// Source   M. E. Newell's method: the sum of the cross products of neighbours is the normal times twice the area.
Vec3 normal_of(const Polygon& polygon) {
    Vec3 any(0);
    for (const auto& loop : polygon.loops) {
        Vec3 area(0), corner(0);
        for (size_t i = 2; i < loop.size(); ++i) {
            const Vec3 triangle = cross(loop[i - 1] - loop[0], loop[i] - loop[0]);
            area += triangle;
            if (corner == Vec3(0)) corner = cross(loop[1] - loop[0], loop[i] - loop[0]);
        }
        if (area != Vec3(0)) return normalized(dot(area, corner) < 0 ? -area : area);
        if (any == Vec3(0)) any = corner;
    }
    return any == Vec3(0) ? any : normalized(any);
}

uint32_t slot_count(const ShapeGeometry& geometry) {
    const Mesh* mesh = std::get_if<Mesh>(&geometry);
    uint32_t last = 0;
    if (!mesh) return 1;
    for (const auto* slots : {&mesh->slots, &mesh->corner_slots})
        if (!slots->empty()) last = std::max(last, *std::max_element(slots->begin(), slots->end()));
    return last + 1;
}

}  // namespace alidade
