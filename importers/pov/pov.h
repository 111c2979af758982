// SPDX-License-Identifier: Apache-2.0
/// POV-Ray scenes.
#pragma once

#include "importers/importer.h"

namespace alidade {

/// Reads the scene with POV-Ray's language, versions 3.1 to 3.7, and builds what docs/pov-support.md lists; what is not modelled yet is a counted
/// warning. Files are read below the scene's folder, the include paths and POV-Ray's own includes.
ImportResult import_pov(const std::string& path, const ImportOptions& options);

/// Never: the language has no beginning that others do not have. The ending of the name decides.
bool looks_like_pov(std::span<const std::byte> head);

}  // namespace alidade
