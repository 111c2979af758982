// SPDX-License-Identifier: Apache-2.0
/// The rays that accelerators are measured with.
#pragma once

#include "core/ray.h"
#include "stress/scene.h"

#include <string>

namespace alidade {

/// What a tracer converts to its own; made from floats, so that no ray tracer rounds them.
struct StressRay {
    Vec3 origin, dir;
    double tmin = 0, tmax = kInf;

    Ray ray() const {
        Ray out;
        out.origin = origin, out.dir = dir, out.tmin = tmin, out.tmax = tmax;
        return out;
    }
};

enum class Question { closest, any };

/// Rays of one kind, and what is asked of each.
struct RaySet {
    std::string name;
    Question question = Question::closest;
    std::vector<StressRay> rays;
};

/// side x side rays of the scene's camera, line by line.
std::vector<StressRay> camera_rays(const StressScene& scene, size_t side);

/// Four sets: "primary", the given ones; from what they hit, in their order, "shadow" to one of the lamps (any hit; t = 1 is a lamp that is not far) and
/// "diffuse" by the cosine about the normal; "random", as many as primary ones: from anywhere in the scene's box through anywhere else.
/// `accelerator` stands over the scene: over its places, where it has some.
std::vector<RaySet> make_ray_sets(const StressScene& scene, const Accelerator& accelerator, std::vector<StressRay> primary, uint64_t seed);

}  // namespace alidade
