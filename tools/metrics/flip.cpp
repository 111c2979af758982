// SPDX-License-Identifier: Apache-2.0
#include "tools/metrics/flip_filters.h"

#include <algorithm>

namespace alidade {
namespace {

/// What a display shows, as light. Of linear pictures by clipping alone: encoding and decoding would only round.
std::vector<float> shown(const PicturePair& pair, const Picture& picture) {
    auto colors = linear_colors(pair, picture);
    for (float& value : colors) value = std::clamp(value, 0.0f, 1.0f);
    return colors;
}

}  // namespace

/// LDR-FLIP, 67.02 pixels per degree.
/// Source   Andersson et al., "FLIP: A Difference Evaluator for Alternating Images", HPG 2020.
/// Error    1e-4 in mean and quartiles, 1e-3 in min and max against the authors' program. Held by metrics_test.
Measured measure_flip(const PicturePair& pair) {
    return pooled_flip(pair, flip_map(pair.width(), pair.height(), shown(pair, pair.reference), shown(pair, pair.test), pair.threads));
}

}  // namespace alidade
