// SPDX-License-Identifier: Apache-2.0
/// What accelerator benchmarks have in common: meshes, rays, and the rows of another ray tracer.
#pragma once

#include "tests/accel/rays.h"

#include <memory>
#include <vector>

namespace alidade::bench {

/// A mesh in float precision and rays around it: every second one is aimed at a triangle, the others at nothing.
struct Workload {
    test::Mesh mesh;
    std::vector<Ray> rays;
};

std::shared_ptr<const Workload> make_workload(const test::Mesh& mesh);

/// Adds the same rows for Embree 3, where this was built with it. It hits the same triangles except near edges, where its default mode leaks.
void register_embree_rows(const std::shared_ptr<const Workload>& workload);

}  // namespace alidade::bench
