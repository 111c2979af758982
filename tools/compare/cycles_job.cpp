// SPDX-License-Identifier: Apache-2.0
#include "tools/compare/cycles_job.h"

#include "core/image.h"
#include "scene/queries.h"
#include "tracer/cameras.h"
#include "tracer/compiled_scene.h"
#include "tracer/sky.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alidade {
namespace {

Json to_json(const Vec3& v) { return {v.x, v.y, v.z}; }

/// What is nearer to the eye is not seen: Cycles wants a limit.
double near_limit(const Scene& scene, const Vec3& eye) {
    const Bounds box = world_bounds(scene);
    const double reach = box.empty() || !box.finite() ? 0 : length(box.center() - eye) + length(box.extent());
    return std::max(1e-6 * reach, 1e-6);
}

tl::expected<Json, std::string> camera_json(const Camera& c, const Scene& scene) {
    if (c.projection != Projection::perspective && c.projection != Projection::orthographic)
        return tl::unexpected(std::string("Cycles is asked for perspective and orthographic cameras only, and the scene's is another"));
    const Vec3 right = normalized(c.right), up = normalized(c.up);
    if (std::abs(dot(right, up)) > 1e-6) return tl::unexpected(std::string("Cycles has no camera whose window is skew"));
    const Vec3 normal = normalized(cross(c.right, c.up)), back = dot(normal, c.direction) > 0 ? -normal : normal;
    const double width = length(c.right), ahead = -dot(c.direction, back), aspect = length(c.up) / width;
    const bool parallel = c.projection == Projection::orthographic;
    return Json{{"projection", parallel ? "orthographic" : "perspective"}, {"location", to_json(c.location)},
                {"right", to_json(right)}, {"up", to_json(up)}, {"back", to_json(back)},
                {"width", parallel ? width : width / ahead}, {"aspect", aspect}, {"near", near_limit(scene, c.location)},
                {"shift", parallel ? Json{0, 0} : Json{dot(c.direction, right) / width, dot(c.direction, up) / width}},
                {"aperture", parallel ? 0 : c.aperture}, {"focus", -dot(c.focal_point - c.location, back)}};
}

/// A sky of more than one colour, as the picture that Blender's worlds take: the top row is +y, the centre column +x, and columns go on towards +z.
Picture sky_picture(const Sky& sky) {
    constexpr int kWidth = 2048, kHeight = 1024;
    Picture out(kWidth, kHeight, {"R", "G", "B"});
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const double phi = 2 * kPi * ((x + 0.5) / kWidth - 0.5), theta = kPi * (y + 0.5) / kHeight;
            const Color seen = sky.radiance({std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)});
            for (int c = 0; c < 3; ++c) out.at(x, y)[c] = float(seen[c]);
        }
    return out;
}

tl::expected<Json, std::string> sky_json(const CompiledScene& scene, const std::string& folder) {
    Json out{{"lights", scene.sky->lights()}};
    if (!scene.scene.atmosphere.sky || scene.scene.atmosphere.environment) {
        out["color"] = to_json(scene.sky->radiance(Vec3(0, 1, 0)));
        return out;
    }
    const auto written = write_picture(folder + "/sky.exr", sky_picture(*scene.sky));
    if (!written) return tl::unexpected(written.error());
    out["picture"] = "sky.exr";
    return out;
}

/// The sun that we add where the scene has no light; the scene's own are in the .glb.
Json suns_json(const CompiledScene& scene) {
    bool own = false;
    visit_paths(scene.scene, [&](const Visit& visit) {
        own = own || std::holds_alternative<LightId>(scene.scene.nodes[visit.node.index].what);
        return !own;
    });
    Json out = Json::array();
    if (own) return out;
    for (const PlacedLight& sun : scene.lights) out.push_back({{"direction", to_json(sun.axis)}, {"irradiance", to_json(sun.light.intensity)}});
    return out;
}

}  // namespace

tl::expected<Json, std::string> cycles_job(const CompareJob& job, const CompiledScene& scene, const std::string& folder) {
    const auto camera = camera_json(fitted(scene.cameras.front().camera, job.width, job.height), scene.scene);
    if (!camera) return tl::unexpected(camera.error());
    const auto sky = sky_json(scene, folder);
    if (!sky) return tl::unexpected(sky.error());
    Json pictures = Json::array();
    for (int seed = 0; seed < job.seeds; ++seed) pictures.push_back(fmt::format("picture{}.exr", seed));
    return Json{{"width", job.width}, {"height", job.height}, {"samples", job.spp}, {"depth", scene.scene.settings.max_depth.value_or(8)},
                {"camera", *camera}, {"sky", *sky}, {"suns", suns_json(scene)}, {"pictures", pictures}};
}

}  // namespace alidade
