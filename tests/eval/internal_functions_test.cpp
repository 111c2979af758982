// SPDX-License-Identifier: Apache-2.0
/// The functions that POV-Ray has built in, beside its own values.
#include "eval/functions/internal.h"

#include "tests/povray/povray.h"

#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <random>
#include <set>

namespace alidade {
namespace {

/// Arguments behind x, y, z.
struct Case {
    int number;
    std::vector<double> more;
};

const Case kCases[] = {
    {17, {1, 2, 0.5}}, {17, {-1, 0.3, 4}},
    {29, {0.5, 2, 6.5, 0.8, 1, 2}}, {29, {0.9, 2.2, 4, 0.3, 2.7, 0}}, {29, {0.4, 1.7, 1, 0.5, 0, 1}}, {29, {0.4, 1.9, 3.25, 0.7, 2, 3}}, {29, {0.5, 2, 0.5, 0.8, 1, 2}},
    {47, {}}, {57, {}},
    {58, {2, 6.5, 0.5, 0.7, 0.6, 2}}, {58, {1.8, 3, 0.7, 0.2, 0.3, 0}}, {58, {2.1, 1.5, 0.4, 0.5, 0.5, 3}}, {58, {2, 0.5, 0.5, 0.7, 0.6, 1}},
    {59, {0.5, 2.1, 6, 1, 2, 2}}, {59, {0.8, 1.9, 3.5, 0.9, 1.3, 0}}, {59, {0.5, 2, 1, 1, 2, 3}}, {59, {1, 2.5, 9, 0.7, 3, 1}},
    {60, {0.1, 1, 0.8, 1.2}}, {60, {0, 0.5, 0.5, 2}}, {60, {0.4, 1, 2, 0.3}},
    {61, {1.5}}, {61, {0}}, {68, {0.5, 0.3}}, {68, {1, 1}}, {68, {2, 0.7}}, {69, {}}, {70, {1, 0.25}}, {70, {0.3, 1}},
    {76, {}}, {78, {0}}, {78, {1}}, {78, {2}}, {78, {3}},
};

std::vector<Vec3> points() {
    std::mt19937_64 engine(7);
    const auto uniform = [&](double a) { return std::uniform_real_distribution<double>(-a, a)(engine); };
    std::vector<Vec3> all = {Vec3(0), Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0, 0, 2), Vec3(0.5, -0.5, 0.5), Vec3(-1, 2, -3)};
    while (all.size() < 30) {
        const double reach = all.size() % 4 == 0 ? 20 : 2;
        all.emplace_back(uniform(reach), uniform(reach), uniform(reach));
    }
    return all;
}

/// The values at all points, by one run of POV-Ray.
void expect_same(const std::vector<Case>& cases) {
    std::string prelude;
    std::set<int> numbers;
    for (const Case& c : cases) numbers.insert(c.number);
    for (const int n : numbers) prelude += fmt::format("#declare F{} = function {{ internal({}) }}\n", n, n);
    std::vector<std::string> asked;
    for (const Case& c : cases)
        for (const Vec3& p : points()) {
            std::string text = fmt::format("F{}({:.17g}, {:.17g}, {:.17g}", c.number, p.x, p.y, p.z);
            for (const double a : c.more) text += fmt::format(", {:.17g}", a);
            asked.push_back(text + ")");
        }
    const std::vector<double> theirs = povray_values(prelude, asked);
    ASSERT_EQ(theirs.size(), asked.size());
    size_t i = 0;
    for (const Case& c : cases) {
        const InternalFunction* row = find_internal_function(c.number);
        ASSERT_EQ(row->parameters, c.more.size()) << row->name;
        for (const Vec3& p : points()) {
            const double ours = row->value(p, c.more, NoiseGenerator::range_corrected);
            EXPECT_TRUE(std::abs(ours - theirs[i]) <= 1e-12 * std::max(1.0, std::abs(theirs[i])) || (std::isnan(ours) && std::isnan(theirs[i]))) << row->name << " " << asked[i] << ": " << ours << ", POV-Ray has " << theirs[i];
            ++i;
        }
    }
}

TEST(InternalFunctions, HavePovRaysOwnValues) {
    std::set<int> rows, tested;
    for (const InternalFunction& row : internal_functions()) rows.insert(row.number);
    for (const Case& c : kCases) tested.insert(c.number);
    EXPECT_EQ(rows, tested) << "every row has a case";
    if (!povray_is_installed()) GTEST_SKIP() << "povray is not installed";
    // POV-Ray keeps what it has calculated for the first f_ridged_mf() of a run, and takes it for all others.
    for (const Case& c : kCases)
        if (c.number == 59) expect_same({c});
    std::vector<Case> others;
    for (const Case& c : kCases)
        if (c.number != 59) others.push_back(c);
    expect_same(others);
}
TEST(InternalFunctions, NumbersThatAreNoneAreBounded) {
    for (const InternalFunction& row : internal_functions())
        for (const double huge : {1e300, -1e300, std::nan(""), double(INFINITY)}) {
            const std::vector<double> more(row.parameters, huge);
            row.value(Vec3(huge), more, NoiseGenerator::perlin);      // returns, soon
        }
    EXPECT_FALSE(find_internal_function(999));
    EXPECT_FALSE(find_internal_function(76.5));
}

}  // namespace
}  // namespace alidade
