// SPDX-License-Identifier: Apache-2.0
#include "eval/shapes/approach.h"
#include "eval/shapes/outlines.h"
#include "eval/shapes/rows.h"

namespace alidade {

namespace {

/// Parts: the two flat faces, then for each arc the side above it, with the inside on its left (even) or on its right (odd).
constexpr uint32_t kLow = 0, kHigh = 1, kFirstSide = kExtrusionSides;

struct Slab {
    double low, high;
    explicit Slab(const Extrusion& e) : low(std::min(e.bottom, e.top)), high(std::max(e.bottom, e.top)) {}
};

Bounds extrusion_bounds(const ShapeGeometry& geometry) { return bounds(geometry); }

/// The end of a stretch of a line inside the solid.
struct End {
    double s;
    uint32_t part;
};

uint32_t side_of(const Cut& cut, bool entry) { return kFirstSide + 2 * cut.arc + (entry == (cut.turn > 0) ? 1 : 0); }

/// A line relative to the middle of the shape's box: p + s d, and the crossings on it.
class OutlineLine {
  public:
    OutlineLine(const Extrusion& e, const Ray& ray, const Approach& nearest, const Vec3& center, const LineInterval& inside)
        : e_(e), ray_(ray), nearest_(nearest), center_(center), inside_(inside) {}

    Crossings crossings() {
        const Slab slab(e_);
        const Vec3 p = nearest_.nearest, d = ray_.dir;
        End enter{-kInf, kLow}, leave{kInf, kHigh};
        if (d.z != 0) {
            enter.s = (slab.low - center_.z - p.z) / d.z, leave.s = (slab.high - center_.z - p.z) / d.z;
            if (d.z < 0) std::swap(enter, leave);
        } else if (!(slab.low <= p.z + center_.z && p.z + center_.z <= slab.high)) {
            return out_;
        }
        if (d.x * d.x + d.y * d.y < std::numeric_limits<double>::min()) {   // the shadow is a point
            if (outlines_hold(e_, Vec2(center_.x + p.x, center_.y + p.y))) add_stretch(enter, leave);
        } else {
            add_stretches(enter, leave);
        }
        return out_;
    }

  private:
    /// The stretches of the line's shadow inside the outlines, cut to the part between the flat faces.
    void add_stretches(const End& enter, const End& leave) {
        std::byte space[2048];
        std::pmr::monotonic_buffer_resource memory(space, sizeof space);
        const Vec2 origin(center_.x, center_.y);
        int winding = 0, count = 0;
        End from = enter;
        for (const Cut& cut : cuts_of(e_, origin, Vec2(nearest_.nearest.x, nearest_.nearest.y), Vec2(ray_.dir.x, ray_.dir.y), memory)) {
            const bool was_inside = is_inside(e_, winding, count);
            winding += cut.turn, ++count;
            const bool now_inside = is_inside(e_, winding, count);
            if (was_inside == now_inside) continue;
            const End end{cut.s, side_of(cut, now_inside)};
            if (now_inside) from = end.s > enter.s ? end : enter;
            else add_stretch(from, end.s < leave.s ? end : leave);
        }
    }

    void add_stretch(const End& from, const End& to) {
        if (!(from.s <= to.s)) return;
        add(from), add(to);
    }

    void add(const End& end) {
        out_.add(std::clamp(nearest_.shift + (nearest_.rest + end.s), inside_.entry, inside_.exit), end.part);
    }

    const Extrusion& e_;
    const Ray& ray_;
    const Approach& nearest_;
    const Vec3& center_;
    const LineInterval& inside_;
    Crossings out_;
};

/// Units    the shape's space; `t` counts multiples of |ray.dir|.
/// Method   the ray is moved to its point nearest to the middle of the box. Its shadow in the plane of the outlines is cut by the arcs, quadratic equations
///          in which only the distances of the control points from the line stand; the stretches inside are then cut to those between the flat faces, so
///          that crossings always pair.
/// Error    of t: <= 8 units of 2^-52 (|t| + size / |d|) / cosine of the angle to the normal. Held by tests/eval/extrusion_test.cpp.
Crossings extrusion_crossings(const ShapeGeometry& geometry, const Ray& ray) {
    const Extrusion& e = std::get<Extrusion>(geometry);
    const Bounds box = bounds(geometry);
    if (!is_finite(ray) || !box.finite()) return {};
    const LineInterval inside = inside_bounds(ray, box);
    const Vec3 center = box.center();
    const Approach nearest = approach(center, ray);
    if (inside.empty() || !std::isfinite(nearest.shift)) return {};
    return OutlineLine(e, ray, nearest, center, inside).crossings();
}

/// The distance from the plane of a flat face, or from the point of the arc that is nearest.
ErrorBound extrusion_error(const ShapeGeometry& geometry, const Ray& ray, double t, uint32_t part) {
    const Extrusion& e = std::get<Extrusion>(geometry);
    const Vec3 p = ray.at(t);
    const Slab slab(e);
    double off;
    if (part < kFirstSide) {
        off = std::abs(p.z - (part == kLow ? slab.low : slab.high));
    } else {
        const Vec2 at(p.x, p.y);
        const BezierArc arc = arc_of(e, (part - kFirstSide) / 2, at);
        const Vec2 nearest = arc.at(arc.nearest(Vec2(0)));
        const Vec2 size = glm::abs(at) + glm::abs(arc.a) + glm::abs(arc.control) + glm::abs(arc.b);   // which the roundings are relative to
        off = std::hypot(nearest.x, nearest.y) + gamma_bound(8) * (size.x + size.y);
    }
    return {(1 + gamma_bound(4)) * off + at_rounding(ray, t)};
}

SurfacePoint extrusion_surface(const ShapeGeometry& geometry, const Vec3& point, uint32_t part) {
    SurfacePoint out;
    out.uv = {point.x, point.y};
    out.normal = {0, 0, part == kLow ? -1 : 1};
    if (part < kFirstSide) return out;
    const Vec2 at(point.x, point.y);
    const BezierArc arc = arc_of(std::get<Extrusion>(geometry), (part - kFirstSide) / 2, at);
    const Vec2 tangent = arc.tangent(arc.nearest(Vec2(0)));
    const bool inside_is_right = (part - kFirstSide) % 2 != 0;
    out.normal = normalized(inside_is_right ? Vec3(-tangent.y, tangent.x, 0) : Vec3(tangent.y, -tangent.x, 0));
    out.dpdu = {-out.normal.y, out.normal.x, 0}, out.dpdv = {0, 0, 1};
    return out;
}

bool extrusion_inside(const ShapeGeometry& geometry, const Vec3& point) {
    const Extrusion& e = std::get<Extrusion>(geometry);
    const Slab slab(e);
    return slab.low <= point.z && point.z <= slab.high && outlines_hold(e, Vec2(point.x, point.y));
}

}  // namespace

const ShapeOps kExtrusionOps = {"extrusion", "outlines with a depth: letters", kind_of<Extrusion>(), extrusion_bounds, extrusion_crossings, extrusion_error, extrusion_surface, extrusion_inside, always_solid, nullptr, true};

}  // namespace alidade
