// SPDX-License-Identifier: Apache-2.0
#include "numerics/suite.h"

#include "tests/accel/run_size.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>

namespace alidade::test {
namespace {

class Numerics : public testing::TestWithParam<const NumericsRow*> {};

TEST_P(Numerics, MeetsItsGoal) {
    const NumericsRow& row = *GetParam();
    const NumericsTally tally = run_numerics(row, 0, run_size(row.ci, row.full));
    fmt::print("{} {}: {} asked, {} wrong, worst {:.3g} (case {})\n", row.id, row.name, tally.asked(), tally.wrong(), tally.worst(), tally.worst_case());
    EXPECT_GT(tally.asked(), run_size(row.ci, row.full) / 4) << "most cases ask something";
    const uint64_t allowed = row.id == std::string("T14") ? tally.asked() / 1000 : 0;
    EXPECT_LE(tally.wrong(), allowed) << row.id << " case " << tally.first_wrong() << ": " << tally.why();
}

std::vector<const NumericsRow*> rows() {
    std::vector<const NumericsRow*> list;
    for (const NumericsRow& row : numerics_suite()) list.push_back(&row);
    return list;
}

INSTANTIATE_TEST_SUITE_P(Suite, Numerics, testing::ValuesIn(rows()), [](const auto& row) { return std::string(row.param->id); });

/// T14, by its figure, and T24, whose goal leaves plastics out: both are told.
TEST(NumericsSuite, AtMostTwoRowsFallShort) {
    size_t count = 0;
    for (const NumericsRow& row : numerics_suite()) count += *row.falls_short != 0;
    EXPECT_LE(count, 2u);
    for (const char* row : {"T14", "T24"}) EXPECT_TRUE(*find_numerics(row)->falls_short) << row;
}

/// What whole runs found, and ordinary ones are too short for.
TEST(NumericsSuite, CasesThatOnceFailedAreRight) {
    for (const auto& [row, number] : {std::pair("T09", 28464), {"T09", 468079}, {"T09", 1023371}, {"T15", 14831}}) {
        const NumericsTally tally = run_numerics(*find_numerics(row), uint64_t(number), 1);
        EXPECT_GT(tally.asked(), 0u) << row << ' ' << number;
        EXPECT_EQ(tally.wrong(), 0u) << row << ' ' << number << ": " << tally.why();
    }
}

TEST(NumericsSuite, IdsAreInOrderAndFound) {
    std::string last;
    for (const NumericsRow& row : numerics_suite()) {
        EXPECT_LT(last, row.id);
        last = row.id;
        EXPECT_EQ(find_numerics(row.id), &row);
        EXPECT_EQ(find_numerics(row.name), &row);
    }
    EXPECT_EQ(find_numerics("T99"), nullptr);
}

}  // namespace
}  // namespace alidade::test
