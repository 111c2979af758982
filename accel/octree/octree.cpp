// SPDX-License-Identifier: Apache-2.0
#include "accel/octree/octree.h"

#include "accel/structure.h"

namespace alidade {

OctreeSplit::OctreeSplit(const Bounds& box, const Vec3& typical) : middle(box.center()) {
    const Vec3 extent = box.extent() / typical;
    const double shortest = 0.5 * max_component(extent);
    for (int a = 0; a < 3; ++a) {
        if (extent[a] > shortest && box.min[a] < middle[a] && middle[a] < box.max[a]) {
            halved |= 1u << a;
        } else {
            middle[a] = box.max[a];
        }
    }
}

Bounds OctreeSplit::child(const Bounds& box, uint32_t octant) const {
    Bounds child = box;
    for (int a = 0; a < 3; ++a) (octant >> a & 1 ? child.min[a] : child.max[a]) = middle[a];
    return child;
}

uint32_t OctreeSplit::sides(const Bounds& part, bool lower) const {
    uint32_t sides = 0;
    for (int a = 0; a < 3; ++a) {
        const bool halves = halved >> a & 1;
        if (lower ? !halves || part.min[a] <= middle[a] : halves && part.max[a] >= middle[a]) sides |= 1u << a;
    }
    return sides;
}

double octree_division_cost(const Bounds& box, const OctreeSplit& split, const std::array<size_t, 8>& counts) {
    const double area = box.half_area();
    double cost = 0;
    for (uint32_t octant = 0; octant < 8; ++octant) {
        if (counts[octant]) cost += 1 + double(counts[octant]) * (area > 0 ? split.child(box, octant).half_area() / area : 1);
    }
    return cost;
}

template std::unique_ptr<Accelerator> over_triangles<Octree>(const TriangleView&, const AccelOptions&);
template std::unique_ptr<Accelerator> over_set<Octree>(std::shared_ptr<const PrimitiveSet>, const AccelOptions&);

}  // namespace alidade
