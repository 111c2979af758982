// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <charconv>
#include <string>

namespace alidade {

/// The fewest digits that read back as the same number, whatever the locale.
template <class T> void append_number(std::string& out, T value) {
    char digits[64];
    out.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

/// " x" for each of `values`.
template <class... T> void append_numbers(std::string& out, T... values) { ((out += ' ', append_number(out, values)), ...); }

}  // namespace alidade
