// SPDX-License-Identifier: Apache-2.0
#include "pattern_cases.h"

#include <cmath>
#include <fmt/format.h>

namespace alidade {

namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;

/// A pattern signal in one expression.
struct P {
    PatternSignal s;

    explicit P(const char* name, std::vector<double> parameters = {}) { s.pattern = name, s.parameters = std::move(parameters); }
    P& turbulence(const Vec3& amount, int octaves = 6, double omega = 0.5, double lambda = 2) { return s.turbulence = {amount, octaves, omega, lambda}, *this; }
    P& generator(int n) { return s.noise = NoiseGenerator(n), *this; }
    P& frequency(double f, double phase = 0) { return s.frequency = f, s.phase = phase, *this; }
    P& wave(Wave w, double exponent = 1) { return s.wave = w, s.wave_exponent = exponent, *this; }
    P& warp(WarpKind kind, std::vector<double> parameters = {}) { return s.warps.push_back({kind, {}, std::move(parameters)}), *this; }
    P& moved(const Transform& t) { return s.warps.push_back({WarpKind::transform, t, {}}), *this; }
    P& scale(double f) { return moved(Transform::scale(Vec3(f))); }
};

/// POV-Ray turns the other way round: its axes are left-handed.
Transform turned_about_x(double degrees) { return Transform::rotate({1, 0, 0}, degrees * kDegree); }

using Cases = std::vector<PatternCase>;

void add(Cases& all, std::string declaration, const P& p) { all.push_back({std::move(declaration), p.s}); }

void add_noises(Cases& all) {
    for (int g = 1; g <= 3; ++g) {
        const auto with = [g](const char* text) { return fmt::format("{} noise_generator {}", text, g); };
        for (const char* name : {"bozo", "granite", "wrinkles", "dents", "agate"}) add(all, with(name), P(name).generator(g));
        add(all, with("crackle solid"), P("crackle", {-1, 1, 0, 2, 0, 1}).generator(g));
        add(all, with("marble turbulence .6"), P("marble").turbulence(Vec3(.6)).generator(g));
        add(all, with("spiral1 3 turbulence .4"), P("spiral1", {3}).turbulence(Vec3(.4)).generator(g));
        add(all, with("spiral2 2 turbulence .3"), P("spiral2", {2}).turbulence(Vec3(.3)).generator(g));
    }
    add(all, "bumps", P("bumps"));
    add(all, "spotted", P("spotted"));
    add(all, "agate agate_turb .6 octaves 4 omega .6 lambda 3", P("agate", {.6}).turbulence(Vec3(0), 4, .6, 3));
    add(all, "agate turbulence .4", P("agate").turbulence(Vec3(.4)));
    add(all, "bozo turbulence <.3,.1,.7> octaves 3 omega .7 lambda 2.5", P("bozo").turbulence({.3, .1, .7}, 3, .7, 2.5));
    add(all, "bozo warp{turbulence .3} scale 2", P("bozo").warp(WarpKind::turbulence, {.3, .3, .3}).scale(2));
    add(all, "bozo scale 2 warp{turbulence .3}", P("bozo").scale(2).warp(WarpKind::turbulence, {.3, .3, .3}));
    add(all, "bozo warp{turbulence <.3,.1,.2> octaves 3 omega .7 lambda 2.2}", P("bozo").warp(WarpKind::turbulence, {.3, .1, .2, 3, .7, 2.2}));
    add(all, "bozo turbulence .3 scale 2", P("bozo").turbulence(Vec3(.3)).scale(2));
    add(all, "marble", P("marble"));
    add(all, "wood", P("wood"));
    add(all, "wood turbulence <.1,.3,.2> octaves 3", P("wood").turbulence({.1, .3, .2}, 3));
    add(all, "wood turbulence .05 scale <.3,.3,1> rotate 5*x", P("wood").turbulence(Vec3(.05)).moved(Transform::scale({.3, .3, 1})).moved(turned_about_x(5)));
    add(all, "spiral1 3", P("spiral1", {3}));
    add(all, "spiral2 4", P("spiral2", {4}));
    add(all, "cells", P("cells"));
    add(all, "crackle", P("crackle"));
    add(all, "crackle form <1,0,0>", P("crackle", {1, 0, 0}));
    add(all, "crackle form <.2,.5,-.3> metric 1", P("crackle", {.2, .5, -.3, 1}));
    add(all, "crackle metric 3", P("crackle", {-1, 1, 0, 3}));
    add(all, "crackle form <1,0,0> offset .4", P("crackle", {1, 0, 0, 2, .4}));
}

void add_waves(Cases& all) {
    add(all, "leopard frequency 2 phase .25", P("leopard").frequency(2, .25));
    add(all, "radial frequency 6 phase .2", P("radial").frequency(6, .2));
    add(all, "gradient x frequency -2", P("gradient", {1, 0, 0}).frequency(-2));
    add(all, "gradient x frequency 0 phase .3", P("gradient", {1, 0, 0}).frequency(0, .3));
    add(all, "gradient x sine_wave frequency 1.7 phase .1", P("gradient", {1, 0, 0}).wave(Wave::sine).frequency(1.7, .1));
    add(all, "gradient x triangle_wave frequency 1.7", P("gradient", {1, 0, 0}).wave(Wave::triangle).frequency(1.7));
    add(all, "gradient x scallop_wave frequency 1.7", P("gradient", {1, 0, 0}).wave(Wave::scallop).frequency(1.7));
    add(all, "gradient x cubic_wave frequency 1.7", P("gradient", {1, 0, 0}).wave(Wave::cubic).frequency(1.7));
    add(all, "gradient x poly_wave 2.5", P("gradient", {1, 0, 0}).wave(Wave::poly, 2.5));
    add(all, "marble ramp_wave", P("marble").wave(Wave::ramp));
    add(all, "ripples", P("ripples"));
    add(all, "ripples frequency 3 phase .3", P("ripples").frequency(3, .3));
    add(all, "waves", P("waves"));
    add(all, "waves frequency 2", P("waves").frequency(2));
}

void add_distances(Cases& all) {
    for (const char* name : {"onion", "leopard", "radial", "boxed", "spherical", "cylindrical", "planar", "quilted"}) add(all, name, P(name));
    for (const char* name : {"boxed", "spherical", "cylindrical", "planar"}) add(all, fmt::format("{} scale 4", name), P(name).scale(4));
    add(all, "gradient <1,2,-1>", P("gradient", {1, 2, -1}));
    add(all, "quilted control0 .3 control1 .8", P("quilted", {.3, .8}));
}

void add_blocks(Cases& all) {
    for (const char* name : {"checker", "hexagon", "brick", "cubic"}) add(all, name, P(name));
    add(all, "brick brick_size <1,.5,.7> mortar .1", P("brick", {1, .5, .7, .1}));
    all.push_back({"square", P("square").s, 4});
    all.push_back({"triangular", P("triangular").s, 6});
    all.push_back({"hexagon", P("hexagon").scale(.3).s, 3});
    all.back().declaration = "hexagon scale .3";
}

void add_fractals(Cases& all) {
    add(all, "mandel 50", P("mandel", {50}));
    add(all, "mandel 50 exterior 6,.3 interior 1,1.2", P("mandel", {50, 2, 6, .3, 1, 1.2}));
    add(all, "mandel 30 exponent 3", P("mandel", {30, 3}));
    add(all, "mandel 25 exponent 7 scale 1.3", P("mandel", {25, 7}).scale(1.3));
    add(all, "julia <.353,.288>,30", P("julia", {.353, .288, 30}));
    add(all, "julia <.353,.288>,30 exponent 5", P("julia", {.353, .288, 30, 5}));
    add(all, "magnet 1 mandel 30", P("magnet_mandel", {1, 30}));
    add(all, "magnet 2 mandel 20", P("magnet_mandel", {2, 20}));
    add(all, "magnet 1 mandel 30 interior 1, 3", P("magnet_mandel", {1, 30, 1, 1, 1, 3}));
    add(all, "magnet 2 mandel 30 interior 1, 2", P("magnet_mandel", {2, 30, 1, 1, 1, 2}));
    add(all, "magnet 1 julia <.2,.1>,30 interior 1, 3", P("magnet_julia", {1, .2, .1, 30, 1, 1, 1, 3}));
    add(all, "magnet 1 julia <.2,.1>,30", P("magnet_julia", {1, .2, .1, 30}));
    add(all, "magnet 2 julia <.2,.1>,30", P("magnet_julia", {2, .2, .1, 30}));
    for (int type = 0; type <= 6; ++type) add(all, fmt::format("julia <-.4,.6>,20 exterior {},3", type), P("julia", {-.4, .6, 20, 2, double(type), 3}));
    for (int type = 0; type <= 6; ++type) add(all, fmt::format("mandel 9 interior {},.3", type), P("mandel", {9, 2, 1, 1, double(type), .3}));
}

void add_warps(Cases& all) {
    const std::string gradient = "gradient <1,2,3> frequency .1 ";
    const auto slow = [] { return P("gradient", {1, 2, 3}).frequency(.1); };
    add(all, gradient + "warp{spherical dist_exp 1}", slow().warp(WarpKind::spherical, {0, 0, 1, 1}));
    add(all, gradient + "warp{spherical orientation y}", slow().warp(WarpKind::spherical, {0, 1, 0}));
    add(all, gradient + "warp{cylindrical}", slow().warp(WarpKind::cylindrical));
    add(all, gradient + "warp{cylindrical orientation y dist_exp .5}", slow().warp(WarpKind::cylindrical, {0, 1, 0, .5}));
    add(all, gradient + "warp{toroidal major_radius .7}", slow().warp(WarpKind::toroidal, {0, 0, 1, 0, .7}));
    add(all, gradient + "warp{toroidal orientation x dist_exp 1 major_radius 1.5}", slow().warp(WarpKind::toroidal, {1, 0, 0, 1, 1.5}));
    add(all, gradient + "warp{planar y,.5}", slow().warp(WarpKind::planar, {0, 1, 0, .5}));
    add(all, gradient + "warp{planar x,-.3}", slow().warp(WarpKind::planar, {1, 0, 0, -.3}));
    add(all, gradient + "warp{planar}", slow().warp(WarpKind::planar));
    add(all, gradient + "warp{cubic}", slow().warp(WarpKind::cubic));
    add(all, "gradient <1,.3,.2> frequency .1 warp{repeat 2*x offset <0,.5,.25> flip <1,1,0>}",
        P("gradient", {1, .3, .2}).frequency(.1).warp(WarpKind::repeat, {2, 0, 0, 0, .5, .25, 1, 1, 0}));
    add(all, "gradient <1,.3,.2> frequency .1 warp{repeat .7*z flip <1,0,0>}", P("gradient", {1, .3, .2}).frequency(.1).warp(WarpKind::repeat, {0, 0, .7, 0, 0, 0, 1, 0, 0}));
    add(all, "gradient <1,.3,.2> frequency .1 warp{repeat .7*z offset <.3,.1,0> flip <1,0,1>}",
        P("gradient", {1, .3, .2}).frequency(.1).warp(WarpKind::repeat, {0, 0, .7, .3, .1, 0, 1, 0, 1}));
    add(all, "gradient <1,.3,.2> frequency .1 warp{repeat -.7*y}", P("gradient", {1, .3, .2}).frequency(.1).warp(WarpKind::repeat, {0, -.7, 0}));
    const auto slower = [] { return P("gradient", {1, 0, 0}).frequency(.05); };
    add(all, "gradient x frequency .05 warp{black_hole <1,2,0>,5 strength 1.5 falloff 1.7}", slower().warp(WarpKind::black_hole, {1, 2, 0, 5, 1.5, 1.7}));
    add(all, "gradient x frequency .05 warp{black_hole <.5,.5,.5>,.4 repeat <1,1,1> turbulence .3 inverse}",
        slower().warp(WarpKind::black_hole, {.5, .5, .5, .4, 1, 2, 1, 1, 1, 1, .3, .3, .3}));
    add(all, "gradient x frequency .05 warp{black_hole <.1,.5,.2>,.4 repeat <1,1.5,0>}", slower().warp(WarpKind::black_hole, {.1, .5, .2, .4, 1, 2, 0, 1, 1.5, 0}));
    add(all, "bozo scale 2 warp{repeat x} rotate 30*x warp{turbulence .1} translate y",
        P("bozo").scale(2).warp(WarpKind::repeat, {1}).moved(turned_about_x(30)).warp(WarpKind::turbulence, {.1, .1, .1}).moved(Transform::translate({0, 1, 0})));
}

}  // namespace

std::vector<PatternCase> pattern_cases() {
    Cases all;
    add_noises(all);
    add_waves(all);
    add_distances(all);
    add_blocks(all);
    add_fractals(all);
    add_warps(all);
    return all;
}

}  // namespace alidade
