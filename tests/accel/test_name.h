// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cctype>
#include <string>

namespace alidade::test {

/// `text` as the name of a test: - and + become m and p, all else but letters and digits '_'.
inline std::string test_name(std::string text) {
    for (char& c : text) {
        if (c == '-' || c == '+') c = c == '-' ? 'm' : 'p';
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    }
    return text;
}

}  // namespace alidade::test
