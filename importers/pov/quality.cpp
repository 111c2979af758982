// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/quality.h"

#include "importers/pov/settings.h"

namespace alidade::pov {

namespace {

template <class F> void for_each_finish(Scene& scene, const F& change) {
    for (Material& material : scene.materials)
        for (auto& layer : material.layers)
            if (auto* finish = std::get_if<PovFinish>(&layer)) change(*finish);
}

void remove_haze(Scene& scene) {
    scene.atmosphere.fogs.clear(), scene.atmosphere.rainbows.clear(), scene.atmosphere.media.clear();
    for (Interior& interior : scene.interiors) interior.media.clear();
}

void remove_shadows(Scene& scene) {
    for (Node& node : scene.nodes) node.flags.shadow = false;
    for (Light& light : scene.lights) light.projected_through.reset();
}

/// What glows with the colour of its pigment, and nothing else.
PovFinish flat(const PovFinish& finish) {
    PovFinish colour;
    colour.pigment = finish.pigment, colour.uncolored = finish.uncolored;
    colour.ambient = Color(1), colour.diffuse = 0;
    return colour;
}

void show_colours(Scene& scene) {
    for_each_finish(scene, [](PovFinish& finish) { finish = flat(finish); });
    scene.settings.ambient_light = Color(1), scene.settings.see_through = SeeThrough::opaque;
}

}  // namespace

void reduce(Scene& scene, int quality) {
    if (quality < kFullQuality) remove_haze(scene);
    if (quality < 8) {
        for_each_finish(scene, [](PovFinish& finish) { finish.normal.reset(); });
        scene.settings.follows_mirrors = false;
    }
    if (quality < kWholePigments) scene.settings.see_through = SeeThrough::black;
    if (quality < 5)
        for (Light& light : scene.lights) light.shadow_grid.reset();
    if (quality < 4) remove_shadows(scene);
    if (quality < 2) show_colours(scene);
}

}  // namespace alidade::pov
