// SPDX-License-Identifier: Apache-2.0
#include "core/huge_pages.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <new>

namespace alidade::test {
namespace {

bool aligned(const void* memory, size_t to) { return reinterpret_cast<uintptr_t>(memory) % to == 0; }

TEST(LargeVector, IsAlignedAndHoldsWhatItIsGiven) {
    struct alignas(64) Line {
        uint64_t n[8];
    };
    for (const size_t count : {1u, 1000u, 200000u}) {
        LargeVector<Line> lines(count);
        EXPECT_TRUE(aligned(lines.data(), 64));
        for (size_t i = 0; i < count; ++i) lines[i].n[0] = i;
        lines.resize(3 * count);
        for (size_t i = 0; i < count; ++i) ASSERT_EQ(lines[i].n[0], i);
    }
    LargeVector<char> bytes(size_t(5) << 20);
    EXPECT_TRUE(aligned(bytes.data(), size_t(1) << 21)) << "a huge page can begin with it";
}

TEST(LargeVector, RefusesWhatNoMachineHas) {
    EXPECT_THROW(allocate_large(std::numeric_limits<size_t>::max() - 100, 64), std::bad_alloc);
    EXPECT_THROW(allocate_large(size_t(1) << 60, 64), std::bad_alloc);
}

}  // namespace
}  // namespace alidade::test
