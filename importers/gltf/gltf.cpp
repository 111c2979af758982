// SPDX-License-Identifier: Apache-2.0
#include "importers/gltf/gltf.h"

#include "core/image.h"
#include "importers/gltf/animations.h"
#include "importers/gltf/cameras.h"
#include "importers/gltf/container.h"
#include "importers/gltf/draco.h"
#include "importers/gltf/instancing.h"
#include "importers/gltf/lights.h"
#include "importers/gltf/materials.h"
#include "importers/gltf/meshopt.h"
#include "importers/gltf/node_tree.h"
#include "importers/gltf/ranges.h"
#include "importers/gltf/schema.h"
#include "importers/gltf/unshown.h"

#include <filesystem>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alidade {

namespace gltf {

namespace {

/// The JSON of `container`, if it is a valid glTF 2.0 asset as far as JSON alone can tell.
std::optional<Json> read_checked_json(const Container& container, Reporter& report) {
    auto root = parse_json(container.json, report);
    if (!root) return std::nullopt;
    check_version(*root, report);
    if (report.failed()) return std::nullopt;
    check_schema(*root, report);
    if (report.failed()) return std::nullopt;
    check_extensions(*root, report);
    check_node_tree(*root, report);
    check_ranges(*root, report);
    return report.failed() ? std::nullopt : std::move(root);
}

void convert(const Model& model, const ImportOptions& options, Scene& scene, Reporter& report) {
    scene.settings.generator = model.asset.generator;
    convert_materials(model, scene, report);
    convert_cameras(model, scene, report);
    const auto lights = convert_lights(model, options.light_units, scene, report);
    const auto meshes = convert_meshes(model, scene, report);
    if (report.failed()) return;
    const ShapeNodes shape_nodes = convert_nodes(model, meshes, lights, scene, report);
    convert_skins(model, scene, report);
    convert_animations(model, shape_nodes, scene, report);
}

bool shows_a_mesh(const Scene& scene) {
    return !scene.roots.empty() && std::any_of(scene.nodes.begin(), scene.nodes.end(), [](const Node& node) { return std::holds_alternative<ShapeId>(node.what); });
}

/// Check everything, let tinygltf read what passed, check the data, convert. Each step may end with errors in `report`.
std::optional<Scene> import(std::span<const std::byte> bytes, const std::string& base_dir, const ImportOptions& options, Reporter& report) {
    const auto container = split_container(bytes, report);
    if (!container) return std::nullopt;
    auto root = read_checked_json(*container, report);
    if (!root) return std::nullopt;

    const Sources sources{is_glb(bytes), container->bin, base_dir, options.max_file_bytes, options.shown_only ? leave_out_unshown(*root) : std::vector<bool>()};
    auto buffers = load_buffers(*root, sources, report);
    if (report.failed()) return std::nullopt;
    decompress_views(*root, buffers, report);
    if (report.failed()) return std::nullopt;
    decompress_primitives(*root, buffers, report);
    check_instances(*root, buffers, report);
    if (report.failed()) return std::nullopt;
    Scene scene;
    scene.images = load_images(*root, buffers, sources, report);
    materialise_zeros(*root, buffers, report);
    if (report.failed()) return std::nullopt;

    const auto model = to_model(std::move(*root), std::move(buffers), report);
    if (!model) return std::nullopt;
    check_accessor_data(*model, report);
    if (report.failed()) return std::nullopt;
    convert(*model, options, scene, report);
    return report.failed() ? std::nullopt : std::optional(std::move(scene));
}

}  // namespace

}  // namespace gltf

ImportResult import_gltf_bytes(std::span<const std::byte> bytes, const std::string& name, const std::string& base_dir, const ImportOptions& options) {
    gltf::Reporter report(name, options.strict);
    auto scene = gltf::import(bytes, base_dir, options, report);
    if (!scene) return tl::unexpected(report.diagnostics());
    if (options.shown_only && !gltf::shows_a_mesh(*scene)) report.warning("", "the scene is empty: no node of it shows a mesh, so that the picture is all background");
    scene->files = report.diagnostics().files();
    return Imported{std::move(*scene), report.diagnostics()};
}

ImportResult import_gltf(const std::string& path, const ImportOptions& options) {
    const auto bytes = read_file(path, options.max_file_bytes);
    if (!bytes) {
        gltf::Reporter report(path, options.strict);
        report.error("", fmt::format("cannot read the file: {}", bytes.error()));
        return tl::unexpected(report.diagnostics());
    }
    const std::string parent = std::filesystem::path(path).parent_path().string();
    return import_gltf_bytes(*bytes, path, parent.empty() ? "." : parent, options);
}

bool looks_like_gltf(std::span<const std::byte> head) {
    if (gltf::is_glb(head)) return true;
    const std::string_view text(reinterpret_cast<const char*>(head.data()), head.size());
    const size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    return first != std::string_view::npos && text[first] == '{';
}

}  // namespace alidade
