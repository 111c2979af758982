// SPDX-License-Identifier: Apache-2.0
/// From the text of an OBJ file to triangle meshes.
#pragma once

#include "importers/mesh/obj_text.h"
#include "importers/mesh/triangulate.h"
#include "scene/shape.h"


namespace alidade::mesh {

/// An object of the file with faces: a run of sections.
struct ObjectSections {
    uint32_t object = 0;
    size_t first = 0, last = 0;   ///< in ObjText::sections, one past the last
};
std::vector<ObjectSections> objects_with_faces(const ObjText& text);

/// Leaves out, with a warning, the faces that no renderer can use: with a vertex that is not finite or too large for float, or with fewer than three
/// different corners in a row. A face that is left out has no corners any more. Corners that repeat the one before are dropped silently.
void leave_out_broken_faces(ObjText& text, uint32_t file, Diagnostics& said);

/// A mesh, and what the file calls the materials of its slots (indices into ObjText::materials, or kAbsent).
struct BuiltMesh {
    Mesh mesh;
    std::vector<uint32_t> slot_materials;
    uint32_t complex_faces = 0, first_complex_line = 0;   ///< polygons that are not simple
};

/// Builds the meshes of one file.
///
/// Origin      Mesh::origin is 0, unless the object lies more than 64 of its own sizes away from 0: then float's 24 bits would leave its shape less
///             than 18, and positions are counted from an origin near the object.
/// Exactness   Mesh::exact_positions are kept if some coordinate of the file has more digits than a float keeps.
class MeshBuilder {
  public:
    explicit MeshBuilder(ObjText& text) : text_(text) {}
    BuiltMesh build(const ObjectSections& object);

  private:
    /// Numbers the elements of one array in the order of their first use.
    class Renumbering {
      public:
        /// Replaces the indices by their new numbers; returns the old index of each number.
        std::vector<uint32_t> apply(std::vector<uint32_t>& indices, size_t count);

      private:
        std::vector<uint32_t> number_;
    };

    void cut_into_triangles(const ObjectSections& object, BuiltMesh& out);
    size_t cut_face(const Face& face, BuiltMesh& out);
    void set_positions(BuiltMesh& out);
    void set_uvs(Mesh& mesh);
    void set_normals(Mesh& mesh);
    std::vector<uint32_t> indices(uint32_t Corner::*which, uint32_t instead) const;

    ObjText& text_;
    Triangulator triangulator_;
    std::vector<Vec3> polygon_;
    std::vector<Index3> triangles_;
    std::vector<uint32_t> cut_;           ///< of the object being built: the corner in ObjText::corners of each triangle's corners
    std::vector<uint32_t> positions_;     ///< the new number of each one's position
    Renumbering of_positions_, of_uvs_, of_normals_;
};

}  // namespace alidade::mesh
