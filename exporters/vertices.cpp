// SPDX-License-Identifier: Apache-2.0
#include "exporters/vertices.h"

#include <algorithm>
#include <unordered_map>

namespace alidade {

namespace {

constexpr uint32_t kNone = ~uint32_t(0);

/// The index of an attribute at each corner of `which`.
template <class T> std::vector<uint32_t> corner_indices(const Attribute<T>& attribute, std::span<const uint32_t> which) {
    std::vector<uint32_t> out;
    out.reserve(3 * which.size());
    for (const uint32_t t : which)
        for (size_t c = 0; c < 3; ++c) out.push_back(attribute.corners[3 * size_t(t) + c]);
    return out;
}

/// Calls f(attribute) for each that the mesh has.
template <class F> void for_each_attribute(const Mesh& mesh, const F& f) {
    f(mesh.normals), f(mesh.tangents);
    for (const auto& uv : mesh.uvs) f(uv);
    for (const auto& color : mesh.colors) f(color);
}

std::vector<uint32_t> position_of_corners(const Mesh& mesh, std::span<const uint32_t> which) {
    std::vector<uint32_t> out;
    out.reserve(3 * which.size());
    for (const uint32_t t : which)
        for (int c = 0; c < 3; ++c) out.push_back(mesh.triangles[t][c]);
    return out;
}

/// Vertices are positions, in their order.
Vertices shared(const Mesh& mesh, std::span<const uint32_t> which) {
    Vertices out;
    std::vector<uint32_t> number(mesh.positions.size(), which.size() == mesh.triangles.size() ? 0 : kNone);
    for (const uint32_t t : which)
        for (int c = 0; c < 3; ++c) number[mesh.triangles[t][c]] = 0;
    for (uint32_t i = 0; i < number.size(); ++i)
        if (number[i] != kNone) number[i] = uint32_t(out.positions.size()), out.positions.push_back(i);
    for (const uint32_t t : which) {
        const Index3& v = mesh.triangles[t];
        out.triangles.emplace_back(number[v.x], number[v.y], number[v.z]);
    }
    return out;
}

}  // namespace

void number_pairs(std::vector<uint32_t>& a, std::span<const uint32_t> b) {
    std::unordered_map<uint64_t, uint32_t> numbers;
    numbers.reserve(a.size());
    for (size_t i = 0; i < a.size(); ++i) a[i] = numbers.try_emplace(uint64_t(a[i]) << 32 | b[i], uint32_t(numbers.size())).first->second;
}

Vertices collect_vertices(const Mesh& mesh, std::span<const uint32_t> which) {
    bool own_corners = false;
    for_each_attribute(mesh, [&](const auto& a) { own_corners = own_corners || !a.corners.empty(); });
    if (!own_corners) return shared(mesh, which);
    const std::vector<uint32_t> position = position_of_corners(mesh, which);
    std::vector<uint32_t> vertex = position;
    for_each_attribute(mesh, [&](const auto& a) {
        if (!a.corners.empty()) number_pairs(vertex, corner_indices(a, which));
    });
    Vertices out;
    for (size_t i = 0; i < vertex.size(); ++i) {
        if (vertex[i] < out.positions.size()) continue;   // numbers come in order
        out.positions.push_back(position[i]);
        out.corners.push_back(3 * which[i / 3] + uint32_t(i % 3));
    }
    for (size_t i = 0; i < vertex.size(); i += 3) out.triangles.emplace_back(vertex[i], vertex[i + 1], vertex[i + 2]);
    return out;
}

std::vector<uint32_t> finite_triangles(const Mesh& mesh) {
    const auto finite = [&](uint32_t i) { return is_finite(mesh.positions[i]) && (mesh.exact_positions.empty() || is_finite(mesh.exact_positions[i])); };
    std::vector<uint32_t> out;
    out.reserve(mesh.triangles.size());
    for (uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const Index3& v = mesh.triangles[t];
        if (finite(v.x) && finite(v.y) && finite(v.z)) out.push_back(t);
    }
    return out;
}

}  // namespace alidade
