// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
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

}  // namespace alidade
