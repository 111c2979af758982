// SPDX-License-Identifier: Apache-2.0
/// What cycles.py is told beside the .glb.
#pragma once

#include "tools/compare/reference.h"
#include "tools/json.h"

namespace alidade {

/// The camera that we render with, the sky, the sun of a scene without light, samples, depth and the names of the pictures, in files of `folder`. An error
/// is one sentence that says what Cycles does not have.
tl::expected<Json, std::string> cycles_job(const CompareJob& job, const CompiledScene& scene, const std::string& folder);

}  // namespace alidade
