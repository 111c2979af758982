// SPDX-License-Identifier: Apache-2.0
#include "eval/shapes/rows.h"

namespace alidade {

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
