// SPDX-License-Identifier: Apache-2.0
#include "importers/importer.h"

#include "core/image.h"
#include "importers/gltf/gltf.h"
#include "importers/mesh/obj.h"
#include "importers/mesh/off.h"
#include "importers/mesh/ply.h"
#include "importers/mesh/stl.h"
#include "importers/pov/pov.h"
#include "scene/queries.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <new>

namespace alidade {

namespace {

constexpr ImporterEntry kImporters[] = {
    {"gltf", ".gltf .glb", "glTF 2.0, text and binary", looks_like_gltf, import_gltf},
    {"obj", ".obj", "Wavefront OBJ, with MTL material libraries", looks_like_obj, import_obj},
    {"ply", ".ply", "PLY, text and binary", looks_like_ply, import_ply},
    {"stl", ".stl", "STL, text and binary", looks_like_stl, import_stl},
    {"off", ".off", "OFF, text", looks_like_off, import_off},
    {"pov", ".pov", "POV-Ray scenes", looks_like_pov, import_pov},
};

/// How much of a file importers look at to recognise it.
constexpr size_t kHeadBytes = 4096;

ImportResult failure(const std::string& path, std::string message, std::string hint = {}) {
    Diagnostics diagnostics;
    SourcePos at;
    at.file = diagnostics.add_file(path);
    diagnostics.error(at, std::move(message), std::move(hint));
    return tl::unexpected(std::move(diagnostics));
}

std::vector<std::byte> read_head(const std::string& path) {
    std::vector<std::byte> head(kHeadBytes);
    std::ifstream in(path, std::ios::binary);
    in.read(reinterpret_cast<char*>(head.data()), std::streamsize(head.size()));
    head.resize(size_t(std::max<std::streamsize>(in.gcount(), 0)));
    return head;
}

bool has_ending(const ImporterEntry& entry, const std::string& ending) {
    return !ending.empty() && fmt::format(" {} ", entry.extensions).find(fmt::format(" {} ", ending)) != std::string::npos;
}

/// By content, then by ending.
const ImporterEntry* choose(const std::string& path, std::span<const std::byte> head) {
    for (const ImporterEntry& entry : kImporters)
        if (entry.recognises(head)) return &entry;
    for (const ImporterEntry& entry : kImporters)
        if (has_ending(entry, lower_ending(path))) return &entry;
    return nullptr;
}

const ImporterEntry* named(const std::string& name) {
    for (const ImporterEntry& entry : kImporters)
        if (name == entry.name) return &entry;
    return nullptr;
}

std::string known_formats() {
    std::string names;
    for (const ImporterEntry& entry : kImporters) names += fmt::format("{}{} ({})", names.empty() ? "" : ", ", entry.doc, entry.extensions);
    return names;
}

/// What the importer has made must hold together whatever the file said; warnings of both are kept.
ImportResult validated(ImportResult result) {
    if (!result) return result;
    result->diagnostics.append(validate(result->scene));
    if (result->diagnostics.has_errors()) return tl::unexpected(std::move(result->diagnostics));
    return result;
}

}  // namespace

std::span<const ImporterEntry> importers() { return kImporters; }

ImportResult import_scene(const std::string& path, const ImportOptions& options) {
    std::error_code unreadable;
    const auto status = std::filesystem::status(path, unreadable);
    if (!std::filesystem::exists(status)) return failure(path, "there is no such file");
    if (std::filesystem::is_directory(status)) return failure(path, "is a directory, not a scene");
    if (!std::filesystem::is_regular_file(status)) return failure(path, "is a device or a pipe, not a file");
    try {
        const std::vector<std::byte> head = read_head(path);
        const ImporterEntry* entry = choose(path, head);
        if (!entry) entry = named(options.format);
        const bool may_be_empty = entry && entry->import == import_pov;        // POV-Ray renders a scene of nothing
        if (head.empty() && !may_be_empty) return failure(path, "the file is empty or cannot be read");
        if (!entry) return failure(path, "the format is not recognised", "known formats: " + known_formats());
        return validated(entry->import(path, options));
    } catch (const std::bad_alloc&) {
        return failure(path, "there is not enough memory for this file");
    } catch (const std::exception& e) {
        return failure(path, fmt::format("the file cannot be imported: {}", e.what()));
    }
}

}  // namespace alidade
