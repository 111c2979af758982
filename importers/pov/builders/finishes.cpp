// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/textures.h"

#include "importers/pov/builders/interiors.h"

#include <cmath>

namespace alidade::pov {

namespace {

/// `reflection COLOUR`, or `reflection { COLOUR [, COLOUR] fresnel falloff F exponent E metallic M }`: with one colour the reflection is the same at all
/// angles, but with `fresnel` it begins at none; one colour alone takes back the `fresnel` of a block before (probed).
void take_reflection_block(Build& build, const Block& block, PovFinish& f) {
    Cursor at(build, block);
    std::vector<Color> colours;
    while (colours.size() < 2 && at.at_numeric()) colours.push_back(at.rgb("a reflection"));
    if (colours.empty()) colours.emplace_back(0);   // whatever was before (probed)
    if (colours.size() == 1) f.reflection_fresnel = false;
    while (!at.done()) {
        if (at.accept("fresnel"_w)) f.reflection_fresnel = at.flag();
        else if (at.accept("falloff"_w)) f.reflection_falloff = at.number("the falloff");
        else if (at.accept("exponent"_w)) f.reflection_exponent = double(float(at.number("the exponent")));
        else if (at.accept("metallic"_w)) f.reflection_metallic = at.at_number() ? at.number("metallic") : 1;
        else at.skip_unmodelled();
    }
    f.reflection_max = colours.back();
    f.reflection_min = colours.size() == 2 ? colours[0] : f.reflection_fresnel ? Color(0) : colours[0];
}

/// `irid { AMOUNT thickness T turbulence K }`
void take_irid(Build& build, const Block& block, PovFinish& f) {
    Cursor at(build, block);
    if (at.at_number()) f.irid = at.number("the amount of irid");
    while (!at.done()) {
        if (at.accept("thickness"_w)) f.irid_thickness = at.number("the thickness of the film");
        else if (at.accept("turbulence"_w)) f.irid_turbulence = at.number("the turbulence of the film");
        else at.skip_unmodelled();
    }
}

/// Some numbers are brought to the energy that they stand for, by `albedo` before them: at the end of the block, when the exponents are known.
struct Albedo {
    bool diffuse = false, phong = false, specular = false;

    void apply(PovFinish& f) const {
        const double s = 1 / f.roughness;
        if (diffuse) f.diffuse *= (f.brilliance + 1) / 2, f.diffuse_back *= (f.brilliance + 1) / 2;
        if (phong) f.phong *= (f.phong_size + 1) / 2;
        if (specular) f.specular *= (s + 2) / (4 * (2 - std::pow(2, -s / 2)));
    }
};

double* plain_number(PovFinish& f, WordId word) {
    switch (word) {
        case "brilliance"_w: return &f.brilliance;
        case "phong_size"_w: return &f.phong_size;
        case "roughness"_w: return &f.roughness;
        case "crand"_w: return &f.crand;
        case "reflection_exponent"_w: return &f.reflection_exponent;
        default: return nullptr;
    }
}

/// Words of POV-Ray 3.0, which are those of an interior; its `caustics` are given in other units.
bool take_interior_word(Build& build, Cursor& at, PovFinish& f) {
    const Place place = at.place();
    if (at.accept("ior"_w)) {
        const double ior = at.number("the index of refraction");
        if (ior < 0) f.ior.reset();   // POV-Ray takes it for nothing
        else f.ior = checked_ior(build, ior, place);
    } else if (at.accept("caustics"_w)) f.caustics = at.number("the caustics") / 45;
    else if (at.accept("refraction"_w)) f.refraction = at.number("the refraction");
    else return false;
    return true;
}

bool take_lit(Cursor& at, PovFinish& f, Albedo& albedo) {
    if (at.accept("diffuse"_w)) {
        albedo.diffuse = at.accept("albedo"_w);
        f.diffuse = at.number("diffuse");
        if (at.at_number()) f.diffuse_back = at.number("diffuse of the back");
    } else if (at.accept("phong"_w)) {
        albedo.phong = at.accept("albedo"_w);
        f.phong = at.number("phong");
    } else if (at.accept("specular"_w)) {
        albedo.specular = at.accept("albedo"_w);
        f.specular = at.number("specular");
    } else return false;
    return true;
}

void take_word(Build& build, Cursor& at, PovFinish& f, Albedo& albedo) {
    if (take_lit(at, f, albedo) || take_interior_word(build, at, f)) return;
    if (double* number = at.peek().kind == Item::Kind::word ? plain_number(f, at.peek().word) : nullptr) {
        at.next();
        *number = double(float(at.number("this part of a finish")));   // POV-Ray keeps them in single precision
    } else if (const Block* base = at.block_at("finish"_w)) at.next(), take_declared_finish(build, *base, f), albedo = Albedo();
    else if (const Block* block = at.block_at("reflection"_w)) at.next(), take_reflection_block(build, *block, f);
    else if (const Block* film = at.block_at("irid"_w)) at.next(), take_irid(build, *film, f);
    else if (at.accept("reflection"_w)) f.reflection_min = f.reflection_max = at.rgb("a reflection");
    else if (at.accept("ambient"_w)) f.ambient = at.rgb("the ambient colour");
    else if (at.accept("emission"_w)) f.emission = at.rgb("the emission");
    else if (at.accept("metallic"_w)) f.metallic = at.at_number() ? at.number("metallic") : 1;
    else if (at.accept("conserve_energy"_w)) f.conserve_energy = at.flag();
    else at.skip_unmodelled();
}

}  // namespace

void build_finish(Build& build, const Block& block, PovFinish& f) {
    constexpr double kWidest = 1e9;   // highlights go with the power of one over it
    Albedo albedo;
    for (Cursor at(build, block); !at.done();) take_word(build, at, f, albedo);
    if (f.roughness == 0) build.p.tally(block.place, "a roughness of 0 is none at all: highlights are as wide as can be, as in POV-Ray"), f.roughness = kWidest;
    albedo.apply(f);
}

void take_declared_finish(Build& build, const Block& block, PovFinish& f) {
    PovFinish made = default_texture(build, block.defaults);
    made.pigment = f.pigment, made.normal = f.normal;
    build_finish(build, block, made);
    f = made;
}

}  // namespace alidade::pov
