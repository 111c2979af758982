// SPDX-License-Identifier: Apache-2.0
/// Points on the triangles of a mesh.
#pragma once

#include "scene/shape.h"

namespace alidade {

/// An attribute at the barycentric coordinates (u, v) of a triangle.
template <class T> T interpolate(const Attribute<T>& attribute, const Mesh& mesh, uint32_t triangle, double u, double v) {
    const Index3& vertices = mesh.triangles[triangle];
    using F = typename T::value_type;
    const T& a = attribute.values[attribute.index(triangle, 0, vertices)];
    const T& b = attribute.values[attribute.index(triangle, 1, vertices)];
    const T& c = attribute.values[attribute.index(triangle, 2, vertices)];
    return a * F(1 - u - v) + b * F(u) + c * F(v);
}

/// Unit, to the side from which the corners are seen counter-clockwise.
inline Vec3 triangle_normal(const Mesh& mesh, uint32_t triangle) {
    const Index3& i = mesh.triangles[triangle];
    const auto at = [&](uint32_t v) { return mesh.exact_positions.empty() ? Vec3(mesh.positions[v]) : mesh.exact_positions[v]; };
    return normalized(cross(at(i.y) - at(i.x), at(i.z) - at(i.x)));
}

}  // namespace alidade
