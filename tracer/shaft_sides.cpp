// SPDX-License-Identifier: Apache-2.0
#include "tracer/shaft_sides.h"

namespace alidade {
namespace {

/// Far more than what rounding moves a surface by, next to the sizes that it is placed with.
constexpr double kPad = 1e-9;

Bounds padded(const Bounds& box, double size) {
    const Vec3 pad(kPad * std::max(size, std::max(max_abs(box.min), max_abs(box.max))));
    return {box.min - pad, box.max + pad};
}

CsgSide side_of_plane(const Plane& plane, const Bounds& box) {
    const Vec3 middle = box.center(), half = box.extent() * 0.5;
    const double size = length(plane.normal), offset = plane.distance * size;
    const double height = dot(plane.normal, middle) - offset, reach = dot(glm::abs(plane.normal), half) + kPad * (dot(glm::abs(plane.normal), glm::abs(middle)) + std::abs(offset));
    return height > reach ? CsgSide::outside : height < -reach ? CsgSide::inside : CsgSide::varies;
}

/// Is the box in what is convex? Of a ball the farthest corner tells it.
bool holds(const Geometry& geometry, const Bounds& box) {
    if (!geometry.bounds.contains(box.min) || !geometry.bounds.contains(box.max)) return false;
    if (const auto* ball = std::get_if<Sphere>(geometry.source)) {
        const Vec3 farthest = glm::max(glm::abs(box.min - ball->center), glm::abs(box.max - ball->center));
        return dot(farthest, farthest) <= (1 - kPad) * ball->radius * ball->radius;
    }
    if (std::holds_alternative<Box>(*geometry.source)) return true;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 at(corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y, corner & 4 ? box.max.z : box.min.z);
        if (!geometry.ops->inside(*geometry.source, at)) return false;
    }
    return true;
}

/// An instance, and boxes in its own space.
struct Local {
    const Instance& instance;
    const Geometry& geometry;
    bool finite;
    double size;

    Local(const CompiledScene& scene, uint32_t id)
        : instance(scene.instances[id]), geometry(scene.geometries[instance.geometry]), finite(geometry.bounds.finite()), size(finite ? std::max(max_abs(geometry.bounds.min), max_abs(geometry.bounds.max)) : 0) {}
    Bounds operator()(const Bounds& box) const { return padded(instance.in_place ? box : instance.to_local.bounds(box), size); }
    const Plane* plane() const { return std::get_if<Plane>(geometry.source); }
};

/// Do all segments between the boxes surely miss the ball? At t they are in a ball around the segment between the middles, with a radius between those of the boxes: its distance from the other ball is a
/// quadratic in t, which is positive all along.
bool misses(const Sphere& ball, const Bounds& from, const Bounds& to) {
    const Vec3 way = to.center() - from.center(), off = ball.center - from.center();
    const double radius = length(from.extent()) * 0.5, widening = length(to.extent()) * 0.5 - radius, touching = std::abs(ball.radius) + radius;
    const double a = dot(way, way) - widening * widening, b = -2 * (dot(off, way) + touching * widening), c = dot(off, off) - touching * touching;
    const double least = kPad * (dot(way, way) + dot(off, off) + touching * touching + widening * widening);   // far more than roundings
    const bool turns = a > 0 && b < 0 && -b < 2 * a;   // the quadratic, between the ends
    return c > least && a + b + c > least && (!turns || c - b * b / (4 * a) > least);
}

/// In the instance's own space its box is tighter than that in the world, where it is turned. Where rays are corrected on their way there, boxes are not: nothing is known.
CsgSide side_of_finite(const Local& local, const Shaft& shaft) {
    const Bounds from = local(shaft.from()), to = local(shaft.to());
    const Instance& instance = local.instance;
    if (!instance.inexact && from.finite() && to.finite()) {
        const auto* ball = std::get_if<Sphere>(local.geometry.source);
        if (ball ? misses(*ball, from, to) : !instance.in_place && !Shaft(from, to).meets(local.geometry.bounds)) return CsgSide::outside;
    }
    return local.geometry.ops->convex && holds(local.geometry, to) && holds(local.geometry, from) ? CsgSide::inside : CsgSide::varies;
}

}  // namespace

bool ShaftSides::leaves_plane(uint32_t id) const {
    const Local local(scene_, id);
    return local.plane() && side_of_plane(*local.plane(), local(shaft_.to())) != CsgSide::varies;
}

CsgSide ShaftSides::side(uint32_t id) const {
    const Local local(scene_, id);
    const Geometry& geometry = local.geometry;
    if (geometry.mesh || geometry.ops->costly) return CsgSide::varies;   // a costly search, once a point, gains nothing
    if (local.plane()) {
        const CsgSide side = side_of_plane(*local.plane(), local(shaft_.to()));
        return id == stood_on_ || side_of_plane(*local.plane(), local(shaft_.from())) == side ? side : CsgSide::varies;
    }
    if (local.finite) return side_of_finite(local, shaft_);
    if (!geometry.ops->narrow) return CsgSide::varies;
    const Bounds hull = local(shaft_.hull());
    if (geometry.ops->narrow(*geometry.source, false, hull).empty()) return CsgSide::outside;
    return geometry.ops->narrow(*geometry.source, true, hull).empty() ? CsgSide::inside : CsgSide::varies;
}

}  // namespace alidade
