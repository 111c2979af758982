// SPDX-License-Identifier: Apache-2.0
/// POV-Ray's cutaway_textures: faces of parts without a material show what they lay open.
#pragma once

#include "tracer/compiled_scene.h"

namespace alidade {

struct ShadePoint;

/// Adds to CompiledScene::cutaways, and to the instances in `solid` which of them they ask.
///
/// By experiment: a leaf without a material is meant whose own operation cuts (an intersection, a difference, a union that is taken away), if that or an
/// operation around it says cutaway_textures and some part of the outermost operation that cuts has a material.
void find_cutaways(CompiledScene& scene, const CsgExpression& solid);

/// What the surface at `point`, of an instance with a cutaway, shows in equal shares, as indices into CompiledScene::slots. By experiment: the parts of the
/// outermost operation that cuts which hold the point, of a difference the first alone, and in them their parts; black where there are none.
std::vector<uint32_t> slots_laid_open(const CompiledScene& scene, const ShadePoint& point);

}  // namespace alidade
