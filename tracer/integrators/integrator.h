// SPDX-License-Identifier: Apache-2.0
/// What light a ray brings. An integrator is one file and one row of the table in integrator.cpp.
#pragma once

#include "tracer/occluders.h"
#include "tracer/start_inside.h"
#include "tracer/surface.h"

#include <array>
#include <atomic>
#include <utility>

namespace alidade {

/// What the output layers need of a camera ray's first visible surface.
struct FirstHit {
    FirstHit() {}   // not by default: that would clear all of it first, and then set it

    bool hit = false;
    double depth = kInf;      ///< distance from the ray's origin, world units
    Vec3 normal{0};           ///< shading normal, towards the eye
    Color albedo{0};
    Vec2 uv{0};
    uint32_t instance = kNoId;
    uint32_t slot = 0;        ///< into CompiledScene::slots
    double shows = 0;         ///< how much of what is behind the scene is seen, where pictures have alpha
    double coverage = 0;      ///< 1 less what passes through alpha to the background
};

/// A mirrored or refracted ray that is still to be followed.
struct PendingRay {
    PendingRay(const Ray& followed, const RayState& with, double to_the = 1) : ray(followed), state(with), exponent(to_the) {}

    Ray ray;
    RayState state;
    double exponent;   ///< Secondary::exponent
};

/// What is known of the points of a light's grid. A round forgets the one before it without touching the points, of which few may be asked.
struct GridScratch {
    struct Point {
        Color value{0};
        uint32_t round = 0;   ///< in which the value was found
    };
    std::vector<Point> points{};
    uint32_t round = 0;
    std::vector<uint32_t> asked_of_equal{};   ///< by light: how many of its points are asked where all have the same value; 0: not known yet

    void begin(size_t count) {
        ++round;
        if (points.size() >= count && round != 0) return;
        points.assign(count, Point());
        round = 1;
    }
};

/// What hid a light from a shadow ray: it often hides it from the next one, too, and is asked first, which changes no answer.
struct LastHider {
    uint32_t id = kNoId;   ///< as CompiledScene::set numbers them
    int missed = 0;        ///< rays in a row that it was asked for, and did not hide it from
    int pause = 0;         ///< of hidden rays from which nobody learned what hides them: the longer, the less what was learned has helped
    int left = 0;          ///< of the pause
};

/// No light: of shadow rays to the sky.
inline constexpr size_t kNoLight = std::numeric_limits<size_t>::max();

/// One thread's view of a render.
struct Tracing {
    const CompiledScene& scene;
    const StartInside& around;   ///< the camera
    int max_depth;
    int light_samples;        ///< shadow rays a surface point sends to each light with an extent, and to the sky
    double bailout;           ///< rays whose weight is below it in all channels are not followed (POV-Ray's adc_bailout)
    bool alpha;               ///< pictures have alpha
    bool describes;           ///< is there a layer beside colour, which asks what camera rays meet?
    RenderStats& stats;
    std::vector<Hit> passed{};   ///< scratch of shadow rays
    Secondaries secondaries{};   ///< scratch of an integrator
    GridScratch grid{};          ///< scratch of lights with a ShadowGrid
    Occluders occluders{};       ///< and of those
    std::vector<LastHider> hiders{};   ///< by light; none until one is asked for
    std::vector<PendingRay> pending{};   ///< scratch of an integrator: empty between camera rays
    const std::atomic<bool>* stop = nullptr;   ///< null: nobody does

    /// Then what a ray brings counts no more, and need not be whole.
    bool stopped() const { return stop && stop->load(std::memory_order_relaxed); }
};

/// What a ray brings that hits nothing, unweighted; where pictures have alpha, `first` gets what shows through.
Color sky_seen(const Tracing& tracing, const Vec3& direction, const RayState& state, FirstHit& first);

/// Radiance along a camera ray; also fills in `first`, if layers ask for that. The same for the same ray and key. `state` goes with the ray, and is not put back.
using Radiance = Color (*)(Tracing& tracing, const Ray& ray, RayState& state, FirstHit& first);

struct Integrator {
    IntegratorEntry entry;
    std::array<Radiance, kAllFeatures + 1> kernels;   ///< by feature mask
};

/// An integrator's table of kernels: `Kernel<F>::radiance` for every mask F.
template <template <unsigned> class Kernel, unsigned... F> constexpr std::array<Radiance, sizeof...(F)> kernels(std::integer_sequence<unsigned, F...>) {
    return {Kernel<F>::radiance...};
}
using EveryMask = std::make_integer_sequence<unsigned, kAllFeatures + 1>;

std::span<const Integrator> integrator_table();
Integrator cast_integrator();
Integrator whitted_integrator();

/// What the camera's layers say of a hit.
void describe(const ShadePoint& point, const Surface& surface, double depth, FirstHit& first);

}  // namespace alidade
