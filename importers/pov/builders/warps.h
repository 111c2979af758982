// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "importers/pov/builders/build.h"

namespace alidade::pov {

/// `warp { ... }`. Source   POV-Ray 3.7 reference, 3.4.7.7 "Warps".
Warp build_warp(Build& build, const Block& block);

/// `turbulence`, `octaves`, `omega` or `lambda` with its value; false where none of them stands.
bool take_turbulence(Cursor& at, Turbulence& t);

}  // namespace alidade::pov
