// SPDX-License-Identifier: Apache-2.0
/// The light from all around a scene.
#pragma once

#include "core/diagnostics.h"
#include "tracer/options.h"

namespace alidade {

struct CompiledScene;

/// Gives `out` the sky that the user asked for, else the file's.
void make_sky(CompiledScene& out, const CompileOptions& options, Diagnostics& said);

}  // namespace alidade
