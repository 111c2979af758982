// SPDX-License-Identifier: Apache-2.0
/// Which channels of a picture are its colours.
#pragma once

#include "core/image.h"

namespace alidade {

/// The numbers of the channels that make the colour, R, G, B or Y alone, and then that of A if there is one; none if there is no colour.
std::vector<int> color_channels(const Picture& picture);

/// The channels of `picture` at `from`, under new names.
Picture select_channels(const Picture& picture, const std::vector<int>& from, std::vector<std::string> names);

/// The colours alone, as Y, YA, RGB or RGBA: depth, layers and further parts of an EXR file are left out. An error is one sentence without the file's name.
tl::expected<Picture, std::string> colors_alone(Picture picture);

}  // namespace alidade
