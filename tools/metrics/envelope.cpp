// SPDX-License-Identifier: Apache-2.0
/// The share of pixels that lie more than 8/255 outside the range that the reference has in the 3x3 pixels around, in any channel: an edge that
/// lies a part of a pixel elsewhere is inside that range, something that is not in the reference is outside.
#include "tools/metrics/differences.h"

#include <algorithm>

namespace alidade {
namespace {

struct Range {
    float least, most;
};

/// Beyond its border a picture goes on as at the border.
Range around(const Picture& picture, int x, int y, int channel) {
    Range range{picture.at(x, y)[channel], picture.at(x, y)[channel]};
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, picture.height - 1); ++v)
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, picture.width - 1); ++u) {
            const float value = picture.at(u, v)[channel];
            range = {std::min(range.least, value), std::max(range.most, value)};
        }
    return range;
}

bool is_outside(const PicturePair& pair, int x, int y) {
    for (int c = 0; c < pair.reference.channels; ++c) {
        const float value = pair.test.at(x, y)[c];
        if (std::abs(value - pair.reference.at(x, y)[c]) <= over_steps(8)) continue;   // the pixel itself is in its range: most end here
        const Range range = around(pair.reference, x, y, c);
        if (double(range.least) - value > over_steps(8) || double(value) - range.most > over_steps(8)) return true;
    }
    return false;
}

}  // namespace

Measured measure_envelope(const PicturePair& pair) {
    size_t outside = 0;
    for (int y = 0; y < pair.height(); ++y)
        for (int x = 0; x < pair.width(); ++x) outside += pair.counts[size_t(y) * size_t(pair.width()) + size_t(x)] && is_outside(pair, x, y);
    return {{{"value", double(outside) / double(counted(pair))}, {"pixels", double(outside)}}, {}};
}

}  // namespace alidade
