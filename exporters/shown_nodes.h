// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/scene.h"

#include <functional>

namespace alidade {

/// Calls f(node, where it stands in the world) for all nodes that are shown, each once (an instance at its first place), parents first; f says whether to go on below it.
void visit_shown_nodes(const Scene& scene, const std::function<bool(NodeId, const Transform&)>& f);

}  // namespace alidade
