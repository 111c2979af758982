// SPDX-License-Identifier: Apache-2.0
/// From nodes of the scene graph to a CsgExpression.
#pragma once

#include "eval/csg.h"
#include "scene/queries.h"

#include <optional>

namespace alidade {

/// Is the node with all below it one solid? A union is its parts; but turned inside out or clipped, it is more than they.
bool is_solid(const Node& node);

/// Shadow rays that ask for what stops all light, and for what lets a part of it through: who knows what things are made of clears one bit or the other.
inline constexpr Mask kMaskOpaque = 16, kMaskFilter = 32;

/// The rays that see what has these flags.
Mask mask_of(const NodeFlags& flags);

/// Of a node that places, inverts, clips or covers one thing alone, that thing.
std::optional<NodeId> lone_part(const Node& node);
/// A shape that stands alone, neither inverse nor clipped nor bounded.
struct LoneShape {
    const ShapeGeometry* shape = nullptr;      ///< null: there is more
    Transform to_space;                        ///< to the parent of the node
};
LoneShape lone_shape(const Scene& scene, NodeId id);

/// The rays that see what is at the end of a path through the scene, by the flags of all on it, and of what it places alone: in POV-Ray an object that is placed or clipped once more is the same object, with the flags
/// that it had. A union that is clipped or `whole` is one object, whose parts' flags count for reflections alone.
Mask mask_of_path(const Scene& scene, std::vector<NodeId> path);

/// Who makes leaves of the shapes of a solid.
class CsgParts {
  public:
    virtual ~CsgParts() = default;
    /// Asked at each node before anything else; if not, it is left out with all that it leads to.
    virtual bool enters(const Visit& at) = 0;
    /// Places what stands at the node itself. The id of the leaf that its shape becomes, or kNoId where there is nothing that can be hit. `to_set`: from the node's space to that of the whole solid.
    virtual uint32_t place(const Visit& at, const Transform& to_set) = 0;
};

/// The node at the end of `at`, which is changed on the way and given back as it was, as a part of a solid. `seen`: the rays that see all above it.
/// Nothing if it has no shapes: lights may stand among the parts.
std::optional<CsgExpression> csg_expression(const Scene& scene, Visit& at, Mask seen, CsgParts& parts);

}  // namespace alidade
