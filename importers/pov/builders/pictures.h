// SPDX-License-Identifier: Apache-2.0
/// image_map, image_pattern, bump_map, material_map -> pictures in space.
#pragma once

#include "importers/pov/builders/build.h"

namespace alidade::pov {

/// Does such a block come next?
bool at_picture(const Cursor& at);
/// Its picture, which is looked for where includes are: one that is not there is an error. `depth` is changed by bump_size, where that may stand in it.
/// Source   POV-Ray 3.7 reference, 3.4.7.6 "Image Map"; what gamma files have was found by probing.
PatternPicture build_picture(Build& build, const Block& block, double* depth = nullptr);
/// The same from the beginning of a block, which is left at the first item that says nothing of the picture.
PatternPicture take_picture(Build& build, Cursor& at, double* depth = nullptr);

}  // namespace alidade::pov
