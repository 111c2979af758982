// SPDX-License-Identifier: Apache-2.0
/// Small scenes with every kind of shape and of surface, whose whole world hangs on one node.
#pragma once

#include "tracer/render.h"

#include <vector>

namespace alidade::numerics {

/// A row for each closed form in the table of shapes, a mesh and a solid, times the surfaces.
size_t toy_scene_count();

/// Everything below one root that is scaled by `scale` and moved by `offset`; what is in world units (light, its fading, clearances, fog, the falling off of what is clear) is scaled to match.
Scene toy_scene(size_t number, double scale = 1, const Vec3& offset = Vec3(0));
/// The same without a transform: vertices, the numbers of closed forms, the lights, the camera and the patterns are scaled themselves.
Scene baked_toy_scene(size_t number, double scale);
std::string toy_scene_name(size_t number);

/// The shape of a row of the table as it comes: of size 1 or 2, at the origin.
ShapeGeometry toy_shape(size_t row);
struct PlacedToy {
    ShapeGeometry geometry;
    Transform to_world;
};
/// Shapes alone, an instance each, in their order.
Scene toy_shapes(std::vector<PlacedToy> shapes);

/// 40 x 30, through the centres of pixels. Empty if it cannot be rendered.
Picture toy_picture(const Scene& scene, CompileOptions compile_options = {}, RenderOptions options = {});

}  // namespace alidade::numerics
