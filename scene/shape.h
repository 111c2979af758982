// SPDX-License-Identifier: Apache-2.0
/// What can be hit. Shapes say what the file says, in the file's numbers; eval/shapes knows how to intersect them.
#pragma once

#include "core/bounds.h"
#include "core/source.h"

#include <optional>
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

/// All points within |minor| of the circle of radius |major| around `center`, in the plane y = center.y. If minor is the larger, the middle is filled, and the
/// tube is seen within, too, where it overlaps itself.
struct Torus {
    Vec3 center{0};
    double major = 1, minor = 0.25;
};

/// All points with A x^2 + B y^2 + C z^2 + D xy + E xz + F yz + G x + H y + I z + J = 0; as a solid: where this is negative.
struct Quadric {
    Vec3 squares{1};    ///< A, B, C
    Vec3 products{0};   ///< D, E, F
    Vec3 linear{0};     ///< G, H, I
    double constant = -1;
};

/// All points where a polynomial in x, y and z is 0; as a solid: where it is negative. The coefficients stand by falling powers of x, then of y, then of
/// z: x^2, xy, xz, x, y^2, yz, y, z^2, z, 1 for order 2.
struct Polynomial {
    static constexpr int kMostOrder = 35;
    int order = 2;
    std::vector<double> coefficients{1, 0, 0, 0, 1, 0, 0, 1, 0, -1};

    /// How many coefficients a polynomial of this order has.
    static constexpr size_t terms(int order) { return size_t(order + 1) * size_t(order + 2) * size_t(order + 3) / 6; }
};

/// A flat face: the points of one plane that an odd number of loops surrounds. A loop ends where it began, without repeating the point.
/// It has no inside. Its normal is the one about which its first corner turns counter-clockwise.
struct Polygon {
    std::vector<std::vector<Vec3>> loops{{Vec3(0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)}};
};

/// A closed chain of quadratic Bezier curves: point 2 i is on the curve, point 2 i + 1 is the control point between it and the next one (after the last:
/// the first). A control point equal to the point before it makes a straight line.
struct Outline {
    std::vector<Vec2> points;
};

/// The solid above outlines in the plane z = 0, from z = `bottom` to z = `top`: a letter. Inside is what the outlines wind around, or, if `even_odd`, what an
/// odd number of them surrounds.
struct Extrusion {
    std::vector<Outline> outlines{{{Vec2(0, 0), Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1), Vec2(0, 1)}}};
    double bottom = 0, top = 1;
    bool even_odd = false;
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
    std::vector<uint32_t> corner_slots;     ///< empty, or 3 x triangles: the slots whose light is mixed over a triangle (POV-Ray's texture_list)
    std::vector<uint32_t> faces;            ///< the polygon of the file that each triangle came from; empty: itself
    Attribute<Vec3f> normals;               ///< absent: flat
    std::vector<Attribute<Vec2f>> uvs;      ///< one a texture coordinate set, v growing downwards (glTF's convention)
    Attribute<Vec4f> tangents;              ///< xyz and the sign of the bitangent
    std::vector<Attribute<Vec4f>> colors;   ///< linear RGBA
    std::vector<MorphTarget> morphs;
    std::vector<double> morph_weights;      ///< default weights, one a target
    std::vector<JointSet> joint_sets;       ///< linear blend skinning, where a node has a skin
    std::optional<Vec3> inside_vector;      ///< in set operations, a point is inside if a line from it this way crosses an odd number of triangles (POV-Ray); absent: nothing is
};

using ShapeGeometry = std::variant<Sphere, Plane, Box, Disc, Cylinder, Cone, Torus, Quadric, Polynomial, Polygon, Extrusion, Mesh>;

struct ShapeEntry {
    std::string name;
    ShapeGeometry geometry;
    SourcePos from;
};

/// The box of a shape in its own space: infinite where the shape is, empty for a mesh without triangles. It holds every point of the shape.
Bounds bounds(const ShapeGeometry& geometry);

/// The unit normal of a polygon, or 0 if all points of each loop are on a line.
Vec3 normal_of(const Polygon& polygon);

/// A shape with more material slots is refused by validate().
inline constexpr uint32_t kMostSlots = 1 << 24;

/// How many material slots a shape has (at least 1).
uint32_t slot_count(const ShapeGeometry& geometry);

}  // namespace alidade
