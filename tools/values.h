// SPDX-License-Identifier: Apache-2.0
/// Words of the command line as values. Every function gives the value, or says in one clause what the word should have been.
#pragma once

#include "tracer/options.h"

#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace alidade {

template <class T> using Value = tl::expected<T, std::string>;

struct Size {
    int width = 0, height = 0;
};

/// With small letters, of ASCII alone.
std::string lower(std::string text);

/// "640x480"; both at least 1, and at most kMaxPixels pixels.
Value<Size> parse_size(std::string_view word);
inline constexpr int64_t kMaxPixels = int64_t(1) << 30;

/// "x0,y0,x1,y1", not empty.
Value<Region> parse_region(std::string_view word);

/// "#rgb" or "#rrggbb", as the web writes colours (sRGB-encoded); the value is linear.
Value<Color> parse_color(std::string_view word);

/// A whole number in [low, high].
Value<int64_t> parse_integer(std::string_view word, int64_t low, int64_t high);
/// A finite number in [low, high].
Value<double> parse_number(std::string_view word, double low, double high = kInf);

}  // namespace alidade
