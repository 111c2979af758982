// SPDX-License-Identifier: Apache-2.0
/// What `tradeoff` is made of: axes, statistics, fronts, and the closed forms themselves.
#include "core/random.h"
#include "tools/analytic.h"
#include "tools/tradeoff/axes.h"
#include "tools/tradeoff/errors.h"
#include "tools/tradeoff/external.h"
#include "tools/tradeoff/statistics.h"
#include "tools/store.h"
#include "tools/tradeoff/verdict.h"

#include <filesystem>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <set>
#include <unistd.h>

namespace alidade::tradeoff {
namespace {

TEST(TradeoffAxes, AreNamesAndValues) {
    const auto axis = parse_axis("spp=1,4,16");
    ASSERT_TRUE(axis);
    EXPECT_EQ(axis->name, "spp");
    EXPECT_EQ(axis->values, (std::vector<std::string>{"1", "4", "16"}));
    EXPECT_EQ(parse_axis("declare=A=1,A=2")->values, (std::vector<std::string>{"A=1", "A=2"}));
    EXPECT_EQ(parse_axis("aov=depth,normal;id")->values, (std::vector<std::string>{"depth,normal", "id"}));
    for (const char* bad : {"", "spp", "=1", "spp=", "spp=1,,4", "spp=1,4,1"}) EXPECT_FALSE(parse_axis(bad)) << bad;
}

TEST(TradeoffAxes, ModesChooseSettings) {
    const std::vector<Axis> axes{{"a", {"1", "2", "3"}}, {"b", {"x", "y"}}};
    EXPECT_EQ(expand(axes, *parse_mode("full"))->size(), 6u);
    EXPECT_EQ(expand(axes, *parse_mode("one"))->size(), 5u);
    const auto spread = *expand(axes, *parse_mode("halton:4"));
    ASSERT_EQ(spread.size(), 4u);
    for (size_t i = 0; i < 4; ++i)
        for (size_t j = 0; j < i; ++j) EXPECT_NE(spread[i], spread[j]);
    EXPECT_EQ(expand(axes, *parse_mode("halton:100"))->size(), 6u) << "there are no more";
    for (const char* bad : {"", "all", "halton", "halton:", "halton:0", "halton:1e3"}) EXPECT_FALSE(parse_mode(bad)) << bad;
}

/// Of Halton's points every prefix of b^k points has as many in each of b parts: here the first axis of two values, base 2.
TEST(TradeoffAxes, HaltonIsEven) {
    Axis many{"a", {}};
    for (int i = 0; i < 64; ++i) many.values.push_back(std::to_string(i));
    const auto spread = *expand(std::vector<Axis>{many}, *parse_mode("halton:32"));
    int low = 0;
    for (const Setting& setting : spread) low += std::stoi(setting[0].value) < 32;
    EXPECT_EQ(low, 16);
}

TEST(TradeoffAxes, MoreThanAnyoneMeansIsRefusedAtOnce) {
    std::vector<Axis> axes(9);
    for (size_t i = 0; i < axes.size(); ++i) {
        axes[i].name = std::string(1, char('a' + i));
        for (int v = 0; v < 10; ++v) axes[i].values.push_back(std::to_string(v));
    }
    const auto settings = expand(axes, *parse_mode("full"));
    ASSERT_FALSE(settings);
    EXPECT_NE(settings.error().find("1e+09 settings"), std::string::npos) << settings.error();
    EXPECT_EQ(expand(axes, *parse_mode("one"))->size(), 90u);
}

TEST(TradeoffAxes, SettingsReplaceWhatIsGiven) {
    const Setting base{{"spp", "4"}, {"declare", "A=1"}};
    EXPECT_EQ(combined(base, {{"spp", "16"}}), (Setting{{"declare", "A=1"}, {"spp", "16"}}));
    EXPECT_EQ(combined(base, {{"declare", "B=2"}}).size(), 3u) << "what may be given more than once is added";
    const auto request = parse_request("a.glb", {{"spp", "7"}, {"full-kernel", "true"}, {"exposure", "-2"}});
    ASSERT_TRUE(request);
    EXPECT_EQ(request->render.spp, 7);
    EXPECT_TRUE(request->compile.full_kernel);
    EXPECT_EQ(request->render.exposure, -2);
    EXPECT_NE(parse_request("a.glb", {{"ssp", "7"}}).error().find("did you mean '--spp'?"), std::string::npos);
}

TEST(TradeoffStatistics, MediansAndDeviations) {
    EXPECT_EQ(median({3, 1, 2}), 2);
    EXPECT_EQ(median({4, 1, 2, 3}), 2.5);
    EXPECT_TRUE(std::isnan(median({})));
    EXPECT_EQ(median_deviation({1, 2, 3, 4, 1000}), 1) << "one round does not matter";
    EXPECT_FALSE(differ({1, 0.1}, {1.1, 0.06}));
    EXPECT_TRUE(differ({1, 0.1}, {1.25, 0.06}));
    EXPECT_FALSE(differ({1, 0}, {1, 0}));
    EXPECT_TRUE(differ({1, 0}, {1.0001, 0})) << "what is counted differs by any amount";
}

/// The interval of the median of 40 values holds the true one in 95 of 100 cases, or nearly: the percentile method is known to be a little narrow.
TEST(TradeoffStatistics, IntervalsHoldTheMedian) {
    int held = 0;
    for (uint64_t trial = 0; trial < 300; ++trial) {
        std::vector<double> values;
        for (uint64_t i = 0; i < 40; ++i) values.push_back(RandomKey(trial, 1, 2).uniform(i));
        const Interval interval = median_interval(values);
        held += interval.low <= 0.5 && 0.5 <= interval.high;
    }
    EXPECT_GE(held, 270);
    EXPECT_LT(held, 300);
    EXPECT_EQ(median_interval({2}).low, 2);
}

TEST(TradeoffStatistics, ShufflesAreFair) {
    std::vector<int> first(5);
    for (uint64_t i = 0; i < 5000; ++i) {
        const auto order = shuffled(5, RandomKey(i, 0, 0));
        EXPECT_EQ(std::set<size_t>(order.begin(), order.end()).size(), 5u);
        ++first[order[0]];
    }
    for (const int count : first) EXPECT_NEAR(count, 1000, 150);
}

/// The definition itself is the oracle, without noise: nothing else is as good in one and better in the other.
TEST(TradeoffFront, IsWhatNothingDominates) {
    const RandomKey key(1, 2, 3);
    std::vector<Point> points;
    for (uint64_t i = 0; i < 300; ++i) points.push_back({{std::floor(20 * key.uniform(2 * i)), 0}, std::floor(20 * key.uniform(2 * i + 1))});
    const std::vector<bool> front = front_of(points);
    int count = 0;
    for (size_t i = 0; i < points.size(); ++i) {
        bool beaten = false;
        for (const Point& other : points) {
            const bool as_good = other.cost.median <= points[i].cost.median && other.error <= points[i].error;
            beaten = beaten || (as_good && (other.cost.median < points[i].cost.median || other.error < points[i].error));
        }
        EXPECT_EQ(front[i], !beaten) << i;
        count += front[i];
    }
    EXPECT_GT(count, 1);
    EXPECT_LT(count, 30);
}

TEST(TradeoffFront, DoesNotCallNoiseADifference) {
    const std::vector<Point> equal{{{1.00, 0.1}, 0.5}, {{1.05, 0.1}, 0.5}};
    EXPECT_EQ(front_of(equal), (std::vector<bool>{true, true}));
    const std::vector<Point> better{{{1.00, 0.1}, 0.5}, {{1.05, 0.1}, 0.4}};
    EXPECT_EQ(front_of(better), (std::vector<bool>{false, true})) << "as fast, and more accurate";
    EXPECT_EQ(front_of({{{1, 0}, 0}}), (std::vector<bool>{true}));
}

TEST(TradeoffFront, HasItsKneeWhereItBends) {
    std::vector<Point> front;
    for (int i = 0; i <= 10; ++i) front.push_back({{std::pow(10.0, i), 0}, std::pow(10.0, i <= 3 ? -2.0 * i : -6 - 0.1 * (i - 3))});
    EXPECT_EQ(knee_of(front), 3u);
    EXPECT_EQ(knee_of({front[0], front[10]}), std::nullopt);
    for (int i = 0; i <= 10; ++i) front[size_t(i)].error = std::pow(10.0, -i);
    EXPECT_EQ(knee_of(front), std::nullopt) << "a straight line has none";
    front[10].error = 0;
    EXPECT_NO_FATAL_FAILURE((void)knee_of(front));
}

TEST(TradeoffRequirements, HaveAnErrorAndACost) {
    const auto rule = parse_requirement("rmse<0.01 @ rays<2e6");
    ASSERT_TRUE(rule) << rule.error();
    EXPECT_EQ(rule->error.metric, "rmse");
    EXPECT_EQ(rule->error.limit, 0.01);
    EXPECT_EQ(rule->cost.metric, "rays");
    EXPECT_EQ(rule->cost.limit, 2e6);
    EXPECT_EQ(parse_requirement("over4 <= 0.5% @ time < 1")->error.limit, 0.005);
    for (const auto& [bad, says] : {std::pair{"rmse<0.01", "@"}, {"rmsee<0.01 @ rays<1", "did you mean 'rmse'?"}, {"rmse<0.01 @ ray<1", "did you mean 'rays'?"}, {"rmse<x @ rays<1", "no limit"}, {"@", "NAME<LIMIT"}}) {
        const auto wrong = parse_requirement(bad);
        ASSERT_FALSE(wrong) << bad;
        EXPECT_NE(wrong.error().find(says), std::string::npos) << wrong.error();
    }
}

/// Two settings that differ in what must not matter alone.
Experiment with_two_accelerators(const std::string& second_spp) {
    Experiment e;
    e.job.scene = "analytic:lambert-sphere";
    e.job.axes = {{"accel", {"bvh", "grid"}}};
    for (const char* accel : {"bvh", "grid"}) {
        Row row;
        row.setting = {{"accel", accel}};
        row.is_default = e.rows.empty();
        row.options = {{"accel", accel}, {"size", "8x8"}, {"spp", "1"}};
        Setting real = row.options;
        if (!e.rows.empty()) real.back().value = second_spp;
        row.request = *parse_request(e.job.scene, real);
        row.errors["rmse"] = 0.5;
        row.seconds = {1};
        row.fingerprint = second_spp == "1" ? 0 : e.rows.size();
        e.rows.push_back(row);
    }
    return e;
}

TEST(TradeoffVerdict, AFreeAxisThatChangesThePictureIsTold) {
    const Verdicts fine = judge(with_two_accelerators("1"), {});
    EXPECT_EQ(fine.free_axes, (std::vector<std::string>{"accel"}));
    EXPECT_TRUE(fine.not_free.empty());
    EXPECT_TRUE(fine.unchecked_axes.empty());
    const Verdicts bad = judge(with_two_accelerators("4"), {});
    ASSERT_EQ(bad.not_free.size(), 1u);
    EXPECT_EQ(bad.not_free[0].sentence.rfind("accel=bvh and accel=grid made different pictures, which is a bug: pixel ", 0), 0u) << bad.not_free[0].sentence;
}

TEST(TradeoffVerdict, AnAxisIsCalledFreeOnlyWhereItWasCompared) {
    Experiment e = with_two_accelerators("1");
    e.rows[1].options.back().value = "4";   // which is paid for
    EXPECT_TRUE(judge(e, {}).free_axes.empty());
    EXPECT_EQ(judge(e, {}).unchecked_axes, (std::vector<std::string>{"accel"}));
    e.rows[1].options = {{"spp", "1"}, {"accel", "grid"}, {"size", "8x8"}};   // in another order
    e.rows[1].fingerprint = 1;
    EXPECT_EQ(judge(e, {}).free_axes, (std::vector<std::string>{"accel"}));
    EXPECT_EQ(judge(e, {}).not_free.size(), 1u);
}

TEST(TradeoffVerdict, APictureThatDoesNotComeAgainIsTold) {
    Experiment e = with_two_accelerators("1");
    e.unrepeatable = {1};
    ASSERT_EQ(judge(e, {}).not_free.size(), 1u);
    EXPECT_EQ(judge(e, {}).not_free[0].sentence, "accel=grid: another run made another picture, which is a bug");
}

TEST(TradeoffVerdict, WhatIsWithinTheReferencesErrorIsMarked) {
    Experiment e = with_two_accelerators("1");
    e.reference.own["rmse"] = 0.1;
    e.rows[0].errors["rmse"] = 0.1, e.rows[1].errors["rmse"] = 0.11;
    EXPECT_EQ(judge(e, {}).uncertain, (std::vector<bool>{true, false}));
    e.rows[0].non_finite = 1;
    EXPECT_EQ(judge(e, {}).front, (std::vector<bool>{false, true})) << "what is no picture beats nothing";
}

/// The mean of the point's form factor over the first disc is the discs', by Simpson's rule over the radius.
TEST(TradeoffAnalytic, FormFactorsAgree) {
    for (const double distance : {0.2, 1.0, 7.0}) {
        const int n = 20000;
        double mean = 0;
        for (int i = 0; i <= n; ++i) {
            const double r = double(i) / n, weight = i == 0 || i == n ? 1 : i % 2 ? 4 : 2;
            mean += weight / (3 * n) * point_to_disc(r, distance, 1.5) * 2 * r;
        }
        EXPECT_NEAR(mean, disc_to_disc(1, 1.5, distance), 1e-9) << distance;
    }
    EXPECT_NEAR(disc_to_disc(1, 1, 1), (3 - std::sqrt(5.0)) / 2, 1e-15);
}

TEST(TradeoffAnalytic, ThePictureOfTheDiscHoldsItsFormFactor) {
    const Picture picture = analytic_picture(*find_analytic("analytic:disc-disc"), 24, 24);
    double mean = 0;
    for (const float value : picture.values) mean += double(value) / double(picture.values.size());
    EXPECT_NEAR(mean * 4 / kPi, disc_to_disc(1, 1, 1), 1e-5) << "the square around the disc is 4 / pi as large";
}

TEST(TradeoffAnalytic, PicturesDoNotDependOnTheirSize) {
    for (const AnalyticScene& scene : analytic_scenes()) {
        const Picture fine = analytic_picture(scene, 40, 20), coarse = analytic_picture(scene, 10, 10);
        for (int y = 0; y < 10; ++y)
            for (int x = 0; x < 10; ++x) {
                double mean = 0;
                for (int i = 0; i < 8; ++i) mean += double(fine.at(4 * x + i % 4, 2 * y + i / 4)[0]) / 8;
                EXPECT_NEAR(mean, double(coarse.at(x, y)[0]), 1e-3) << scene.name;   // a part that 16 x 16 points miss
            }
    }
}

TEST(TradeoffErrors, OfEqualPicturesAreNone) {
    Picture a(16, 16, {"R", "G", "B"});
    for (size_t i = 0; i < a.values.size(); ++i) a.values[i] = float(i % 7) / 7;
    const MeasuredErrors errors = measure_errors(a, a, false);
    for (const ErrorColumn& column : error_columns())
        if (column.is_error) { EXPECT_EQ(errors.values.at(column.name), 0) << column.name; }
    EXPECT_EQ(errors.values.at("ssim"), 1);
    Picture b = a;
    b.values[5] = NAN, b.values[8] = INFINITY;
    EXPECT_EQ(measure_errors(a, b, false).non_finite, 2u);
    EXPECT_EQ(measure_errors(a, b, false).values.at("rmse"), 0);
}

/// Of two halves with independent noise of one size the mean is off by half of what lies between them.
TEST(TradeoffErrors, HalvesTellTheErrorOfTheirMean) {
    Picture a(64, 64, {"R", "G", "B"}), b = a, truth = a, mean = a;
    const RandomKey key(5, 6, 7);
    for (size_t i = 0; i < a.values.size(); ++i) {
        truth.values[i] = 0.5F;
        a.values[i] = float(0.4 + 0.2 * key.uniform(2 * i)), b.values[i] = float(0.4 + 0.2 * key.uniform(2 * i + 1));
        mean.values[i] = 0.5F * (a.values[i] + b.values[i]);
    }
    const double told = errors_of_halves(a, b, false).at("rmse");
    EXPECT_NEAR(told / measure_errors(truth, mean, false).values.at("rmse"), 1, 0.02);
    EXPECT_NEAR(told, 0.2 / std::sqrt(24.0), 0.001) << "the standard deviation of the mean of two even distributions";
}

TEST(TradeoffExternal, WordsAreSplitAndFilled) {
    const auto external = parse_external("povray '+I{scene}' +A{aa} \"+O{out}\" -D '' a{b");
    ASSERT_TRUE(external) << external.error();
    EXPECT_EQ(external->words, (Words{"povray", "+I{scene}", "+A{aa}", "+O{out}", "-D", "", "a{b"}));
    EXPECT_EQ(external->axes, (std::vector<std::string>{"aa"}));
    EXPECT_EQ(command_line(*external, {{"aa", "0.3"}}, {"/x/a.pov", 3, 4, 1}, "o"), "povray +I/x/a.pov +A0.3 +Oo.png -D '' 'a{b'");
    EXPECT_FALSE(parse_external("povray +A0.3")) << "nothing says where the picture goes";
    EXPECT_FALSE(parse_external("povray '+O{out}"));
    EXPECT_FALSE(parse_external("  "));
}

TEST(TradeoffStore, KeepsLinesThatAreWhole) {
    const auto folder = std::filesystem::temp_directory_path() / ("tradeoff_store_" + std::to_string(getpid()));
    const Json head = {{"schema", 1}, {"scene", "a"}};
    {
        auto store = Store::open(folder.string(), head);
        ASSERT_TRUE(store) << store.error();
        ASSERT_TRUE(store->keep("one", 1.5));
    }
    std::ofstream(folder / "measured.jsonl", std::ios::app) << "{\"key\": \"two\", \"val";   // killed here
    auto again = Store::open(folder.string(), head);
    ASSERT_TRUE(again);
    EXPECT_EQ(*again->find("one"), Json(1.5));
    EXPECT_EQ(again->find("two"), nullptr);
    ASSERT_TRUE(again->keep("three", "x"));
    EXPECT_EQ(*Store::open(folder.string(), head)->find("three"), Json("x"));
    const auto other = Store::open(folder.string(), {{"schema", 1}, {"scene", "b"}});
    ASSERT_FALSE(other);
    EXPECT_NE(other.error().find("another scene"), std::string::npos) << other.error();
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace alidade::tradeoff
