// SPDX-License-Identifier: Apache-2.0
/// File -> Scene. The table is the list of formats; a format is one row and one folder.
#pragma once

#include "core/diagnostics.h"
#include "importers/pov/settings.h"
#include "scene/scene.h"

#include <span>
#include <tl/expected.hpp>

namespace alidade {

enum class LightUnitsOption { automatic, photometric, raw };

struct ImportOptions {
    std::vector<std::string> include_paths;          ///< -I
    bool scene_folder_last = false;                  ///< what a POV scene reads is looked for in its own folder behind all others, not before them
    std::string header;                              ///< a file that a POV scene is read behind, as if it began with #include; empty: none
    std::vector<std::string> declarations;           ///< NAME=VALUE
    pov::Limits limits;                              ///< --limit: of POV scenes
    bool strict = false;                             ///< warnings about what is not understood become errors
    std::optional<std::string> write_folder;         ///< --allow-write: where a scene's program may write
    pov::FrameSettings frame;                        ///< what a scene's program may ask of the picture and the clock
    std::optional<double> version;                   ///< of the language of POV scenes that do not say it
    int quality = pov::kFullQuality;                 ///< of POV scenes: below, what takes time is left out, as POV-Ray's +Q says
    LightUnitsOption light_units = LightUnitsOption::automatic;
    pov::PrintText print;                            ///< what a POV scene's #debug, #render and #statistics print, as it comes; absent: notes, the first hundred
    uint64_t max_file_bytes = uint64_t(1) << 34;
    std::string format;                              ///< the name of the importer for files of which neither content nor ending tells; if empty, they are errors
    bool shown_only = false;                         ///< what no node of the scene shows may stay unread, if its format has it apart: for rendering
};

/// A scene that passed validate(), and what its importer had to say.
struct Imported {
    Scene scene;
    Diagnostics diagnostics;
};

using ImportResult = tl::expected<Imported, Diagnostics>;

struct ImporterEntry {
    const char* name;
    const char* extensions;   ///< separated by spaces, with the dot
    const char* doc;
    /// Does the file's beginning look like this format? Asked before the ending of the name is.
    bool (*recognises)(std::span<const std::byte> head);
    ImportResult (*import)(const std::string& path, const ImportOptions& options);
};

std::span<const ImporterEntry> importers();

/// Picks the importer by content, then by ending, then by ImportOptions::format; reads, validates. Never throws on bad input.
ImportResult import_scene(const std::string& path, const ImportOptions& options = {});

}  // namespace alidade
