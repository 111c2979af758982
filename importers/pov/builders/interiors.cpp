// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/interiors.h"

namespace alidade::pov {

namespace {

void take_dispersion(Build& build, Cursor& at, Interior& in) {
    const Place place = at.place();
    at.next();
    in.dispersion = at.number("the dispersion");
    if (in.dispersion != 1) build.p.tally(place, "dispersion in interior is not modelled yet: light of all colours is bent alike");
}

void read_interior(Build& build, const Block& block, Interior& in) {
    for (Cursor at(build, block); !at.done();) {
        if (const Block* base = at.block_at("interior"_w)) at.next(), in = Interior(), read_interior(build, *base, in);
        else if (at.accept("ior"_w)) in.ior = at.number("the index of refraction");
        else if (at.accept("caustics"_w)) in.caustics = at.number("the caustics");
        else if (at.at_word("dispersion"_w)) take_dispersion(build, at, in);
        else if (at.accept("dispersion_samples"_w)) in.dispersion_samples = at.integer("the number of samples", 2, 1000);
        else if (at.accept("fade_distance"_w)) in.fade_distance = at.number("the distance of fading");
        else if (at.accept("fade_power"_w)) in.fade_power = at.number("the power of fading");
        else if (at.accept("fade_color"_w) || at.accept("fade_colour"_w)) in.fade_color = at.rgb("the colour of fading");
        else if (at.at_word("refraction"_w)) at.skip();            // POV-Ray reads it, and refracts all the same
        else at.skip_unmodelled();
    }
}

}  // namespace

InteriorId add_interior(Build& build, const Block& block, std::optional<InteriorId> before) {
    Interior in;
    if (before) in = build.scene.interiors[before->index];
    read_interior(build, block, in);
    in.from = build.position(block.place);
    if (!(in.fade_distance > 1e-10)) in.fade_distance = 0;   // POV-Ray takes less for none
    in.ior = checked_ior(build, in.ior, block.place);
    build.scene.interiors.push_back(in);
    return {uint32_t(build.scene.interiors.size() - 1)};
}

double checked_ior(Build& build, double ior, Place place) {
    if (ior > 0) return ior;
    if (ior != 0) build.p.fail(place, "the index of refraction must be greater than 0");
    build.p.tally(place, "an index of refraction of 0 counts as 1, as in POV-Ray");
    return 1;
}

}  // namespace alidade::pov
