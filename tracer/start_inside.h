// SPDX-License-Identifier: Apache-2.0
/// What a camera's rays are in when they begin: it is left where they come to its surface, and what is not hollow keeps fog out.
#pragma once

#include "tracer/box_tree.h"
#include "tracer/compiled_scene.h"
#include "tracer/interior_stack.h"

#include <optional>

namespace alidade {

/// The bodies that hold the origin of a camera's ray, in the order of the scene. By experiment: POV-Ray counts those that a camera does not see, too;
/// each part of a union by itself; a solid, or a union that is one object, if the operation has an interior, not if its parts alone have; and none outside of the box of its surface, or of that
/// of what bounds it.
class StartInside {
  public:
    StartInside(const CompiledScene& scene, const Camera& camera);
    /// Is no ray of the camera in anything?
    bool empty() const { return bodies_.empty(); }
    InteriorStack at(const Vec3& origin) const;

  private:
    struct Body {
        uint32_t id = 0;              ///< of an instance, or behind all of them in number a solid
        Bounds bounds;                ///< of its surface
        InteriorStack::Entry entry;
    };
    bool holds(const Body& body, const Vec3& point) const;

    const CompiledScene& scene_;
    std::vector<Body> bodies_;        ///< those that may hold the origin of a ray
    BoxTree tree_;                    ///< of their bounds: orthographic cameras begin each ray elsewhere
    std::optional<Vec3> fixed_;       ///< where all rays begin, if that is one place
    InteriorStack there_;
};

}  // namespace alidade
