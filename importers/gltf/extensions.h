// SPDX-License-Identifier: Apache-2.0
/// The glTF extensions that the importer knows. The table is the manual (docs/gltf-support.md is checked against it).
#pragma once

#include <span>
#include <string_view>

namespace alidade::gltf {

enum class Support {
    full,       ///< read into the scene
    harmless,   ///< says nothing that a picture could show: skipped in silence, even if required
    ignored,    ///< skipped with a warning (an error where the user asked for strictness), even if required: the picture's colours may differ
    needed,     ///< skipped with a warning; a file that requires it is refused, since geometry or textures would be missing
};

struct Extension {
    const char* name;
    Support support;
    const char* doc;    ///< what it does (full, harmless), or what is lost without it (ignored, needed)
    const char* hint = "";   ///< what to do about a file that requires it
};

std::span<const Extension> extensions();
/// The row of `name`, or null.
const Extension* find_extension(std::string_view name);

}  // namespace alidade::gltf
