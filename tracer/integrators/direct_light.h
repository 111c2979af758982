// SPDX-License-Identifier: Apache-2.0
/// Light from all lights and from the sky that a surface sends to the eye.
#pragma once

#include "tracer/integrators/shadow_grid.h"
#include "tracer/projector.h"
#include "tracer/shade.h"

namespace alidade {

enum class Shadows { cast, ignored };

/// What comes through everything on a shadow ray to the light of that index, or kNoLight, that starts inside of `inside`. `among`: what alone it can meet, if that is known.
Color filtered_light(Tracing& tracing, Ray ray, const InteriorStack& inside, size_t light, Occluders* among);

/// What of the light of that index, at the end of `ray`, which begins at a surface, comes to that. `kFilters` false: nothing in the scene lets a part of it through.
/// Inline: once a light and a point, whatever the kernel can do else.
template <bool kFilters> [[gnu::always_inline]] inline Color visible_along(Tracing& tracing, Ray& ray, const RayState& state, size_t light, Occluders* among) {
    ray.mask = kMaskShadow;
    ray.time = state.time;
    ray.tmin = tracing.scene.scene.settings.shadow_clearance;
    if constexpr (kFilters) {
        if (tracing.scene.filters_light) return filtered_light(tracing, ray, state.inside, light, among);
    }
    if (among) return among->occluded(tracing.scene, ray, tracing.stats.work) ? Color(0) : Color(1);
    return tracing.scene.top->occluded(ray, tracing.stats.work) ? Color(0) : Color(1);
}

/// The same of the light `distance` away in the unit direction `direction` from the point.
template <bool kFilters> [[gnu::always_inline]] inline Color visible(Tracing& tracing, const ShadePoint& point, const RayState& state, size_t light, const Vec3& direction, double distance) {
    ++tracing.stats.shadow_rays;
    if (!(distance > 0)) return Color(1);
    Ray ray = spawn_ray(point, direction, distance);
    return visible_along<kFilters>(tracing, ray, state, light, nullptr);
}

/// Is it less than any film holds, so that nobody need know whether it is in a shadow? All of glass is, but for its highlights: a power of a thousand vanishes a little way off them.
inline bool is_nothing(const Color& scattered) { return max_abs(scattered) < 1e-60; }

/// How far the way to the light `index` goes, of `distance` in the unit direction `direction`: the whole, or to what it is projected through; nothing where the light
/// does not come.
inline std::optional<double> way_to_light(const Tracing& tracing, const ShadePoint& point, size_t index, const Vec3& direction, double distance) {
    const auto& projectors = tracing.scene.projectors;
    if (index >= projectors.size() || !projectors[index]) return distance;
    return projectors[index]->reach(spawn_ray(point, direction, distance));
}

template <unsigned F> class DirectLight {
  public:
    DirectLight(Tracing& tracing, const ShadePoint& point, const Surface& surface, const RayState& state, Shadows shadows)
        : tracing_(tracing), point_(point), surface_(surface), state_(state), shadows_(shadows) {}

    Color sum() const {
        Color sum(0);
        const bool groups = !tracing_.scene.lit_by.empty();
        for (size_t i = 0; i < tracing_.scene.lights.size(); ++i) {
            if (groups && !shines(i)) continue;
            const PlacedLight& light = tracing_.scene.lights[i];
            if constexpr ((F & kSampledLights) != 0) {
                if (light.sampled()) {
                    sum += from_sampled_light(i);
                    continue;
                }
            }
            sum += from_light(light, Vec2(0), i);
        }
        if constexpr ((F & kSampledLights) != 0) {
            if (tracing_.scene.sky->lights()) sum += from_sampled_sky();
        }
        return sum;
    }

  private:
    // Apart from the camera's: a light whose samples went with the place in the pixel would be seen from there alone.
    static constexpr uint64_t kFirstLight = uint64_t(1) << 39, kSkyDimension = uint64_t(1) << 40;

    template <class One> Color sampled(uint64_t dimension, One one) const {
        Color sum(0);
        const uint32_t count = uint32_t(tracing_.light_samples);
        for (uint32_t k = 0; k < count; ++k) sum += one(state_.key.pair_of_light(dimension, k, count));
        return sum / double(count);
    }

    // Out of line: scenes without such lights pay for a comparison alone.
    [[gnu::noinline]] Color from_sampled_light(size_t i) const {
        return sampled(kFirstLight + i, [&](const Vec2& square) { return from_light(tracing_.scene.lights[i], square, i); });
    }
    [[gnu::noinline]] Color from_sampled_sky() const {
        return sampled(kSkyDimension, [&](const Vec2& square) { return from_sky(square); });
    }

    Color from_light(const PlacedLight& light, const Vec2& square, size_t i) const {
        if (light.from_its_place && surface_.faces_away(light.position - point_.position)) return Color(0);
        const Illumination arriving = illuminate(light, point_.position, square);
        if (light.light.shadow_grid) return light_from_grid(tracing_, point_, surface_, state_, i, arriving, shadows_ == Shadows::cast);
        if (is_black(arriving.irradiance)) return Color(0);
        const Color scattered = surface_.scatter(arriving.direction, !light.light.shadowless) * arriving.irradiance;
        if (is_nothing(scattered)) return scattered;
        const auto way = way_to_light(tracing_, point_, i, arriving.direction, arriving.distance - light.light.clearance);
        if (!way) return Color(0);
        return light.light.shadowless ? scattered : scattered * through(i, arriving.direction, *way);
    }

    // Out of line, as above.
    [[gnu::noinline]] bool shines(size_t i) const { return tracing_.scene.lit_by[tracing_.scene.instances[point_.instance].light_set][i]; }

    Color from_sky(const Vec2& square) const {
        const Sky::Sample sky = tracing_.scene.sky->sample(surface_.normal(), square);
        const Vec3 facing = point_.front ? point_.geometric_normal : -point_.geometric_normal;
        const double cosine = dot(surface_.normal(), sky.direction);
        if (!(cosine > 0 && sky.density > 0) || dot(facing, sky.direction) <= 0) return Color(0);
        const Color scattered = surface_.diffuse() * sky.radiance * (cosine / (kPi * sky.density));
        return is_black(scattered) ? scattered : scattered * through(kNoLight, sky.direction, kInf);
    }

    Color through(size_t light, const Vec3& direction, double distance) const {
        if (shadows_ == Shadows::ignored) return Color(1);
        return visible<(F & (kAlpha | kTransmission)) != 0>(tracing_, point_, state_, light, direction, distance);
    }

    Tracing& tracing_;
    const ShadePoint& point_;
    const Surface& surface_;
    const RayState& state_;
    Shadows shadows_;
};

/// What the surface sends to the eye by itself and by direct light, times the part of it that is there.
template <unsigned F> Color local_light(Tracing& tracing, const ShadePoint& point, const Surface& surface, const RayState& state, Shadows shadows) {
    const double there = surface.coverage();
    if (there <= 0) return Color(0);
    return (surface.emitted() + DirectLight<F>(tracing, point, surface, state, shadows).sum()) * there;
}

}  // namespace alidade
