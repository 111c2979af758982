// SPDX-License-Identifier: Apache-2.0
/// The meshes of a scene as its nodes show them: for formats that have no nodes.
#pragma once

#include "exporters/losses.h"

#include <tl/expected.hpp>

namespace alidade {

/// A mesh as one path from a root shows it.
struct WorldMesh {
    const Mesh* mesh = nullptr;
    std::string name;
    Transform to_world, to_local;
    std::vector<std::optional<MaterialId>> materials;   ///< one a slot, inherited ones included
    std::vector<uint32_t> finite;                       ///< the triangles whose vertices are numbers

    /// In double precision, with the digits that the file had.
    Vec3 position(uint32_t vertex) const;
    /// Of length 1, or 0 if `normal` has no direction.
    Vec3 normal(const Vec3f& normal) const;
    /// The corners (0, 1, 2) of a triangle in the order that is counter-clockwise from the front: a mirroring turns it.
    Index3 order() const { return to_world.determinant() < 0 ? Index3(0, 2, 1) : Index3(0, 1, 2); }
};

/// All that are shown, in document order. What a file of meshes alone does not hold is told to `losses`. An error if the scene shows more than
/// kMostTriangles, or leads to its shapes by more paths than that.
tl::expected<std::vector<WorldMesh>, std::string> world_meshes(const Scene& scene, Losses& losses);
inline constexpr size_t kMostTriangles = 200'000'000;

/// Do all coordinates survive being rounded to float, also where a reader counts them from an origin near the mesh? So they do if they are floats,
/// and no mesh lies so far away that a part of its float digits says where it is.
bool floats_suffice(const std::vector<WorldMesh>& meshes);

/// One channel of 8 bits, if there is one that reads back as this linear number, else -1.
int srgb_byte(float linear);

}  // namespace alidade
