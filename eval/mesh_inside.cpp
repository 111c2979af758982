// SPDX-License-Identifier: Apache-2.0
#include "eval/mesh_inside.h"

#include <algorithm>
#include <numeric>

namespace alidade {

namespace {

/// Of each position, a number that positions at the same place share.
std::vector<uint32_t> place_numbers(const std::vector<Vec3f>& positions) {
    std::vector<uint32_t> order(positions.size()), number(positions.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto less = [&](uint32_t a, uint32_t b) {
        const Vec3f &p = positions[a], &q = positions[b];
        return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
    };
    std::sort(order.begin(), order.end(), less);
    for (size_t i = 1; i < order.size(); ++i) number[order[i]] = number[order[i - 1]] + (less(order[i - 1], order[i]) ? 1 : 0);
    return number;
}

}  // namespace

bool keeps_inside_in_box(const Mesh& mesh) {
    const std::vector<uint32_t> number = place_numbers(mesh.positions);
    std::vector<uint64_t> edges;
    edges.reserve(3 * mesh.triangles.size());
    for (const Index3& t : mesh.triangles)
        for (int k = 0; k < 3; ++k) {
            const uint64_t a = number[t[k]], b = number[t[(k + 1) % 3]];
            if (a != b) edges.push_back(std::min(a, b) << 32 | std::max(a, b));
        }
    std::sort(edges.begin(), edges.end());
    for (size_t i = 0, end; i < edges.size(); i = end) {
        end = size_t(std::upper_bound(edges.begin() + std::ptrdiff_t(i), edges.end(), edges[i]) - edges.begin());
        if ((end - i) % 2 != 0) return false;
    }
    return true;
}

bool inside_mesh(const Mesh& mesh, const Accelerator& triangles, const Vec3& point, WorkCounters& work) {
    if (!mesh.inside_vector) return false;
    Ray ray;
    ray.origin = point, ray.dir = *mesh.inside_vector;
    thread_local std::vector<Hit> hits;
    hits.clear();
    triangles.all_hits(ray, hits, work);
    return hits.size() % 2 == 1;
}

}  // namespace alidade
