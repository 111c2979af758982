// SPDX-License-Identifier: Apache-2.0
#include "scene/queries.h"
#include "tools/features.h"
#include "tools/interrupt.h"
#include "tools/load.h"
#include "tools/surfaces.h"
#include "tracer/explain.h"
#include "tracer/render.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <iterator>
#include <variant>

namespace alidade {

namespace {

Json triple(const Vec3& v) { return {v.x, v.y, v.z}; }

Json holds(const Scene& scene) {
    size_t meshes = 0;
    for (const ShapeEntry& shape : scene.shapes) meshes += std::holds_alternative<Mesh>(shape.geometry);
    return {{"nodes", scene.nodes.size()}, {"shapes", scene.shapes.size()}, {"of them meshes", meshes}, {"materials", scene.materials.size()},
            {"images", scene.images.size()}, {"lights", scene.lights.size()}, {"cameras", scene.cameras.size()},
            {"animations", scene.animations.size()}, {"skins", scene.skins.size()}};
}

Json required(const Scene& scene, const Diagnostics& places) {
    Json list = Json::array();
    for (const RequiredBy& each : requirements(scene))
        list.push_back({{"what", name(each.what)}, {"count", each.count}, {"first", places.where(each.first)}});
    return list;
}

Json cameras(const Scene& scene) {
    static constexpr const char* kProjection[] = {"perspective", "orthographic", "fisheye", "ultra_wide_angle", "omnimax", "panoramic", "cylindrical", "spherical"};
    Json list = Json::array();
    for (const Camera& camera : scene.cameras)
        list.push_back({{"number", list.size()}, {"name", camera.name}, {"projection", kProjection[int(camera.projection)]},
                        {"aspect", length(camera.right) / length(camera.up)}});
    return list;
}

Json lights(const Scene& scene) {
    static constexpr const char* kKind[] = {"point", "spot", "directional", "area", "POV-Ray spotlight", "POV-Ray cylinder"};
    static constexpr const char* kUnit[] = {"W/sr", "W/sr", "W/m^2", "W/(sr m^2)", "W/sr", "W/sr"};
    static_assert(std::size(kKind) == std::variant_size_v<decltype(Light::kind)> && std::size(kUnit) == std::size(kKind));
    Json list = Json::array();
    for (const Light& light : scene.lights)
        list.push_back({{"number", list.size()}, {"name", light.name}, {"kind", light.parallel && std::holds_alternative<PointLight>(light.kind) ? "POV-Ray parallel" : kKind[light.kind.index()]}, {"intensity", triple(light.intensity)},
                        {"unit", light.inverse_square ? kUnit[light.kind.index()] : "POV-Ray's colour"}});
    return list;
}

Json structures(const CompiledSummary& built) {
    Json list = Json::array();
    for (const auto& [structure, stats] : built.structures) {
        Json row = {{"name", structure}};
        row.update(to_json(stats));
        list.push_back(std::move(row));
    }
    return list;
}

Json explained(const std::vector<Explained>& list) {
    Json rows = Json::array();
    for (const Explained& each : list) rows.push_back({{"what", each.what}, {"name", each.name}, {"why", each.why}});
    return rows;
}

Json describe_scene(const Request& request, const Scene& scene) {
    const Bounds box = world_bounds(scene);
    Diagnostics places;
    for (const SourceFile& file : scene.files) places.add_file(file.path);
    return {{"scene", request.scene}, {"generator", scene.settings.generator}, {"holds", holds(scene)},
            {"bounds", box.empty() ? Json() : Json{{"min", triple(box.min)}, {"max", triple(box.max)}}},
            {"light units", scene.settings.why_light_units}, {"requires", required(scene, places)}, {"cameras", cameras(scene)},
            {"lights", lights(scene)}};
}

/// The scene, then what compile() makes of it; without the latter if it cannot be compiled.
Json describe(const Request& request, Loaded& loaded) {
    Json document = describe_scene(request, *loaded.scene);
    document.update(describe_surfaces(*loaded.scene));
    if (const auto compiled = compile(std::move(*loaded.scene), request.compile, loaded.said)) {
        const CompiledSummary built = summary(*compiled);
        document["kernel"] = built.kernel;
        document["compiled"] = to_json(built);
        document["structures"] = structures(built);
        document["decoded"] = explained(decoded(*compiled));
        document["left out"] = explained(left_out(*compiled));
    }
    document["messages"] = to_json(loaded.said);
    return document;
}

void print(const Json& document, bool json) { fmt::print("{}", json ? as_json_text(document) : as_text(document)); }

}  // namespace

int run_info(const Verb& verb, const Words& given) {
    Request request;
    bool json = false, only_features = false;
    CLI::App app;
    add_scene_options(app, request);
    add_compile_options(app, request);
    app.add_flag("--json", json, "prints JSON instead of text");
    auto* list = app.add_flag("--features", only_features, "lists what the program can do; takes no scene");
    app.get_option("SCENE")->required(false)->excludes(list);
    if (const auto code = parse_words(app, verb, given)) return *code;
    if (!only_features && request.scene.empty()) return usage_error(verb, "SCENE is missing; or list what the program can do: alidade info --features");

    exit_on_signal();
    if (only_features) {
        print(features(), json);
        return kDone;
    }
    Loaded loaded = load(request);
    if (loaded.scene) print(describe(request, loaded), json);   // what cannot be rendered can still be told about
    if (!loaded.said.has_errors()) return kDone;
    fmt::print(stderr, "{}", loaded.said.text());
    return kError;
}

}  // namespace alidade
