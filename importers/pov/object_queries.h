// SPDX-License-Identifier: Apache-2.0
/// What a scene asks of its objects while it is read: trace(), inside(), min_extent(), max_extent().
#pragma once

#include "eval/solid_query.h"
#include "importers/pov/parser.h"

namespace alidade::pov {

/// What trace() finds: both 0 where it meets nothing.
struct Traced {
    Vec3 point{0}, normal{0};
};

/// Builds the objects that are asked for into a scene of their own, each once as long as there is room, and asks eval/. `object` is a declared object's block.
class ObjectQueries {
  public:
    explicit ObjectQueries(Parser& p);
    ~ObjectQueries();

    /// The first surface on the way from `origin` along `dir`, farther than 1e-4 and nearer than 1e7 away, as in POV-Ray.
    Traced trace(const Value& object, const Vec3& origin, const Vec3& dir, Place at);
    /// Fails for objects that have no inside: triangles, meshes, lights, and what is made of them.
    bool inside(const Value& object, const Vec3& point, Place at);
    Bounds extent(const Value& object);

  private:
    struct Known;
    struct Stage;
    Known& known(const Value& object);
    const SolidQuery& solid(const Value& object, Place at);
    template <class Ask> auto asked(const Ask& ask);

    Parser& p_;
    std::unique_ptr<Stage> stage_;
};

}  // namespace alidade::pov
