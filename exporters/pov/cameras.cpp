// SPDX-License-Identifier: Apache-2.0
#include "exporters/pov/cameras.h"

#include "exporters/pov/paths.h"
#include "scene/queries.h"

#include <fmt/format.h>

namespace alidade::pov_export {

namespace {

constexpr const char* kProjections[] = {"perspective", "orthographic", "fisheye", "ultra_wide_angle", "omnimax", "panoramic", "cylinder", "spherical"};

bool is_flat(const Camera& c) { return c.projection == Projection::perspective || c.projection == Projection::orthographic; }

Camera placed(const Camera& camera, const Transform& to_world) {
    Camera out = camera;
    out.location = to_world.point(camera.location);
    out.direction = to_world.vector(camera.direction), out.right = to_world.vector(camera.right), out.up = to_world.vector(camera.up);
    out.focal_point = to_world.point(camera.focal_point);
    return out;
}

/// POV-Ray warns of axes that are not perpendicular: those that are but for the rounding of a matrix in a file are made so.
void straighten(Camera& c, Losses& losses) {
    constexpr double kRounding = 1e-5;
    const auto slant = [](const Vec3& a, const Vec3& b) { return std::abs(dot(a, b)) / (length(a) * length(b)); };
    const double worst = std::max({slant(c.right, c.direction), slant(c.up, c.direction), slant(c.up, c.right)});
    if (!(worst > 1e-10) || !is_flat(c)) return;
    if (worst > kRounding) return losses.add("sheared cameras", 1, "as they are, which POV-Ray warns of");
    const Vec3 towards = normalized(c.direction), right = c.right - dot(c.right, towards) * towards;
    const Vec3 across = normalized(cross(right, towards));
    c.right = right, c.up = across * dot(c.up, across);
}

/// From the upper front, with y upwards; the bounding sphere touches the window's edges.
Camera framing_camera(const Bounds& bounds) {
    constexpr double kHalfAngle = 20 * kPi / 180;
    const Bounds b = bounds.empty() || !bounds.finite() ? Bounds{Vec3(-0.5), Vec3(0.5)} : bounds;
    const double radius = std::max(length(b.extent()) / 2, 1e-9), size = 2 * std::tan(kHalfAngle);
    const Vec3 towards = normalized(Vec3(-0.55, -0.45, -1)), right = normalized(cross(towards, Vec3(0, 1, 0)));
    Camera camera;
    camera.direction = towards, camera.location = b.center() - towards * (radius / std::sin(kHalfAngle));
    camera.right = right * size, camera.up = cross(right, towards) * size;
    camera.fit = Fit::show_all;
    return camera;
}

/// The window's sides: in its own shape, or with the picture's where that is wider or higher.
void write_window(const Camera& c, Sdl& sdl) {
    const double own = length(c.right) / length(c.up);
    if (c.fit == Fit::stretch || !(own > 0) || !std::isfinite(own)) {
        sdl.line("right", c.right);
        sdl.line("up", c.up);
    } else if (c.fit == Fit::height) {
        sdl.line("right", c.right, "* (image_width / image_height /", own, ")");
        sdl.line("up", c.up);
    } else {
        sdl.line("right", c.right, "* max(1, image_width / image_height /", own, ")");
        sdl.line("up", c.up, "* max(1,", own, "/ (image_width / image_height))");
    }
}

void write_lens(const Camera& c, const RenderSettings& settings, Sdl& sdl) {
    if (!(c.aperture > 0)) return;
    constexpr int kSamples = 37;
    const LensNoise noise = settings.lens_noise.value_or(LensNoise());
    sdl.line("aperture", c.aperture * 2, "focal_point", c.focal_point);   // POV-Ray's lens is half as wide
    const int most = c.blur_samples > 0 ? c.blur_samples : kSamples;
    if (noise.fewest > 0) sdl.line("blur_samples", noise.fewest, ",", most);
    else sdl.line("blur_samples", most);
    sdl.line("variance", noise.variance, "confidence", noise.confidence);
}

void write_camera(const Camera& c, const RenderSettings& settings, Sdl& sdl, PatternWriter& patterns) {
    sdl.comment(c.name);
    sdl.begin("camera");
    if (c.projection == Projection::cylindrical) sdl.line("cylinder", c.cylinder);
    else sdl.line(kProjections[int(c.projection)]);
    sdl.line("location", c.location);
    sdl.line("direction", c.direction);
    write_window(c, sdl);
    if (c.projection == Projection::spherical) {
        if (c.vertical_angle != 0) sdl.line("angle", c.angle, ",", c.vertical_angle);
        else sdl.line("angle", c.angle);
    } else if (!is_flat(c)) sdl.line("angle", c.angle);
    write_lens(c, settings, sdl);
    if (c.normal) patterns.normal_block(*c.normal);
    sdl.end();
}

}  // namespace

Cameras cameras_of(const Scene& scene, Losses& losses) {
    constexpr size_t kMost = 1000;
    Cameras out;
    const auto is_camera = [](const Node& node) { return std::holds_alternative<CameraId>(node.what); };
    const bool all = for_each_path(scene, is_camera, kMost, [&](const Node& node, const Transform& to_world) {
        Camera camera = placed(scene.cameras[std::get<CameraId>(node.what).index], to_world);
        if (!to_world.is_identity()) straighten(camera, losses);   // POV-Ray's own stay as they are
        out.all.push_back(std::move(camera));
    });
    losses.add("cameras beyond a thousand", !all);
    losses.add("further cameras", out.all.empty() ? 0 : out.all.size() - 1, "declared, as Camera_2 and so on: the first is looked through");
    if (out.all.empty()) out.all.push_back(framing_camera(world_bounds(scene)));
    return out;
}

void write_cameras(const Cameras& cameras, const RenderSettings& settings, Sdl& sdl, PatternWriter& patterns) {
    for (size_t i = 0; i < cameras.all.size(); ++i) {
        if (i > 0) sdl.line(fmt::format("#declare Camera_{} =", i + 1));
        write_camera(cameras.all[i], settings, sdl, patterns);
    }
}

}  // namespace alidade::pov_export
