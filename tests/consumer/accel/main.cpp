// SPDX-License-Identifier: Apache-2.0
/// The accelerators alone, over a plain triangle array: every structure of the table finds the same hit.
#include "accel/accelerator.h"

#include <cstdio>

using namespace alidade;

/// A unit square at z = -2, in two triangles, and a ray that meets the second.
int main() {
    const Vec3f positions[] = {Vec3f(0, 0, -2), Vec3f(1, 0, -2), Vec3f(1, 1, -2), Vec3f(0, 1, -2)};
    const Index3 triangles[] = {Index3(0, 1, 2), Index3(0, 2, 3)};
    Ray ray;
    ray.origin = Vec3(0.25, 0.5, 1);
    ray.dir = Vec3(0, 0, -1);

    int wrong = 0;
    for (const AcceleratorEntry& entry : accelerators()) {
        const auto structure = entry.over_triangles({positions, {}, triangles}, {});
        Hit hit;
        WorkCounters work;
        const bool found = structure->intersect(ray, hit, work);
        std::printf("%-8s t %g, triangle %u, (u, v) = (%g, %g), %llu triangles looked at\n", entry.name, hit.t, hit.primitive, double(hit.u), double(hit.v),
                    static_cast<unsigned long long>(work.filtered));
        wrong += !found || hit.t != 3 || hit.primitive != 1 || hit.u != 0.25f || hit.v != 0.25f;
    }
    return wrong;
}
