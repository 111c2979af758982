// SPDX-License-Identifier: Apache-2.0
/// The outer shell of a glTF file: GLB chunks (glTF 2.0 specification, section 4) or plain JSON.
#pragma once

#include "importers/gltf/json.h"
#include "importers/gltf/reporter.h"

#include <optional>
#include <span>

namespace alidade::gltf {

struct Container {
    std::string_view json;
    std::optional<std::span<const std::byte>> bin;   ///< GLB's binary chunk
};

bool is_glb(std::span<const std::byte> bytes);

/// The parts of `bytes`, which they point into. Nothing, and an error, if a GLB's chunks do not add up.
std::optional<Container> split_container(std::span<const std::byte> bytes, Reporter& report);

/// The JSON value of `text`. Nothing, and an error with line and column, if it is malformed or nested deeper than 64 levels.
std::optional<Json> parse_json(std::string_view text, Reporter& report);

}  // namespace alidade::gltf
