// SPDX-License-Identifier: Apache-2.0
/// Each row of the pattern registry against POV-Ray: its own run where it is installed, and what it printed once where that is at hand.
#include "eval/noise/hash.h"
#include "eval/patterns/pattern.h"

#include "pattern_cases.h"
#include "tests/povray/povray.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <map>
#include <random>
#include <set>

using namespace alidade;

namespace {

Pattern made(const PatternSignal& signal) {
    auto pattern = Pattern::make(signal);
    EXPECT_TRUE(pattern) << pattern.error();
    return *pattern;
}

/// Where patterns have their detail, far away, and on the planes between cells.
std::vector<Vec3> pattern_points(size_t count, unsigned seed) {
    std::mt19937_64 engine(seed);
    const auto uniform = [&](double a) { return std::uniform_real_distribution<double>(-a, a)(engine); };
    std::vector<Vec3> points = {Vec3(0), Vec3(1), Vec3(-1), Vec3(0.5, -0.5, 0.5), Vec3(0, 0.3, 0), Vec3(0, -0.3, 0), Vec3(-1, 0, 1), Vec3(-1, 1, -1)};
    while (points.size() < count) {
        const double reach = std::vector<double>{3, 3, 3, 1, 40}[points.size() % 5];
        Vec3 p(uniform(reach), uniform(reach), uniform(reach));
        if (points.size() % 7 == 0) p = Vec3(std::round(p.x * 4), std::round(p.y * 4), std::round(p.z * 4)) / 4.0;
        points.push_back(p);
    }
    return points;
}

/// POV-Ray's text for a function of the case's value.
std::string declared(const PatternCase& c, size_t index) {
    if (!c.colours) return fmt::format("#declare F{} = function {{ pattern {{ {} }} }}\n", index, c.declaration);
    const size_t name = c.declaration.find(' ');
    std::string list;
    for (int i = 0; i < c.colours; ++i) list += fmt::format("{} rgb {}", i ? "," : "", i);
    const std::string rest = name == std::string::npos ? "" : c.declaration.substr(name);
    return fmt::format("#declare F{} = function {{ pigment {{ {}{}{} }} }}\n", index, c.declaration.substr(0, name), list, rest);
}

bool same(double a, double b, double allowed) { return std::fabs(a - b) <= allowed || (std::isnan(a) && std::isnan(b)); }

}  // namespace

/// Without a cell left out: crackle's nearest point of all 81 around.
Vec3 nearest_of_all(const Vec3& p, double metric) {
    Vec3 nearest(0);
    double least = kInf;
    for (int i = 0; i < 125; ++i) {
        const Vec3 from_own(i % 5 - 2, i / 5 % 5 - 2, i / 25 - 2), cell = glm::floor(p - kBlockEpsilon) + from_own;
        if ((std::abs(from_own.x) == 2) + (std::abs(from_own.y) == 2) + (std::abs(from_own.z) == 2) > 1) continue;
        const unsigned h = cell_hash(int64_t(cell.x), int64_t(cell.y), int64_t(cell.z));
        const Vec3 at = cell + Vec3(cell_random(h), cell_random(h + 1), cell_random(h + 2)), away = glm::abs(at - p);
        const double distance = std::pow(away.x, metric) + std::pow(away.y, metric) + std::pow(away.z, metric);
        if (distance < least) least = distance, nearest = at;
    }
    return nearest;
}

TEST(Patterns, CrackleLeavesOutOnlyCellsThatAreTooFar) {
    for (const double metric : {1.0, 2.0, 3.0, 0.5})
        for (const Vec3& p : pattern_points(5000, 11)) ASSERT_EQ(pattern::nearest_point(p, metric), nearest_of_all(p, metric)) << metric << ": " << p.x << " " << p.y << " " << p.z;
}

/// Four places at once have the values of each alone, bit for bit: in one cell and across cells, on the planes between them, far away, and where there is no number.
TEST(Patterns, FourPlacesAreAsEachAlone) {
    std::vector<PatternSignal> signals;
    for (const PatternOps& row : patterns()) {
        if (!row.four) continue;
        for (const NoiseGenerator generator : {NoiseGenerator::original, NoiseGenerator::range_corrected, NoiseGenerator::perlin}) {
            PatternSignal signal;
            signal.pattern = row.name, signal.noise = generator, signal.frequency = 1.7, signal.wave = Wave::sine;
            signals.push_back(signal);
        }
    }
    ASSERT_EQ(signals.size(), 12u) << "bozo, spotted, granite, crackle";
    for (const std::vector<double>& parameters : {std::vector<double>{1, 0, 0}, {-1, 1, 0}, {0.3, -0.4, 0.9, 2, 0.1}, {1, 0, 0, 1}, {-1, 1, 0, 3}, {0, 0, 0, 2, 0, 1}}) {
        PatternSignal signal;
        signal.pattern = "crackle", signal.parameters = parameters;
        signals.push_back(signal);
    }
    std::vector<Vec3> points = pattern_points(1500, 23);
    for (const double far : {1e8, 3e9, 1e12, 1e300}) points.push_back({far, -far, 0.3}), points.push_back({0.1, 0.2, -far});
    points.push_back(Vec3(std::numeric_limits<double>::quiet_NaN(), 0, 0));
    for (const PatternSignal& signal : signals) {
        const Pattern pattern = made(signal);
        for (size_t i = 0; i < points.size(); ++i) {
            const double size = std::vector<double>{0.02, 0.02, 0.3, 1e-6, 3}[i % 5];
            const Vec3 places[4] = {points[i] + Vec3(size, -size / 3, 0), points[i] + Vec3(-size / 2, -size / 3, size), points[i] + Vec3(-size / 2, -size / 3, -size), points[i] + Vec3(0, size, 0)};
            double together[4];
            pattern.values_at(places, together);
            for (int k = 0; k < 4; ++k) ASSERT_TRUE(same(together[k], pattern.value_at(places[k]), 0)) << signal.pattern << " " << i << " " << k;
        }
    }
}

TEST(Patterns, EveryRowHasACase) {
    std::set<std::string> tested = {"average", "facets"};   // have no number: pictures beside POV-Ray's
    for (const PatternCase& c : pattern_cases()) tested.insert(c.signal.pattern);
    for (const PatternOps& row : patterns()) EXPECT_TRUE(row.source != SourceKind::none || tested.count(row.name)) << row.name;
    std::set<WarpKind> warps;
    for (const PatternCase& c : pattern_cases())
        for (const Warp& w : c.signal.warps) warps.insert(w.kind);
    EXPECT_EQ(warps.size(), size_t(WarpKind::cubic) + 1);
}

TEST(Patterns, ASourceIsAskedAtThePlaceAndShaped) {
    PatternSignal s;
    s.pattern = "pigment_pattern";
    s.source = SignalId{0};
    s.wave = Wave::triangle, s.frequency = 2;
    s.warps.push_back({WarpKind::transform, Transform::scale(Vec3(4)), {}});
    const auto pattern = Pattern::make(s, {[](const Vec3& p) { return p.x; }, nullptr});
    ASSERT_TRUE(pattern);
    EXPECT_DOUBLE_EQ(pattern->value({1, 0, 0}), 1);      // a quarter, twice, folded
    EXPECT_DOUBLE_EQ(pattern->value({0.5, 0, 0}), 0.5);
    EXPECT_FALSE(pattern->is_average());
    EXPECT_FALSE(Pattern::make(s)) << "nobody knows the number";
    s.pattern = "bozo";
    EXPECT_FALSE(Pattern::make(s)) << "which has its own";
}

TEST(Patterns, EveryCaseIsPovRays) {
    if (!povray_is_installed()) GTEST_SKIP() << "povray is not installed";
    const std::vector<PatternCase> cases = pattern_cases();
    constexpr size_t kEach = 260;
    std::string prelude;
    std::vector<std::string> asked;
    for (size_t i = 0; i < cases.size(); ++i) {
        prelude += declared(cases[i], i);
        for (const Vec3& p : pattern_points(kEach, unsigned(i))) asked.push_back(fmt::format("F{}({:.17g}, {:.17g}, {:.17g}){}", i, p.x, p.y, p.z, cases[i].colours ? ".red" : ""));
    }
    ASSERT_GE(asked.size(), 20000u);
    const std::vector<double> theirs = povray_values(prelude, asked);
    ASSERT_EQ(theirs.size(), asked.size());
    for (size_t i = 0; i < cases.size(); ++i) {
        const Pattern pattern = made(cases[i].signal);
        const std::vector<Vec3> points = pattern_points(kEach, unsigned(i));
        int wrong = 0;
        std::string first;
        for (size_t k = 0; k < kEach; ++k) {
            const double ours = pattern.value(points[k]), want = theirs[i * kEach + k];
            if (!same(ours, want, 1e-9) && !wrong++) first = fmt::format("{}: {:.17g}, POV-Ray has {:.17g}", pov_text(points[k]), ours, want);
        }
        EXPECT_EQ(wrong, 0) << cases[i].declaration << " at " << first;
    }
}

TEST(Patterns, SharedVectors) {
    std::map<std::string, Pattern> by_declaration;
    for (const PatternCase& c : pattern_cases()) by_declaration.emplace(c.declaration, made(c.signal));
    int compared = 0;
    for (const PovVector& v : pov_vectors()) {
        if (v.kind != "pattern") continue;
        ++compared;
        const auto at = by_declaration.find(v.declaration);
        ASSERT_NE(at, by_declaration.end()) << v.declaration;
        const double ours = at->second.value(v.point);
        EXPECT_TRUE(same(ours, v.value, 1e-9)) << v.declaration << " at " << pov_text(v.point) << ": " << ours << ", POV-Ray printed " << v.value;
    }
    if (!compared) GTEST_SKIP() << "the shared research is not at hand";
    EXPECT_EQ(compared, 2988);
}

TEST(Patterns, WhatCannotBeIsRefused) {
    PatternSignal s;
    s.pattern = "zork";
    EXPECT_EQ(Pattern::make(s).error(), "there is no pattern 'zork'");
    s.pattern = "bozo";
    s.parameters = {1};
    EXPECT_EQ(Pattern::make(s).error(), "the pattern 'bozo' has 1 parameters, more than 0");
    s.parameters = {};
    s.warps = {{WarpKind::transform, Transform::scale({1, 0, 1}), {}}};
    EXPECT_EQ(Pattern::make(s).error(), "a pattern is flattened by its transform, which has no inverse");
    s.warps = {{WarpKind::repeat, {}, {0, 0, 0, 1, 0, 0}}};
    EXPECT_EQ(Pattern::make(s).error(), "a repeat warp has no width");
    s.warps = {{WarpKind::cubic, {}, {1}}};
    EXPECT_EQ(Pattern::make(s).error(), "a warp has 1 parameters, more than 0");
}

/// Wild numbers give some number: nothing traps, and nothing runs on.
TEST(Patterns, WildNumbersAreHarmless) {
    for (const PatternOps& row : patterns())
        for (const double wild : {0.0, -1.0, 1e300, -1e300, 1e-300}) {
            PatternSignal s;
            s.pattern = row.name;
            for (const PatternParameter& p : row.parameters) s.parameters.push_back(std::string(p.name) == "iterations" ? std::min(wild, 100.0) : wild);
            s.turbulence = {Vec3(wild), int(std::clamp(wild, -9.0, 99.0)), wild, wild};
            s.frequency = wild;
            if (row.source != SourceKind::none) continue;
            const Pattern pattern = made(s);
            for (const double at : {0.0, 0.3, -1e300, 1e300, std::nan("")}) (void)pattern.value({at, 0.5, at});
        }
}
