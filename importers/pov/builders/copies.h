// SPDX-License-Identifier: Apache-2.0
/// What is stored once and stands in a scene many times.
#pragma once

#include "importers/pov/builders/build.h"

namespace alidade::pov {

/// Objects and pigments are stored once however often they are named, but are drawn as often: a few levels of two names each, and no machine could. An error
/// at the largest if there are more copies than Limits::copies. The scene must have no errors.
void check_copies(Build& build);

}  // namespace alidade::pov
