// SPDX-License-Identifier: Apache-2.0
#include "core/image.h"
#include "tools/analytic.h"
#include "tools/compare/program.h"
#include "tools/interrupt.h"
#include "tools/option_words.h"
#include "tools/output.h"
#include "tools/tradeoff/document.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <array>
#include <filesystem>

namespace alidade {

namespace {

using namespace tradeoff;

struct TradeoffWords {
    Request request;   // its scene alone counts: settings are parsed one by one
    Job job;
    Questions questions;
    std::vector<std::string> vary, external, require, reference_with;
    std::string mode = "full", csv, report;
    bool json = false;
};

void add_question_words(CLI::App& app, TradeoffWords& words) {
    app.add_option("--vary", words.vary, "an option of `render`, or a placeholder of --external, and its values; may be given again")->type_name("NAME=V1,V2,...")->expected(1)->take_all();
    app.add_option("--mode", words.mode, "full: every combination; one: each axis alone; halton:N: N points spread over the axes (default full)")->type_name("MODE");
    app.add_option("--external", words.external, "another program as a row, its words with {out}, {scene}, {folder}, {width}, {height} and axes; may be given again")->type_name("COMMAND")->expected(1)->take_all();
    app.add_option("--reference", words.job.reference, "self, self:SPP (two halves of so many samples a pixel), povray, exact (of analytic scenes) or a FILE (default: exact where there is one, else self)")
        ->type_name("WHAT");
    app.add_option("--reference-with", words.reference_with, "an option of the own reference; may be given again")->type_name("NAME=VALUE")->expected(1)->take_all();
    app.add_option("--metric", words.questions.metric, "the error of the front: rmse, rel_mse, max_abs, flip or over4 (default rmse)")->type_name("NAME");
    add_number(app, "--error", "E", 0, [&words](double value) { words.questions.error = value; }, "recommends the fastest with no more error (default: the default setting's)");
    add_number(app, "--budget", "SECONDS", 0, [&words](double value) { words.questions.time = value; }, "recommends the most accurate within so much CPU time (default: the default setting's)");
    app.add_option("--require", words.require, "a setting must meet it, such as 'rmse<0.01 @ rays<2e6'; may be given again")->type_name("RULE")->expected(1)->take_all();
    group_options(app, "What is compared");
}

void add_measuring_words(CLI::App& app, TradeoffWords& words) {
    app.add_option("--repeat", words.job.repeat, "rounds in which each setting is timed, in random order (default 5)")->type_name("N")->check(CLI::Range(1, 1000));
    app.add_option("--seeds", words.job.seeds, "pictures of each setting, 8 or more, for bias and variance (default 1: neither)")->type_name("N")->check(CLI::Range(1, 100000));
    app.add_flag("--instructions", words.job.instructions, "counts them, by valgrind");
    add_number(app, "--timeout", "SECONDS", 0.001, [&words](double value) { words.job.timeout = value; }, "seconds that another program has (default 600)", 1e7);
    app.add_option("--out", words.job.out, "a folder for everything; what is measured there already is not measured again")->type_name("DIR");
    app.add_option("--csv", words.csv, "writes a line for each setting")->type_name("FILE");
    app.add_option("--report", words.report, "writes one self-contained page with the plot")->type_name("FILE.html");
    app.add_flag("--json", words.json, "prints JSON instead of the table");
    add_choice(app, "--progress", {"bar", "none"}, [&words](size_t i) { words.job.progress = i == 0 ? ProgressMode::bar : ProgressMode::none; }, "a bar (only on a terminal), or nothing (default bar)");
}

Value<bool> take_words(TradeoffWords& words) {
    Job& job = words.job;
    for (const std::string& text : words.vary) {
        auto axis = parse_axis(text);
        if (!axis) return tl::unexpected(axis.error());
        job.axes.push_back(std::move(*axis));
    }
    for (const std::string& text : words.external) {
        auto external = parse_external(text);
        if (!external) return tl::unexpected(external.error());
        job.externals.push_back(std::move(*external));
    }
    for (const std::string& text : words.require) {
        auto rule = parse_requirement(text);
        if (!rule) return tl::unexpected(rule.error());
        words.questions.require.push_back(std::move(*rule));
    }
    for (const std::string& text : words.reference_with) {
        const size_t equal = text.find('=');
        if (equal == 0 || equal == text.npos) return tl::unexpected(fmt::format("--reference-with: '{}' is not NAME=VALUE", text));
        job.reference_with.push_back({text.substr(0, equal), text.substr(equal + 1)});
    }
    const auto mode = parse_mode(words.mode);
    if (!mode) return tl::unexpected(fmt::format("--mode: {}", mode.error()));
    job.mode = *mode;
    return true;
}

/// What words alone cannot say.
std::string why_senseless(const TradeoffWords& words) {
    const Job& job = words.job;
    if (job.axes.empty() && job.externals.empty()) return "there is nothing to compare: --vary NAME=V1,V2,... varies an option of `render`";
    if (job.seeds > 1 && job.seeds < 8) return fmt::format("--seeds {}: a variance needs 8 or more", job.seeds);
    const ErrorColumn* column = find_error(words.questions.metric);
    if (!column || !column->is_error) {
        std::vector<std::string> names;
        for (const ErrorColumn& each : error_columns())
            if (each.is_error) names.emplace_back(each.name);
        return fmt::format("--metric: '{}' is not one of {}", words.questions.metric, fmt::join(names, ", "));
    }
    if (job.instructions && find_program("valgrind").empty()) return "--instructions: valgrind is not installed (Debian's package valgrind)";
    const bool counted = std::any_of(words.questions.require.begin(), words.questions.require.end(), [](const Requirement& rule) { return rule.cost.metric == "instructions"; });
    return counted && !job.instructions ? "--require: instructions are counted with --instructions alone" : "";
}

/// Of settings that say nothing of it: one thread, for a time that means work; a small picture of what has no size of its own.
void set_defaults(Job& job) {
    const auto told = [&job](const std::string& name) {
        return std::any_of(job.base.begin(), job.base.end(), [&](const Choice& choice) { return choice.name == name; });
    };
    if (!told("threads")) job.base.push_back({"threads", "1"});
    if (!told("size") && is_analytic(job.scene)) job.base.push_back({"size", "96x96"});
}

Value<bool> write_text(const std::string& path, const std::string& text) {
    if (path.empty()) return true;
    if (const auto written = write_file(path, std::as_bytes(std::span(text))); !written) return tl::unexpected(fmt::format("{}: {}", path, written.error()));
    return true;
}

int write_everything(const TradeoffWords& words, const Experiment& e, const Verdicts& v) {
    const Json document = as_document(e, v);
    std::vector<std::pair<std::string, std::string>> files{{words.csv, "csv"}, {words.report, "page"}};
    const std::string& out = words.job.out;
    if (!out.empty()) files.insert(files.end(), {{out + "/results.csv", "csv"}, {out + "/results.json", "json"}, {out + "/tradeoff.html", "page"}});
    for (const auto& [path, kind] : files) {
        const auto written = write_text(path, path.empty() ? "" : kind == "csv" ? as_csv(e, v) : kind == "json" ? as_json_text(document) : as_page(e, v));
        if (!written) return fail(written.error());
    }
    for (const std::string& warning : e.warnings) fmt::print(stderr, "alidade: warning: {}\n", warning);
    fmt::print("{}", words.json ? as_json_text(document) : as_lines(e, v));
    for (const NotFree& each : v.not_free) fail(each.sentence);
    if (!v.not_free.empty()) return kError;
    return std::all_of(v.required.begin(), v.required.end(), [](const Met& met) { return !met.rows.empty(); }) ? kDone : 2;
}

}  // namespace

int run_tradeoff(const Verb& verb, const Words& given) {
    TradeoffWords words;
    CLI::App app;
    add_question_words(app, words);
    add_measuring_words(app, words);
    add_scene_options(app, words.request);
    add_render_options(app, words.request);
    add_compile_options(app, words.request);
    if (const auto code = parse_words(app, verb, given)) return *code;
    words.job.scene = words.request.scene;
    words.job.base = given_options(app);
    set_defaults(words.job);
    if (const auto taken = take_words(words); !taken) return usage_error(verb, taken.error());
    if (const std::string why = why_senseless(words); !why.empty()) return usage_error(verb, why);
    auto rows = rows_of(words.job);
    if (!rows) return usage_error(verb, rows.error());
    if (const auto name = reference_name(words.job, *rows); !name) return usage_error(verb, name.error());
    for (const std::string& path : {words.csv, words.report})
        if (const std::string why = path.empty() ? "" : why_no_file(path); !why.empty()) return fail(why);
    clean_up_on_signal();
    const auto experiment = run_experiment(words.job, std::move(*rows));
    if (!experiment) return experiment.error().empty() ? int(kError) : fail(experiment.error());
    return write_everything(words, *experiment, judge(*experiment, words.questions));
}

}  // namespace alidade
