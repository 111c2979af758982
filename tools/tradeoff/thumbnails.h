// SPDX-License-Identifier: Apache-2.0
/// Small pictures for the page.
#pragma once

#include "core/image.h"

#include <string>
#include <vector>

namespace alidade::tradeoff {

inline constexpr int kThumbnailWidth = 160;

/// Means of blocks of pixels, at most kThumbnailWidth wide, as PNG in base64.
std::string thumbnail(const Picture& picture);
/// The same of FLIP's error in each pixel, in the colours of `diff`'s heat map.
std::string error_thumbnail(int width, int height, const std::vector<float>& flip);

}  // namespace alidade::tradeoff
