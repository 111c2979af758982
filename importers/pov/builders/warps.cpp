// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/warps.h"

namespace alidade::pov {

namespace {

void append(std::vector<double>& out, const Vec3& v) { out.insert(out.end(), {v.x, v.y, v.z}); }

Warp turbulence(Cursor& at) {
    Turbulence t;
    t.amount = at.vector("the amount of turbulence");
    while (take_turbulence(at, t)) {}
    Warp warp{WarpKind::turbulence, {}, {}};
    append(warp.parameters, t.amount);
    warp.parameters.insert(warp.parameters.end(), {double(t.octaves), t.omega, t.lambda});
    return warp;
}

/// `black_hole CENTRE, RADIUS strength S falloff F inverse repeat V turbulence V`
Warp black_hole(Cursor& at) {
    const Vec3 centre = at.vector("the centre of a black hole");
    const double radius = at.number("the radius of a black hole");
    double strength = 1, falloff = 2, inverted = 0;
    Vec3 repeat(0), jitter(0);
    while (!at.done()) {
        if (at.accept("strength"_w)) strength = at.number("the strength");
        else if (at.accept("falloff"_w)) falloff = at.number("the falloff");
        else if (at.accept("inverse"_w)) inverted = at.flag() ? 1 : 0;
        else if (at.accept("repeat"_w)) repeat = at.vector("the distance between black holes");
        else if (at.accept("turbulence"_w)) jitter = at.vector("the turbulence of black holes");
        else at.skip_unmodelled();
    }
    Warp warp{WarpKind::black_hole, {}, {}};
    append(warp.parameters, centre);
    warp.parameters.insert(warp.parameters.end(), {radius, strength, falloff, inverted});
    append(warp.parameters, repeat), append(warp.parameters, jitter);
    return warp;
}

Warp repeat(Build& build, Cursor& at) {
    const Place place = at.place();
    const Vec3 width = at.vector("the width of what is repeated");
    Vec3 offset(0), flip(0);
    while (!at.done()) {
        if (at.accept("offset"_w)) offset = at.vector("the offset");
        else if (at.accept("flip"_w)) flip = at.vector("the axes to flip");
        else at.skip_unmodelled();
    }
    if ((width.x != 0) + (width.y != 0) + (width.z != 0) != 1) build.p.fail(place, "a pattern is repeated along one axis: one component of the vector may differ from 0");
    Warp warp{WarpKind::repeat, {}, {}};
    append(warp.parameters, width), append(warp.parameters, offset), append(warp.parameters, flip);
    return warp;
}

/// `planar V, D` and the maps around something: `orientation V dist_exp E major_radius R`.
Warp mapping(Cursor& at, WarpKind kind) {
    Vec3 orientation(0, 0, 1);
    double exponent = 0, radius = 1;
    if (kind == WarpKind::planar) {
        if (at.at_numeric()) orientation = at.vector("the normal of a plane");
        if (at.at_number()) exponent = at.number("the distance of a plane");
    }
    while (!at.done()) {
        if (at.accept("orientation"_w)) orientation = at.vector("the orientation");
        else if (at.accept("dist_exp"_w)) exponent = at.number("the exponent of the distance");
        else if (at.accept("major_radius"_w)) radius = at.number("the major radius");
        else at.skip_unmodelled();
    }
    Warp warp{kind, {}, {}};
    if (kind == WarpKind::cubic) return warp;
    append(warp.parameters, length(orientation) > 0 ? normalized(orientation) : orientation);
    warp.parameters.push_back(exponent);
    if (kind == WarpKind::toroidal) warp.parameters.push_back(radius);
    return warp;
}

}  // namespace

bool take_turbulence(Cursor& at, Turbulence& t) {
    if (at.accept("turbulence"_w)) t.amount = at.vector("the amount of turbulence");
    else if (at.accept("octaves"_w)) t.octaves = at.integer("the number of octaves", 1, 10);
    else if (at.accept("omega"_w)) t.omega = double(float(at.number("omega")));
    else if (at.accept("lambda"_w)) t.lambda = double(float(at.number("lambda")));
    else return false;
    return true;
}

Warp build_warp(Build& build, const Block& block) {
    Cursor at(build, block);
    const Place place = at.place();
    if (at.accept("turbulence"_w)) return turbulence(at);
    if (at.accept("black_hole"_w)) return black_hole(at);
    if (at.accept("repeat"_w)) return repeat(build, at);
    if (at.accept("planar"_w)) return mapping(at, WarpKind::planar);
    if (at.accept("cylindrical"_w)) return mapping(at, WarpKind::cylindrical);
    if (at.accept("spherical"_w)) return mapping(at, WarpKind::spherical);
    if (at.accept("toroidal"_w)) return mapping(at, WarpKind::toroidal);
    if (at.accept("cubic"_w)) return mapping(at, WarpKind::cubic);
    if (at.at_transform()) return {WarpKind::transform, at.transform(), {}};
    build.p.fail(place, "a warp begins with turbulence, black_hole, repeat, planar, cylindrical, spherical, toroidal or cubic");
}

}  // namespace alidade::pov
