// SPDX-License-Identifier: Apache-2.0
#include "tools/diff/tiles.h"

#include "tools/metrics/differences.h"

#include <algorithm>

namespace alidade {

namespace {

Tile measure(const PicturePair& pair, const std::vector<float>& differences, int x0, int y0, int size) {
    Tile tile{x0, y0, std::min(x0 + size, pair.width()), std::min(y0 + size, pair.height()), 0, 0};
    size_t count = 0;
    for (int y = tile.y0; y < tile.y1; ++y)
        for (int x = tile.x0; x < tile.x1; ++x) {
            const size_t pixel = size_t(y) * size_t(pair.width()) + size_t(x);
            if (!pair.counts[pixel]) continue;
            ++count, tile.mean += double(differences[pixel]), tile.largest = std::max(tile.largest, double(differences[pixel]));
        }
    tile.mean /= double(std::max<size_t>(count, 1));
    return tile;
}

}  // namespace

TileTable tile_table(const PicturePair& pair) {
    const std::vector<float> differences = pixel_differences(pair);
    TileTable table;
    table.size = (std::max(pair.width(), pair.height()) + 127) / 128 * 8;
    table.columns = (pair.width() + table.size - 1) / table.size, table.rows = (pair.height() + table.size - 1) / table.size;
    for (int y = 0; y < pair.height(); y += table.size)
        for (int x = 0; x < pair.width(); x += table.size) table.tiles.push_back(measure(pair, differences, x, y, table.size));
    return table;
}

}  // namespace alidade
