// SPDX-License-Identifier: Apache-2.0
#include "eval/patterns/registry.h"

namespace alidade {

namespace {

constexpr PatternParameter kGradient[] = {{"x"}, {"y"}, {"z"}};
constexpr PatternParameter kQuilted[] = {{"control0", 1, true}, {"control1", 1, true}};
constexpr PatternParameter kBrick[] = {{"size.x", 8}, {"size.y", 3}, {"size.z", 4.5}, {"mortar", 0.5}};
constexpr PatternParameter kAgate[] = {{"agate_turb", 1, true}};
constexpr PatternParameter kSpiral[] = {{"arms", 1}};
constexpr PatternParameter kCrackle[] = {{"form.x", -1}, {"form.y", 1}, {"form.z", 0}, {"metric", 2}, {"offset", 0}, {"solid", 0}};
constexpr PatternParameter kFacets[] = {{"coords", 0, true}, {"size", 0.1}, {"metric", 2}};
constexpr PatternParameter kWaves[] = {{"number_of_waves", 10}};
constexpr PatternParameter kMandel[] = {{"iterations", 1}, {"exponent", 2}, {"exterior", 1}, {"exterior factor", 1}, {"interior", 0}, {"interior factor", 1}};
constexpr PatternParameter kJulia[] = {{"c.re"}, {"c.im"}, {"iterations", 1}, {"exponent", 2}, {"exterior", 1}, {"exterior factor", 1}, {"interior", 0}, {"interior factor", 1}};
constexpr PatternParameter kMagnetMandel[] = {{"type", 1}, {"iterations", 1}, {"exterior", 1}, {"exterior factor", 1}, {"interior", 0}, {"interior factor", 1}};
constexpr PatternParameter kMagnetJulia[] = {{"type", 1},    {"c.re"}, {"c.im"}, {"iterations", 1}, {"exterior", 1}, {"exterior factor", 1}, {"interior", 0},
                                             {"interior factor", 1}};

constexpr PatternOps kPatterns[] = {
    {"agate", "bands along z, bent by turbulence of their own", kAgate, pattern::agate},
    {"average", "all entries of its map, by their weights", {}, nullptr},
    {"boxed", "1 at the origin, 0 at the box from -1 to 1 and outside", {}, pattern::boxed},
    {"bozo", "noise", {}, pattern::plain_noise, Wave::ramp, 1, true, nullptr, nullptr, SourceKind::none, false, false, pattern::four_noises},
    {"brick", "mortar 0, bricks 1", kBrick, pattern::brick, Wave::ramp, 0},
    {"bumps", "noise", {}, pattern::plain_noise, Wave::ramp, 1, true, nullptr, pattern::bumps_relief},
    {"bump_map", "a picture that bends normals alone", {}, nullptr, Wave::ramp, 0, true, nullptr, nullptr, SourceKind::picture, false, true},
    {"cells", "a number for each unit cube", {}, pattern::cells},
    {"checker", "unit cubes of 0 and 1 in turn", {}, pattern::checker, Wave::ramp, 0},
    {"crackle", "distances to random points, one a unit cube", kCrackle, pattern::crackle, Wave::ramp, 1, true, nullptr, nullptr, SourceKind::none, false, false, pattern::four_crackles},
    {"cubic", "0 to 5 for the six pyramids around the origin", {}, pattern::cubic, Wave::ramp, 0},
    {"cylindrical", "1 at the y axis, 0 at distance 1 and outside", {}, pattern::cylindrical},
    {"dents", "noise to the third power", {}, pattern::dents, Wave::ramp, 1, true, nullptr, pattern::dents_relief},
    {"facets", "flat pieces: it bends normals alone", kFacets, nullptr, Wave::ramp, 1, true, nullptr, pattern::facets_relief},
    {kFunctionPattern, "the number of a function of the scene", {}, nullptr, Wave::ramp, 1, true, nullptr, nullptr, SourceKind::function},
    {"gradient", "the distance along a direction, folded at 1", kGradient, pattern::gradient},
    {"granite", "six octaves of folded noise", {}, pattern::granite, Wave::ramp, 1, true, nullptr, nullptr, SourceKind::none, false, false, pattern::four_granites},
    {"hexagon", "hexagons of 0, 1 and 2 in the xz plane", {}, pattern::hexagon, Wave::ramp, 0},
    {kImageMap, "the colours of a picture", {}, nullptr, Wave::ramp, 0, true, nullptr, nullptr, SourceKind::picture, true},
    {"image_pattern", "the grey of a picture, or what it lets through", {}, nullptr, Wave::ramp, 0, true, nullptr, nullptr, SourceKind::picture},
    {"julia", "the Julia set of z^exponent + c in the xy plane", kJulia, pattern::julia},
    {"leopard", "the square of the mean of three sines", {}, pattern::leopard},
    {"magnet_julia", "magnet julia", kMagnetJulia, pattern::magnet_julia},
    {"magnet_mandel", "magnet mandel", kMagnetMandel, pattern::magnet_mandel},
    {"mandel", "the Mandelbrot set in the xy plane", kMandel, pattern::mandel},
    {"marble", "x, moved by turbulence", {}, pattern::marble, Wave::triangle, 1, false},
    {"onion", "the distance from the origin", {}, pattern::onion},
    {"pigment_pattern", "the grey of a pigment", {}, nullptr, Wave::ramp, 1, true, nullptr, nullptr, SourceKind::pigment},
    {"planar", "1 at y = 0, 0 at distance 1 and outside", {}, pattern::planar},
    {"quilted", "a bump in each unit cube", kQuilted, pattern::quilted, Wave::ramp, 0, true, nullptr, pattern::quilted_relief},
    {"radial", "the angle about the y axis", {}, pattern::radial},
    {"ripples", "the mean of waves from points of the unit sphere", kWaves, pattern::ripples, Wave::ramp, 1, true, pattern::wave_sources, pattern::ripples_relief},
    {"spherical", "1 at the origin, 0 at distance 1 and outside", {}, pattern::spherical},
    {"spiral1", "arms that wind about the z axis", kSpiral, pattern::spiral1, Wave::triangle},
    {"spiral2", "arms that wind both ways", kSpiral, pattern::spiral2, Wave::triangle},
    {"spotted", "noise", {}, pattern::plain_noise, Wave::ramp, 1, true, nullptr, nullptr, SourceKind::none, false, false, pattern::four_noises},
    {"square", "squares of 0 to 3 in the xz plane", {}, pattern::square, Wave::ramp, 0},
    {"triangular", "triangles of 0 to 5 in the xz plane", {}, pattern::triangular, Wave::ramp, 0},
    {"waves", "waves of many lengths from points of the unit sphere", kWaves, pattern::waves, Wave::ramp, 1, true, pattern::wave_sources, pattern::waves_relief},
    {"wood", "the distance from the z axis, moved by turbulence", {}, pattern::wood, Wave::triangle, 1, false},
    {"wrinkles", "ten octaves of noise", {}, pattern::wrinkles, Wave::ramp, 1, true, nullptr, pattern::wrinkles_relief},
};

}  // namespace

std::span<const PatternOps> patterns() { return kPatterns; }

const PatternOps* find_pattern(std::string_view name) {
    for (const PatternOps& row : kPatterns)
        if (name == row.name) return &row;
    return nullptr;
}

}  // namespace alidade
