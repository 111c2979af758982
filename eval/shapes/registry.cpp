// SPDX-License-Identifier: Apache-2.0
#include "core/clamp.h"
#include "eval/shapes/rows.h"

namespace alidade {

Crossings ShapeOps::crossings_at_unit_speed(const ShapeGeometry& shape, const Bounds& own, const Ray& ray) const {
    const double speed = max_abs(ray.dir);
    if (!(speed > 0 && std::isfinite(speed))) return crossings(shape, ray);
    const int power = std::ilogb(speed);
    Ray slowed = ray;
    for (int axis = 0; axis < 3; ++axis) slowed.dir[axis] = std::ldexp(ray.dir[axis], -power);
    Crossings found = crossings(shape, slowed);
    for (int i = 0; i < found.count; ++i) {
        const double t = std::ldexp(found.at[size_t(i)].t, -power);
        if (!std::isfinite(t)) return {};   // further than the ray's own numbers reach
        found.at[size_t(i)].t = clamp_to_bounds(t, ray, own);
    }
    return found;
}

std::span<const ShapeOps> shapes() {
    static const ShapeOps kTable[] = {kSphereOps, kPlaneOps, kBoxOps, kDiscOps, kCylinderOps, kConeOps, kTorusOps, kQuadricOps, kPolynomialOps, kPolygonOps, kExtrusionOps};
    return kTable;
}

const ShapeOps* find_shape(const ShapeGeometry& geometry) {
    for (const ShapeOps& row : shapes())
        if (row.kind == geometry.index()) return &row;
    return nullptr;
}

}  // namespace alidade
