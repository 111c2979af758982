// SPDX-License-Identifier: Apache-2.0
/// The largest connected set (by edges and corners) of pixels that differ by more than 8/255: a broken place that no mean shows.
#include "tools/metrics/regions.h"

namespace alidade {

Measured measure_region(const PicturePair& pair) {
    const PixelRegion largest = largest_region(pair, over_steps(8));
    return {{{"pixels", double(largest.pixels)},
             {"share", double(largest.pixels) / double(counted(pair))},
             {"x0", double(largest.x0)},
             {"y0", double(largest.y0)},
             {"x1", double(largest.x1)},
             {"y1", double(largest.y1)}},
            {}};
}

}  // namespace alidade
