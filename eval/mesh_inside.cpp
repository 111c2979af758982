// SPDX-License-Identifier: Apache-2.0
#include "eval/mesh_inside.h"

namespace alidade {

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
