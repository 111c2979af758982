// SPDX-License-Identifier: Apache-2.0
/// GIF files of up to 100 pixels with a palette of four colours.
#pragma once

#include <cstdint>
#include <string>

namespace alidade::test {

struct GifSize {
    char width, height;
};

inline std::string gif_bytes(GifSize size) { return {size.width, '\0', size.height, '\0'}; }

/// A picture at the corner of the screen, with a palette of its own if one is given. Codes of 8 bits each, which they have as long as the decoder's table is not full.
inline std::string gif_frame(GifSize size, const std::string& numbers, bool interlaced = false, const std::string& own_colors = "") {
    const int flags = (interlaced ? 0x40 : 0) | (own_colors.empty() ? 0 : 0x81);
    return "," + std::string(4, '\0') + gif_bytes(size) + char(flags) + own_colors + "\x07" + char(numbers.size() + 2) + "\x80" + numbers + "\x81" + std::string(1, '\0');
}

/// What stands before a picture of which one number is transparent.
inline std::string gif_clear(char number) { return std::string("\x21\xf9\4\1\0\0", 6) + number + std::string(1, '\0'); }

/// `colors`: twelve bytes.
inline std::string gif_file(GifSize screen, const std::string& colors, const std::string& frames) { return "GIF89a" + gif_bytes(screen) + std::string("\xf1\0\0", 3) + colors + frames + ";"; }

}  // namespace alidade::test
