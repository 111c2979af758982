// SPDX-License-Identifier: Apache-2.0
/// An OBJ file as plain data: what it says, line by line, with its indices resolved.
#pragma once

#include "core/diagnostics.h"
#include "core/vec.h"

#include <optional>
#include <string_view>
#include <vector>

namespace alidade::mesh {

inline constexpr uint32_t kAbsent = ~uint32_t(0);

/// A corner of a polygon: indices from 0, or kAbsent.
struct Corner {
    uint32_t position, uv = kAbsent, normal = kAbsent;
};

/// A polygon of at least three corners.
struct Face {
    uint32_t first, count;   ///< in ObjText::corners
    uint32_t line;
};

/// From this face on (up to the next section) the faces have these properties.
struct Section {
    uint32_t first_face = 0;
    uint32_t object = 0;
    uint32_t material = kAbsent;   ///< in ObjText::materials
    uint32_t smoothing = 0;        ///< the smoothing group; 0: off
};

/// A name that the file mentions, and where first.
struct Named {
    std::string name;
    SourcePos from;
};

/// PLY, STL and OFF files are read into this form too: one object, no materials.
struct ObjText {
    std::vector<Vec3> positions;
    std::vector<Vec4f> colors;      ///< linear, with alpha; empty, or one a position
    std::vector<Vec2f> uvs;         ///< v turned to grow downwards
    std::vector<Vec3f> normals;     ///< of length 1, or 0 where the file's has no direction
    std::vector<Corner> corners;
    std::vector<Face> faces;
    std::vector<Section> sections;
    std::vector<Named> objects;     ///< the first is what stands before any `o`
    std::vector<Named> materials;   ///< as `usemtl` names them
    std::vector<Named> libraries;   ///< the rest of each `mtllib` line
    bool exceeds_float = false;     ///< some coordinate has more digits than a float keeps

    /// Of any length; false, and a normal of length 0, if it is not finite.
    bool add_normal(const Vec3& normal);
    /// As files write it, v growing upwards; false, and that of (0, 0), if it is not finite.
    bool add_uv(double u, double v);

    /// One past the last face of a section.
    uint32_t section_end(size_t section) const { return section + 1 < sections.size() ? sections[section + 1].first_face : uint32_t(faces.size()); }
};

/// Reads all of `text`. Statements for what is no polygon (points, lines, curves, surfaces) and unknown ones are left out with a warning.
/// Errors are in `said`, and then nothing is returned: malformed numbers and faces, indices that are 0 or name nothing, text in which no OBJ
/// statement is found.
/// Source   Wavefront, "Object Files (.obj)", version 3.0; vertex colours as MeshLab and Blender write them, after the coordinates.
std::optional<ObjText> read_obj_text(std::string_view text, uint32_t file, bool strict, Diagnostics& said);

/// Does the text begin with a statement that only OBJ has, after comments?
bool begins_like_obj(std::string_view text);

}  // namespace alidade::mesh
