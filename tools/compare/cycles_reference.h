// SPDX-License-Identifier: Apache-2.0
/// The installed Blender's renderer Cycles.
#pragma once

#include "tools/compare/reference.h"

namespace alidade {

/// Cycles' pictures of the .glb at job.scene, seen and lit as `scene` is: job.seeds of them, from the cache if the .glb, the script that renders it, Blender's
/// version and what was asked for are what they were.
tl::expected<Rendered, RenderFailure> cycles_reference(const CompareJob& job, const CompiledScene& scene, const std::string& scratch);

/// "3.4.1", or "" if Blender is not installed.
const std::string& blender_version();

}  // namespace alidade
