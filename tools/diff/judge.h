// SPDX-License-Identifier: Apache-2.0
/// Is a picture good enough? Rules in, a verdict and its reason out.
#pragma once

#include "tools/diff/load_pair.h"
#include "tools/metrics/metric.h"

#include <limits>
#include <map>
#include <tl/expected.hpp>

namespace alidade {

/// The exit codes of `diff` and `compare` too.
enum class Verdict { pass = 0, warn = 1, fail = 2, incomparable = 3, error = 4 };
const char* name_of(Verdict verdict);

/// idiff's rule. A pixel is over it if a channel's difference is greater than `over` and than `relative` times the mean of both values. It is broken
/// where more pixels are over than `percent` of all and than `allowed`, or where one differs by more than `hard`.
struct PixelRule {
    double over = 0, relative = 0, percent = 0, hard = std::numeric_limits<double>::infinity();
    double allowed = 0;
};

/// "flip.mean<0.02": a metric's number (its first one without a dot) against a limit. A number's name that only one metric has needs no metric: "p99<8/255".
struct MetricRule {
    std::string text, metric, number;
    enum class Is { less, less_or_equal, greater, greater_or_equal } is = Is::less;
    double limit = 0;   ///< "0.5%" is 0.005, "8/255" is 0.0314
};
/// An error is one sentence, with the nearest name where the name is unknown.
tl::expected<MetricRule, std::string> parse_metric_rule(const std::string& text);

struct Rules {
    std::optional<PixelRule> fail, warn, preset;   ///< `preset`: fails too, whatever else is asked for
    std::vector<MetricRule> require;
    bool noise = false;   ///< differences must be those of independent noise: measure_noise
};

/// A visible table.
struct Preset {
    const char* name;
    const char* doc;
    Rules (*rules)();
};
std::span<const Preset> presets();

using Measurements = std::map<std::string, Measured>;   ///< by the metric's name
/// Every metric that applies to the pair.
Measurements measure_all(const PicturePair& pair);

/// One rule, and what came of it.
struct Check {
    std::string rule;    ///< as the user spells it
    double value = 0;    ///< what was measured
    bool warns = false;  ///< a broken one warns, where others fail
    bool kept = true;
    bool counts_pixels = false;   ///< the value is the share of pixels that are over a PixelRule
};

struct Judgement {
    Verdict verdict = Verdict::pass;
    std::string reason;   ///< one sentence
    std::vector<Check> checks;
};

/// NaN or an infinity in one picture alone fails whatever the rules say; at the same places in both it warns.
Judgement judge(const LoadedPair& loaded, const Measurements& measured, const Rules& rules);

}  // namespace alidade
