// SPDX-License-Identifier: Apache-2.0
/// The bytes behind a glTF file: buffers and images, from the GLB chunk, data: URIs and files beside the scene.
#pragma once

#include "importers/gltf/json.h"
#include "importers/gltf/reporter.h"
#include "importers/importer.h"

#include <optional>
#include <span>

namespace alidade::gltf {

using Bytes = std::vector<unsigned char>;

/// What may be read while importing one file.
struct Sources {
    bool glb = false;
    std::optional<std::span<const std::byte>> bin;   ///< the GLB's binary chunk
    std::string base_dir;                            ///< of the files that URIs name; empty: none may be read
    uint64_t max_file_bytes = 0;                     ///< of all files together
    std::vector<bool> unread;                        ///< buffers that nobody asks for, and that are not read; empty: all are
};

/// The bytes of each buffer of the checked `root`, cut to byteLength. A buffer that nothing refers to may be without
/// data, but for the first of a GLB.
std::vector<Bytes> load_buffers(const Json& root, const Sources& sources, Reporter& report);

/// The images of the checked `root`, still encoded: as bytes, or as the path of a file beside the scene. To be called after check_ranges().
/// Images that name the same buffer view share no memory: they may use the buffers several times over, but not thousands of times.
std::vector<Image> load_images(const Json& root, const std::vector<Bytes>& buffers, const Sources& sources, Reporter& report);

}  // namespace alidade::gltf
