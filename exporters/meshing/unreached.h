// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/scene.h"

namespace alidade::meshing {

/// `scene` without the nodes that its roots do not lead to any more, while they did in `before`, whose nodes have the same ids.
Scene without_unreached(Scene scene, const Scene& before);

}  // namespace alidade::meshing
