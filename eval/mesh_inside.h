// SPDX-License-Identifier: Apache-2.0
/// What is inside of a mesh.
#pragma once

#include "accel/accelerator.h"
#include "scene/shape.h"

namespace alidade {

/// Is `point`, in the mesh's own space, inside? Where the mesh has an inside_vector and a line from the point that way crosses an odd number of its
/// triangles (POV-Ray manual, 3.4.5.2.4 "Mesh"). `triangles` is the accelerator of the mesh.
bool inside_mesh(const Mesh& mesh, const Accelerator& triangles, const Vec3& point, WorkCounters& work);

/// Is nothing inside of the mesh but in its box? So it is where each edge, by the places of its ends, belongs to an even number of triangles: whatever comes
/// from far away meets an even number of them. A mesh with a hole has insides that go on behind it for ever.
bool keeps_inside_in_box(const Mesh& mesh);

}  // namespace alidade
