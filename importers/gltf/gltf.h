// SPDX-License-Identifier: Apache-2.0
/// glTF 2.0: GLB and JSON. What is understood: docs/gltf-support.md.
#pragma once

#include "importers/importer.h"

namespace alidade {

ImportResult import_gltf(const std::string& path, const ImportOptions& options);

/// The same from bytes in memory. `name` stands in messages; URIs are read at or below `base_dir`, or not at all if it is empty.
ImportResult import_gltf_bytes(std::span<const std::byte> bytes, const std::string& name, const std::string& base_dir, const ImportOptions& options);

/// GLB's magic, or JSON that mentions "asset".
bool looks_like_gltf(std::span<const std::byte> head);

}  // namespace alidade
