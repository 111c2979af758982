// SPDX-License-Identifier: Apache-2.0
/// Connected sets of pixels that differ.
#pragma once

#include "tools/metrics/differences.h"

namespace alidade {

/// `pixels` of them, within [x0, x1) x [y0, y1).
struct PixelRegion {
    size_t pixels = 0;
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

/// The largest set of pixels that touch by an edge or a corner and differ by more than `over`; of equal ones that which begins first, row by row.
PixelRegion largest_region(const PicturePair& pair, double over);

}  // namespace alidade
