// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "importers/gltf/json.h"
#include "importers/gltf/reporter.h"

namespace alidade::gltf {

/// The nodes must be trees: at most one parent each, no cycle, and the nodes that scenes list have none. Also which properties
/// of a node go together. `root` has passed check_schema().
void check_node_tree(const Json& root, Reporter& report);

}  // namespace alidade::gltf
