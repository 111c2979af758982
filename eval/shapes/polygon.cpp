// SPDX-License-Identifier: Apache-2.0
#include "eval/shapes/approach.h"
#include "eval/shapes/implicit.h"

namespace alidade {

namespace {

Bounds polygon_bounds(const ShapeGeometry& geometry) { return bounds(geometry); }

/// A polygon seen along the axis that its normal is nearest to, relative to its first point.
class FlatView {
  public:
    FlatView(const Polygon& polygon, const Vec3& normal) : polygon_(polygon), first_(polygon.loops.front().front()) {
        const Vec3 size = glm::abs(normal);
        const int across = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
        u_ = (across + 1) % 3, v_ = (across + 2) % 3;
    }

    /// Does an odd number of loops surround the point? Sides that end at its height count once for both, so that no line through a corner counts wrongly.
    bool holds(const Vec3& from_first) const {
        bool odd = false;
        for (const auto& loop : polygon_.loops) {
            if (loop.empty()) continue;
            Vec3 a = loop.back() - first_;
            for (const Vec3& point : loop) {
                const Vec3 b = point - first_;
                if ((a[v_] > from_first[v_]) != (b[v_] > from_first[v_]) && from_first[u_] < a[u_] + (from_first[v_] - a[v_]) / (b[v_] - a[v_]) * (b[u_] - a[u_])) odd = !odd;
                a = b;
            }
        }
        return odd;
    }

  private:
    const Polygon& polygon_;
    Vec3 first_;
    int u_, v_;
};

/// A bound on the distance of ray.at(t) from the plane: the height found by evaluating it there, and the roundings of that (of the unit normal, the
/// difference and the product) and of ray.at(t).
ErrorBound polygon_error(const ShapeGeometry& geometry, const Ray& ray, double t, uint32_t) {
    const Polygon& polygon = std::get<Polygon>(geometry);
    const Vec3 p = ray.at(t) - polygon.loops.front().front();
    return {std::abs(dot(normal_of(polygon), p)) + gamma_bound(10) * length(p) + at_rounding(ray, t)};
}

/// Units    the shape's space; `t` counts multiples of |ray.dir|.
/// Method   the ray is moved to its point nearest to the polygon's first point; then the plane, then the loops, by the number of sides on one side.
/// Error    of t: <= 4 units of 2^-52 (|t| + size / |d|) / cosine of the angle to the normal, as a disc's. Held by tests/eval/polygon_test.cpp.
Crossings polygon_crossings(const ShapeGeometry& geometry, const Ray& ray) {
    const Polygon& polygon = std::get<Polygon>(geometry);
    Crossings out;
    const Vec3 normal = normal_of(polygon);
    if (!is_finite(normal) || normal == Vec3(0) || polygon.loops.front().empty()) return out;
    const Vec3 first = polygon.loops.front().front();
    const Approach p = approach(first, ray);
    const double way = -dot(normal, p.nearest) / dot(normal, ray.dir);
    if (!is_finite(ray) || !std::isfinite(p.shift) || !std::isfinite(way) || !FlatView(polygon, normal).holds(p.nearest + way * ray.dir)) return out;
    const LineInterval inside = inside_bounds(ray, bounds(geometry));
    if (inside.empty()) return out;
    out.add(std::clamp(p.shift + (p.rest + way), inside.entry, inside.exit), 0);
    return out;
}

SurfacePoint polygon_surface(const ShapeGeometry& geometry, const Vec3& point, uint32_t) {
    const Vec3 normal = normal_of(std::get<Polygon>(geometry));
    return flat_mapped(normal == Vec3(0) ? Vec3(0, 0, 1) : normal, point);
}

bool polygon_inside(const ShapeGeometry&, const Vec3&) { return false; }
bool polygon_solid(const ShapeGeometry&) { return false; }

}  // namespace

const ShapeOps kPolygonOps = {.name = "polygon", .doc = "a flat face between loops", .kind = kind_of<Polygon>(), .bounds = polygon_bounds, .crossings = polygon_crossings,
                              .error = polygon_error, .surface = polygon_surface, .inside = polygon_inside, .solid = polygon_solid, .sheet = true};

}  // namespace alidade
