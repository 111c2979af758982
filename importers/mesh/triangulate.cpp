// SPDX-License-Identifier: Apache-2.0
#include "importers/mesh/triangulate.h"

namespace alidade::mesh {

Vec3 area_vector(std::span<const Vec3> polygon) {
    Vec3 sum(0);
    for (size_t i = 1; i + 1 < polygon.size(); ++i) sum += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
    return 0.5 * sum;
}

void Triangulator::project(std::span<const Vec3> polygon) {
    const Vec3 normal = area_vector(polygon), size = glm::abs(normal);
    const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const double mirror = normal[axis] < 0 ? -1 : 1;   // so that the polygon turns to the left
    points_.clear();
    for (const Vec3& p : polygon) points_.emplace_back(mirror * (p[u] - polygon[0][u]), p[v] - polygon[0][v]);
}

/// Twice the signed area of a triangle: positive if it turns to the left at b.
double Triangulator::turn(uint32_t a, uint32_t b, uint32_t c) const {
    const Vec2 ab = points_[b] - points_[a], ac = points_[c] - points_[a];
    return ab.x * ac.y - ab.y * ac.x;
}

bool Triangulator::triangulate(std::span<const Vec3> polygon, std::vector<Index3>& triangles) {
    if (polygon.size() == 3) {
        triangles.emplace_back(0, 1, 2);
        return true;
    }
    project(polygon);
    return fan(triangles) || clip_ears(triangles);
}

/// A fan is right if all its triangles turn to the left and it stays within one turn; both diagonals of a quadrangle are tried.
bool Triangulator::fan(std::vector<Index3>& triangles) const {
    const uint32_t count = uint32_t(points_.size());
    for (uint32_t apex = 0; apex < (count == 4 ? 2u : 1u); ++apex) {
        bool right = true;
        for (uint32_t i = 1; i + 1 < count && right; ++i) right = turn(apex, (apex + i) % count, (apex + i + 1) % count) > 0;
        // All left turns seen from the apex: within half a turn if no edge's end lies beyond the straight line through the first edge.
        for (uint32_t i = 2; i < count && right; ++i) right = turn(apex, (apex + 1) % count, (apex + i) % count) > 0;
        if (!right) continue;
        for (uint32_t i = 1; i + 1 < count; ++i) triangles.emplace_back(apex, (apex + i) % count, (apex + i + 1) % count);
        return true;
    }
    return false;
}

void Triangulator::unlink(uint32_t corner) {
    next_[previous_[corner]] = next_[corner];
    previous_[next_[corner]] = previous_[corner];
}

/// Convex, and no other corner lies in its triangle or on its border; corners at the same place as one of its own do not count.
bool Triangulator::is_ear(uint32_t corner) {
    const uint32_t a = previous_[corner], c = next_[corner];
    if (!(turn(a, corner, c) > 0)) return false;
    for (uint32_t i = next_[c]; i != a; i = next_[i]) {
        if (tests_left_ == 0) return true;
        --tests_left_;
        const bool inside = turn(a, corner, i) >= 0 && turn(corner, c, i) >= 0 && turn(c, a, i) >= 0;
        if (inside && points_[i] != points_[a] && points_[i] != points_[corner] && points_[i] != points_[c]) return false;
    }
    return true;
}

bool Triangulator::clip_ears(std::vector<Index3>& triangles) {
    const uint32_t count = uint32_t(points_.size());
    next_.resize(count), previous_.resize(count), ear_.resize(count);
    for (uint32_t i = 0; i < count; ++i) next_[i] = (i + 1) % count, previous_[i] = (i + count - 1) % count;
    for (uint32_t i = 0; i < count; ++i) ear_[i] = is_ear(i);

    bool simple = true;
    uint32_t corner = 0, since_last = 0;   // corners looked at since the last ear
    for (uint32_t left = count; left > 3;) {
        if (!ear_[corner] && since_last < left && tests_left_ > 0) {
            corner = next_[corner], ++since_last, --tests_left_;
            continue;
        }
        simple = simple && ear_[corner];   // without an ear the polygon is not simple: any corner is cut, so that this ends
        const uint32_t a = previous_[corner], c = next_[corner];
        triangles.emplace_back(a, corner, c);
        unlink(corner);
        ear_[a] = is_ear(a), ear_[c] = is_ear(c);
        corner = c, since_last = 0, --left;
    }
    triangles.emplace_back(previous_[corner], corner, next_[corner]);
    return simple && turn(previous_[corner], corner, next_[corner]) > 0 && tests_left_ > 0;
}

}  // namespace alidade::mesh
