// SPDX-License-Identifier: Apache-2.0
#include "tools/diff/words.h"

#include "tools/diff/report_pair.h"
#include "tools/options.h"
#include "tools/output.h"
#include "tools/values.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace alidade {
namespace {

/// A number from 0 on, or infinity; not NaN, which no value is over.
CLI::Validator at_least_zero() {
    return CLI::Validator([](std::string& text) {
        double value = 0;
        return CLI::detail::lexical_cast(text, value) && value >= 0 ? std::string() : fmt::format("'{}' is not a number from 0 on", text);
    }, "");
}

void add_pixel_rule(CLI::App& app, const std::string& name, const std::string& hard, const std::string& allowed, std::optional<PixelRule>& rule) {
    const auto add = [&](const std::string& option, double PixelRule::*field, const char* doc) {
        app.add_option_function<double>("--" + option, [&rule, field](double value) {
               if (!rule) rule = PixelRule{};
               (*rule).*field = value;
           }, doc)->type_name("N")->check(at_least_zero())->group(name == "fail" ? "Rules that fail" : "Rules that warn");
    };
    add(name, &PixelRule::over, "a pixel is over the rule where a channel differs by more than this (0)");
    add(name + "percent", &PixelRule::percent, "percent of the pixels that may be over it (0)");
    add(name + "relative", &PixelRule::relative, "and by more than this times the mean of both values (0)");
    add(hard, &PixelRule::hard, "no pixel may differ by more (infinite)");
    add(allowed, &PixelRule::allowed, "number of pixels that may be over it (0)");
}

void merge(const Rules& from, Rules& into) {
    if (from.fail) into.preset = from.fail;
    into.require.insert(into.require.end(), from.require.begin(), from.require.end());
    into.noise = into.noise || from.noise;
}

}  // namespace

void add_rule_words(CLI::App& app, Rules& rules) {
    std::vector<std::string> names;
    std::string docs = "rules by name:";
    for (const Preset& preset : presets()) names.emplace_back(preset.name), docs += fmt::format(" {} = {};", preset.name, preset.doc);
    add_choice(app, "--preset", names, [&rules](size_t i) { merge(presets()[i].rules(), rules); }, docs);
    app.add_option_function<std::vector<std::string>>("--require", [&rules](const std::vector<std::string>& texts) {
           for (const std::string& text : texts) {
               auto rule = parse_metric_rule(text);
               if (!rule) throw CLI::ValidationError("--require", rule.error());
               rules.require.push_back(std::move(*rule));
           }
       }, "METRIC<LIMIT: flip.mean<0.02, over8<0.5%, p99<16/255, psnr>40; may be given again")->type_name("RULE")->allow_extra_args(false);
    add_pixel_rule(app, "fail", "hardfail", "allowfailures", rules.fail);
    add_pixel_rule(app, "warn", "hardwarn", "allowwarnings", rules.warn);
}

void add_pair_words(CLI::App& app, DiffRequest& asked) {
    app.add_option("--mask", asked.pair.mask, "a picture: only pixels brighter than the half of white count")->type_name("FILE");
    app.add_option_function<std::string>("--crop", [&asked](const std::string& text) {
           const auto region = parse_region(text);
           if (!region) throw CLI::ValidationError("--crop", region.error());
           asked.pair.x0 = region->x0, asked.pair.y0 = region->y0, asked.pair.x1 = region->x1, asked.pair.y1 = region->y1;
       }, "compares only this part, in pixels from the top left, the ends outside")->type_name("x0,y0,x1,y1");
    app.add_option("--layer", asked.pair.layer, "compares the channels NAME.* of EXR files instead of the colours")->type_name("NAME");
    app.add_flag("--align", asked.align, "tells by how many pixels the test is shifted");
    app.add_option("--threads", asked.pair.threads, "0: as many as the machine has (0)")->type_name("N")->check(CLI::Range(0, 1024));
}

void add_output_words(CLI::App& app, DiffRequest& asked) {
    app.add_flag("--json", asked.json, "prints the document of docs/diff.md instead of lines");
    app.add_option("--junit", asked.junit, "writes the verdict for test servers")->type_name("FILE");
    app.add_option("--heatmap", asked.heatmap, "writes where the pictures differ, by FLIP")->type_name("FILE");
    app.add_option("--report", asked.report, "writes one HTML file that shows both pictures and how they differ")->type_name("FILE");
}

void set_default_rules(Rules& rules, const std::string& preset) {
    if (rules.fail || rules.warn || rules.preset || !rules.require.empty() || rules.noise) return;
    for (const Preset& each : presets())
        if (each.name == preset) rules = each.rules();
}

Words with_two_dashes(const CLI::App& app, const Words& given) {
    Words out;
    for (const std::string& word : given) {
        const std::string longer = "-" + word;
        const bool meant = word.size() > 2 && word[0] == '-' && word[1] != '-' && app.get_option_no_throw(longer.substr(0, longer.find('='))) != nullptr;
        out.push_back(meant ? longer : word);
    }
    return out;
}

std::string why_not_writable(const DiffRequest& request) {
    for (const std::string& path : {request.junit, request.report})
        if (const std::string why = path.empty() ? "" : why_no_file(path); !why.empty()) return why;
    if (const std::string why = request.heatmap.empty() ? "" : why_not_writable(request.heatmap); !why.empty()) return why;
    return {};
}

std::string why_overwritten(const DiffRequest& request, std::vector<std::string> taken) {
    for (const std::string& path : {request.junit, request.heatmap, request.report}) {
        if (path.empty()) continue;
        for (const std::string& other : taken) {
            std::error_code ignored;
            if (path == other || std::filesystem::equivalent(path, other, ignored)) return fmt::format("'{}' would be overwritten: give another name", path);
        }
        taken.push_back(path);
    }
    return {};
}

Comparison compare_files(const std::string& reference, const std::string& test, const DiffRequest& asked) {
    Comparison out;
    out.reference = reference, out.test = test;
    auto loaded = load_pair(reference, test, asked.pair);
    if (!loaded) {
        out.judgement = {loaded.error().incomparable ? Verdict::incomparable : Verdict::error, loaded.error().sentence, {}};
        out.cause = {loaded.error().cause, loaded.error().sentence};
        return out;
    }
    out.loaded = std::move(*loaded);
    const PicturePair& pair = out.loaded->pair;
    out.measured = measure_all(pair), out.tiles = tile_table(pair);
    out.judgement = judge(*out.loaded, out.measured, asked.rules);
    if (asked.align) out.aligned = true, out.shift = find_shift(pair);
    const NonFinite& odd = out.loaded->non_finite;
    if (odd.in_one + odd.nan_in_both > 0) out.cause = {odd.nan ? "nan" : "inf", out.judgement.reason};
    else out.cause = find_cause(pair);
    return out;
}

namespace {

tl::expected<void, std::string> write_text(const std::string& path, const std::string& text) { return write_file(path, std::as_bytes(std::span(text))); }

tl::expected<void, std::string> write_report(const Comparison& comparison, const DiffRequest& asked) {
    const auto leaf = [](const std::string& path) { return std::filesystem::path(path).filename().string(); };
    const std::string name = fmt::format("{} against {}", leaf(comparison.test), leaf(comparison.reference));
    const auto page = report_html({name, {{"alidade", ALIDADE_VERSION}}, {report_pair(comparison, name, asked.commands)}});
    if (!page) return tl::unexpected(page.error());
    return write_text(asked.report, *page);
}

}  // namespace

tl::expected<void, std::string> write_files(const Comparison& comparison, const DiffRequest& asked) {
    tl::expected<void, std::string> done;
    if (!asked.junit.empty()) done = write_text(asked.junit, as_junit(comparison));
    if (done && !asked.heatmap.empty() && !comparison.measured.empty()) done = write_picture(asked.heatmap, heat_map(comparison));
    if (done && !asked.report.empty()) done = write_report(comparison, asked);
    return done;
}

}  // namespace alidade
