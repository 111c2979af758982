// SPDX-License-Identifier: Apache-2.0
/// What a camera's rays are in when they begin: it is left where they come to its surface, and what is not hollow keeps fog out.
#pragma once

#include "tracer/box_tree.h"
#include "tracer/compiled_scene.h"
#include "tracer/interior_stack.h"

#include <optional>

namespace alidade {

/// The bodies that hold the origin of a camera's ray, in the order of the scene. By experiment: POV-Ray counts those that a camera does not see, too;
/// each part of a union by itself; a solid, or a union that is one object, as one body in the interior of the whole, given or not: if all parts have interiors of their own, no surface
/// leads out of it; and none outside of the box of its surface, or of that of what bounds it.
class StartInside {
  public:
    StartInside(const CompiledScene& scene, const Camera& camera);
    /// Is no ray of the camera in anything?
    bool empty() const { return bodies_.empty(); }
    InteriorStack at(const Vec3& origin) const;

  private:
    struct Body {
        std::vector<uint32_t> parts;  ///< instances, and behind all of them in number solids: what is in one of them is in it
        Bounds bounds;                ///< of its surface
        InteriorStack::Entry entry;
    };
    void add_objects(const Bounds& begin);
    /// The interior of the whole object, if this part has that one.
    std::optional<InteriorStack::Entry> filling(const Instance& part) const;
    std::optional<InteriorStack::Entry> filling(uint32_t object) const;
    bool holds(const Body& body, const Vec3& point) const;
    bool holds(uint32_t part, const Vec3& point) const;

    const CompiledScene& scene_;
    std::vector<Body> bodies_;        ///< those that may hold the origin of a ray
    BoxTree tree_;                    ///< of their bounds: orthographic cameras begin each ray elsewhere
    std::optional<Vec3> fixed_;       ///< where all rays begin, if that is one place
    InteriorStack there_;
};

}  // namespace alidade
