// SPDX-License-Identifier: Apache-2.0
#include "core/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

namespace alidade {
namespace {

/// The chi-square statistic of `counts` against equal ones, as a normal deviate (Wilson, Hilferty, 1931).
double chi_square_deviate(const std::vector<int>& counts, double total) {
    const double expected = total / double(counts.size()), freedom = double(counts.size() - 1);
    double chi = 0;
    for (const int n : counts) chi += (n - expected) * (n - expected) / expected;
    return (std::cbrt(chi / freedom) - (1 - 2 / (9 * freedom))) / std::sqrt(2 / (9 * freedom));
}

/// One cell of 32 x 32 for each pair of draws.
double pair_deviate(const std::function<double(int)>& first, const std::function<double(int)>& second) {
    constexpr int kPairs = 200000, kSide = 32;
    std::vector<int> counts(kSide * kSide);
    for (int i = 0; i < kPairs; ++i) ++counts[size_t(first(i) * kSide) * kSide + size_t(second(i) * kSide)];
    return chi_square_deviate(counts, kPairs);
}

TEST(RandomKey, UniformAndIndependentInEveryCoordinate) {
    const auto pixel = [](int i) { return RandomKey(7, 0, uint64_t(i), 0); };
    const struct {
        const char* what;
        double deviate;
    } cases[] = {
        {"neighbouring pixels", pair_deviate([&](int i) { return pixel(i).uniform(0); }, [&](int i) { return pixel(i + 1).uniform(0); })},
        {"two dimensions", pair_deviate([&](int i) { return pixel(i).uniform(0); }, [&](int i) { return pixel(i).uniform(1); })},
        {"far dimensions", pair_deviate([&](int i) { return pixel(i).uniform(3); }, [&](int i) { return pixel(i).uniform(1000003); })},
        {"samples of a pixel", pair_deviate([](int i) { return RandomKey(7, 0, 5, uint64_t(i)).uniform(0); },
                                            [](int i) { return RandomKey(7, 0, 5, uint64_t(i) + 1).uniform(0); })},
        {"frames", pair_deviate([](int i) { return RandomKey(7, uint64_t(i), 5, 0).uniform(0); },
                                [](int i) { return RandomKey(7, uint64_t(i) + 1, 5, 0).uniform(0); })},
        {"seeds", pair_deviate([](int i) { return RandomKey(uint64_t(i), 0, 5, 0).uniform(0); },
                               [](int i) { return RandomKey(uint64_t(i) + 1, 0, 5, 0).uniform(0); })},
        {"two children", pair_deviate([&](int i) { return pixel(i).child(0).uniform(0); }, [&](int i) { return pixel(i).child(1).uniform(0); })},
        {"parent and child", pair_deviate([&](int i) { return pixel(i).uniform(0); }, [&](int i) { return pixel(i).child(0).uniform(0); })},
        {"child and grandchild", pair_deviate([&](int i) { return pixel(i).child(1).uniform(0); },
                                              [&](int i) { return pixel(i).child(1).child(1).uniform(0); })},
    };
    for (const auto& c : cases) EXPECT_LT(std::abs(c.deviate), 4) << c.what;
}

TEST(RandomKey, EveryBitIsFair) {
    constexpr int kDraws = 100000;
    std::vector<int> ones(64);
    for (int i = 0; i < kDraws; ++i) {
        const uint64_t bits = RandomKey(1, 2, 3, uint64_t(i)).bits(4);
        for (size_t b = 0; b < 64; ++b) ones[b] += int(bits >> b & 1);
    }
    for (size_t b = 0; b < 64; ++b) EXPECT_LT(std::abs(ones[b] - kDraws / 2), 4.5 * std::sqrt(kDraws) / 2) << "bit " << b;
}

TEST(RandomKey, StaysBelowOne) {
    for (uint64_t i = 0; i < 100000; ++i) {
        const double u = RandomKey(0, 0, i, 0).uniform(i);
        ASSERT_GE(u, 0);
        ASSERT_LT(u, 1);
    }
}

/// Pictures depend on these numbers: a change of them changes every stochastic render.
TEST(RandomKey, GoldenValues) {
    EXPECT_EQ(RandomKey(0, 0, 0, 0).bits(0), 0xb9895a2b68592df1u);
    EXPECT_EQ(RandomKey(1, 2, 3, 4).bits(5), 0x1fca35ad0a5e3244u);
    EXPECT_EQ(RandomKey(1, 2, 3, 4).child(6).bits(7), 0xc32a74b6df9a6716u);
    EXPECT_EQ(RandomKey(1, 2, 3, 4).child(6).child(8).uniform(9), 0x1.dd66c8af905dcp-1);
}

}  // namespace
}  // namespace alidade
