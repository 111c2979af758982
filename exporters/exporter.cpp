// SPDX-License-Identifier: Apache-2.0
#include "exporters/exporter.h"

#include "exporters/gltf/gltf.h"
#include "exporters/mesh/obj.h"
#include "exporters/mesh/ply.h"
#include "exporters/meshing/mesh_scene.h"
#include "exporters/pov/pov.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <new>

namespace alidade {

namespace {

constexpr ExporterEntry kTable[] = {
    {"gltf", ".gltf .glb", "glTF 2.0: JSON with a .bin and pictures beside it, or all in one", write_gltf},
    {"obj", ".obj", "Wavefront OBJ, with an MTL material library and pictures beside it", write_obj},
    {"ply", ".ply", "PLY, binary: one mesh of all that is shown", write_ply},
    {"pov", ".pov", "POV-Ray 3.7's language, with pictures beside it", write_pov, false},
};

std::string lower_case(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return text;
}

}  // namespace

std::span<const ExporterEntry> exporters() { return kTable; }

const ExporterEntry* find_exporter(const std::string& path) {
    const std::string ending = lower_case(std::filesystem::path(path).extension().string());
    for (const ExporterEntry& entry : kTable)
        if (!ending.empty() && fmt::format(" {} ", entry.extensions).find(fmt::format(" {} ", ending)) != std::string::npos) return &entry;
    return nullptr;
}

std::string known_endings() {
    std::string out;
    for (const ExporterEntry& entry : kTable) out += fmt::format("{}{}", out.empty() ? "" : " ", entry.extensions);
    return out;
}

tl::expected<Exported, std::string> export_scene(const Scene& scene, const std::string& path, const ExportOptions& options) {
    const ExporterEntry* entry = find_exporter(path);
    if (!entry) return tl::unexpected(fmt::format("'{}' has no ending that names a format to write: {}", path, known_endings()));
    try {
        OutputFiles files(scene, path);
        Losses losses;
        tl::expected<Scene, std::string> meshes;
        const bool needed = entry->meshes_alone && meshing::needs_meshes(scene);
        if (needed && !(meshes = meshing::mesh_scene(scene, options.segments, losses))) return tl::unexpected(meshes.error());
        if (const auto done = entry->write(needed ? *meshes : scene, files, losses); !done) return tl::unexpected(done.error());
        auto written = files.write();
        if (!written) return tl::unexpected(written.error());
        return Exported{std::move(*written), losses.list(), losses.materials()};
    } catch (const std::bad_alloc&) {
        return tl::unexpected(std::string("there is not enough memory to write this scene"));
    }
}

}  // namespace alidade
