// SPDX-License-Identifier: Apache-2.0
#include "tools/metrics/regions.h"

#include <algorithm>

namespace alidade {
namespace {

/// Takes the set that holds `start` out of `bad`.
PixelRegion take(std::vector<uint8_t>& bad, int width, int height, size_t start) {
    PixelRegion region{0, width, height, 0, 0};
    std::vector<size_t> open{start};
    bad[start] = 0;
    while (!open.empty()) {
        const size_t at = open.back();
        open.pop_back();
        const int x = int(at % size_t(width)), y = int(at / size_t(width));
        ++region.pixels;
        region = {region.pixels, std::min(region.x0, x), std::min(region.y0, y), std::max(region.x1, x + 1), std::max(region.y1, y + 1)};
        for (int v = std::max(y - 1, 0); v <= std::min(y + 1, height - 1); ++v)
            for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width - 1); ++u) {
                const size_t next = size_t(v) * size_t(width) + size_t(u);
                if (bad[next]) bad[next] = 0, open.push_back(next);
            }
    }
    return region;
}

}  // namespace

PixelRegion largest_region(const PicturePair& pair, double over) {
    const std::vector<float> differences = pixel_differences(pair);
    std::vector<uint8_t> bad(differences.size());
    for (size_t p = 0; p < bad.size(); ++p) bad[p] = double(differences[p]) > over;
    PixelRegion largest;
    for (size_t p = 0; p < bad.size(); ++p)
        if (bad[p])
            if (const PixelRegion region = take(bad, pair.width(), pair.height(), p); region.pixels > largest.pixels) largest = region;
    return largest;
}

}  // namespace alidade
