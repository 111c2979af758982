// SPDX-License-Identifier: Apache-2.0
/// Rules as users write them.
#include "tools/diff/judge.h"
#include "tools/verbs.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace alidade {
namespace {

Rules exact() {
    Rules rules;
    rules.fail = PixelRule{};
    return rules;
}

Rules ci() {
    Rules rules;
    rules.fail = PixelRule{0.016, 0, 1};
    return rules;
}

Rules pov() {
    Rules rules;
    rules.require = {*parse_metric_rule("flip.mean<0.02"), *parse_metric_rule("p99<16/255")};
    return rules;
}

Rules noise() {
    Rules rules;
    rules.noise = true;
    return rules;
}

constexpr Preset kPresets[] = {
    {"exact", "every value equal (what holds without any rule)", exact},
    {"ci", "--fail 0.016 --failpercent 1: what Blender's tests allow", ci},
    {"pov", "flip.mean<0.02 and p99<16/255: the same scene by another renderer", pov},
    {"noise", "a difference that is noise alone: no 16x16 tile has a mean that chance does not explain", noise},
};

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    return text;
}

std::optional<double> number(std::string_view text) {
    double value = 0;
    text = trimmed(text);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
    return value;
}

/// "0.5", "0.5%", "8/255".
std::optional<double> limit(std::string_view text) {
    text = trimmed(text);
    double unit = 1;
    if (!text.empty() && text.back() == '%') text.remove_suffix(1), unit = 0.01;
    const size_t slash = text.find('/');
    const auto above = number(text.substr(0, slash));
    if (slash == std::string_view::npos) return above ? std::optional(*above * unit) : std::nullopt;
    const auto below = number(text.substr(slash + 1));
    return above && below && *below != 0 ? std::optional(*above / *below * unit) : std::nullopt;
}

/// What each metric measures is known by measuring a picture of one pixel.
const Measurements& samples() {
    static const Measurements sample = [] {
        PicturePair pair{Picture(1, 1, {"R", "G", "B"}), Picture(1, 1, {"R", "G", "B"}), true, {1}, 1};
        return measure_all(pair);
    }();
    return sample;
}

tl::unexpected<std::string> unknown(const std::string& name) {
    std::vector<std::string> known;
    for (const auto& [metric, measured] : samples()) {
        known.push_back(metric);
        for (const auto& each : measured.numbers) known.push_back(metric + "." + each.name);
    }
    const std::string near = nearest(name, known);
    return tl::unexpected(fmt::format("no metric is called '{}'; {}", name, near.empty() ? "`alidade info --features` lists them" : fmt::format("did you mean '{}'?", near)));
}

/// "flip", "flip.mean", or "p99" of a metric that alone has it.
tl::expected<void, std::string> find_number(const std::string& name, MetricRule& out) {
    const size_t dot = name.find('.');
    for (const auto& [metric, measured] : samples()) {
        if (name == metric) return out.metric = metric, out.number = measured.numbers[0].name, tl::expected<void, std::string>();
        if (name.substr(0, dot) == metric && dot != std::string::npos && measured.find(name.substr(dot + 1)))
            return out.metric = metric, out.number = name.substr(dot + 1), tl::expected<void, std::string>();
    }
    size_t owners = 0;
    for (const auto& [metric, measured] : samples())
        if (measured.find(name)) ++owners, out.metric = metric, out.number = name;
    if (owners == 1) return {};
    return unknown(name);
}

}  // namespace

std::span<const Preset> presets() { return kPresets; }

tl::expected<MetricRule, std::string> parse_metric_rule(const std::string& text) {
    const size_t sign = text.find_first_of("<>");
    const bool equal = sign != std::string::npos && sign + 1 < text.size() && text[sign + 1] == '=';
    if (sign == std::string::npos) return tl::unexpected(fmt::format("'{}' is not METRIC<LIMIT, such as flip.mean<0.02 or over8<0.5%", text));
    MetricRule out;
    out.text = text;
    const std::string name(trimmed(std::string_view(text).substr(0, sign)));
    if (auto found = find_number(name, out); !found) return tl::unexpected(found.error());
    const bool less = text[sign] == '<';
    out.is = less ? (equal ? MetricRule::Is::less_or_equal : MetricRule::Is::less) : (equal ? MetricRule::Is::greater_or_equal : MetricRule::Is::greater);
    const auto value = limit(std::string_view(text).substr(sign + 1 + equal));
    if (!value) return tl::unexpected(fmt::format("'{}' has no limit that is a number, such as 0.02, 0.5% or 8/255", text));
    out.limit = *value;
    return out;
}

}  // namespace alidade
