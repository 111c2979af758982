// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "importers/gltf/reporter.h"
#include "scene/shape.h"

#include <span>

namespace alidade::gltf {

/// Examines the joint sets of a primitive: a set without joints or without weights is dropped, and weights that do not add up to 1 (specification,
/// section 3.7.3.3) are pointed out: deform() divides by their sum. False, and an error, if a weight is negative.
/// `vertices`: the file's number of each vertex of `mesh`; empty: its own.
bool finish_joints(Mesh& mesh, std::span<const uint32_t> vertices, const std::string& at, Reporter& report);

}  // namespace alidade::gltf
