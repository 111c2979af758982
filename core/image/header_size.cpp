// SPDX-License-Identifier: Apache-2.0
#include "core/header_size.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <string_view>

namespace alidade {

namespace {

using HeaderSize = std::optional<std::pair<uint64_t, uint64_t>>;

uint64_t number_at(std::string_view head, size_t at, size_t bytes, bool little) {
    uint64_t n = 0;
    for (size_t i = 0; i < bytes; ++i) n = n << 8 | static_cast<unsigned char>(head[little ? at + bytes - 1 - i : at + i]);
    return n;
}

/// `P6 # comment` and two numbers.
HeaderSize pnm_size(std::string_view head) {
    uint64_t numbers[2] = {};
    size_t at = 2;
    for (uint64_t& n : numbers) {
        for (; at < head.size() && (std::isspace(static_cast<unsigned char>(head[at])) || head[at] == '#'); ++at)
            if (head[at] == '#') at = std::min(head.find('\n', at), head.size() - 1);
        const size_t first = at;
        for (; at < head.size() && std::isdigit(static_cast<unsigned char>(head[at])) && at - first < 18; ++at) n = 10 * n + uint64_t(head[at] - '0');
        if (at == first || at == head.size()) return std::nullopt;
    }
    return HeaderSize({numbers[0], numbers[1]});
}

}  // namespace

HeaderSize header_size(const std::string& path) {
    constexpr size_t kHead = 1024;
    std::string bytes(kHead, '\0');
    std::ifstream in(path, std::ios::binary);
    in.read(bytes.data(), std::streamsize(bytes.size()));
    bytes.resize(size_t(std::max<std::streamsize>(in.gcount(), 0)));
    const std::string_view head = bytes;
    if (head.size() < 24) return std::nullopt;
    if (head.starts_with("\x89PNG\r\n\x1a\n") && head.substr(12, 4) == "IHDR") return HeaderSize({number_at(head, 16, 4, false), number_at(head, 20, 4, false)});
    if (head.starts_with("GIF87a") || head.starts_with("GIF89a")) return HeaderSize({number_at(head, 6, 2, true), number_at(head, 8, 2, true)});
    const bool is_pnm = head[0] == 'P' && std::string_view("2356fF").find(head[1]) != std::string_view::npos && std::isspace(static_cast<unsigned char>(head[2]));
    return is_pnm ? pnm_size(head) : std::nullopt;
}

}  // namespace alidade
