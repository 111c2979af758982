// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/diagnostics.h"
#include "scene/scene.h"

namespace alidade {

/// Says what the scene holds and the tracer does not render: an error where the picture would show something else, a warning where it only lacks
/// something. Nothing is lost in silence.
void report_unrendered(const Scene& scene, Diagnostics& said);

}  // namespace alidade
