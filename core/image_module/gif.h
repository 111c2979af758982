// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace alidade {

/// The first picture of a GIF. OpenImageIO passes neither numbers nor the colour of what is transparent on.
struct GifPicture {
    std::vector<uint8_t> numbers;                          ///< of each pixel's colour in the palette, rows from the top
    std::array<std::array<uint8_t, 3>, 256> colors{};      ///< red, green and blue; those that the palette has not are black
};

/// Without numbers if the picture does not fill the file's screen, or is broken.
GifPicture gif_picture(const void* bytes, size_t size);

}  // namespace alidade
