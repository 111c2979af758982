// SPDX-License-Identifier: Apache-2.0
/// Ray casting (Appel 1968, without his shadow rays): the first surface, lit by every light as if nothing stood between.
#include "tracer/integrators/direct_light.h"

namespace alidade {
namespace {

template <unsigned F> struct Cast {
    static Color radiance(Tracing& tracing, const Ray& ray, RayState& state, FirstHit& first) {
        const CompiledScene& scene = tracing.scene;
        Color sum(0);
        double through = 1;   // of alpha
        Ray next = ray;
        for (;;) {
            Hit hit;
            if (!scene.top->intersect(next, hit, tracing.stats.work)) break;
            const ShadePoint point = shade_point(scene, next, hit);
            const Surface surface = shade<F>(scene, point, ray.dir, state.inside);
            if (tracing.describes && surface.coverage() > 0 && !first.hit) describe(point, surface, length(point.position - ray.origin), first);
            sum += local_light<F>(tracing, point, surface, state, Shadows::ignored) * through;
            through *= 1 - surface.coverage();
            if ((F & kAlpha) == 0 || through < tracing.bailout || through <= 0) break;
            next = spawn_ray(point, ray.dir);
            next.mask = ray.mask;
        }
        first.coverage = 1 - through, state.shows = through;
        return sum + sky_seen(tracing, ray.dir, state, first) * through;
    }
};

}  // namespace

Integrator cast_integrator() { return {{"cast", "the first surface, lit without shadows or reflections"}, kernels<Cast>(EveryMask())}; }

}  // namespace alidade
