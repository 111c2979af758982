// SPDX-License-Identifier: Apache-2.0
/// Recursive ray tracing: light from every light that is seen, mirror and refracted rays to a depth limit.
/// Source   Whitted, "An Improved Illumination Model for Shaded Display", CACM 23(6), 1980.
#include "tracer/integrators/direct_light.h"
#include "tracer/segment.h"

namespace alidade {
namespace {

Mask mask_of(RayKind kind) {
    switch (kind) {
        case RayKind::reflection: return kMaskReflection;
        case RayKind::refraction: return kMaskRefraction;
        case RayKind::shadow: return kMaskShadow;
        case RayKind::camera: break;
    }
    return kMaskCamera;
}

template <unsigned F> struct Whitted {
    Tracing& tracing;
    FirstHit& first;
    double length_so_far = 0;   // of the camera ray and its straight continuations through alpha

    static Color radiance(Tracing& tracing, const Ray& ray, const RayState& state, FirstHit& first) { return Whitted{tracing, first}.trace(ray, state); }

    /// Goes on straight through alpha, however many layers; mirrors and glass are followed by new rays.
    Color trace(const Ray& start, const RayState& state) {
        Color sum(0), through(1);
        Ray ray = start;
        for (;;) {
            Hit hit;
            if (!tracing.scene.top->intersect(ray, hit, tracing.stats.work)) return sum + through * tracing.scene.sky->radiance(normalized(ray.dir));
            const ShadePoint point = shade_point(tracing.scene, ray, hit);
            const Surface surface = shade<F>(tracing.scene, point, normalized(ray.dir));
            const double distance = hit.t * length(ray.dir);
            through *= transmittance(tracing.scene, state.inside, distance);
            if (state.kind == RayKind::camera) see(point, surface, distance);
            sum += through * shaded(point, surface, state, through);
            if constexpr ((F & kAlpha) == 0) return sum;
            through *= 1 - surface.coverage();
            if (max_component(state.weight * through) < tracing.bailout || is_black(through)) return sum;
            ray = spawn_ray(point, start.dir);
            ray.mask = start.mask;
            ray.time = start.time;
        }
    }

    /// What the surface sends back along the ray, of which `through` will arrive where the ray started.
    Color shaded(const ShadePoint& point, const Surface& surface, const RayState& state, const Color& through) {
        Color light = local_light<F>(tracing, point, surface, state, Shadows::cast);
        if constexpr ((F & (kTransmission | kMirrors)) != 0) {
            RayState here = state;
            here.weight = state.weight * through;
            light += follow(point, surface.secondary(tracing.scene, here), here);
        }
        return light;
    }

    /// A surface on the camera ray itself.
    void see(const ShadePoint& point, const Surface& surface, double distance) {
        length_so_far += distance;
        if (surface.coverage() > 0 && !first.hit) describe(point, surface, length_so_far, first);
        first.coverage += (1 - first.coverage) * surface.coverage();
    }

    Color follow(const ShadePoint& point, const Secondaries& secondaries, const RayState& state) {
        Color sum(0);
        for (int i = 0; i < secondaries.count; ++i) {
            const Secondary& s = secondaries.at[i];
            RayState next = state;
            next.weight = state.weight * s.weight;
            if (max_component(next.weight) < tracing.bailout || state.depth >= tracing.max_depth) continue;
            next.inside = s.inside;
            next.kind = s.kind;
            next.depth = state.depth + 1;
            next.key = state.key.child(uint64_t(i));
            Ray ray = spawn_ray(point, s.dir);
            ray.mask = mask_of(s.kind);
            ray.time = state.time;
            ++tracing.stats.secondary_rays;
            sum += s.weight * trace(ray, next);
        }
        return sum;
    }
};

}  // namespace

Integrator whitted_integrator() { return {{"whitted", "shadows, mirrors and glass to a depth limit"}, kernels<Whitted>(EveryMask())}; }

}  // namespace alidade
