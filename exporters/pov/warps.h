// SPDX-License-Identifier: Apache-2.0
/// What bends the space of a pattern.
#pragma once

#include "exporters/pov/sdl.h"
#include "scene/material.h"

namespace alidade::pov_export {

void write_turbulence(Sdl& sdl, const Turbulence& t);
/// A transformation, or `warp { }`.
void write_warp(Sdl& sdl, const Warp& warp);

}  // namespace alidade::pov_export
