// SPDX-License-Identifier: Apache-2.0
/// The boxes of objects, much as POV-Ray has them: they decide what is seen of surfaces that coincide, and those of solids whether a camera is in one (probed).
#pragma once

#include "tracer/compiled_scene.h"

namespace alidade {

/// Numbers the objects that paths lead to, which come in the order of visit_paths() or of the parts of a solid: all that is below a set operation or a union that is a whole is one.
class ObjectNumbers {
  public:
    explicit ObjectNumbers(const Scene& scene) : scene_(scene) {}
    /// 0 where nobody asks.
    uint32_t number_of(const std::vector<NodeId>& path);

  private:
    const Scene& scene_;
    std::vector<NodeId> last_;     ///< the path to the last object
    uint32_t number_ = 0;
};

/// Of the surfaces of a solid. Of an intersection those parts count that are nothing far away, or all if there are none.
Bounds box_of_surfaces(const CompiledScene& scene, const Solid& solid);

/// By Instance::object: of all that is one object, in single precision. Without an end: all of space.
std::vector<Bounds> object_boxes(const CompiledScene& scene);

/// Where a ray comes into the box of an object, in t; before all others without an end.
double entry_of(const Ray& ray, const Bounds& box);

}  // namespace alidade
