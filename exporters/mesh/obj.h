// SPDX-License-Identifier: Apache-2.0
/// Wavefront OBJ with its MTL material library.
#pragma once

#include "exporters/exporter.h"

namespace alidade {

/// Each mesh that is shown becomes an object, in world coordinates: its triangles, normals, first texture coordinates and first vertex colours
/// (sRGB-encoded, behind the coordinates, as Blender and MeshLab write them). Coordinates have the fewest digits that read back as the same double;
/// or float, where that is enough. Names are made plain (plain_name), so that none can break a line or a path.
tl::expected<void, std::string> write_obj(const Scene& scene, OutputFiles& files, Losses& losses);

}  // namespace alidade
