// SPDX-License-Identifier: Apache-2.0
#include "tools/tradeoff/thumbnails.h"

#include "tools/diff/document.h"
#include "tools/report/page.h"

#include <algorithm>

namespace alidade::tradeoff {
namespace {

/// Blocks of whole pixels; the last ones may be smaller.
Picture reduced(const Picture& picture) {
    const int block = (picture.width + kThumbnailWidth - 1) / kThumbnailWidth;
    Picture out((picture.width + block - 1) / block, (picture.height + block - 1) / block, picture.names);
    std::vector<int> counts(size_t(out.width) * size_t(out.height));
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            for (int c = 0; c < out.channels; ++c) out.at(x / block, y / block)[c] += picture.at(x, y)[c];
            ++counts[size_t(y / block) * size_t(out.width) + size_t(x / block)];
        }
    for (size_t i = 0; i < out.values.size(); ++i) out.values[i] /= float(counts[i / size_t(out.channels)]);
    return out;
}

std::string png(const Picture& picture) {
    const auto bytes = encode_picture(picture, ".png");
    return bytes ? base64(*bytes) : "";
}

}  // namespace

std::string thumbnail(const Picture& picture) { return png(reduced(picture)); }

std::string error_thumbnail(int width, int height, const std::vector<float>& flip) {
    if (flip.empty()) return {};
    Picture errors(width, height, {"Y"});
    errors.values = flip;
    const Picture small = reduced(errors);
    Comparison comparison;
    comparison.loaded.emplace();
    comparison.loaded->pair.reference = Picture(small.width, small.height, {"R", "G", "B"});
    comparison.measured["flip"].map = small.values;
    return png(heat_map(comparison));
}

}  // namespace alidade::tradeoff
