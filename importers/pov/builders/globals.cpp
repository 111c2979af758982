// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/globals.h"

#include <utility>

namespace alidade::pov {

namespace {

/// `assumed_gamma NUMBER` or `assumed_gamma srgb`: what the scene's numbers mean. The first holds.
void take_gamma(Build& build, Cursor& at) {
    RenderSettings& s = build.scene.settings;
    const Place place = at.place();
    if (std::exchange(build.gamma_given, true)) {
        build.p.warn(place, "assumed_gamma was given before: this one is not used");
        return (void)at.next();
    }
    s.srgb_coded = at.accept("srgb"_w);
    s.assumed_gamma = s.srgb_coded ? 1 : at.number("the assumed gamma");
    if (!(s.assumed_gamma > 0)) build.p.fail(place, "the assumed gamma must be greater than 0");
}

/// Words of global_settings that change no picture that is modelled.
bool is_silent(const Cursor& at) {
    return at.at_word("charset"_w) || at.at_word("ascii"_w) || at.at_word("utf8"_w) || at.at_word("sys"_w) || at.at_word("max_intersections"_w) || at.at_word("mm_per_unit"_w) || at.at_word("hf_gray_16"_w);
}

}  // namespace

void begin_settings(Build& build) {
    RenderSettings& s = build.scene.settings;
    s.default_spp = 1;
    s.default_light = false, s.first_box_shows = true, s.shadow_clearance = 0.001;
    s.max_depth = 4;
    s.adc_bailout = 1.0 / 255;
    s.srgb_coded = build.p.lacks_gamma();
    s.filter_dims_by_colour = build.p.is_old();
    if (build.p.version_given && build.p.version < 3.5 - 1e-9) s.noise = NoiseGenerator::original;
    s.generator = "POV-Ray";
}

void read_globals(Build& build, const Block& block) {
    RenderSettings& s = build.scene.settings;
    for (Cursor at(build, block); !at.done();) {
        if (at.accept("assumed_gamma"_w)) take_gamma(build, at);
        else if (at.accept("max_trace_level"_w)) s.max_depth = at.integer("the most levels", 1, 256) - 1;
        else if (at.accept("adc_bailout"_w)) s.adc_bailout = at.number("adc_bailout");
        else if (at.accept("ambient_light"_w)) s.ambient_light = at.rgb("the ambient light");
        else if (at.accept("irid_wavelength"_w)) s.irid_wavelength = at.rgb("the wavelengths of irid");
        else if (at.accept("noise_generator"_w)) s.noise = NoiseGenerator(at.integer("the noise generator", 1, 3));
        else if (at.accept("number_of_waves"_w)) build.number_of_waves = at.integer("the number of waves", 1, 1000);
        else if (is_silent(at)) at.skip();
        else at.skip_unmodelled();
    }
}

}  // namespace alidade::pov
