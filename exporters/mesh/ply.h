// SPDX-License-Identifier: Apache-2.0
/// PLY (the Stanford format), binary.
#pragma once

#include "exporters/exporter.h"

namespace alidade {

/// All that is shown becomes one mesh in world coordinates: triangles, and vertices with normals, texture coordinates (u, v) and colours if any mesh has
/// them. Coordinates are float where that is exact, else double; colours are 8-bit sRGB where that is exact, else linear floats. A mesh without
/// normals among others with them gets those of its triangles.
tl::expected<void, std::string> write_ply(const Scene& scene, OutputFiles& files, Losses& losses);

}  // namespace alidade
