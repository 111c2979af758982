// SPDX-License-Identifier: Apache-2.0
#include "exporters/pov/warps.h"

namespace alidade::pov_export {

namespace {

/// A warp's parameters, with POV-Ray's defaults behind those that are given.
class Parameters {
  public:
    explicit Parameters(const Warp& warp) : given_(warp.parameters) {}
    double number(size_t i, double usual) const { return i < given_.size() ? given_[i] : usual; }
    Vec3 vector(size_t i, const Vec3& usual) const { return {number(i, usual.x), number(i + 1, usual.y), number(i + 2, usual.z)}; }

  private:
    const std::vector<double>& given_;
};

void black_hole(Sdl& sdl, const Parameters& p) {
    sdl.line("black_hole", p.vector(0, Vec3(0)), ",", p.number(3, 1));
    sdl.line("strength", p.number(4, 1), "falloff", p.number(5, 2));
    if (p.number(6, 0) != 0) sdl.line("inverse");
    if (const Vec3 repeat = p.vector(7, Vec3(0)); repeat != Vec3(0)) sdl.line("repeat", repeat);
    if (const Vec3 jitter = p.vector(10, Vec3(0)); jitter != Vec3(0)) sdl.line("turbulence", jitter);
}

void repeat(Sdl& sdl, const Parameters& p) {
    sdl.line("repeat", p.vector(0, {1, 0, 0}));
    if (const Vec3 offset = p.vector(3, Vec3(0)); offset != Vec3(0)) sdl.line("offset", offset);
    if (const Vec3 flip = p.vector(6, Vec3(0)); flip != Vec3(0)) sdl.line("flip", flip);
}

void mapping(Sdl& sdl, WarpKind kind, const Parameters& p) {
    const Vec3 orientation = p.vector(0, {0, 0, 1});
    if (kind == WarpKind::planar) return sdl.line("planar", orientation, ",", p.number(3, 0));
    sdl.line(kind == WarpKind::cylindrical ? "cylindrical" : kind == WarpKind::spherical ? "spherical" : "toroidal", "orientation", orientation);
    sdl.line("dist_exp", p.number(3, 0));
    if (kind == WarpKind::toroidal) sdl.line("major_radius", p.number(4, 1));
}

}  // namespace

void write_turbulence(Sdl& sdl, const Turbulence& t) {
    const Turbulence usual;
    if (t.amount != Vec3(0)) sdl.line("turbulence", t.amount);
    if (t.octaves != usual.octaves) sdl.line("octaves", t.octaves);
    if (t.omega != usual.omega) sdl.line("omega", t.omega);
    if (t.lambda != usual.lambda) sdl.line("lambda", t.lambda);
}

void write_warp(Sdl& sdl, const Warp& warp) {
    if (warp.kind == WarpKind::transform) return sdl.line(warp.transform);
    const Parameters p(warp);
    sdl.begin("warp");
    switch (warp.kind) {
        case WarpKind::turbulence: sdl.line("turbulence", p.vector(0, Vec3(0)), "octaves", p.number(3, 6), "omega", p.number(4, 0.5), "lambda", p.number(5, 2)); break;
        case WarpKind::black_hole: black_hole(sdl, p); break;
        case WarpKind::repeat: repeat(sdl, p); break;
        case WarpKind::cubic: sdl.line("cubic"); break;
        default: mapping(sdl, warp.kind, p);
    }
    sdl.end();
}

}  // namespace alidade::pov_export
