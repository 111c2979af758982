// SPDX-License-Identifier: Apache-2.0
#include "tests/tools/metrics/pairs.h"
#include "tools/metrics/metric.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alidade {
namespace {

using testing::ElementsAre;

TEST(Percentiles, AreTheSmallestValueThatTheShareDoesNotExceed) {
    const double shares[] = {0, 0.2, 0.21, 0.5, 0.8, 0.99, 1};
    EXPECT_THAT(percentiles({50, 10, 40, 20, 30}, shares), ElementsAre(10, 10, 20, 30, 40, 50, 50));
    EXPECT_THAT(percentiles({7}, shares), ElementsAre(7, 7, 7, 7, 7, 7, 7));
}

TEST(Percentiles, OrderNegativeValues) {
    const double shares[] = {0, 0.25, 0.5, 0.75, 1};
    EXPECT_THAT(percentiles({1, -3, 0, -1e-30f}, shares), ElementsAre(-3, -3, double(-1e-30f), 0, 1));
}

TEST(WeightedPercentiles, AreWhereTheSumReachesTheShare) {
    const double shares[] = {0.1, 0.25, 0.5, 0.75, 1};
    EXPECT_THAT(weighted_percentiles({4, 1, 3, 2}, shares), ElementsAre(1, 2, 3, 4, 4)) << "sums 1, 3, 6, 10";
    EXPECT_THAT(weighted_percentiles({0, 0, 0}, shares), ElementsAre(0, 0, 0, 0, 0));
    EXPECT_THAT(weighted_percentiles({0, 0, 5}, shares), ElementsAre(5, 5, 5, 5, 5)) << "zeros weigh nothing";
}

TEST(Percentiles, AreThoseOfASort) {
    std::vector<float> values;
    for (int i = 0; i < 5000; ++i) values.push_back(test::noise(9, -2, 3)(i, 0)[0]);
    auto ordered = values;
    std::sort(ordered.begin(), ordered.end());
    const double shares[] = {0.001, 0.5, 0.95, 0.999};
    EXPECT_THAT(percentiles(values, shares), ElementsAre(double(ordered[4]), double(ordered[2499]), double(ordered[4749]), double(ordered[4994])));
}

}  // namespace
}  // namespace alidade
