// SPDX-License-Identifier: Apache-2.0
/// Scenes made in memory whose pictures are known in closed form: a reference without noise.
#pragma once

#include "core/image.h"
#include "scene/scene.h"
#include "tools/values.h"

#include <span>

namespace alidade::tradeoff {

/// What is seen at one point of a picture. `piece` tells the parts apart between which the picture has edges.
struct SeenPoint {
    Color radiance{0};
    int piece = 0;
};

struct AnalyticScene {
    const char* name;
    const char* doc;
    Scene (*scene)();
    /// At (s, t), 0 .. 1 from the top left.
    SeenPoint (*seen)(double s, double t);
};
std::span<const AnalyticScene> analytic_scenes();

/// "analytic:furnace" -> its row; null for other names.
const AnalyticScene* find_analytic(std::string_view scene);
bool is_analytic(std::string_view scene);
/// The scene "analytic:NAME"; an error is one sentence.
Value<Scene> analytic_scene(const std::string& name);

/// The mean of what is seen in each pixel: of 16 x 16 points, of 256 x 256 where a pixel has an edge in it.
Picture analytic_picture(const AnalyticScene& scene, int width, int height);

/// The form factor between two parallel discs on one axis, `distance` apart: the part of the light from the first that the second meets.
/// Source   Howell, "A Catalog of Radiation Heat Transfer Configuration Factors", C-41.
double disc_to_disc(double radius1, double radius2, double distance);
/// Of a point of a plane, `offset` from the axis of a disc that lies parallel in `distance`. Source   ibid., B-13.
double point_to_disc(double offset, double distance, double radius);

}  // namespace alidade::tradeoff
