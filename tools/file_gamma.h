// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/image.h"

namespace alidade {

/// As encode_picture, but for the curve: codes are the `gamma`th roots of linear values instead of sRGB's, and a PNG file says so by a gAMA chunk in sRGB's place. Files of
/// floats (.exr, .pfm, .hdr) stay linear.
tl::expected<std::vector<std::byte>, std::string> encode_with_gamma(Picture picture, const std::string& ending, int bits, double gamma);

}  // namespace alidade
