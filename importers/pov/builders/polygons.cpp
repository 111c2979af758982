// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/shapes.h"

namespace alidade::pov {

namespace {

/// A loop ends where its first point comes again; the last one also where the points end.
std::vector<std::vector<Vec3>> loops_of(Build& build, const std::vector<Vec3>& points, Place place) {
    std::vector<std::vector<Vec3>> loops;
    bool open = false;
    for (const Vec3& p : points) {
        if (!open) loops.emplace_back();
        std::vector<Vec3>& loop = loops.back();
        open = !open || p != loop.front();
        if (open) loop.push_back(p);
    }
    if (open) build.p.tally(place, "the polygon is not closed: a side leads back to its first point");
    return loops;
}

/// POV-Ray leaves out a polygon with a point farther from its plane.
constexpr double kFlat = 5e-10;

bool is_flat(const Polygon& polygon) {
    const Vec3 normal = normal_of(polygon);
    for (const auto& loop : polygon.loops)
        for (const Vec3& p : loop)
            if (std::abs(dot(normal, p - polygon.loops.front().front())) > kFlat) return false;
    return true;
}

}  // namespace

BuiltShape build_polygon(Build& build, Cursor& at) {
    const Place place = at.place();
    const double count = at.number("the number of points of a polygon");
    if (!(count >= 3)) build.p.fail(place, "a polygon has at least three points");
    std::vector<Vec3> points;
    while (double(points.size()) + 1 <= count) points.push_back(at.vector("a point of a polygon"));
    Polygon polygon;
    polygon.loops = loops_of(build, points, place);
    if (is_flat(polygon)) return {std::move(polygon), {}};
    build.p.tally(place, "a polygon whose points are not in one plane is left out, as POV-Ray does");
    return {Polygon{{}}, {}};
}

}  // namespace alidade::pov
