// SPDX-License-Identifier: Apache-2.0
/// POV-Ray's projected_through: light that comes from an object's surface alone.
#pragma once

#include "eval/solid_query.h"

namespace alidade {

/// The object that a light is projected through, in world space.
class Projector {
  public:
    /// `placed` leads from the object's node to the world. The scene must outlive it.
    Projector(const Scene& scene, NodeId object, const Transform& placed) : meshes_(scene), query_(scene, object, meshes_, placed) {}

    /// Where the way to the light ends that begins with `ray`, a unit vector's: at the object's first surface, behind which nothing hides the light. Nothing where the
    /// ray meets none before it ends: there the light does not come.
    /// Source   POV-Ray 3.7 reference, 3.4.4.5 "Projected Through"; verified by probing.
    std::optional<double> reach(const Ray& ray) const {
        const auto met = query_.first(ray);
        return met ? std::optional(met->t) : std::nullopt;
    }
    /// SolidQuery::complete.
    bool complete() const { return query_.complete(); }

  private:
    MeshAccelerators meshes_;
    SolidQuery query_;
};

}  // namespace alidade
