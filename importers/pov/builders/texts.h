// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "importers/pov/builders/build.h"

namespace alidade::pov {

/// `text { ttf "font.ttf" "letters" depth, offset ... }`: a node for each letter. The first one begins at x = 0; from letter to letter it is the font's advance
/// width, its kerning and the offset (of which POV-Ray takes x and y). Leaves `at` at the first modifier.
std::vector<NodeId> build_text(Build& build, Cursor& at);

}  // namespace alidade::pov
