// SPDX-License-Identifier: Apache-2.0
#include "tools/analytic.h"

#include "core/parallel.h"
#include "tools/verbs.h"

#include <cmath>
#include <fmt/format.h>

namespace alidade::tradeoff {
namespace {

const Color kAlbedo{0.8, 0.5, 0.3}, kGround{1, 0.6, 0.2}, kSky{0.2, 0.5, 1};

/// Adds to a Scene, one call a thing.
struct Maker {
    Scene scene;

    SignalId constant(const Vec4& value) {
        scene.signals.push_back({ConstantSignal{value}, {}});
        return SignalId{uint32_t(scene.signals.size() - 1)};
    }

    /// A perfectly diffuse surface.
    GltfPbr diffuse(const Color& albedo) {
        GltfPbr surface;
        surface.base_color = constant(Vec4(albedo, 1));
        surface.metallic = constant(Vec4(0));
        surface.specular = constant(Vec4(0));
        return surface;
    }

    GltfPbr mirror() {
        GltfPbr surface;
        surface.base_color = constant(Vec4(1));
        surface.metallic = constant(Vec4(1));
        surface.roughness = constant(Vec4(0));
        return surface;
    }

    GltfPbr glowing(const Color& radiance) {
        GltfPbr surface = diffuse(radiance);
        surface.unlit = true;
        return surface;
    }

    void node(Node node) {
        scene.nodes.push_back(std::move(node));
        scene.roots.push_back(NodeId{uint32_t(scene.nodes.size() - 1)});
    }

    void object(ShapeGeometry geometry, const GltfPbr& surface) {
        scene.shapes.push_back({"shape", std::move(geometry), {}});
        scene.materials.push_back({"surface", {surface}, {}});
        Node carrier;
        carrier.what = ShapeId{uint32_t(scene.shapes.size() - 1)};
        carrier.materials = {MaterialId{uint32_t(scene.materials.size() - 1)}};
        node(std::move(carrier));
    }

    void light(decltype(Light::kind) kind, const Color& intensity, const Transform& place) {
        Light light;
        light.kind = kind, light.intensity = intensity;
        scene.lights.push_back(light);
        Node carrier;
        carrier.what = LightId{uint32_t(scene.lights.size() - 1)};
        carrier.to_parent = place;
        node(std::move(carrier));
    }

    /// The picture's window, whatever its pixels then look like.
    void camera(Projection projection, const Vec3& location, const Vec3& direction, const Vec3& right, const Vec3& up) {
        Camera camera;
        camera.projection = projection;
        camera.location = location, camera.direction = direction, camera.right = right, camera.up = up;
        scene.cameras.push_back(camera);
        Node carrier;
        carrier.what = CameraId{uint32_t(scene.cameras.size() - 1)};
        node(std::move(carrier));
    }

    /// Looks down on a square of the plane y = 0 from half a unit above; z of the plane is upwards.
    void camera_above(double side) { camera(Projection::orthographic, {0, 0.5, 0}, {0, -1, 0}, {side, 0, 0}, {0, 0, side}); }
};

/// The point of the plane y = 0 that camera_above() sees.
Vec3 on_plane(double s, double t, double side) { return {(s - 0.5) * side, 0, (0.5 - t) * side}; }

/// Distance along the ray of a unit direction to the unit sphere, or infinity.
double to_sphere(const Vec3& origin, const Vec3& direction) {
    const double b = dot(origin, direction), c = dot(origin, origin) - 1, square = b * b - c;
    return square < 0 || -b - std::sqrt(square) < 0 ? kInf : -b - std::sqrt(square);
}

// ---- A sphere that scatters evenly, lit from a point: albedo / pi * intensity * cos / distance^2 ----

const Vec3 kLamp{2, 3, 4};
constexpr double kLampIntensity = 30, kSphereWindow = 2.4;

Scene lambert_sphere() {
    Maker m;
    m.object(Sphere{}, m.diffuse(kAlbedo));
    m.light(PointLight{}, Color(kLampIntensity), Transform::translate(kLamp));
    m.camera(Projection::orthographic, {0, 0, 5}, {0, 0, -1}, {kSphereWindow, 0, 0}, {0, kSphereWindow, 0});
    return m.scene;
}

/// The unit sphere from along z, in the window of the scenes with one: the point on it, if there is one.
bool on_sphere(double s, double t, Vec3& point) {
    const double x = (s - 0.5) * kSphereWindow, y = (0.5 - t) * kSphereWindow, square = 1 - x * x - y * y;
    if (square < 0) return false;
    point = {x, y, std::sqrt(square)};
    return true;
}

SeenPoint seen_lambert_sphere(double s, double t) {
    Vec3 point{0};
    if (!on_sphere(s, t, point)) return {};
    const Vec3 to_light = kLamp - point;
    const double distance = length(to_light), cosine = dot(point, to_light) / distance;
    return {cosine > 0 ? kAlbedo / kPi * kLampIntensity * cosine / (distance * distance) : Color(0), cosine > 0 ? 2 : 1};
}

// ---- A plane under a sphere of even radiance: the form factor R^2 cos / distance^2 ----

constexpr double kBulb = 0.5, kBulbHeight = 1.5, kPlaneWindow = 4;

Scene sphere_plane() {
    Maker m;
    m.object(Plane{}, m.diffuse(Color(1)));
    m.light(AreaLight{AreaLight::Form::sphere, 1, 1, kBulb}, Color(1), Transform::translate({0, kBulbHeight, 0}));
    m.camera_above(kPlaneWindow);
    return m.scene;
}

SeenPoint seen_sphere_plane(double s, double t) {
    const double distance = length(on_plane(s, t, kPlaneWindow) - Vec3(0, kBulbHeight, 0));
    return {Color(kBulb * kBulb * kBulbHeight / (distance * distance * distance)), 1};
}

// ---- A disc under a parallel one of even radiance; the mean over it is the form factor between both ----

constexpr double kDiscDistance = 1;

Scene disc_disc() {
    Maker m;
    m.object(Disc{}, m.diffuse(Color(1)));
    m.light(AreaLight{AreaLight::Form::disc, 1, 1, 1}, Color(1), Transform::translate({0, kDiscDistance, 0}) * Transform::rotate({1, 0, 0}, -kPi / 2));
    m.camera_above(2);
    return m.scene;
}

SeenPoint seen_disc_disc(double s, double t) {
    const double offset = length(on_plane(s, t, 2));
    return offset > 1 ? SeenPoint{} : SeenPoint{Color(point_to_disc(offset, kDiscDistance, 1)), 1};
}

// ---- White in white: whatever scatters all light, under an even sky, is not seen ----

Scene furnace() {
    Maker m;
    m.object(Sphere{}, m.diffuse(Color(1)));
    m.scene.atmosphere.environment = Color(1);
    m.camera(Projection::orthographic, {0, 0, 5}, {0, 0, -1}, {kSphereWindow, 0, 0}, {0, kSphereWindow, 0});
    return m.scene;
}

SeenPoint seen_furnace(double, double) { return {Color(1), 0}; }

// ---- A mirror on a glowing plane: where the horizon is in it ----

const Vec3 kMirrorEye{0, 1, 5};
constexpr double kMirrorWindow = 0.55;

Scene mirror_sphere() {
    Maker m;
    m.object(Sphere{}, m.mirror());
    m.object(Plane{{0, 1, 0}, -1}, m.glowing(kGround));
    m.scene.atmosphere.environment = kSky;
    const Vec3 forward = normalized(-kMirrorEye), right{1, 0, 0};
    m.camera(Projection::perspective, kMirrorEye, forward, right * kMirrorWindow, cross(right, forward) * kMirrorWindow);
    return m.scene;
}

SeenPoint seen_mirror_sphere(double s, double t) {
    const Vec3 forward = normalized(-kMirrorEye), right{1, 0, 0}, up = cross(right, forward);
    Vec3 direction = normalized(forward + right * ((s - 0.5) * kMirrorWindow) + up * ((0.5 - t) * kMirrorWindow));
    const double distance = to_sphere(kMirrorEye, direction);
    const bool mirrored = distance < kInf;
    if (mirrored) {
        const Vec3 normal = kMirrorEye + direction * distance;
        direction = direction - normal * (2 * dot(normal, direction));
    }
    const bool ground = direction.y < 0;
    return {ground ? kGround : kSky, 2 * int(mirrored) + int(ground)};
}

constexpr AnalyticScene kScenes[] = {
    {"lambert-sphere", "a diffuse sphere lit from a point", lambert_sphere, seen_lambert_sphere},
    {"sphere-plane", "a plane lit by a sphere: form factors in closed form", sphere_plane, seen_sphere_plane},
    {"disc-disc", "a disc lit by a parallel one: the mean is the form factor between both", disc_disc, seen_disc_disc},
    {"furnace", "a white sphere in a white sky, which is not seen", furnace, seen_furnace},
    {"mirror-sphere", "a mirror on a glowing plane, under a sky of one colour", mirror_sphere, seen_mirror_sphere},
};

constexpr std::string_view kPrefix = "analytic:";

/// `count` x `count` points of a pixel. False if not all of them are of one piece.
bool sum_of_points(const AnalyticScene& scene, int x, int y, const Picture& picture, int count, Color& sum) {
    bool even = true;
    int piece = 0;
    sum = Color(0);
    for (int i = 0; i < count; ++i)
        for (int j = 0; j < count; ++j) {
            const SeenPoint seen = scene.seen((x + (j + 0.5) / count) / picture.width, (y + (i + 0.5) / count) / picture.height);
            if (i + j == 0) piece = seen.piece;
            even = even && seen.piece == piece;
            sum = sum + seen.radiance;
        }
    return even;
}

}  // namespace

std::span<const AnalyticScene> analytic_scenes() { return kScenes; }

bool is_analytic(std::string_view scene) { return scene.starts_with(kPrefix); }

const AnalyticScene* find_analytic(std::string_view scene) {
    for (const AnalyticScene& row : kScenes)
        if (is_analytic(scene) && scene.substr(kPrefix.size()) == row.name) return &row;
    return nullptr;
}

Value<Scene> analytic_scene(const std::string& name) {
    if (const AnalyticScene* row = find_analytic(name)) return row->scene();
    std::vector<std::string> names;
    for (const AnalyticScene& row : kScenes) names.push_back(fmt::format("{}{}", kPrefix, row.name));
    const std::string near = nearest(name, names);
    return tl::unexpected(fmt::format("there is no scene '{}'{}; there are {}", name, near.empty() ? "" : fmt::format(", did you mean '{}'?", near), fmt::join(names, ", ")));
}

Picture analytic_picture(const AnalyticScene& scene, int width, int height) {
    Picture picture(width, height, {"R", "G", "B"});
    parallel_for(size_t(height), 0, [&](size_t row) {
        for (int x = 0; x < width; ++x) {
            Color sum;
            int count = 16;
            if (!sum_of_points(scene, x, int(row), picture, count, sum)) sum_of_points(scene, x, int(row), picture, count = 256, sum);
            for (int c = 0; c < 3; ++c) picture.at(x, int(row))[c] = float(sum[c] / (double(count) * count));
        }
    });
    return picture;
}

double disc_to_disc(double radius1, double radius2, double distance) {
    const double a = radius1 / distance, b = radius2 / distance, x = 1 + (1 + b * b) / (a * a);
    return 0.5 * (x - std::sqrt(x * x - 4 * (b / a) * (b / a)));
}

double point_to_disc(double offset, double distance, double radius) {
    const double h = distance / radius, a = offset / radius, sum = a * a + h * h + 1;
    return 0.5 * (1 - (a * a + h * h - 1) / std::sqrt(sum * sum - 4 * a * a));
}

}  // namespace alidade::tradeoff
