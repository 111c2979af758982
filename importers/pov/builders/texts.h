// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/bounds.h"
#include "importers/pov/builders/build.h"

namespace alidade::pov {

struct BuiltText {
    std::vector<NodeId> letters;
    Bounds box;                  ///< as POV-Ray has it (probed): a letter that reaches to the left of where it is put is as far longer on the right, and blanks are there as points
};

/// `text { ttf "font.ttf" "letters" depth, offset ... }`: a node for each letter. The first one begins at x = 0; from letter to letter it is the font's advance
/// width, its kerning and the offset (of which POV-Ray takes x and y). Leaves `at` at the first modifier.
BuiltText build_text(Build& build, Cursor& at);

}  // namespace alidade::pov
