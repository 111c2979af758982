// SPDX-License-Identifier: Apache-2.0
/// Constructive solid geometry on one line: which crossings of the leaves are surfaces of the whole, and which are cut away.
#pragma once

#include "eval/half_spaces.h"
#include "eval/shapes/shape_ops.h"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace alidade {

enum class CsgOp : uint8_t {
    leaf,
    union_,         ///< all surfaces of the parts, also those inside of other parts
    merge,          ///< the same set, and only its outer surface
    intersection,
    difference,     ///< the first part without the others
    clip,           ///< the first part inside of the others, which show no surface of their own
};

/// How it is known where the line is inside of a leaf.
enum class CsgInside : uint8_t {
    by_crossings,   ///< by turns, from crossing to crossing
    at_points,      ///< asked at each crossing of the line with anything: leaves whose surface does not bound what is inside
    nowhere,        ///< a surface without inside, also turned inside out, as in POV-Ray: what it is taken from has no surface left
};
/// How it is known where the inside of a shape is; a mesh has no ops.
CsgInside csg_inside(const ShapeOps* ops, const ShapeGeometry& shape);
/// Is something inside beyond its bounds? Of a mesh that is not closed, too.
bool csg_endless(const ShapeGeometry& shape);

/// Leaves with equal ids are the same thing at several places.
struct CsgLeaf {
    uint32_t id = kNoId;
    CsgInside inside = CsgInside::nowhere;
    Bounds bounds;                  ///< of the surface and, unless that is endless, of what is inside
    uint8_t cost = 0;               ///< of siblings those that cost less are asked first, and others only if they leave the question open
    bool endless = false;           ///< is something inside beyond `bounds`? Of a disc, all that is behind its plane
};

/// What a file says: operations on parts, any of them turned inside out. Without parts an intersection is everything, every other operation nothing.
struct CsgExpression {
    CsgOp op = CsgOp::leaf;
    bool inverse = false;           ///< of a clip: turns the first part inside out, and not what clips it, as POV-Ray does
    CsgLeaf leaf;
    Mask mask = kMaskAll;           ///< the rays for which it is there at all
    bool cutaway_textures = false;  ///< of the node (Node::cutaway_textures)
    std::vector<CsgExpression> parts;
};

/// Is part `i` of the operation turned inside out if the operation is, or not, for all that stands around it and its own `inverse`?
inline bool turns_part(const CsgExpression& e, size_t i, bool inverse) {
    return e.op == CsgOp::clip ? inverse && i == 0 : inverse != (e.op == CsgOp::difference && i > 0);
}

/// A crossing of the line with a leaf.
struct CsgCrossing {
    Hit hit;
    uint32_t node = 0;              ///< filled in by the tree
};

/// Where all rays that are going to be asked are, if that is on one side of a surface.
enum class CsgSide : uint8_t { varies, inside, outside };

/// A part of space that rays stay in.
class CsgRegion {
  public:
    virtual ~CsgRegion() = default;
    /// False only if nothing of it is in the box.
    virtual bool meets(const Bounds& box) const = 0;
    /// On which side of the leaf, as it is without inversion, it is surely.
    virtual CsgSide side(uint32_t leaf) const = 0;
};

/// What a tree asks of its leaves; all in the space of the ray.
class CsgLeaves {
  public:
    virtual ~CsgLeaves() = default;
    /// Appends all crossings of the whole line with a leaf; those outside of the ray's interval may be anywhere on their side of it, or left out before it. True if the
    /// line is inside before the first (asked of leaves that are inside by crossings).
    virtual bool crossings(uint32_t leaf, const Ray& ray, std::vector<CsgCrossing>& out) const = 0;
    virtual bool inside(uint32_t leaf, const Vec3& point) const = 0;
    /// Does the ray see the surface of the leaf? Asked only of what CsgTree::find_bounded() found. What is inside stays, whoever sees it.
    virtual bool sees(uint32_t, const Ray&) const { return true; }
    /// How far the true surface may be from the hit, along its normal, and the cosine of the angle between that and the ray, without its sign. Asked only
    /// where crossings are near each other.
    struct Sharpness {
        double error, cosine;
    };
    virtual Sharpness sharpness(const Ray& ray, const Hit& hit) const = 0;
};

/// A box around what is inside of a leaf, turned inside out or not, within a box whose sides may be infinite.
using CsgNarrow = std::function<Bounds(uint32_t leaf, bool inverted, const Bounds& box)>;
/// What a leaf fills if it is half of space.
using CsgHalfSpaces = std::function<std::optional<HalfSpace>(uint32_t leaf)>;

/// The space of the set itself. Turned in the space of the rays, its endless parts have no boxes there that others could bring in, but may stand along the axes here.
struct CsgOwnSpace {
    CsgNarrow narrow;
    std::function<Bounds(const Bounds&)> placed;   ///< around all of the set that is in a box, in the space of the rays
    CsgNarrow by_sides;                            ///< by planes across the axes alone, the only endless things that have a box in POV-Ray
};

/// Where a node is more than all inside or all outside.
enum class CsgExtent : uint8_t { nowhere, in_box, everywhere };

/// A node with its subtree behind it.
struct CsgNode {
    CsgOp op = CsgOp::leaf;         ///< never difference
    CsgInside inside = CsgInside::nowhere;
    bool inverted = false;          ///< leaves alone
    bool far = false;               ///< is it inside everywhere outside of `box`?
    bool bounded = false;           ///< leaves alone: some rays do not see its surface (CsgLeaves::sees)
    CsgExtent extent = CsgExtent::in_box;   ///< what `box` says, at a glance
    uint32_t leaf = kNoId;
    uint32_t parent = 0, place = 0; ///< the number among its siblings, which need not stand in that order
    uint32_t end = 0;               ///< the first node behind the subtree
    uint32_t children = 0;
    uint32_t rank = 0;              ///< leaves alone: where surfaces coincide, the one of the highest is seen
    Mask mask = kMaskAll;
    Bounds box;                     ///< outside of it the node has no surface, and is all inside or all outside
};

/// An expression made ready for rays. Inversion stands at leaves alone (the inverse of a union is the intersection of the inverses, that of an
/// intersection the merge of the inverses), operations in an equal operation are one, and many parts are sorted by place, so that a line meets few of them.
///
/// What is a surface of the whole is decided by the sides: a crossing of a part of an intersection stays if all other parts are inside on the side on
/// which the part is; of a merge, if all others are outside on the side on which it is outside. Crossings within their error bounds of each other are
/// one place: so A - A is nothing, A * A is A, and where faces coincide there is one of them. Which one, a ray learns as in POV-Ray (probed): there a set
/// makes a list of hits, part after part, an intersection or difference that of each part from its end, and of equal ones the last is seen.
class CsgTree {
  public:
    /// `narrow` gives boxes to intersections of endless parts, asked of leaves that are inside by crossings; `own` to those that it finds no end of; where the whole has
    /// none by that, planes are asked for the corners between them.
    explicit CsgTree(const CsgExpression& expression, const CsgNarrow& narrow = nullptr, const CsgOwnSpace& own = {}, const CsgHalfSpaces& half_spaces = nullptr);

    std::span<const CsgNode> nodes() const { return nodes_; }
    /// How many nodes stand in one another.
    uint32_t levels() const;
    /// Leaves for which `bounded` is true are asked which rays see them.
    void find_bounded(const std::function<bool(uint32_t leaf)>& bounded);
    /// Of the surfaces, also where what is inside has no end. Infinite where they are.
    const Bounds& bounds() const { return bounds_; }
    /// The same without what corners tell: POV-Ray's box has no end there.
    const Bounds& bounds_by_sides() const { return bounds_by_sides_; }
    /// Appends the sides of the nodes in a region, one for each of nodes(), to be given to first(). The side of the root: if it does not vary, rays in the region meet no surface.
    CsgSide sides(const CsgRegion& region, std::vector<CsgSide>& out) const;
    /// The first surface with tmin <= t <= tmax that the ray's mask sees; of several at one place the one of the highest rank. In bounds(), as inside_bounds() has it. `known`: the sides that the nodes have where the ray goes, or nothing.
    bool first(const Ray& ray, const CsgLeaves& leaves, Hit& hit, std::span<const CsgSide> known = {}) const;
    /// All of them, appended in order of t.
    void all(const Ray& ray, const CsgLeaves& leaves, std::vector<Hit>& hits) const;
    /// Is the point inside of the whole? A surface without inside holds none.
    bool inside(const Vec3& point, const CsgLeaves& leaves) const;
    /// The same, also where the whole is clipped away.
    bool inside_unclipped(const Vec3& point, const CsgLeaves& leaves) const;

  private:
    std::vector<CsgNode> nodes_;    ///< each before its subtree
    Bounds bounds_, bounds_by_sides_;
};

/// What a leaf of that shape costs: a plane nearly nothing, most others some, roots of polynomials of a high order much.
uint8_t csg_cost(const ShapeOps& ops);
inline constexpr uint8_t kCsgCostOfMesh = 2;

/// Does the line of `ray` come from inside of a solid? `crossings` are all of its crossings with it.
bool begins_inside(const ShapeOps& ops, const ShapeGeometry& shape, const Ray& ray, const Crossings& crossings);

}  // namespace alidade
