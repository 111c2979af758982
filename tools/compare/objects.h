// SPDX-License-Identifier: Apache-2.0
/// What stands where in a picture, for people who look at it.
#pragma once

#include "tools/report/report.h"

namespace alidade {

struct CompiledScene;

/// The object that the middle of each pixel shows. Names are the nodes', the shapes', or what the shapes are, and where they stand in their file: "sphere (room.pov:12)".
ReportObjects objects_seen(const CompiledScene& scene, int width, int height);

/// The part x0 <= x < x1, y0 <= y < y1 of objects that are `width` wide.
ReportObjects cropped(const ReportObjects& objects, int width, int x0, int y0, int x1, int y1);

}  // namespace alidade
