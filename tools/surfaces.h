// SPDX-License-Identifier: Apache-2.0
/// What info tells of the meshes of a scene as surfaces.
#pragma once

#include "scene/scene.h"
#include "tools/json.h"

namespace alidade {

/// "surfaces", a row for each mesh: how many pieces, closed or not, Euler characteristic, genus; and "defects", a row for each mesh that has some. The
/// words are those of topology/report.h. About a second a million triangles.
Json describe_surfaces(const Scene& scene);

}  // namespace alidade
