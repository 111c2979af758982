// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace alidade {

/// The columns and rows that a picture's header tells, without a look at its pixels: of PNG, GIF, and plain and raw PGM, PPM and PFM. Nothing of other files, and where the
/// header is broken: who reads the pixels says what is wrong.
std::optional<std::pair<uint64_t, uint64_t>> header_size(const std::string& path);

}  // namespace alidade
