// SPDX-License-Identifier: Apache-2.0
/// What can be hit. Shapes say what the file says, in the file's numbers; eval/shapes knows how to intersect them.
#pragma once

#include "core/bounds.h"
#include "core/source.h"

#include <string>
#include <variant>
#include <vector>

namespace alidade {

/// All points at `radius` from `center`. A negative radius draws as a positive one.
struct Sphere {
    Vec3 center{0};
    double radius = 1;
};

/// All points p with dot(normal, p) = distance |normal|. As a solid: the side opposite to `normal`.
struct Plane {
    Vec3 normal{0, 1, 0};
    double distance = 0;
};

/// The solid between two opposite corners, in any order.
struct Box {
    Vec3 a{-1}, b{1};
};

/// A flat disc with a hole of radius `hole` (0: none). As a solid: the half space opposite to `normal`, as POV-Ray has it; the hole is only not hit.
/// Negative radii draw as positive ones.
struct Disc {
    Vec3 center{0}, normal{0, 1, 0};
    double radius = 1, hole = 0;
};

/// All points within `radius` of the axis from `a` to `b`. `open`: without its caps; what is inside stays the same. A negative radius draws as a positive one.
struct Cylinder {
    Vec3 a{0}, b{0, 1, 0};
    double radius = 1;
    bool open = false;
};

/// A cone cut off at both ends: its radius goes from `radius_a` at `a` to `radius_b` at `b`, evenly. Radii of different signs make two cones that meet
/// where the radius is 0; else a negative radius draws as a positive one. `open`: as for a cylinder.
struct Cone {
    Vec3 a{0}, b{0, 1, 0};
    double radius_a = 1, radius_b = 0;
    bool open = false;
};

/// All points within |minor| of the circle of radius |major| around `center`, in the plane y = center.y. If minor is the larger, the middle is filled.
struct Torus {
    Vec3 center{0};
    double major = 1, minor = 0.25;
};

/// A vertex attribute: values, and for each corner of each triangle an index into them. `corners` empty: indexed as the positions are.
template <class T> struct Attribute {
    std::vector<T> values;
    std::vector<uint32_t> corners;   ///< empty, or 3 x triangles

    bool present() const { return !values.empty(); }
    uint32_t index(size_t triangle, int corner, const Index3& vertices) const {
        return corners.empty() ? vertices[corner] : corners[3 * triangle + size_t(corner)];
    }
};

/// Deltas from the rest shape, one a vertex; an empty array means none.
struct MorphTarget {
    std::vector<Vec3f> positions, normals, tangents;
};

/// Four joints that move each vertex, and how much: one entry a vertex. A mesh has as many sets as its file gives; their weights add up to 1.
struct JointSet {
    std::vector<Joints4> joints;   ///< indices into the skin of the node that shows the mesh
    std::vector<Vec4f> weights;
};

/// A triangle mesh. Positions are relative to `origin`, so that surveyed coordinates keep their digits.
struct Mesh {
    Vec3 origin{0};
    std::vector<Vec3f> positions;
    std::vector<Vec3> exact_positions;      ///< empty, or as many as positions: the file's numbers where float rounds them (--precision double)
    std::vector<Index3> triangles;          ///< into positions; counter-clockwise seen from the front
    std::vector<uint32_t> slots;            ///< the material slot of each triangle; empty: all 0
    std::vector<uint32_t> faces;            ///< the polygon of the file that each triangle came from; empty: itself
    Attribute<Vec3f> normals;               ///< absent: flat
    std::vector<Attribute<Vec2f>> uvs;      ///< one a texture coordinate set, v growing downwards (glTF's convention)
    Attribute<Vec4f> tangents;              ///< xyz and the sign of the bitangent
    std::vector<Attribute<Vec4f>> colors;   ///< linear RGBA
    std::vector<MorphTarget> morphs;
    std::vector<double> morph_weights;      ///< default weights, one a target
    std::vector<JointSet> joint_sets;       ///< linear blend skinning, where a node has a skin
};

using ShapeGeometry = std::variant<Sphere, Plane, Box, Disc, Cylinder, Cone, Torus, Mesh>;

struct ShapeEntry {
    std::string name;
    ShapeGeometry geometry;
    SourcePos from;
};

/// The box of a shape in its own space: infinite where the shape is, empty for a mesh without triangles. It holds every point of the shape.
Bounds bounds(const ShapeGeometry& geometry);

/// A shape with more material slots is refused by validate().
inline constexpr uint32_t kMostSlots = 1 << 24;

/// How many material slots a shape has (at least 1).
uint32_t slot_count(const ShapeGeometry& geometry);

}  // namespace alidade
