// SPDX-License-Identifier: Apache-2.0
#include "tools/diff/document.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace alidade {
namespace {

Json numbers_of(const Measured& measured) {
    Json out = Json::object();
    for (const auto& number : measured.numbers) out[number.name] = number.value;
    return out;
}

Json to_json(const Check& check) {
    return {{"rule", check.rule}, {"value", check.value}, {"kept", check.kept}, {"broken_means", name_of(check.warns ? Verdict::warn : Verdict::fail)}};
}

Json to_json(const TileTable& table) {
    Json mean = Json::array(), largest = Json::array();
    for (const Tile& tile : table.tiles) mean.push_back(tile.mean), largest.push_back(tile.largest);
    return {{"size", table.size}, {"columns", table.columns}, {"rows", table.rows}, {"mean", mean}, {"max", largest}};
}

Json to_json(const NonFinite& found) {
    return {{"in_one", found.in_one}, {"nan_in_both", found.nan_in_both}, {"inf_in_both", found.inf_in_both}};
}

void add_pair(const Comparison& c, Json& out) {
    const PicturePair& pair = c.loaded->pair;
    out["width"] = pair.width(), out["height"] = pair.height(), out["channels"] = pair.reference.names;
    out["values"] = pair.hdr ? "linear" : "display";
    out["notes"] = c.loaded->notes;
    out["same_files"] = c.loaded->same_files;
    out["non_finite"] = to_json(c.loaded->non_finite);
    Json& all = out["metrics"] = Json::object();
    for (const Metric& metric : metrics())
        if (const auto found = c.measured.find(metric.name); found != c.measured.end()) all[metric.name] = numbers_of(found->second);
    out["tiles"] = to_json(c.tiles);
    if (c.aligned) out["shift"] = c.shift ? Json{{"x", c.shift->x}, {"y", c.shift->y}, {"explained", c.shift->explained}} : Json();
}

/// XML has no other bytes than UTF-8's: those of a file's name that are none become the replacement character.
std::string escaped_xml(const std::string& text) {
    std::string out;
    for (const char c : Json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace)).get<std::string>()) switch (c) {
        case '<': out += "&lt;"; break;
        case '>': out += "&gt;"; break;
        case '&': out += "&amp;"; break;
        case '"': out += "&quot;"; break;
        default: out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
    return out;
}

std::string test_case(const std::string& name, bool passed, const std::string& message) {
    const std::string head = fmt::format("    <testcase classname=\"alidade.diff\" name=\"{}\"", escaped_xml(name));
    return passed ? head + "/>\n" : fmt::format("{}>\n      <failure message=\"{}\"/>\n    </testcase>\n", head, escaped_xml(message));
}

/// The worst tiles, as lines.
std::string worst_tiles(const TileTable& table) {
    std::vector<Tile> worst = table.tiles;
    std::stable_sort(worst.begin(), worst.end(), [](const Tile& a, const Tile& b) { return a.mean > b.mean; });
    std::string out;
    for (size_t i = 0; i < std::min<size_t>(3, worst.size()) && worst[i].largest > 0; ++i)
        out += fmt::format("  tile {},{} .. {},{}: mean {:.6f}, max {:.6f}\n", worst[i].x0, worst[i].y0, worst[i].x1 - 1, worst[i].y1 - 1, worst[i].mean, worst[i].largest);
    return out;
}

}  // namespace

Json to_json(const Comparison& c) {
    Json out = {{"schema", 1}, {"reference", c.reference}, {"test", c.test}, {"verdict", name_of(c.judgement.verdict)},
                {"exit_code", int(c.judgement.verdict)}, {"reason", c.judgement.reason}, {"cause", c.cause.name}, {"cause_text", c.cause.sentence}};
    Json& checks = out["checks"] = Json::array();
    for (const Check& check : c.judgement.checks) checks.push_back(to_json(check));
    if (c.loaded) add_pair(c, out);
    return out;
}

std::string as_lines(const Comparison& c) {
    std::string out;
    if (c.loaded) {
        for (const std::string& note : c.loaded->notes) out += fmt::format("note: {}\n", note);
        for (const Metric& metric : metrics()) {
            const auto found = c.measured.find(metric.name);
            if (found == c.measured.end()) continue;
            out += fmt::format("  {:<12}", metric.name);
            for (const auto& number : found->second.numbers) out += fmt::format(" {} {:.6g} ", number.name, number.value);
            out.back() = '\n';
        }
        out += worst_tiles(c.tiles);
    }
    if (c.shift) out += fmt::format("shift: {:.3f}, {:.3f} pixels (right, down), which explains {:.1f} % of the squared error\n", c.shift->x, c.shift->y, 100 * c.shift->explained);
    else if (c.aligned) out += fmt::format("shift: none that explains {:.0f} % of the squared error\n", 100 * kShiftExplains);
    for (const Check& check : c.judgement.checks) out += fmt::format("{} {}: {:.6g}\n", check.kept ? "kept  " : "BROKEN", check.rule, check.value);
    if (!c.cause.name.empty()) out += fmt::format("cause: {}: {}\n", c.cause.name, c.cause.sentence);
    return out + fmt::format("{}: {}\n", name_of(c.judgement.verdict), c.judgement.reason);
}

std::string as_junit(const Comparison& c) {
    std::string cases;
    size_t tests = 0, failures = 0;
    const auto add = [&](const std::string& name, bool passed, const std::string& message) { cases += test_case(name, passed, message), ++tests, failures += !passed; };
    for (const Check& check : c.judgement.checks) add(check.rule, check.kept || check.warns, fmt::format("{:.6g}; {}", check.value, c.cause.sentence));
    const Verdict verdict = c.judgement.verdict;
    if (tests == 0 || (failures == 0 && int(verdict) > int(Verdict::warn))) add("comparable", int(verdict) <= int(Verdict::warn), c.judgement.reason);
    return fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n  <testsuite name=\"{} against {}\" tests=\"{}\" failures=\"{}\">\n{}  </testsuite>\n</testsuites>\n",
                       escaped_xml(c.test), escaped_xml(c.reference), tests, failures, cases);
}

std::vector<float> error_map(const Comparison& c) {
    const auto hdr = c.measured.find("hdr_flip");
    std::vector<float> errors = (hdr == c.measured.end() ? c.measured.at("flip") : hdr->second).map;
    const PicturePair& pair = c.loaded->pair;
    const size_t channels = size_t(pair.reference.channels);
    for (size_t p = 0; p < errors.size(); ++p) {
        const size_t last = (p + 1) * channels - 1;
        if (pair.has_alpha()) errors[p] = std::max(errors[p], std::abs(pair.test.values[last] - pair.reference.values[last]));
        if (!c.loaded->odd.empty() && c.loaded->odd[p]) errors[p] = 1;
    }
    return errors;
}

Picture heat_map(const Comparison& c) {
    constexpr std::array<std::array<double, 3>, 6> kColors = {{{0, 0, 0}, {0.26, 0.08, 0.42}, {0.66, 0.17, 0.40}, {0.93, 0.38, 0.24}, {0.99, 0.71, 0.22}, {1, 1, 0.85}}};
    const std::vector<float> errors = error_map(c);
    Picture out(c.loaded->pair.width(), c.loaded->pair.height(), {"R", "G", "B"});
    for (size_t p = 0; p < errors.size(); ++p) {
        if (!c.marked.empty() && c.marked[p]) {
            out.values[3 * p + 1] = 1;
            continue;
        }
        const double at = std::clamp(double(errors[p]), 0.0, 1.0) * (kColors.size() - 1);
        const size_t from = std::min(size_t(at), kColors.size() - 2);
        for (size_t k = 0; k < 3; ++k) out.values[3 * p + k] = float(srgb_to_linear(kColors[from][k] + (at - double(from)) * (kColors[from + 1][k] - kColors[from][k])));
    }
    return out;
}

}  // namespace alidade
