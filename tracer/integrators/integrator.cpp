// SPDX-License-Identifier: Apache-2.0
#include "tracer/integrators/direct_light.h"
#include "tracer/pov_sky.h"
#include "tracer/segment.h"

namespace alidade {

/// Filters are multiplied in the order of hits, so the product is the same, bit for bit, whatever structure found them.
/// What is opaque is asked for first: it needs no list of hits.
Color filtered_light(Tracing& tracing, Ray ray, const InteriorStack& start, Occluders* among) {
    const auto& scene = tracing.scene;
    WorkCounters& work = tracing.stats.work;
    ray.mask = kMaskOpaque;
    if (among ? among->occluded(scene, ray, work) : scene.top->occluded(ray, work)) return Color(0);
    ray.mask = kMaskFilter;
    tracing.passed.clear();
    if (among) among->all_hits(scene, ray, tracing.passed, work);
    else scene.filters->all_hits(ray, tracing.passed, work);
    InteriorStack inside = start;
    Color through(1);
    double t = 0;
    for (const Hit& hit : tracing.passed) {
        const ShadePoint p = shade_point(tracing.scene, ray, hit);
        through *= transmitted(tracing.scene, p, ray.dir);
        if (is_black(through)) return Color(0);
        through *= transmittance(tracing.scene, inside, hit.t - t);
        const double before = t;
        t = hit.t;
        const uint32_t interior = slot_at(tracing.scene, p).interior;
        if (interior == kNoId) continue;
        const uint32_t carrier = tracing.scene.instances[p.instance].carrier;
        const Interior& body = tracing.scene.interiors[interior];
        // As POV-Ray has it, where a shadow ray meets a body that it is in it leaves it, whichever way the surface looks; else it enters it.
        const bool by_turns = !std::isfinite(body.attenuation_distance);
        if ((by_turns || !p.front) && inside.leave(carrier)) {
            if (body.fade_power > 0) through *= pov_fade(body, hit.t - before);
        } else if (by_turns || p.front) inside.enter({carrier, interior});
    }
    return std::isfinite(ray.tmax) ? through * transmittance(tracing.scene, inside, ray.tmax - t) : through;
}

Color sky_seen(const Tracing& tracing, const Vec3& direction, const RayState& state, FirstHit& first) {
    if (!tracing.alpha || tracing.scene.sky->lights()) return tracing.scene.sky->radiance(direction);
    const SkyOver sky = pov_sky_over(tracing.scene, direction, state.mirrored);
    if (!state.mirrored) first.shows += state.shows * sky.shows;
    return sky.color;
}

void describe(const ShadePoint& point, const Surface& surface, double depth, FirstHit& first) {
    first.hit = true;
    first.depth = depth;
    first.normal = surface.normal_towards_eye();
    first.albedo = surface.albedo();
    first.uv = point.uv(0);
    first.instance = point.instance;
    first.slot = point.slot;
}

std::span<const Integrator> integrator_table() {
    static const Integrator table[] = {cast_integrator(), whitted_integrator()};
    return table;
}

std::span<const IntegratorEntry> integrators() {
    static const std::vector<IntegratorEntry> rows = [] {
        std::vector<IntegratorEntry> out;
        for (const Integrator& i : integrator_table()) out.push_back(i.entry);
        return out;
    }();
    return rows;
}

}  // namespace alidade
