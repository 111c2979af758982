// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/shapes.h"

#include "core/transform.h"

namespace alidade::pov {

namespace {

BuiltShape sphere(Build&, Cursor& at) {
    Sphere s;
    s.center = at.vector("the centre of a sphere"), s.radius = at.number("the radius of a sphere");
    return {s, {}};
}

BuiltShape plane(Build& build, Cursor& at) {
    const Place place = at.place();
    Plane s;
    s.normal = at.vector("the normal of a plane"), s.distance = at.number("the distance of a plane");
    if (length(s.normal) == 0) build.p.fail(place, "the normal of a plane has no length");
    return {s, {}};
}

BuiltShape box(Build&, Cursor& at) {
    Box s;
    s.a = at.vector("a corner of a box"), s.b = at.vector("a corner of a box");
    return {s, {}};
}

void check_axis(Build& build, Place place, const Vec3& a, const Vec3& b, const char* sentence) {
    if (a == b) build.p.fail(place, sentence, "give it two different ends, or use a disc");
}

BuiltShape cylinder(Build& build, Cursor& at) {
    const Place place = at.place();
    Cylinder s;
    s.a = at.vector("the base of a cylinder"), s.b = at.vector("the cap of a cylinder"), s.radius = at.number("the radius of a cylinder");
    s.open = at.accept("open"_w);
    check_axis(build, place, s.a, s.b, "the cylinder has no length");
    return {s, {}};
}

BuiltShape cone(Build& build, Cursor& at) {
    const Place place = at.place();
    Cone s;
    s.a = at.vector("the base of a cone"), s.radius_a = at.number("the radius of a cone's base");
    s.b = at.vector("the cap of a cone"), s.radius_b = at.number("the radius of a cone's cap");
    s.open = at.accept("open"_w);
    check_axis(build, place, s.a, s.b, "the cone has no length");
    return {s, {}};
}

BuiltShape disc(Build& build, Cursor& at) {
    const Place place = at.place();
    Disc s;
    s.center = at.vector("the centre of a disc"), s.normal = at.vector("the normal of a disc"), s.radius = at.number("the radius of a disc");
    if (at.at_number()) s.hole = at.number("the radius of a disc's hole");
    if (length(s.normal) == 0) build.p.tally(place, "a disc whose normal has no length is a point, not seen as in POV-Ray"), s.normal = Vec3(0, 0, 1), s.radius = s.hole = 0;
    return {s, {}};
}

BuiltShape torus(Build&, Cursor& at) {
    Torus s;
    s.major = at.number("the major radius of a torus"), s.minor = at.number("the minor radius of a torus");
    return {s, {}};
}

struct ShapeRow {
    WordId word;
    BuiltShape (*build)(Build&, Cursor&);
};

constexpr ShapeRow kShapes[] = {
    {"sphere"_w, sphere}, {"plane"_w, plane}, {"box"_w, box}, {"cylinder"_w, cylinder}, {"cone"_w, cone}, {"disc"_w, disc}, {"torus"_w, torus},
    {"quadric"_w, build_quadric}, {"cubic"_w, build_cubic}, {"quartic"_w, build_quartic}, {"poly"_w, build_poly}, {"polynomial"_w, build_polynomial}, {"polygon"_w, build_polygon},
    {"triangle"_w, build_triangle}, {"smooth_triangle"_w, build_smooth_triangle}, {"mesh"_w, build_mesh}, {"mesh2"_w, build_mesh2},
};

}  // namespace

std::optional<BuiltShape> build_shape(Build& build, WordId word, Cursor& at) {
    for (const ShapeRow& row : kShapes)
        if (row.word == word) return row.build(build, at);
    return std::nullopt;
}

}  // namespace alidade::pov
