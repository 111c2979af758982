// SPDX-License-Identifier: Apache-2.0
#include "tracer/curved_cameras.h"

#include <cmath>
#include <optional>

namespace alidade {
namespace {

/// The camera's unit vectors, and how long right and up were.
struct Axes {
    Vec3 right, up, ahead;
    double wide, high;

    explicit Axes(const Camera& c) : right(normalized(c.right)), up(normalized(c.up)), ahead(normalized(c.direction)), wide(length(c.right)), high(length(c.up)) {}
    /// The direction `theta` away from ahead, towards the point (a, b) of the picture, which is `rho` from its centre.
    Vec3 around(double a, double b, double rho, double theta) const {
        const double k = rho > 0 ? std::sin(theta) / rho : 0;
        return (a * k) * right + (b * k) * up + std::cos(theta) * ahead;
    }
};

double angle_of(const Camera& c) { return c.angle * kPi / 180; }
double vertical_angle_of(const Camera& c) { return c.vertical_angle != 0 ? c.vertical_angle * kPi / 180 : angle_of(c) / 2; }

Vec2 fisheye_film(const Axes& axes, double s, double t) { return {2 * s * axes.wide, 2 * t * axes.high}; }

std::optional<Vec3> fisheye(const Camera& c, const Axes& axes, double s, double t) {
    const Vec2 film = fisheye_film(axes, s, t);
    const double rho = length(film);
    if (rho > 1) return std::nullopt;
    return axes.around(film.x, film.y, rho, rho * angle_of(c) / 2);
}

/// The point of the film, whose edge is 1 from its centre.
Vec2 omnimax_film(const Axes& axes, double s, double t) {
    constexpr double kFilm = 1.283458;       // the film's own aspect ratio
    const double aspect = axes.wide / axes.high, a = 2 * s, b = 2 * t;
    if (aspect > kFilm) return {a * (aspect / kFilm), (b - 1) / kFilm + 1};
    if (aspect > 1) return {a, (b - 1) / aspect + 1};
    return {a, b / aspect};
}

/// How far from ahead the omnimax ray is that is `rho` from the film's centre.
double omnimax_angle(double rho) {
    const double r2 = rho * rho;
    return rho * (1.411269 - 0.09439 * r2 + 0.25674 * r2 * r2);
}

std::optional<Vec3> omnimax(const Axes& axes, double s, double t) {
    const Vec2 film = omnimax_film(axes, s, t);
    const double rho = length(film), theta = omnimax_angle(rho);
    if (rho > 1) return std::nullopt;
    if (rho > 0 && film.y / rho * std::sin(theta) < -std::cos(theta)) return std::nullopt;
    return axes.around(film.x, film.y, rho, theta);
}

/// Around the film's centre from the right, -pi/2 to 3 pi/2.
double bearing(const Vec2& film) {
    const double rho = length(film), up = rho > 0 ? std::asin(film.y / rho) : 0;
    return film.x < 0 ? kPi - up : up;
}

/// `v` turned by `angle` about the unit vector `k`. Source   Rodrigues' formula.
Vec3 turned(const Vec3& v, const Vec3& k, double angle) {
    return v * std::cos(angle) + cross(k, v) * std::sin(angle) + k * (dot(k, v) * (1 - std::cos(angle)));
}

/// A picture rolled around the camera: around `up` in the kinds 1 and 3, around `right` in 2 and 4. The film is flat along the axis; in 3 and 4 rays are level.
Vec3 cylindrical(const Camera& c, const Axes& axes, double s, double t) {
    const bool upright = c.cylinder % 2 == 1, level = c.cylinder > 2;
    const double angle = (upright ? s : t) * angle_of(c);
    const Vec3 along = upright ? t * axes.high * axes.up : s * axes.wide * axes.right;
    return std::sin(angle) * (upright ? axes.right : axes.up) + std::cos(angle) * axes.ahead + (level ? Vec3(0) : along);
}

/// Where the ray begins: on the axis of the cylinders 3 and 4, else at the camera.
Vec3 origin(const Camera& c, double s, double t) {
    if (c.projection != Projection::cylindrical || c.cylinder < 3) return c.location;
    return c.location + (c.cylinder == 3 ? t * c.up : s * c.right);
}

Vec3 spherical(const Camera& c, const Axes& axes, double s, double t) {
    return turned(turned(axes.ahead, axes.right, -t * vertical_angle_of(c)), axes.up, s * angle_of(c));
}

std::optional<Vec3> direction(const Camera& c, double s, double t) {
    const Axes axes(c);
    const double a = s * angle_of(c), b = t * angle_of(c) * axes.high / axes.wide;
    switch (c.projection) {
        case Projection::fisheye: return fisheye(c, axes, s, t);
        case Projection::omnimax: return omnimax(axes, s, t);
        case Projection::ultra_wide_angle: return std::sin(a) * axes.right + std::sin(b) * axes.up + std::cos(a) * std::cos(b) * axes.ahead;
        case Projection::panoramic: return std::cos((0.5 - s) * kPi) * c.right + std::tan(kPi * t) * c.up + std::sin((0.5 - s) * kPi) * c.direction;
        case Projection::cylindrical: return cylindrical(c, axes, s, t);
        default: return spherical(c, axes, s, t);
    }
}

}  // namespace

Vec2 bent_at(const Camera& c, double s, double t) {
    const Axes axes(c);
    const double a = s * angle_of(c);
    const Vec2 film = c.projection == Projection::omnimax ? omnimax_film(axes, s, t) : fisheye_film(axes, s, t);
    switch (c.projection) {
        case Projection::fisheye: return {bearing(film), length(film) * angle_of(c) / 2};
        case Projection::omnimax: return {bearing(film), omnimax_angle(length(film))};
        case Projection::ultra_wide_angle: return {a, t * angle_of(c) * axes.high / axes.wide};
        case Projection::panoramic: return {kPi * (0.5 - s), kPi * t};
        case Projection::cylindrical: return c.cylinder % 2 == 1 ? Vec2(a, t * axes.high) : Vec2(s * axes.wide, t * angle_of(c));
        case Projection::spherical: return {a, t * vertical_angle_of(c)};
        default: return {s, t};
    }
}

Ray curved_ray(const Camera& camera, double s, double t) {
    Ray ray;
    ray.mask = kMaskCamera;
    ray.origin = origin(camera, s, t);
    const std::optional<Vec3> d = direction(camera, s, t);
    ray.dir = d ? normalized(*d) : normalized(camera.direction);
    if (!d) ray.tmin = 0, ray.tmax = -1;
    return ray;
}

}  // namespace alidade
