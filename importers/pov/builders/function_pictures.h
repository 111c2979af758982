// SPDX-License-Identifier: Apache-2.0
/// Pictures that are made of functions: `image_map { function W, H { ... } }`.
#pragma once

#include "importers/pov/builders/build.h"

namespace alidade::pov {

/// The picture of a function that stands at `place`, asked now: 16 bits a channel, grey, or with colours and alpha of a pigment. Each is made once. Where a part of the
/// function is not modelled it is middle grey, and that is told.
ImageId build_function_picture(Build& build, const Function& function, Place place);

}  // namespace alidade::pov
