// SPDX-License-Identifier: Apache-2.0
/// Strings are UTF-8; the scene language counts characters.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace alidade::pov {

void append_utf8(std::string& out, uint32_t code);

/// Their codes. A byte that is no UTF-8 stands for itself.
std::vector<uint32_t> characters(const std::string& text);

}  // namespace alidade::pov
