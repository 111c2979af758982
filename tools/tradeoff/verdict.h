// SPDX-License-Identifier: Apache-2.0
/// What the measurements say: the front, three recommendations, what is free, what was required.
#pragma once

#include "tools/diff/judge.h"
#include "tools/tradeoff/experiment.h"

namespace alidade::tradeoff {

/// A cost and an error, as points of a plot.
struct Point {
    Cost cost;
    double error = 0;
};
/// Those that no other dominates. One dominates another if its error is less and it costs no more, or its error is not more and it costs less; costs
/// that do not differ (statistics.h) are the same.
std::vector<bool> front_of(const std::vector<Point>& points);

/// The point of a front (by ascending cost) that is farthest below the line between its ends, both axes logarithmic: beyond it, accuracy costs more. None
/// of fewer than three.
/// Source   Satopaa et al., "Finding a Kneedle in a Haystack", ICDCS Workshops 2011.
std::optional<size_t> knee_of(const std::vector<Point>& front);

/// "rmse<0.01 @ rays<2e6": a setting meets it with both. The cost is time (CPU seconds), instructions, or one that is counted.
struct Requirement {
    std::string text;
    MetricRule error, cost;    ///< of `cost`, `metric` is the cost's name
};
Value<Requirement> parse_requirement(const std::string& text);
/// Costs by name; nothing where it is not known.
std::optional<double> cost_named(const Row& row, const std::string& name);

struct Met {
    Requirement requirement;
    std::vector<size_t> rows;   ///< that meet it, the fastest first
};

/// Two settings whose pictures have to be the same bytes, and are not.
struct NotFree {
    size_t a = 0, b = 0;
    std::string sentence;      ///< with the first pixel
};

struct Verdicts {
    std::string metric;                 ///< of the front: a column of errors.h
    double most_error = 0, most_time = 0;
    std::vector<bool> front;            ///< one a row
    std::vector<bool> uncertain;        ///< one a row: its error is within the reference's own
    std::optional<size_t> fastest, best, knee;
    std::vector<Met> required;
    std::vector<NotFree> not_free;
    std::vector<std::string> free_axes; ///< names of those that were checked
    std::vector<std::string> unchecked_axes;   ///< and of those that no two settings differ in without differing in what is paid for
};

struct Questions {
    std::string metric = "rmse";
    std::optional<double> error, time;  ///< else those of the default setting
    std::vector<Requirement> require;
};
Verdicts judge(const Experiment& experiment, const Questions& questions);

/// Options on which no picture may depend.
bool must_be_free(const std::string& option);

}  // namespace alidade::tradeoff
