// SPDX-License-Identifier: Apache-2.0
/// How far are we from POV-Ray on this scene?
#include "tools/compare/compare_report.h"
#include "tools/interrupt.h"
#include "tools/options.h"
#include "tools/values.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace alidade {
namespace {

struct CompareWords {
    CorpusRequest corpus;   ///< its `defaults` are the scene's job, its `diff` the rules
    Request scene;          ///< how a scene is read that is not POV-Ray's own
};

/// Words after "--" are POV-Ray's, for both programs.
Words take_povray_words(Words& given) {
    const auto dashes = std::find(given.begin(), given.end(), "--");
    Words words(dashes == given.end() ? dashes : dashes + 1, given.end());
    given.erase(dashes, given.end());
    return words;
}

void add_words(CLI::App& app, CompareWords& words) {
    PovJob& job = words.corpus.defaults;
    add_scene_options(app, words.scene);   // of a POV-Ray scene SCENE alone counts: words after -- are for both programs
    app.get_option("SCENE")->required(false);
    app.add_option_function<std::string>("--size", [&job](const std::string& text) {
           const auto size = parse_size(text);
           if (!size) throw CLI::ValidationError("--size", size.error());
           job.width = size->width, job.height = size->height;
       }, "of the picture (320x240; a list may say its own)")->type_name("WxH");
    app.add_option("--timeout", job.timeout, "seconds that a program has (600)")->type_name("SECONDS")->check(CLI::PositiveNumber);
    app.add_option("--cache", job.cache, fmt::format("the folder of POV-Ray's pictures, which are kept ({})", default_cache()))->type_name("DIR");
    app.add_option("--corpus", words.corpus.list, "compares a list of scenes: a CSV file with a column `path`, or a path a line")->type_name("LIST");
    app.add_option("--scenes", words.corpus.scenes, "the folder that the list's paths begin from (its own)")->type_name("DIR");
    app.add_option("--where", words.corpus.where, "rows of the list that count: tier<=3, category=lights; may be given again")->type_name("CONDITION")->allow_extra_args(false);
    app.add_option("--out", words.corpus.out, "the folder of a list's results, pictures and report; what is there already is not rendered again")->type_name("DIR");
    app.add_option("--jobs", words.corpus.jobs, "scenes of a list that are rendered at a time (1)")->type_name("N")->check(CLI::Range(1, 256));
    add_rule_words(app, words.corpus.diff.rules);
    add_pair_words(app, words.corpus.diff);
    add_output_words(app, words.corpus.diff);
}

/// A program that made no picture fails; one that is not there is an error of the machine.
int exit_code(const SceneComparison& compared) {
    const Verdict verdict = compared.comparison.judgement.verdict;
    if (verdict != Verdict::error) return int(verdict);
    fail(compared.comparison.judgement.reason);
    return compared.missing_program ? int(Verdict::error) : int(Verdict::fail);
}

void print_rows(const std::vector<CorpusResult>& results) {
    for (const CorpusResult& result : results) {
        const auto text = [&](const char* key) { return result.document[key].get<std::string>(); };
        fmt::print("{:<6} {:<12} {}{}\n", result.document["grade"]["name"].get<std::string>(), text("verdict"), result.entry.name,
                   text("cause").empty() ? "" : ": " + text("cause_text"));
    }
    fmt::print("{}", corpus_table(results));
}

int compare_one(const CompareWords& words) {
    DiffRequest diff = words.corpus.diff;
    const std::string report = std::exchange(diff.report, "");
    PovJob job = words.corpus.defaults;
    job.scene = words.scene.scene;
    const bool pov = std::filesystem::path(job.scene).extension() == ".pov";
    const SceneComparison compared = pov ? compare_with_povray(job, diff) : compare_exported(words.scene, job, diff);
    if (diff.json) fmt::print("{}", as_json_text(to_json(compared)));
    else if (compared.comparison.judgement.verdict != Verdict::error) fmt::print("{}", as_lines(compared));
    auto written = write_files(compared.comparison, diff);
    if (written && !report.empty()) written = write_report(report, job.scene, {report_pair(compared)});
    if (!written) return fail(written.error()), int(Verdict::error);
    return exit_code(compared);
}

int compare_many(const CompareWords& words) {
    const auto entries = read_corpus(words.corpus);
    if (!entries) return fail(entries.error()), int(Verdict::error);
    if (povray_version().empty()) return fail("POV-Ray is not installed: its package is povray (and povray-includes)"), int(Verdict::error);
    std::error_code error;
    std::filesystem::create_directories(words.corpus.out, error);
    if (error) return fail(fmt::format("cannot make the folder {}: {}", words.corpus.out, error.message())), int(Verdict::error);
    const std::vector<CorpusResult> results = compare_corpus(words.corpus, *entries);
    int worst = 0;
    for (const CorpusResult& result : results) {
        const int code = result.document["exit_code"].get<int>();
        worst = std::max(worst, code == int(Verdict::error) ? int(Verdict::fail) : code);
    }
    Json all = Json::array();
    for (const CorpusResult& result : results) all.push_back(result.document);
    if (words.corpus.diff.json) fmt::print("{}", as_json_text(all));
    else print_rows(results);
    const std::string report = words.corpus.diff.report.empty() ? words.corpus.out + "/report.html" : words.corpus.diff.report;
    const auto written = write_report(report, fmt::format("{} scenes beside POV-Ray", results.size()), report_pairs(results, words.corpus));
    if (!written) return fail(written.error()), int(Verdict::error);
    return worst;
}

}  // namespace

int run_compare(const Verb& verb, const Words& given) {
    CompareWords words;
    Words ours = given;
    words.corpus.defaults.words = take_povray_words(ours);
    words.corpus.defaults.cache = default_cache();
    CLI::App app;
    add_words(app, words);
    if (const auto code = parse_words(app, verb, with_two_dashes(app, ours))) return *code == kDone ? int(kDone) : int(Verdict::error);
    const auto usage = [&](const char* sentence) { return usage_error(verb, sentence), int(Verdict::error); };
    if (words.scene.scene.empty() == words.corpus.list.empty()) return usage("give a SCENE, or --corpus LIST");
    if (!words.corpus.list.empty() && words.corpus.out.empty()) return usage("--corpus needs --out DIR");
    if (const std::string why = why_not_writable(words.corpus.diff); !why.empty()) return fail(why), int(Verdict::error);
    words.corpus.defaults.results = words.corpus.out;
    set_default_rules(words.corpus.diff.rules, "pov");
    exit_on_signal();
    return words.scene.scene.empty() ? compare_many(words) : compare_one(words);
}

}  // namespace alidade
