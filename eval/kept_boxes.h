// SPDX-License-Identifier: Apache-2.0
/// The boxes that POV-Ray keeps of objects. They are not the smallest ones, and rays that miss the box of an object see nothing of it, also where something of it is outside.
#pragma once

#include "scene/scene.h"

#include <map>
#include <optional>
#include <vector>

namespace alidade {

/// The box of a shape along axes of its own, and where those are: round shapes lie along z.
struct FramedBox {
    Transform frame;
    Bounds box;
};
FramedBox framed_box(const ShapeGeometry& shape);

/// A sphere that was turned first and then scaled along the axes, of which POV-Ray keeps a small box.
struct TurnedSphere {
    Sphere sphere;
    Vec3 scale{1};
};
/// Nothing where `by` does anything else.
std::optional<TurnedSphere> turned(const Sphere& sphere, const Transform& by);

/// Cuts `box` where a plane along an axis bounds what is inside, or outside if that is meant (`inverse`).
void cut_by_plane(Bounds& box, const Plane& plane, const Transform& placed, bool inverse);

/// A box that is moved; all space if it has an end missing.
Bounds moved_box(const Transform& by, const Bounds& box);

/// The box `box` or, where its volume is smaller, the common box `limit` of what clips or bounds its object. By experiment: where those have none in common it is kept as it is, upside down. Along one axis or all
/// three its volume is below 0 then, smaller than any other; no ray meets it.
Bounds smaller_box(const Bounds& box, const Bounds& limit);

/// The boxes of nodes.
///
/// Method   as of importers/pov/builders/extents.h, but all transformations of a node are one. A sphere stays one until it is scaled unevenly, of other shapes the box is moved by all transformations at
///          once, of sets it is made in their own space and moved. What clips or bounds an object stands for its own box where its volume is smaller. Of an intersection it is the common part; of a quadric the part that it reaches in the boxes of
///          what clips it, cut by planes.
/// Source   experiments with POV-Ray 3.7
class KeptBoxes {
  public:
    /// The scene must outlive this, and the nodes may not change any more.
    explicit KeptBoxes(const Scene& scene) : scene_(scene) {}
    /// In the space that `to` leads to from the node's own. All space where there is no end; empty of a node without a shape.
    Bounds of(NodeId id, const Transform& to);
    /// Of an object that was finished in the space that `to` leads to, and was moved `by` something then: by a union that it is a part of and that is taken apart, or by an object that it limits.
    Bounds of_moved(NodeId id, const Transform& to, const Transform& by);

  private:
    /// A node and those below it down to a shape or a set, each of which is all that is in the one above.
    struct Chain {
        std::vector<std::pair<NodeId, Transform>> nodes;   ///< with the way from their own space
        bool inverse = false;                              ///< all in all
    };
    Chain chain(NodeId id, Transform to) const;
    Bounds own(const Chain& chain);
    Bounds own(const Chain& chain, const Quadric& quadric);
    bool may_ask();
    Bounds limited(const Chain& chain, Bounds box, std::vector<NodeId> Node::*limits);
    Bounds of_limit(NodeId id, const Transform& to);
    Transform written_at(NodeId clip) const;
    std::optional<std::pair<Plane, Transform>> plane_in(const Chain& chain) const;
    const Bounds& of_parts(NodeId set);
    Bounds joined(const Node& set);
    Bounds common(const Node& set);

    const Scene& scene_;
    std::map<uint32_t, Bounds> sets_;      ///< by node, in its own space
    uint64_t asked_ = 0;
};

/// By node: may POV-Ray's box of it leave out something of it? Where something bounds it, or it is a set or clipped and there are discs or bounds in that.
std::vector<bool> nodes_beyond_their_boxes(const Scene& scene);

}  // namespace alidade
