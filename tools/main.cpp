// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs.h"

#include <cstdio>
#include <exception>
#include <fmt/format.h>
#include <new>

int main(int argc, char** argv) {
    try {
        const int code = alidade::run_words(alidade::Words(argv + 1, argv + argc));
        if (std::fflush(stdout) == 0) return code;
        fmt::print(stderr, "alidade: error: stdout cannot be written to\n");
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "alidade: error: out of memory\n");
    } catch (const std::exception& e) {
        fmt::print(stderr, "alidade: error: {}\n", std::ferror(stdout) ? "stdout cannot be written to" : e.what());   // what is longer than a buffer fails before its end
    }
    return alidade::kError;
}
