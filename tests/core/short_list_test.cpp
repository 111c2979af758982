// SPDX-License-Identifier: Apache-2.0
#include "core/short_list.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

ShortList<int, 3> counted(int count) {
    ShortList<int, 3> list;
    for (int i = 0; i < count; ++i) list.push_back(10 * i);
    return list;
}

void expect_counted(const ShortList<int, 3>& list, int count) {
    ASSERT_EQ(list.size(), size_t(count));
    EXPECT_EQ(list.empty(), count == 0);
    for (int i = 0; i < count; ++i) EXPECT_EQ(list[size_t(i)], 10 * i);
    EXPECT_EQ(std::vector<int>(list.begin(), list.end()).size(), size_t(count));
}

TEST(ShortList, KeepsItsEntriesBeyondItsOwnRoom) {
    for (int count = 0; count < 10; ++count) expect_counted(counted(count), count);
}

TEST(ShortList, CopiesAreOfTheirOwn) {
    for (int from = 0; from < 7; ++from)
        for (int to = 0; to < 7; ++to) {
            const ShortList<int, 3> original = counted(from);
            ShortList<int, 3> assigned = counted(to), copied = original;
            assigned = original;
            assigned.push_back(10 * from), copied.push_back(10 * from);
            expect_counted(assigned, from + 1), expect_counted(copied, from + 1), expect_counted(original, from);
        }
}

}  // namespace
}  // namespace alidade
