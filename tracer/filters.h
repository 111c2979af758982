// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tracer/compiled_scene.h"

namespace alidade {

/// Tells the instances and solids that let light through from those that stop it, by their masks, and builds what shadow rays ask of either.
void build_filters(CompiledScene& out, const AcceleratorEntry& accel, const AccelOptions& build);

}  // namespace alidade
