// SPDX-License-Identifier: Apache-2.0
#include "tools/values.h"

#include "core/image.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <fmt/format.h>
#include <optional>

namespace alidade {

namespace {

/// All of `word` as a T, or nothing.
template <class T> std::optional<T> whole(std::string_view word) {
    T value{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
    return value;
}

/// The whole numbers between the separators, or none at all if one of the parts is no number.
std::vector<int> integers(std::string_view word, char separator) {
    std::vector<int> numbers;
    for (size_t next = 0; next != word.npos;) {
        next = word.find(separator);
        const auto number = whole<int>(word.substr(0, next));
        if (!number) return {};
        numbers.push_back(*number);
        if (next != word.npos) word.remove_prefix(next + 1);
    }
    return numbers;
}

}  // namespace

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return text;
}

Value<Size> parse_size(std::string_view word) {
    const std::vector<int> sides = integers(word, 'x');
    if (sides.size() != 2 || sides[0] < 1 || sides[1] < 1) return tl::unexpected(fmt::format("'{}' is not WIDTHxHEIGHT, such as 640x480", word));
    if (int64_t(sides[0]) * sides[1] > kMaxPixels) return tl::unexpected(fmt::format("'{}' is more than {} pixels", word, kMaxPixels));
    return Size{sides[0], sides[1]};
}

Value<Region> parse_region(std::string_view word) {
    const std::vector<int> at = integers(word, ',');
    if (at.size() != 4 || at[0] < 0 || at[1] < 0 || at[0] >= at[2] || at[1] >= at[3])
        return tl::unexpected(fmt::format("'{}' is not x0,y0,x1,y1 with x0 < x1 and y0 < y1, in pixels from the top left", word));
    return Region{at[0], at[1], at[2], at[3]};
}

Value<Color> parse_color(std::string_view word) {
    const size_t digits = word.size() == 4 ? 1 : 2;
    bool good = (word.size() == 4 || word.size() == 7) && word[0] == '#';
    Color linear{0};
    for (size_t i = 0; good && i < 3; ++i) {
        const std::string_view part = word.substr(1 + i * digits, digits);
        int code = 0;
        const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), code, 16);
        good = error == std::errc() && end == part.data() + part.size() && code >= 0;
        linear[int(i)] = srgb_to_linear(digits == 1 ? code / 15.0 : code / 255.0);
    }
    if (!good) return tl::unexpected(fmt::format("'{}' is not a colour such as #fff or #ff8000", word));
    return linear;
}

Value<int64_t> parse_integer(std::string_view word, int64_t low, int64_t high) {
    const auto value = whole<int64_t>(word);
    if (!value || *value < low || *value > high) return tl::unexpected(fmt::format("'{}' is not a whole number from {} to {}", word, low, high));
    return *value;
}

Value<double> parse_number(std::string_view word, double low, double high) {
    const auto value = whole<double>(word);
    if (!value || !std::isfinite(*value)) return tl::unexpected(fmt::format("'{}' is not a number", word));
    if (*value < low) return tl::unexpected(fmt::format("'{}' is less than {}", word, low));
    if (*value > high) return tl::unexpected(fmt::format("'{}' is more than {}", word, high));
    return *value;
}

}  // namespace alidade
