// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>

namespace alidade {

inline constexpr uint64_t kFingerprintOfNothing = 0xcbf29ce484222325u;

/// Stands for `bytes`, and for what `before` stands for: 64-bit FNV-1a (Fowler, Noll, Vo), the constants of its authors. Every change of a single byte
/// shows; it is no seal against forgers.
inline uint64_t fingerprint(std::span<const std::byte> bytes, uint64_t before = kFingerprintOfNothing) {
    for (const std::byte b : bytes) before = (before ^ uint64_t(b)) * 0x100000001b3u;
    return before;
}
inline uint64_t fingerprint(std::string_view text, uint64_t before = kFingerprintOfNothing) { return fingerprint(std::as_bytes(std::span(text)), before); }

/// The same promise for large arrays, several times as fast: words of eight bytes, as this machine reads them, in four lanes that do not wait for each other.
inline uint64_t fingerprint_of_array(std::span<const std::byte> bytes, uint64_t before = kFingerprintOfNothing) {
    const auto mixed = [](uint64_t lane, uint64_t word) {   // different for each word, and for each lane; the highest bits of words reach others, too
        constexpr uint64_t factor = 0x9e3779b97f4a7c15u;
        lane = (lane ^ word) * factor;
        return (lane ^ lane >> 32) * factor;
    };
    uint64_t lanes[4] = {before, 1, 2, 3}, words[4];
    for (size_t i = 0; i < bytes.size(); i += sizeof(words)) {
        if (bytes.size() - i < sizeof(words)) std::memset(words, 0, sizeof(words));
        std::memcpy(words, bytes.data() + i, bytes.size() - i < sizeof(words) ? bytes.size() - i : sizeof(words));
        for (int k = 0; k < 4; ++k) lanes[k] = mixed(lanes[k], words[k]);
    }
    uint64_t all = mixed(~before, bytes.size());   // else a size and a word could change places
    for (const uint64_t lane : lanes) all = mixed(all, lane);
    return all;
}

}  // namespace alidade
