// SPDX-License-Identifier: Apache-2.0
/// Scene -> file. The table is the list of formats; a format is one row and one folder.
#pragma once

#include "exporters/losses.h"
#include "exporters/output_files.h"
#include "scene/scene.h"

#include <span>
#include <tl/expected.hpp>

namespace alidade {

struct ExporterEntry {
    const char* name;
    const char* extensions;   ///< separated by spaces, with the dot
    const char* doc;
    /// Hands over the bytes of all files, and says what they do not hold. An error is one sentence.
    tl::expected<void, std::string> (*write)(const Scene& scene, OutputFiles& files, Losses& losses);
    bool meshes_alone = true;   ///< is everything else to be made meshes first?
};

std::span<const ExporterEntry> exporters();

/// The exporter that the ending of `path` names, or null.
const ExporterEntry* find_exporter(const std::string& path);
/// All endings, for a message.
std::string known_endings();

struct ExportOptions {
    int segments = 64;   ///< of a full circle, and cells along the longest side of a solid, where what is no mesh becomes one; at least 3
};

struct Exported {
    std::vector<std::string> files;   ///< their paths, the one that was asked for first
    std::vector<Loss> losses;
    std::vector<WrittenMaterial> materials;   ///< what became of each; empty for formats that do not tell
};

/// Writes `scene`, which has passed validate(), to `path`, in the format that its ending names, and what belongs to it beside it. The files that
/// the scene was read from are never overwritten. An error is one sentence, and then `path` is as it was.
tl::expected<Exported, std::string> export_scene(const Scene& scene, const std::string& path, const ExportOptions& options = {});

}  // namespace alidade
