// SPDX-License-Identifier: Apache-2.0
/// Whitted's ray tracing: light from every light that is seen, mirror and refracted rays to a depth limit.
/// Source   Whitted, "An Improved Illumination Model for Shaded Display", CACM 23(6), 1980.
#include "tracer/integrators/direct_light.h"
#include "tracer/pov_sky.h"
#include "tracer/segment.h"

namespace alidade {
namespace {

/// What a secondary ray meets. What is passed changes nothing: behind glass no_image hides as before it, and no_reflection what mirrors show (by experiment).
Mask mask_of(const RayState& state) { return state.mirrored ? kMaskReflection : kMaskCamera; }

// Out of line: scenes without fog or rainbow pay for a comparison alone.
[[gnu::noinline]] void pass_haze(Tracing& tracing, const Ray& ray, double distance, RayState& state, Color& sum) {
    const Haze on_the_way = haze(tracing.scene, ray.origin, normalized(ray.dir), distance);
    sum += state.weight * on_the_way.added;
    state.weight *= on_the_way.kept, state.shows *= on_the_way.shows;
}

/// Rays that are still to be followed wait in a list, not on the call stack: no depth limit that a scene asks for can overflow it. Each knows the part
/// of its light that arrives at the eye (RayState::weight), so the order in which they are followed does not matter.
template <unsigned F> struct Whitted {
    static constexpr bool kFollows = (F & (kTransmission | kMirrors)) != 0;   // else a camera ray is all there is

    Tracing& tracing;
    FirstHit& first;
    Color sum{0};
    double length_so_far = 0;   // of the camera ray and its straight continuations through alpha

    static Color radiance(Tracing& tracing, const Ray& ray, RayState& state, FirstHit& first) {
        if (!tracing.around.empty()) state.inside = tracing.around.at(ray.origin);
        Whitted whitted{tracing, first};
        whitted.trace(ray, state);
        if constexpr (kFollows) {
            if (!tracing.pending.empty()) whitted.follow_all(0);
        }
        return whitted.sum;
    }

    /// Out of line: a ray that nothing follows pays for a comparison alone. `others` wait for somebody else.
    [[gnu::noinline]] void follow_all(size_t others) {
        while (tracing.pending.size() != others) {
            PendingRay next = tracing.pending.back();
            tracing.pending.pop_back();
            if (next.exponent == 1) trace(next.ray, next.state);
            else add_power(next);
        }
    }

    /// What arrives along the ray and all that follow from it, to the power of the reflection.
    [[gnu::noinline]] void add_power(const PendingRay& reflected) {
        Whitted whitted{tracing, first};
        const size_t others = tracing.pending.size();
        tracing.pending.emplace_back(reflected.ray, reflected.state);
        tracing.pending.back().state.weight = Color(1);
        whitted.follow_all(others);
        sum += reflected.state.weight * glm::pow(glm::max(whitted.sum, Color(0)), Color(reflected.exponent));
    }

    /// Goes on straight through alpha, however many layers; mirrors and glass are followed by new rays. Inline: camera rays have a copy of their own, as if nothing could follow.
    [[gnu::always_inline]] inline void trace(const Ray& start, RayState& state) {
        Ray ray = start;
        for (;;) {
            Hit hit;
            const bool found = tracing.scene.top->intersect(ray, hit, tracing.stats.work);
            if (tracing.scene.scene.atmosphere.is_hazy() && fog_reaches(tracing.scene, state.inside)) pass_haze(tracing, ray, found ? hit.t * length(ray.dir) : kInf, state, sum);
            if (!found) {
                sum += state.weight * sky_seen(tracing, normalized(ray.dir), state, first);
                return;
            }
            const ShadePoint point = shade_point(tracing.scene, ray, hit);
            const double distance = hit.t * length(ray.dir);
            const Surface surface = shade<F>(tracing.scene, point, normalized(ray.dir), state.inside);
            state.travelled = distance;
            state.weight *= transmittance(tracing.scene, state.inside, distance);
            if (state.kind == RayKind::camera) see(point, surface, distance);
            sum += state.weight * local_light<F>(tracing, point, surface, state, Shadows::cast);
            if constexpr (kFollows) {
                if (surface.mirrors_or_refracts()) follow(tracing, point, surface, state);
            }
            if ((F & kAlpha) == 0 || surface.coverage() >= 1) return;
            state.weight *= 1 - surface.coverage(), state.shows *= 1 - surface.coverage();
            if (max_component(state.weight) < tracing.bailout || is_black(state.weight)) return;
            ray = spawn_ray(point, start.dir);
            ray.mask = start.mask;
            ray.time = start.time;
        }
    }

    /// A surface on the camera ray itself.
    void see(const ShadePoint& point, const Surface& surface, double distance) {
        length_so_far += distance;
        if (tracing.describes && surface.coverage() > 0 && !first.hit) describe(point, surface, length_so_far, first);
        first.coverage += (1 - first.coverage) * surface.coverage();
    }

    // Out of line, and without the sum that trace() keeps in registers: what nothing follows from pays for a comparison alone.
    [[gnu::noinline]] static void follow(Tracing& tracing, const ShadePoint& point, const Surface& surface, const RayState& state) {
        if (tracing.stopped()) return;   // those that wait are followed; there could come millions more
        Secondaries& secondaries = tracing.secondaries;
        secondaries.clear();
        surface.secondary(tracing.scene, state, secondaries);
        for (size_t i = secondaries.size(); i-- > 0;) {   // the first is followed first
            const Secondary& s = secondaries[i];
            const Color weight = state.weight * s.weight;
            const double importance = s.importance < 0 ? max_component(weight) : state.importance * s.importance;
            if (importance < tracing.bailout || is_black(weight) || state.depth >= tracing.max_depth) continue;
            PendingRay& pending = tracing.pending.emplace_back(spawn_ray(point, s.dir), state, s.exponent);
            RayState& next = pending.state;
            next.weight = weight, next.importance = importance;
            next.shows = state.shows * s.shows, next.mirrored = state.mirrored || s.kind == RayKind::reflection;
            next.inside = s.inside;
            next.kind = s.kind;
            next.depth = state.depth + (s.straight ? 0 : 1);
            next.key = state.key.child(uint64_t(i));
            pending.ray.mask = mask_of(next);
            pending.ray.time = state.time;
            ++tracing.stats.secondary_rays;
        }
    }
};

}  // namespace

Integrator whitted_integrator() { return {{"whitted", "shadows, mirrors and glass to a depth limit"}, kernels<Whitted>(EveryMask())}; }

}  // namespace alidade
