// SPDX-License-Identifier: Apache-2.0
#include "core/interval.h"
#include "tests/core/draw.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

Interval random_interval(test::Draw& draw) {
    const double a = draw(-1, 1) * draw.decades(-5, 5), b = draw(-1, 1) * draw.decades(-5, 5);
    return {std::min(a, b), std::max(a, b)};
}

/// A point of `i`; the ends are as likely as the middle.
long double random_point(test::Draw& draw, const Interval& i) {
    switch (draw.below(4)) {
        case 0: return i.low;
        case 1: return i.high;
        default: return std::clamp(draw(i.low, i.high), i.low, i.high);
    }
}

/// `exact` has 11 bits more than the ends of the interval: enough to see a bound that is off by a half ulp.
bool holds(const Interval& i, long double exact) { return i.low <= exact && exact <= i.high; }

TEST(Interval, OperationsHoldEveryValue) {
    test::Draw draw(20);
    for (int i = 0; i < 200000; ++i) {
        const Interval a = random_interval(draw), b = random_interval(draw);
        const long double x = random_point(draw, a), y = random_point(draw, b);
        ASSERT_TRUE(holds(a + b, x + y));
        ASSERT_TRUE(holds(a - b, x - y));
        ASSERT_TRUE(holds(-a, -x));
        ASSERT_TRUE(holds(a * b, x * y));
        ASSERT_TRUE(y == 0 || holds(a / b, x / y));
        ASSERT_TRUE(x < 0 || holds(sqrt(a), std::sqrt(x)));
        ASSERT_TRUE(x == -2.5L || holds(a * a - b / (a + 2.5) + sqrt(b * b), x * x - y / (x + 2.5L) + std::sqrt(y * y)));
    }
}

/// Numbers as intervals: the bounds are a few ulp apart, not many.
TEST(Interval, OperationsAreTight) {
    test::Draw draw(21);
    const double epsilon = std::numeric_limits<double>::epsilon();
    for (int i = 0; i < 10000; ++i) {
        const double x = draw(1, 2), y = draw(1, 2);
        ASSERT_LE((Interval(x) + y).width(), 2 * epsilon * (x + y));
        ASSERT_LE((Interval(x) * y).width(), 2 * epsilon * (x * y));
        ASSERT_LE((Interval(x) / y).width(), 8 * epsilon * (x / y));
        ASSERT_LE(sqrt(Interval(x)).width(), 2 * epsilon * std::sqrt(x));
    }
}

TEST(Interval, DivisionByZeroIsTheWholeLine) {
    const Interval whole = Interval(1) / Interval(-1, 1);
    EXPECT_EQ(whole.low, -std::numeric_limits<double>::infinity());
    EXPECT_EQ(whole.high, std::numeric_limits<double>::infinity());
    EXPECT_TRUE((Interval(0) * whole).contains(0)) << "0 times anything is 0";
    EXPECT_TRUE((Interval(0, 1) * whole).contains(-7));
    EXPECT_TRUE((whole + whole).contains(1e300));
}

TEST(Interval, SqrtIsOfThePartThatIsNotNegative) {
    EXPECT_EQ(sqrt(Interval(-2, -1)).low, 0);
    EXPECT_LT(sqrt(Interval(-2, -1)).high, 1e-300);
    EXPECT_TRUE(sqrt(Interval(-1, 4)).contains(2));
}

}  // namespace
}  // namespace alidade
