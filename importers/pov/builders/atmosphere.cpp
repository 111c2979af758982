// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/atmosphere.h"

#include "importers/pov/builders/pigments.h"
#include "importers/pov/builders/warps.h"

namespace alidade::pov {

namespace {

void take_sky(Build& build, const Block& block, SkySphere& sky) {
    for (Cursor at(build, block); !at.done();) {
        if (const Block* base = at.block_at("sky_sphere"_w)) at.next(), take_sky(build, *base, sky);
        else if (const Block* pigment = at.block_at("pigment"_w)) at.next(), sky.pigments.push_back(build_pigment(build, *pigment, plain_pigment(build)));
        else if (at.accept("emission"_w)) sky.emission = at.rgb("the emission of a sky");
        else if (at.at_transform()) sky.transform = at.transform() * sky.transform;
        else at.skip_unmodelled();
    }
}

void take_fog(Build& build, const Block& block, Fog& fog) {
    for (Cursor at(build, block); !at.done();) {
        if (const Block* base = at.block_at("fog"_w)) at.next(), take_fog(build, *base, fog);
        else if (at.accept("fog_type"_w)) fog.ground = at.integer("the type of a fog", 1, 2) == 2;
        else if (at.accept("distance"_w)) fog.distance = at.number("the distance of a fog");
        else if (at.accept("fog_offset"_w)) fog.offset = at.number("the offset of a fog");
        else if (at.accept("fog_alt"_w)) fog.altitude = at.number("the altitude of a fog");
        else if (at.accept("turb_depth"_w)) fog.turbulence_depth = at.number("the depth of turbulence");
        else if (at.accept("up"_w)) fog.up = at.vector("the direction of up");
        else if (at.at_transform()) fog.up = at.transform().vector(fog.up);
        else if (Turbulence t = fog.turbulence.value_or(Turbulence()); take_turbulence(at, t)) fog.turbulence = t;
        else if (at.at_number()) fog.distance = at.number("the distance of a fog");   // as version 1 had it: `fog { color White 200 }`
        else if (at.at_numeric()) {
            const std::array<double, 5> c = at.colour("the colour of a fog");
            fog.color = {c[0], c[1], c[2]}, fog.filter = c[3], fog.transmit = c[4];
        } else at.skip_unmodelled();
    }
}

SignalId add_bow_colours(Build& build, const Block& map, Place place) {
    PatternSignal colours;
    colours.pattern = "gradient", colours.parameters = {1, 0, 0};
    colours.map = read_colour_map(build, map);
    return build.add_signal(colours, place);
}

/// `falloff` is checked at the end: arc_angle may stand behind it.
void take_rainbow(Build& build, const Block& block, Rainbow& bow, std::optional<double>& falloff) {
    for (Cursor at(build, block); !at.done();) {
        const Place place = at.place();
        const Block* map = at.block_at("color_map"_w);
        if (!map) map = at.block_at("colour_map"_w);
        if (map) at.next(), bow.colors = add_bow_colours(build, *map, place);
        else if (const Block* base = at.block_at("rainbow"_w)) at.next(), take_rainbow(build, *base, bow, falloff);
        else if (at.accept("direction"_w)) bow.direction = at.vector("the direction of the sun's light");
        else if (at.accept("up"_w)) bow.up = at.vector("the direction of up");
        else if (at.accept("angle"_w)) bow.angle = at.number("the angle of a rainbow");
        else if (at.accept("width"_w)) bow.width = at.number("the width of a rainbow");
        else if (at.accept("distance"_w)) bow.distance = at.number("the distance of a rainbow");
        else if (at.accept("arc_angle"_w)) bow.arc_angle = at.number("the angle of the arc");
        else if (at.accept("falloff_angle"_w)) falloff = at.number("the angle where the arc begins to fade");
        else if (at.accept("jitter"_w)) {
            if (at.number("the jitter of a rainbow") != 0) build.p.tally(place, "jitter in rainbow is not modelled yet: it is left out");
        } else {
            build.p.fail(at.place(), "a background is one colour and nothing else: a sky_sphere takes pigments");
        }
    }
}

}  // namespace

/// From version 3.7 on, what a background transmits is missing in it, and where pictures have alpha, what it filters, too. Before, it is all missing in these.
void read_background(Build& build, const Block& block) {
    bool coloured = false;
    Atmosphere& air = build.scene.atmosphere;
    air.background = air.background_mirrored = air.background_over = Color(0), air.background_shows = build.scene.settings.filter_dims_by_colour ? 1 : 0;   // of one before it nothing is left
    for (Cursor at(build, block); !at.done();) {
        if (at.at_numeric() && !std::exchange(coloured, true)) {
            const std::array<double, 5> c = at.colour("the background");
            const Color color(c[0], c[1], c[2]);
            const bool old = build.scene.settings.filter_dims_by_colour;
            air.background = color * (old ? 1 : 1 - c[4]);
            air.background_mirrored = color;
            air.background_over = old ? Color(0) : color * (1 - c[3] - c[4]), air.background_shows = old ? 1 : std::min(1.0, std::abs(c[4] + c[3] * pov_grey(color)));
        }
        else at.skip_unmodelled();
    }
}

void read_sky_sphere(Build& build, const Block& block) {
    SkySphere sky;
    take_sky(build, block, sky);
    build.scene.atmosphere.sky = sky;
}

void read_rainbow(Build& build, const Block& block) {
    Rainbow bow;
    bow.direction = Vec3(0);
    std::optional<double> falloff;
    take_rainbow(build, block, bow, falloff);
    if (length(bow.direction) == 0) build.p.fail(block.place, "a rainbow needs the direction of the sun's light");
    if (length(cross(bow.direction, bow.up)) == 0) build.p.fail(block.place, "the rainbow's up is the direction of its light, or has no length");
    if (falloff && *falloff > bow.arc_angle) build.p.fail(block.place, "the falloff_angle of a rainbow is larger than its arc_angle");
    if (falloff) bow.falloff_angle = *falloff;
    if (bow.colors && bow.width != 0) build.scene.atmosphere.rainbows.push_back(bow);
}

void read_fog(Build& build, const Block& block) {
    Fog fog;
    take_fog(build, block, fog);
    if (fog.ground && fog.altitude == 0) {
        build.p.warn(block.place, "a ground fog without fog_alt ends at its fog_offset");
        fog.altitude = 1e-6;   // nearly none: in POV-Ray what is below the offset is black
    }
    if (fog.distance != 0) build.scene.atmosphere.fogs.push_back(fog);
}

}  // namespace alidade::pov
