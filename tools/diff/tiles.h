// SPDX-License-Identifier: Apache-2.0
/// Where pictures differ, in at most 16 x 16 tiles: a broken corner that hides in the mean of all.
#pragma once

#include "tools/metrics/metric.h"

namespace alidade {

struct Tile {
    int x0, y0, x1, y1;       ///< the ends outside
    double mean, largest;     ///< of the pixels' differences (the largest of a pixel's channels); 0 where none counts
};

struct TileTable {
    int size = 0;             ///< pixels a side, a multiple of 8
    int columns = 0, rows = 0;
    std::vector<Tile> tiles;  ///< row by row
};

TileTable tile_table(const PicturePair& pair);

}  // namespace alidade
