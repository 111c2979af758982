// SPDX-License-Identifier: Apache-2.0
#include "core/huge_pages.h"

#include <algorithm>
#include <cstdlib>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace alidade {

void* allocate_large(size_t bytes, size_t alignment) {
    constexpr size_t page = size_t(1) << 21, most = size_t(1) << 47;   // what addresses have room for: a sanitizer ends the program at less than that
    if (bytes > most) throw std::bad_alloc();
    const bool large = bytes >= 2 * page;
    const size_t unit = std::max(large ? page : sizeof(void*), alignment), rounded = (bytes + unit - 1) / unit * unit;
    void* memory = std::aligned_alloc(unit, std::max(rounded, unit));
    if (!memory) throw std::bad_alloc();
#ifdef __linux__
    if (large) madvise(memory, rounded, MADV_HUGEPAGE);   // a wish: the array is as good without
#endif
    return memory;
}

void free_large(void* memory) noexcept { std::free(memory); }

}  // namespace alidade
