// SPDX-License-Identifier: Apache-2.0
#include "topology/half_edges.h"

namespace alidade::topology {
namespace {

/// Where walks would take too long, vertices with more triangles than this are left to themselves.
constexpr uint32_t kCrowd = 1000;

std::vector<uint32_t> valences(std::span<const uint32_t> corners, size_t vertices) {
    std::vector<uint32_t> out(vertices, 0);
    for (const uint32_t v : corners) ++out[v];
    return out;
}

/// For each point: are there too many triangles for walks around it? At none, if walks take no time worth mentioning.
std::vector<uint8_t> crowded_points(const Welded& surface) {
    std::vector<uint32_t> corners;
    for (size_t t = 0; t < surface.triangles.size(); ++t)
        for (int k = 0; surface.sound[t] && k < 3; ++k) corners.push_back(surface.triangles[t][k]);
    std::vector<uint8_t> out(surface.points.size(), 0);
    if (crowding(corners, out.size(), 2) <= kMostSteps) return out;
    const std::vector<uint32_t> valence = valences(corners, out.size());
    for (size_t v = 0; v < out.size(); ++v) out[v] = valence[v] > kCrowd;
    return out;
}

}  // namespace

void silence_openmesh() {
    static const bool once = (omerr().disable(), true);
    (void)once;
}

double crowding(std::span<const uint32_t> corners, size_t vertices, int power) {
    double steps = 0;
    for (const uint32_t n : valences(corners, vertices)) steps += std::pow(double(n), power);
    return steps;
}

HalfEdges half_edges(const Welded& surface) {
    silence_openmesh();
    const std::vector<uint8_t> crowded = crowded_points(surface);
    HalfEdges out;
    out.mesh.reserve(surface.points.size(), 3 * surface.triangles.size() / 2, surface.triangles.size());
    for (const Vec3& p : surface.points) out.mesh.add_vertex(to_openmesh(p));
    for (uint32_t t = 0; t < surface.triangles.size(); ++t) {
        if (!surface.sound[t]) continue;
        const Index3& v = surface.triangles[t];
        if (crowded[v.x] || crowded[v.y] || crowded[v.z]) {
            out.refused.push_back(t);
            continue;
        }
        const auto face = out.mesh.add_face(OpenMesh::VertexHandle(int(v.x)), OpenMesh::VertexHandle(int(v.y)), OpenMesh::VertexHandle(int(v.z)));
        (face.is_valid() ? out.triangle_of : out.refused).push_back(t);
    }
    out.manifold = out.refused.empty();
    for (const auto v : out.mesh.vertices()) out.manifold = out.manifold && out.mesh.is_manifold(v);
    return out;
}

}  // namespace alidade::topology
