// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/utf8.h"

namespace alidade::pov {

void append_utf8(std::string& out, uint32_t code) {
    if (code < 0x80) {
        out += char(code);
    } else if (code < 0x800) {
        out += char(0xC0 | code >> 6), out += char(0x80 | (code & 0x3F));
    } else if (code >= 0x10000) {
        out += char(0xF0 | code >> 18), out += char(0x80 | (code >> 12 & 0x3F)), out += char(0x80 | (code >> 6 & 0x3F)), out += char(0x80 | (code & 0x3F));
    } else {
        out += char(0xE0 | code >> 12), out += char(0x80 | (code >> 6 & 0x3F)), out += char(0x80 | (code & 0x3F));
    }
}

std::vector<uint32_t> characters(const std::string& text) {
    std::vector<uint32_t> out;
    for (size_t i = 0; i < text.size();) {
        const auto byte = [&](size_t k) { return k < text.size() ? uint32_t(static_cast<unsigned char>(text[k])) : 0; };
        const uint32_t first = byte(i);
        const int more = first >= 0xf0 && first < 0xf8 ? 3 : first >= 0xe0 && first < 0xf0 ? 2 : first >= 0xc0 && first < 0xe0 ? 1 : 0;
        uint32_t value = more ? first & (0x3fu >> more) : first;
        bool whole = true;
        for (int k = 1; k <= more; ++k) whole = whole && (byte(i + size_t(k)) & 0xc0) == 0x80, value = value << 6 | (byte(i + size_t(k)) & 0x3f);
        out.push_back(whole ? value : first);
        i += whole ? size_t(more) + 1 : 1;
    }
    return out;
}

}  // namespace alidade::pov
