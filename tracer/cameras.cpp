// SPDX-License-Identifier: Apache-2.0
#include "tracer/cameras.h"

#include "tracer/curved_cameras.h"

#include "tracer/sampler.h"

namespace alidade {

Camera placed(const Camera& camera, const Transform& to_world) {
    Camera out = camera;
    out.location = to_world.point(camera.location);
    out.direction = to_world.vector(camera.direction);
    out.right = to_world.vector(camera.right);
    out.up = to_world.vector(camera.up);
    out.focal_point = to_world.point(camera.focal_point);
    return out;
}

Camera framing_camera(const Bounds& bounds) {
    const Bounds b = bounds.empty() || !bounds.finite() ? Bounds{Vec3(-0.5), Vec3(0.5)} : bounds;
    const double radius = std::max(length(b.extent()) / 2, std::numeric_limits<double>::min());
    constexpr double kHalfAngle = 20 * kPi / 180;
    const Vec3 towards = normalized(Vec3(-0.55, -0.45, -1));
    Camera camera;
    camera.name = "framing";
    camera.direction = towards;
    camera.location = b.center() - towards * (radius / std::sin(kHalfAngle));   // the bounding sphere touches the window's edges
    const Vec3 right = normalized(cross(towards, Vec3(0, 1, 0)));
    const double size = 2 * std::tan(kHalfAngle);
    camera.right = right * size;
    camera.up = cross(right, towards) * size;
    camera.fit = Fit::show_all;
    return camera;
}

Camera fitted(Camera camera, int width, int height) {
    const double own = length(camera.right) / length(camera.up), asked = double(width) / height;
    if (camera.fit == Fit::stretch) return camera;
    if (camera.fit == Fit::height || asked > own) camera.right *= asked / own;
    else camera.up *= own / asked;
    return camera;
}

CameraRays::CameraRays(const Camera& camera, int width, int height) : camera_(fitted(camera, width, height)), width_(width), height_(height) {
    unit_right_ = normalized(camera_.right), unit_up_ = normalized(camera_.up);
    const Vec3 normal = normalized(cross(camera_.right, camera_.up));
    in_focus_ = dot(camera_.focal_point - camera_.location, normal) / dot(camera_.direction, normal);
}

Vec2 CameraRays::bent_at(double x, double y) const { return alidade::bent_at(camera_, x / width_ - 0.5, 0.5 - y / height_); }

Ray CameraRays::at(double x, double y, const Vec2& lens) const {
    const bool plane = camera_.projection == Projection::perspective || camera_.projection == Projection::orthographic;
    Ray ray = plane ? plane_ray(x, y, lens) : curved_ray(camera_, x / width_ - 0.5, 0.5 - y / height_);
    ray.tmin = camera_.clearance;
    return ray;
}

Ray CameraRays::plane_ray(double x, double y, const Vec2& lens) const {
    const Vec3 offset = (x / width_ - 0.5) * camera_.right + (0.5 - y / height_) * camera_.up;
    Ray ray;
    ray.mask = kMaskCamera;
    const bool parallel = camera_.projection == Projection::orthographic;
    ray.origin = parallel ? camera_.location + offset : camera_.location;
    ray.dir = parallel ? camera_.direction : camera_.direction + offset;
    if (!has_lens()) return ray.dir = normalized(ray.dir), ray;
    const Vec2 disc = concentric_disc(lens) * (camera_.aperture / 2);
    const Vec3 from_middle = unit_right_ * disc.x + unit_up_ * disc.y;
    ray.origin += from_middle;
    ray.dir = normalized(ray.dir * in_focus_ - from_middle);
    return ray;
}

}  // namespace alidade
