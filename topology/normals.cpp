// SPDX-License-Identifier: Apache-2.0
#include "topology/normals.h"

#include "topology/edges.h"

namespace alidade::topology {
namespace {

/// For each triangle its unit normal, or 0 if it has no area.
std::vector<Vec3> face_normals(const Welded& surface) {
    std::vector<Vec3> normals(surface.triangles.size(), Vec3(0));
    for (size_t t = 0; t < normals.size(); ++t) {
        if (!surface.sound[t]) continue;
        const Index3& v = surface.triangles[t];
        const Vec3 &a = surface.points[v.x], &b = surface.points[v.y], &c = surface.points[v.z];
        normals[t] = normalized(cross(normalized(b - a), normalized(c - a)));
    }
    return normals;
}

double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(length(cross(a, b)), dot(a, b)); }

double angle_at(const Welded& surface, uint32_t corner) {
    const auto point = [&](uint32_t c) { return surface.points[surface.triangles[c / 3][int(c % 3)]]; };
    const Vec3 here = point(corner);
    return angle_between(normalized(point(next_corner(corner)) - here), normalized(point(previous_corner(corner)) - here));
}

/// A unit vector; anything will do where there is no surface.
Vec3f unit_or_up(const Vec3& v) {
    const Vec3 n = normalized(v);
    return n == Vec3(0) || !is_finite(n) ? Vec3f(0, 0, 1) : Vec3f(n);
}

}  // namespace

void set_crease_normals(Mesh& mesh, double crease_degrees) {
    constexpr double kSlack = 1e-6;
    const Welded surface = weld(mesh);
    const std::vector<Vec3> normals = face_normals(surface);
    const double limit = crease_degrees * kPi / 180 + kSlack;
    const auto smooth = [&](const Side& one, const Side& other) {
        const uint32_t a = one.corner / 3, b = other.corner / 3;
        if (one.from == other.from) return false;
        if (!mesh.faces.empty() && mesh.faces[a] == mesh.faces[b]) return true;
        return normals[a] == Vec3(0) || normals[b] == Vec3(0) || angle_between(normals[a], normals[b]) <= limit;
    };
    Sets around = fans(surface, Edges(surface), smooth);

    const uint32_t corners = uint32_t(3 * mesh.triangles.size());
    std::vector<Vec3> sums(corners, Vec3(0));
    for (uint32_t c = 0; c < corners; ++c)
        if (normals[c / 3] != Vec3(0)) sums[around.find(c)] += angle_at(surface, c) * normals[c / 3];

    mesh.normals = {};
    mesh.normals.corners.resize(corners);
    std::vector<uint32_t> number(corners, kNone);
    for (uint32_t c = 0; c < corners; ++c) {
        uint32_t& n = number[around.find(c)];
        if (n == kNone) {
            n = uint32_t(mesh.normals.values.size());
            mesh.normals.values.push_back(unit_or_up(sums[around.find(c)]));
        }
        mesh.normals.corners[c] = n;
    }
}

}  // namespace alidade::topology
