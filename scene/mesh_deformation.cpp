// SPDX-License-Identifier: Apache-2.0
#include "scene/mesh_deformation.h"

namespace alidade {

namespace {

/// A value that corners of several vertices share becomes one for each corner.
template <class T> void give_each_corner_its_own(Attribute<T>& attribute) {
    if (attribute.corners.empty()) return;
    std::vector<T> values;
    values.reserve(attribute.corners.size());
    for (uint32_t& corner : attribute.corners) {
        values.push_back(attribute.values[corner]);
        corner = uint32_t(values.size() - 1);
    }
    attribute.values = std::move(values);
}

/// Replaces each value of `attribute` by f(value, its vertex).
template <class T, class F> void for_each_value(Attribute<T>& attribute, const std::vector<Index3>& triangles, const F& f) {
    give_each_corner_its_own(attribute);
    const bool by_corner = !attribute.corners.empty();
    for (size_t i = 0; i < attribute.values.size(); ++i) {
        const size_t vertex = by_corner ? triangles[i / 3][int(i % 3)] : i;
        attribute.values[i] = f(attribute.values[i], vertex);
    }
}

/// As a unit vector, or `otherwise` where it has no direction.
Vec3f direction(const Vec3& v, const Vec3f& otherwise) {
    const Vec3 unit = normalized(v);
    return std::abs(dot(unit, unit) - 1) < 1e-6 ? Vec3f(unit) : otherwise;
}

std::vector<Vec3> positions_of(const Mesh& mesh) {
    return mesh.exact_positions.empty() ? std::vector<Vec3>(mesh.positions.begin(), mesh.positions.end()) : mesh.exact_positions;
}

void set_positions(Mesh& mesh, std::vector<Vec3> positions) {
    mesh.positions.assign(positions.begin(), positions.end());
    if (!mesh.exact_positions.empty()) mesh.exact_positions = std::move(positions);
}

Vec3 delta(std::span<const MorphTarget> targets, std::span<const double> weights, std::vector<Vec3f> MorphTarget::*which, size_t vertex) {
    Vec3 sum(0);
    for (size_t i = 0; i < targets.size(); ++i) {
        const std::vector<Vec3f>& deltas = targets[i].*which;
        if (weights[i] != 0 && !deltas.empty()) sum += weights[i] * Vec3(deltas[vertex]);
    }
    return sum;
}

/// The average of the joints that move `vertex`.
Transform blended(std::span<const JointSet> sets, std::span<const Transform> joints, size_t vertex) {
    Transform sum{Mat3(0.0), Vec3(0)};
    double total = 0;
    for (const JointSet& set : sets) {
        for (int k = 0; k < 4; ++k) {
            const double weight = double(set.weights[vertex][k]);
            if (weight == 0) continue;
            const Transform& joint = joints[set.joints[vertex][k]];
            sum.linear += joint.linear * weight;
            sum.translation += joint.translation * weight;
            total += weight;
        }
    }
    return total == 0 ? Transform() : Transform{sum.linear / total, sum.translation / total};
}

/// The transpose of the inverse, up to a positive factor; it exists for flat maps too.
Vec3 map_normal(const Mat3& m, double determinant, const Vec3& n) {
    const Vec3 mapped = cross(m[1], m[2]) * n.x + cross(m[2], m[0]) * n.y + cross(m[0], m[1]) * n.z;
    return determinant < 0 ? -mapped : mapped;
}

/// Floats near 0 have digits to spare; what lies far from it keeps them by an origin of its own.
Vec3 origin_for(const std::vector<Vec3>& positions) {
    constexpr double kFar = 16;   // times the half size: at most four bits are lost
    Bounds bounds;
    for (const Vec3& p : positions)
        if (is_finite(p)) bounds.extend(p);
    if (bounds.empty()) return Vec3(0);
    const double half_size = max_component(bounds.extent() * 0.5);
    return max_abs(bounds.center()) > kFar * half_size ? bounds.center() : Vec3(0);
}

template <class T> void swap_corners(Attribute<T>& attribute, size_t triangle) {
    if (!attribute.corners.empty()) std::swap(attribute.corners[3 * triangle + 1], attribute.corners[3 * triangle + 2]);
}

/// Turns the winding of triangles that are mirrored at all corners: as under a node's transform, their front stays the front.
void keep_fronts(Mesh& mesh, std::span<const Transform> maps) {
    const auto mirrors = [&](uint32_t vertex) { return maps[vertex].determinant() < 0; };
    for (size_t i = 0; i < mesh.triangles.size(); ++i) {
        Index3& t = mesh.triangles[i];
        if (!mirrors(t.x) || !mirrors(t.y) || !mirrors(t.z)) continue;
        std::swap(t.y, t.z);
        swap_corners(mesh.normals, i);
        swap_corners(mesh.tangents, i);
        for (auto& uv : mesh.uvs) swap_corners(uv, i);
        for (auto& color : mesh.colors) swap_corners(color, i);
    }
}

}  // namespace

void morph(Mesh& mesh, std::span<const MorphTarget> targets, std::span<const double> weights) {
    std::vector<Vec3> positions = positions_of(mesh);
    for (size_t i = 0; i < positions.size(); ++i) positions[i] += delta(targets, weights, &MorphTarget::positions, i);
    set_positions(mesh, std::move(positions));
    for_each_value(mesh.normals, mesh.triangles, [&](const Vec3f& n, size_t vertex) {
        return direction(Vec3(n) + delta(targets, weights, &MorphTarget::normals, vertex), n);
    });
    for_each_value(mesh.tangents, mesh.triangles, [&](const Vec4f& t, size_t vertex) {
        return Vec4f(direction(Vec3(t) + delta(targets, weights, &MorphTarget::tangents, vertex), Vec3f(t)), t.w);
    });
}

void skin(Mesh& mesh, std::span<const JointSet> sets, std::span<const Transform> joints) {
    std::vector<Transform> maps(mesh.positions.size());
    for (size_t i = 0; i < maps.size(); ++i) maps[i] = blended(sets, joints, i);
    std::vector<Vec3> positions = positions_of(mesh);
    for (size_t i = 0; i < positions.size(); ++i) positions[i] = maps[i].point(positions[i] + mesh.origin);
    mesh.origin = origin_for(positions);
    for (Vec3& p : positions) p -= mesh.origin;
    set_positions(mesh, std::move(positions));
    for_each_value(mesh.normals, mesh.triangles, [&](const Vec3f& n, size_t vertex) {
        return direction(map_normal(maps[vertex].linear, maps[vertex].determinant(), Vec3(n)), n);
    });
    for_each_value(mesh.tangents, mesh.triangles, [&](const Vec4f& t, size_t vertex) {
        const float side = maps[vertex].determinant() < 0 ? -1.0f : 1.0f;
        return Vec4f(direction(maps[vertex].vector(Vec3(t)), Vec3f(t)), t.w * side);
    });
    keep_fronts(mesh, maps);
}

}  // namespace alidade
