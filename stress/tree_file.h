// SPDX-License-Identifier: Apache-2.0
/// Trees as JSON, for whoever studies them: docs/stress.md has the schema.
#pragma once

#include "stress/scene.h"

#include <functional>
#include <string>
#include <tl/expected.hpp>

namespace alidade {

/// Hands the tree to `write`, piece by piece, as one JSON object. False, and nothing written, if the structure is no tree (Accelerator::visit_nodes). `words`: keys that come first, such as "\"mesh\": 0, "; `triangles`: of the mesh.
bool tree_json(const Accelerator& accelerator, size_t triangles, const std::function<void(std::string_view)>& write, std::string_view words = {});

/// Builds the structure over each mesh, one after the other, and writes all of them to one file. False, and no file, if it is no tree. An error is one sentence.
tl::expected<bool, std::string> write_trees(const std::string& path, const AcceleratorEntry& entry, const AccelOptions& options, const StressScene& scene);

}  // namespace alidade
