// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tracer/compiled_scene.h"

namespace alidade {

/// The set of texture coordinates that a normal map's tangents follow.
uint32_t tangent_uv_set(const Scene& scene, SignalId normal_map);

/// Makes the tangents that instances with normal maps need and their meshes do not have; in parallel.
void make_missing_tangents(CompiledScene& scene, int threads);

}  // namespace alidade
