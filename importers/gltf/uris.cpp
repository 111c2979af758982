// SPDX-License-Identifier: Apache-2.0
#include "importers/gltf/uris.h"

#include "importers/local_path.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fmt/format.h>

namespace alidade::gltf {

namespace {

int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

constexpr std::array<signed char, 256> base64_values() {
    std::array<signed char, 256> table{};
    for (auto& v : table) v = -1;
    constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (int i = 0; i < 64; ++i) table[size_t(digits[i])] = static_cast<signed char>(i);
    table['-'] = 62, table['_'] = 63;   // the alphabet for URLs (RFC 4648, section 5)
    return table;
}

tl::expected<std::vector<unsigned char>, std::string> decode_base64(std::string_view text) {
    static constexpr auto values = base64_values();
    while (!text.empty() && text.back() == '=') text.remove_suffix(1);
    std::vector<unsigned char> out;
    out.reserve(text.size() / 4 * 3 + 2);
    uint32_t bits = 0;
    int held = 0;
    for (const char c : text) {
        const int value = values[static_cast<unsigned char>(c)];
        if (value < 0) return tl::unexpected(fmt::format("byte {:#04x} is not a base64 digit", static_cast<unsigned char>(c)));
        bits = (bits << 6) | uint32_t(value);
        held += 6;
        if (held >= 8) out.push_back(static_cast<unsigned char>(bits >> (held -= 8)));
    }
    if (text.size() % 4 == 1) return tl::unexpected(std::string("the base64 text ends inside a byte"));
    return out;
}

bool has_scheme(std::string_view uri) {
    const size_t colon = uri.find(':');
    if (colon == std::string_view::npos || colon == 0) return false;
    return std::all_of(uri.begin(), uri.begin() + std::ptrdiff_t(colon),
                       [](unsigned char c) { return std::isalnum(c) || c == '+' || c == '-' || c == '.'; });
}

}  // namespace

bool is_data_uri(std::string_view uri) { return uri.substr(0, 5) == "data:"; }

tl::expected<std::vector<unsigned char>, std::string> decode_data_uri(std::string_view uri) {
    const size_t comma = uri.find(',');
    if (comma == std::string_view::npos) return tl::unexpected(std::string("a data: URI needs a comma before its data"));
    const std::string_view header = uri.substr(5, comma - 5), data = uri.substr(comma + 1);
    constexpr std::string_view kBase64 = ";base64";
    if (header.size() >= kBase64.size() && header.substr(header.size() - kBase64.size()) == kBase64) return decode_base64(data);
    const auto text = percent_decoded(data);
    if (!text) return tl::unexpected(text.error());
    return std::vector<unsigned char>(text->begin(), text->end());
}

tl::expected<std::string, std::string> percent_decoded(std::string_view text) {
    std::string out;
    for (size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            out += text[i];
            continue;
        }
        const int high = i + 2 < text.size() ? hex_digit(text[i + 1]) : -1, low = i + 2 < text.size() ? hex_digit(text[i + 2]) : -1;
        if (high < 0 || low < 0) return tl::unexpected(std::string("a % must be followed by two hexadecimal digits"));
        out += static_cast<char>(high * 16 + low);
        i += 2;
    }
    return out;
}

tl::expected<std::string, std::string> resolve_uri(std::string_view uri, const std::string& base_dir) {
    const auto refuse = [&](const char* why) { return tl::unexpected(fmt::format("URI \"{}\" is refused: {}", uri.substr(0, 100), why)); };
    if (base_dir.empty()) return refuse("files beside the scene may not be read here");
    if (has_scheme(uri)) return refuse("only files beside the scene are read, no other schemes or drives");
    auto decoded = percent_decoded(uri);
    if (!decoded) return refuse(decoded.error().c_str());
    if (has_scheme(*decoded)) return refuse("absolute paths are not allowed");
    auto path = local_path(base_dir, *decoded);
    if (!path) return refuse(path.error().c_str());
    return path;
}

}  // namespace alidade::gltf
