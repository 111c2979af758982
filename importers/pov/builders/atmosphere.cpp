// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/atmosphere.h"

#include "importers/pov/builders/pigments.h"
#include "importers/pov/builders/textures.h"
#include "importers/pov/builders/warps.h"

namespace alidade::pov {

namespace {

void take_sky(Build& build, const Block& block, SkySphere& sky) {
    const Nested nested(build.p, block.place);
    for (Cursor at(build, block); !at.done();) {
        if (const Block* base = at.block_at("sky_sphere"_w)) at.next(), take_sky(build, *base, sky);
        else if (const Block* pigment = at.block_at("pigment"_w)) at.next(), sky.pigments.push_back(build_pigment(build, *pigment, default_texture(build, pigment->defaults).pigment));
        else if (at.accept("emission"_w)) sky.emission = at.rgb("the emission of a sky");
        else if (at.at_transform()) sky.transform = at.transform() * sky.transform;
        else at.skip_unmodelled();
    }
}

void take_fog(Build& build, const Block& block, Fog& fog) {
    const Nested nested(build.p, block.place);
    for (Cursor at(build, block); !at.done();) {
        if (const Block* base = at.block_at("fog"_w)) at.next(), take_fog(build, *base, fog);
        else if (at.accept("fog_type"_w)) fog.ground = at.integer("the type of a fog", 1, 2) == 2;
        else if (at.accept("distance"_w)) fog.distance = at.number("the distance of a fog");
        else if (at.accept("fog_offset"_w)) fog.offset = at.number("the offset of a fog");
        else if (at.accept("fog_alt"_w)) fog.altitude = at.number("the altitude of a fog");
        else if (at.accept("turb_depth"_w)) fog.turbulence_depth = at.number("the depth of turbulence");
        else if (at.accept("up"_w)) fog.up = at.vector("the direction of up");
        else if (take_turbulence(at, fog.turbulence)) continue;
        else if (at.at_numeric()) {
            const std::array<double, 5> c = at.colour("the colour of a fog");
            fog.color = {c[0], c[1], c[2]}, fog.filter = c[3], fog.transmit = c[4];
        } else at.skip_unmodelled();
    }
}

}  // namespace

void read_background(Build& build, const Block& block) {
    for (Cursor at(build, block); !at.done();) {
        if (at.at_numeric()) build.scene.atmosphere.background = at.rgb("the background");
        else at.skip_unmodelled();
    }
}

void read_sky_sphere(Build& build, const Block& block) {
    SkySphere sky;
    take_sky(build, block, sky);
    build.scene.atmosphere.sky = sky;
}

void read_fog(Build& build, const Block& block) {
    Fog fog;
    fog.noise = build.noise;
    take_fog(build, block, fog);
    if (fog.ground && fog.altitude == 0) build.p.fail(block.place, "a ground fog needs a fog_alt that is not 0");
    if (fog.distance != 0) build.scene.atmosphere.fogs.push_back(fog);
}

}  // namespace alidade::pov
