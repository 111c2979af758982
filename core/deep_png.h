// SPDX-License-Identifier: Apache-2.0
/// PNG files for numbers that 8 bits are too few for.
#pragma once

#include "core/image.h"

namespace alidade {

/// A PNG file of 16 bits a channel that holds the linear values themselves, cut off at 0 and 1: R, G, B, or R, G, B, A premultiplied. In the file colours are straight,
/// and those of what is clear are black.
tl::expected<std::vector<std::byte>, std::string> encode_linear_png(const Picture& picture);

/// A PNG file of 16 bits a channel that holds the values as they are, cut off at 0 and 1: Y; R, G, B; or R, G, B, A that nothing is multiplied by.
tl::expected<std::vector<std::byte>, std::string> encode_number_png(const Picture& picture);

}  // namespace alidade
