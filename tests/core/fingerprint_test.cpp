// SPDX-License-Identifier: Apache-2.0
/// What stands for large arrays tells them apart.
#include "core/fingerprint.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace alidade::test {
namespace {

/// Lengths that end in each part of a stride, and all of zeros: length tells these apart.
TEST(Fingerprint, EveryChangeOfAnArrayShows) {
    std::set<uint64_t> seen;
    size_t count = 0;
    const auto add = [&](const std::vector<std::byte>& bytes) { seen.insert(fingerprint_of_array(bytes)), ++count; };
    for (size_t size = 0; size <= 100; ++size) {
        std::vector<std::byte> bytes(size);
        add(bytes);
        for (size_t i = 0; i < size; ++i) {
            for (int bit = 0; bit < 8; ++bit) {
                bytes[i] ^= std::byte(1 << bit);
                add(bytes);
                bytes[i] = std::byte(0);
            }
        }
    }
    EXPECT_EQ(seen.size(), count);
}

/// Signs of floats are the highest bits of words, where a mere product keeps what differs: two of them in one lane must not cancel.
TEST(Fingerprint, ChangedSignsDoNotCancel) {
    std::vector<std::byte> bytes(4096, std::byte(5));
    std::set<uint64_t> seen{fingerprint_of_array(bytes)};
    size_t count = 1;
    for (size_t first = 7; first < 512; first += 8) {
        for (size_t second = first + 8; second < 512; second += 8, ++count) {
            bytes[first] ^= std::byte(128), bytes[second] ^= std::byte(128);
            seen.insert(fingerprint_of_array(bytes));
            bytes[first] ^= std::byte(128), bytes[second] ^= std::byte(128);
        }
    }
    EXPECT_EQ(seen.size(), count);
}

TEST(Fingerprint, GoesOnFromWhatWasBefore) {
    const std::vector<std::byte> bytes(64);
    EXPECT_NE(fingerprint_of_array(bytes, 1), fingerprint_of_array(bytes, 2));
    EXPECT_EQ(fingerprint_of_array(bytes, 1), fingerprint_of_array(bytes, 1));
}

}  // namespace
}  // namespace alidade::test
