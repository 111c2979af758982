// SPDX-License-Identifier: Apache-2.0
#include "tools/diff/judge.h"

#include "tools/metrics/differences.h"
#include "tools/metrics/noise.h"

#include <fmt/format.h>

#include <algorithm>

namespace alidade {
namespace {

/// By how much differences of display values may be off: those of files with steps are k / levels in floats, and limits such as 1/255 are meant exactly.
double rounding_of(const PicturePair& pair) { return pair.hdr ? 0 : 1.2e-7; }

/// How far a pixel rule is from being kept.
struct PixelCount {
    double over = 0, largest = 0;
};

PixelCount count_over(const PicturePair& pair, const PixelRule& rule) {
    PixelCount count;
    const size_t channels = size_t(pair.reference.channels);
    const double slack = rounding_of(pair);
    for (size_t p = 0; p < pair.pixels(); ++p) {
        if (!pair.counts[p]) continue;
        bool over = false;
        for (size_t i = p * channels; i < (p + 1) * channels; ++i) {
            const double a = pair.reference.values[i], b = pair.test.values[i], difference = std::abs(b - a);
            over = over || (difference > rule.over + slack && difference > rule.relative * 0.5 * (std::abs(a) + std::abs(b)));
            count.largest = std::max(count.largest, difference);
        }
        count.over += over;
    }
    return count;
}

void check_pixels(const PicturePair& pair, const PixelRule& rule, bool warns, std::vector<Check>& checks) {
    const char* name = warns ? "warn" : "fail";
    const PixelCount count = count_over(pair, rule);
    const double share = count.over / double(counted(pair));
    std::string text = fmt::format("--{} {:.6g}", name, rule.over);
    if (rule.relative > 0) text += fmt::format(" --{}relative {:.6g}", name, rule.relative);
    if (rule.allowed > 0) text += fmt::format(" --{} {:.0f}", warns ? "allowwarnings" : "allowfailures", rule.allowed);
    if (rule.percent > 0) text += fmt::format(" --{}percent {:.6g}", name, rule.percent);
    checks.push_back({std::move(text), share, warns, count.over <= rule.allowed || 100 * count.over <= rule.percent * double(counted(pair)) * (1 + 1e-12), true});
    if (std::isfinite(rule.hard)) checks.push_back({fmt::format("--hard{} {:.6g}", name, rule.hard), count.largest, warns, count.largest <= rule.hard + rounding_of(pair)});
}

bool keeps(double value, const MetricRule& rule, double slack) {
    switch (rule.is) {
        case MetricRule::Is::less: return value < rule.limit - slack;
        case MetricRule::Is::less_or_equal: return value <= rule.limit + slack;
        case MetricRule::Is::greater: return value > rule.limit + slack;
        default: return value >= rule.limit - slack;
    }
}

/// A metric that the pair does not have (hdr_flip of display values) keeps no rule.
Check check_requirement(const Measurements& measured, const MetricRule& rule, double slack) {
    const auto found = measured.find(rule.metric);
    const double* value = found == measured.end() ? nullptr : found->second.find(rule.number);
    if (!value) return {"--require " + rule.text, std::numeric_limits<double>::quiet_NaN(), false, false};
    return {"--require " + rule.text, *value, false, keeps(*value, rule, slack)};
}

std::string reason_of(const Check& check) {
    if (std::isnan(check.value)) return fmt::format("{}: it is not measured for these files", check.rule);
    if (check.counts_pixels) return fmt::format("{:.4g} % of the pixels differ by more than {} allows", 100 * check.value, check.rule);
    return fmt::format("{} is not kept: {:.6g}", check.rule, check.value);
}

/// What no rule may forgive.
std::optional<Judgement> judge_non_finite(const LoadedPair& loaded) {
    const NonFinite& found = loaded.non_finite;
    if (found.in_one > 0)
        return Judgement{Verdict::fail, fmt::format("{} in the {} alone: {} pixels, the first at {},{}", found.nan ? "NaN" : "an infinity",
                                                    found.in_test ? "test" : "reference", found.in_one, found.x, found.y), {}};
    if (counted(loaded.pair) == 0 && found.nan_in_both == 0 && found.inf_in_both > 0) return Judgement{Verdict::pass, "every pixel is the same infinity in both pictures", {}};
    if (counted(loaded.pair) == 0) return Judgement{Verdict::incomparable, "there is no pixel to compare: none is finite in both pictures", {}};
    return std::nullopt;
}

}  // namespace

const char* name_of(Verdict verdict) {
    constexpr const char* kNames[] = {"pass", "warn", "fail", "incomparable", "error"};
    return kNames[size_t(verdict)];
}

Measurements measure_all(const PicturePair& pair) {
    Measurements out;
    if (counted(pair) == 0) return out;
    for (const Metric& metric : metrics())
        if (metric.what == Metric::For::all || pair.hdr) out.emplace(metric.name, metric.measure(pair));
    return out;
}

Judgement judge(const LoadedPair& loaded, const Measurements& measured, const Rules& rules) {
    if (auto surely = judge_non_finite(loaded)) return *surely;
    Judgement out;
    for (const auto& rule : {rules.preset, rules.fail})
        if (rule) check_pixels(loaded.pair, *rule, false, out.checks);
    for (const MetricRule& rule : rules.require) out.checks.push_back(check_requirement(measured, rule, rounding_of(loaded.pair)));
    if (rules.noise) {
        const Noise noise = measure_noise(loaded.pair);
        out.checks.push_back({fmt::format("noise: largest z of a tile < {:.4g}", noise.limit), noise.largest_z, false, noise.largest_z < noise.limit});
    }
    if (rules.warn) check_pixels(loaded.pair, *rules.warn, true, out.checks);
    for (const Check& check : out.checks) {
        if (check.kept) continue;
        const Verdict verdict = check.warns ? Verdict::warn : Verdict::fail;
        if (int(verdict) > int(out.verdict)) out.verdict = verdict, out.reason = reason_of(check);
    }
    if (out.verdict == Verdict::pass && loaded.non_finite.nan_in_both > 0) {
        out.verdict = Verdict::warn;
        out.reason = fmt::format("NaN in both pictures: {} pixels, the first at {},{}", loaded.non_finite.nan_in_both, loaded.non_finite.x,
                                 loaded.non_finite.y);
    }
    if (out.reason.empty()) out.reason = out.checks.empty() ? "there is no rule to break" : fmt::format("every rule is kept ({})", out.checks.size());
    return out;
}

}  // namespace alidade
