// SPDX-License-Identifier: Apache-2.0
#include "accel/local_ray.h"
#include "core/clamp.h"
#include "tracer/instance_set.h"
#include "tracer/integrators/direct_light.h"
#include "tracer/pov_sky.h"
#include "tracer/segment.h"

namespace alidade {

namespace {

/// Leaves of the hits on filters those that count (RenderSettings::shadow_clearance); of those in one place the one that is seen.
void keep_apart(const CompiledScene& scene, const Ray& ray, std::vector<Hit>& hits) {
    const double clearance = scene.scene.settings.shadow_clearance;
    size_t kept = 0;
    for (const Hit& hit : hits) {
        if (kept && hit.t == hits[kept - 1].t && scene.set->is_seen_before(ray, hit.t, hit.instance, hit.primitive, hits[kept - 1])) hits[kept - 1] = hit;
        if (kept && hit.t < hits[kept - 1].t + clearance) continue;
        hits[kept++] = hit;
    }
    hits.resize(kept);
}

/// Is a filter so near before the opaque surface that the ray meets at t that it may keep it from counting?
bool filter_is_near(const CompiledScene& scene, Ray ray, double t, WorkCounters& work) {
    const double clearance = scene.scene.settings.shadow_clearance, reach = clearance * length(ray.dir) + 0x1p-40 * (max_abs(ray.origin) + std::abs(t) * max_abs(ray.dir));   // the second: roundings
    const Vec3 at = ray.at(t);
    const Bounds& box = scene.filter_bounds;
    for (int a = 0; a < 3; ++a)
        if (at[a] < box.min[a] - reach || at[a] > box.max[a] + reach) return false;
    ray.mask = kMaskFilter;
    ray.tmin = std::max(ray.tmin, t - clearance), ray.tmax = t;
    return scene.filters->occluded(ray, work);
}

/// What a ray that asks for opaque things alone need look at.
const Accelerator& opaque_things(const CompiledScene& scene) { return scene.opaques ? *scene.opaques : *scene.top; }

/// May a filter keep the nearest opaque surface from counting? Rays that meet one seldom meet filters, and hardly ever one so close before it.
bool in_a_clearance(Tracing& tracing, Ray ray, Occluders& among) {
    const CompiledScene& scene = tracing.scene;
    WorkCounters& work = tracing.stats.work;
    ray.mask = kMaskFilter;
    if (!among.occluded(scene, ray, work)) return false;
    ray.mask = kMaskOpaque;
    Hit opaque;
    return !opaque_things(scene).intersect(ray, opaque, work) || filter_is_near(scene, ray, opaque.t, work);
}

/// Goes from hit to hit that counts, for rays that meet something opaque in the clearance behind a filter. False where an opaque one counts.
bool surface_by_surface(const CompiledScene& scene, Ray ray, std::vector<Hit>& hits, WorkCounters& work) {
    ray.mask = kMaskOpaque | kMaskFilter;
    for (Hit hit; scene.top->intersect(ray, hit, work); hit = Hit()) {
        const bool advances = hits.empty() || hit.t > hits.back().t;   // so far away the clearance may be lost in rounding
        if (!advances || (scene.instances[hit.instance].mask & kMaskOpaque)) return false;
        hits.push_back(hit);
        ray.tmin = hit.t + scene.scene.settings.shadow_clearance;
    }
    return true;
}

/// That which hid the light from a ray before is forgotten once it has missed so many: to ask it costs a quarter of what is saved where it hides the light again.
constexpr int kMostMisses = 4;
/// To learn what hides a ray costs as much as to find that it is hidden.
constexpr int kLongestPause = 63;

/// Does the ray pass through the box?
bool enters(const Ray& ray, const Bounds& box) {
    const LineInterval in_box = inside_bounds(ray, box);
    return !in_box.empty() && in_box.exit >= ray.tmin && in_box.entry <= ray.tmax;
}

/// Does what hid the light before end the ray, with no filter near before it?
bool hides_again(const CompiledScene& scene, const Ray& ray, LastHider& last, WorkCounters& work) {
    if (last.id == kNoId || !can_hit(ray, kLargestCoordinate<double>)) return false;
    Hit hit;
    ++work.filtered;
    if (enters(ray, scene.set->bounds(last.id)) && scene.set->intersect(std::span(&last.id, 1), ray, hit, work) && !filter_is_near(scene, ray, hit.t, work)) return last.missed = last.pause = 0, true;
    if (++last.missed < kMostMisses) return false;
    last.id = kNoId;
    last.left = last.pause = std::min(2 * last.pause + 1, kLongestPause);
    return false;
}

/// Does an opaque surface that no filter is near before end the ray? `near`: else, is there one that a filter is near before? Then no other was looked for.
bool is_hidden(Tracing& tracing, const Ray& ray, size_t light, bool& near) {
    const CompiledScene& scene = tracing.scene;
    WorkCounters& work = tracing.stats.work;
    const bool remembers = light != kNoLight && !tracing.describes;   // the work of a pixel, which is a layer, must not depend on others
    if (remembers && light >= tracing.hiders.size()) tracing.hiders.resize(scene.lights.size());
    LastHider unused, &last = remembers ? tracing.hiders[light] : unused;
    if (hides_again(scene, ray, last, work)) return true;
    if (!opaque_things(scene).occluded(ray, work)) return false;
    if (!remembers || last.left > 0) {
        if (remembers) --last.left;
        Ray among_filters = ray;
        among_filters.mask = kMaskFilter;
        if (!scene.filters->occluded(among_filters, work)) return true;
    }
    Hit nearest;
    if (!opaque_things(scene).intersect(ray, nearest, work)) return true;    // both agree that something is hit
    if (last.left == 0) last.id = scene.set->whole(nearest.instance), last.missed = 0;
    near = filter_is_near(scene, ray, nearest.t, work);
    return !near;
}

/// All hits that count, in order, as tracing.passed; false if one of them is opaque. What is opaque is asked for first: it needs no list of hits.
bool find_surfaces(Tracing& tracing, Ray ray, size_t light, Occluders* among) {
    const CompiledScene& scene = tracing.scene;
    WorkCounters& work = tracing.stats.work;
    const bool spaced = scene.scene.settings.shadow_clearance > 0;
    tracing.passed.clear();
    ray.mask = kMaskOpaque;
    bool near = false;   // is there something opaque, near behind a filter?
    if (among) {
        if (among->occluded(scene, ray, work) && !(near = spaced && in_a_clearance(tracing, ray, *among))) return false;
    } else if (spaced ? is_hidden(tracing, ray, light, near) : opaque_things(scene).occluded(ray, work)) return false;
    if (near) return surface_by_surface(scene, ray, tracing.passed, work);
    ray.mask = kMaskFilter;
    if (among) among->all_hits(scene, ray, tracing.passed, work);
    else scene.filters->all_hits(ray, tracing.passed, work);
    if (spaced) keep_apart(scene, ray, tracing.passed);
    return true;
}

/// A surface on a shadow ray.
struct PassedSurface {
    Color through;   ///< what it lets through
    uint32_t slot;
    bool front;      ///< met from outside; anything where the side does not matter
};

/// Most filters are of one colour: for those nobody asks where they are met.
PassedSurface passed_surface(const CompiledScene& scene, const Ray& ray, const Hit& hit) {
    const uint32_t slot = plain_slot(scene, hit);
    if (slot != kNoId && scene.uniform_filters[slot]) return {*scene.uniform_filters[slot], slot, true};
    const ShadePoint p = passed_point(scene, ray, hit);
    return {transmitted(scene, p, ray.dir), p.slot, p.front};
}

}  // namespace

/// Filters are multiplied in the order of hits, so the product is the same, bit for bit, whatever structure found them.
Color filtered_light(Tracing& tracing, Ray ray, const InteriorStack& start, size_t light, Occluders* among) {
    if (!find_surfaces(tracing, ray, light, among)) return Color(0);
    InteriorStack inside = start;
    Color through(1);
    double t = 0;
    for (const Hit& hit : tracing.passed) {
        const PassedSurface passed = passed_surface(tracing.scene, ray, hit);
        through *= passed.through;
        if (is_black(through)) return Color(0);
        through *= transmittance(tracing.scene, inside, hit.t - t);
        const double before = t;
        t = hit.t;
        const uint32_t interior = tracing.scene.slots[passed.slot].interior;
        if (interior == kNoId) continue;
        const uint32_t carrier = tracing.scene.instances[hit.instance].carrier;
        const Interior& body = tracing.scene.interiors[interior];
        // As POV-Ray has it, where a shadow ray meets a body that it is in it leaves it, whichever way the surface looks; else it enters it.
        const bool by_turns = !std::isfinite(body.attenuation_distance);
        if ((by_turns || !passed.front) && inside.leave(carrier)) {
            if (body.fade_power > 0) through *= pov_fade(body, hit.t - before);
        } else if (by_turns || passed.front) inside.enter({carrier, interior});
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
