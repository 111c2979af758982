// SPDX-License-Identifier: Apache-2.0
/// How far are we from another renderer on this scene?
#include "tools/compare/compare_report.h"
#include "tools/compare/kept_pictures.h"
#include "tools/compare/program.h"
#include "tools/option_words.h"
#include "tools/options.h"
#include "tools/values.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

namespace alidade {
namespace {

struct CompareWords {
    CorpusRequest corpus;   ///< its `defaults` are the scene's job, its `reading` how a scene is read that is not POV-Ray's own, its `diff` the rules
};

/// Words after "--" are POV-Ray's, for both programs.
Words take_povray_words(Words& given) {
    const auto dashes = std::find(given.begin(), given.end(), "--");
    Words words(dashes == given.end() ? dashes : dashes + 1, given.end());
    given.erase(dashes, given.end());
    return words;
}

/// --noise has its number of seeds, or 16: what follows may be the scene.
Words with_noise_count(const Words& given) {
    Words out;
    for (size_t i = 0; i < given.size(); ++i) {
        const bool counted = i + 1 < given.size() && !given[i + 1].empty() && given[i + 1].find_first_not_of("0123456789") == std::string::npos;
        out.push_back(given[i] == "--noise" && !counted ? "--noise=16" : given[i]);
    }
    return out;
}

void add_reference_words(CLI::App& app, CompareJob& job) {
    std::vector<std::string> names;
    std::string docs;
    for (const ReferenceProgram& program : references()) names.emplace_back(program.name), docs += fmt::format("{} = {}, {}; ", program.name, program.title, program.doc);
    add_choice(app, "--against", names, [&job](size_t i) { job.against = &references()[i]; }, docs + "(default povray)");
    app.add_option("--spp", job.spp, "samples a pixel, of both, beside a program that takes them at random (16)")->type_name("N")->check(CLI::Range(1, 1 << 20));
    app.add_option("--noise", job.seeds, "our pictures of N seeds (16): a difference is an error where their noise does not explain it")->type_name("[N]")->check(CLI::Range(kFewestSeeds, 10000));
}

void add_words(CLI::App& app, CompareWords& words) {
    CompareJob& job = words.corpus.defaults;
    add_reference_words(app, job);
    add_scene_options(app, words.corpus.reading);   // of a POV-Ray scene SCENE alone counts: words after -- are for both programs
    app.get_option("SCENE")->required(false);
    app.add_option_function<std::string>("--size", [&job](const std::string& text) {
           const auto size = parse_size(text);
           if (!size) throw CLI::ValidationError("--size", size.error());
           job.width = size->width, job.height = size->height;
       }, "of the picture (320x240; a list may say its own)")->type_name("WxH");
    add_number(app, "--timeout", "SECONDS", 0.001, [&job](double value) { job.timeout = value; }, "seconds that a program has (600)", 1e7);
    app.add_option("--cache", job.cache, fmt::format("the folder of the other programs' pictures, which are kept ({})", default_cache()))->type_name("DIR");
    app.add_option("--corpus", words.corpus.list, "compares a list of scenes: a CSV file with a column `path`, or a path a line")->type_name("LIST");
    app.add_option("--scenes", words.corpus.scenes, "the folder that the list's paths begin from (its own)")->type_name("DIR");
    app.add_option("--where", words.corpus.where, "rows of the list that count: tier<=3, category=lights; may be given again")->type_name("CONDITION")->allow_extra_args(false);
    app.add_option("--out", words.corpus.out, "the folder of a list's results, pictures and report; what is there already is not rendered again")->type_name("DIR");
    app.add_option("--jobs", words.corpus.jobs, "scenes of a list that are rendered at a time (1)")->type_name("N")->check(CLI::Range(1, 256));
    add_rule_words(app, words.corpus.diff.rules);
    add_pair_words(app, words.corpus.diff);
    add_output_words(app, words.corpus.diff);
}

/// What changes a result.
std::string as_one_line(const CLI::App& app) {
    constexpr std::array kOthers = {"--jobs", "--cache", "--timeout", "--out", "--corpus", "--scenes", "--where", "--json", "--junit", "--report", "--heatmap", "--threads"};
    std::string line;
    for (const CLI::Option* option : app.get_options()) {
        const bool counts = option->count() > 0 && std::none_of(kOthers.begin(), kOthers.end(), [&](const char* other) { return option->check_name(other); });
        if (counts) line += fmt::format("{} {}\n", option->get_name(), fmt::join(option->results(), " "));
    }
    return line;
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
    CompareJob job = words.corpus.defaults;
    job.scene = words.corpus.reading.scene, job.objects = !report.empty();
    const SceneComparison compared = compare_scene(words.corpus.reading, job, diff);
    if (diff.json) fmt::print("{}", as_json_text(to_json(compared)));
    else if (compared.comparison.judgement.verdict != Verdict::error) fmt::print("{}", as_lines(compared));
    auto written = write_files(compared.comparison, diff);
    if (written && !report.empty()) written = write_report(report, job.scene, *job.against, {report_pair(compared)});
    if (!written) return fail(written.error()), int(Verdict::error);
    if (compared.comparison.judgement.verdict == Verdict::error) fail(compared.comparison.judgement.reason);
    return exit_code(compared);
}

int compare_many(const CompareWords& words) {
    const auto entries = read_corpus(words.corpus);
    if (!entries) return fail(entries.error()), int(Verdict::error);
    const ReferenceProgram& against = *words.corpus.defaults.against;
    if (const std::string why = why_missing(against); !why.empty()) return fail(why), int(Verdict::error);
    std::error_code error;
    std::filesystem::create_directories(words.corpus.out, error);
    if (error) return fail(fmt::format("cannot make the folder {}: {}", words.corpus.out, error.message())), int(Verdict::error);
    const std::vector<CorpusResult> results = compare_corpus(words.corpus, *entries);
    int worst = 0;
    for (const CorpusResult& result : results) worst = std::max(worst, result.document["exit_code"].get<int>());
    Json all = Json::array();
    for (const CorpusResult& result : results) all.push_back(result.document);
    if (words.corpus.diff.json) fmt::print("{}", as_json_text(all));
    else print_rows(results);
    const std::string report = words.corpus.diff.report.empty() ? words.corpus.out + "/report.html" : words.corpus.diff.report;
    const auto written = write_report(report, fmt::format("{} scenes beside {}", results.size(), against.title), against, report_pairs(results, words.corpus));
    if (!written) return fail(written.error()), int(Verdict::error);
    return worst;
}

}  // namespace

int run_compare(const Verb& verb, const Words& given) {
    CompareWords words;
    CorpusRequest& corpus = words.corpus;
    Words ours = given;
    corpus.defaults.words = take_povray_words(ours);
    corpus.defaults.cache = default_cache(), corpus.defaults.against = &references()[0];
    CLI::App app;
    add_words(app, words);
    if (const auto code = parse_words(app, verb, with_noise_count(with_two_dashes(app, ours)))) return *code == kDone ? int(kDone) : int(Verdict::error);
    const auto usage = [&](const std::string& sentence) { return usage_error(verb, sentence), int(Verdict::error); };
    const std::string& scene = corpus.reading.scene;
    if (scene.empty() == corpus.list.empty()) return usage("give a SCENE, or --corpus LIST");
    if (!corpus.list.empty() && corpus.out.empty()) return usage("--corpus needs --out DIR");
    const ReferenceProgram& against = *corpus.defaults.against;
    if (!corpus.list.empty() && !(corpus.diff.junit + corpus.diff.heatmap).empty()) return usage("--junit and --heatmap are for one SCENE; a list has --json and --report");
    const bool one_of_ours = !scene.empty() && !is_povray_scene(scene);
    if (one_of_ours && !corpus.defaults.words.empty()) return usage("the words after -- are POV-Ray's, and this is no scene of POV-Ray's: what they say cannot be said to both programs");
    if (!scene.empty() && !std::filesystem::is_regular_file(scene)) return fail(fmt::format("there is no file '{}'", scene)), int(Verdict::error);
    if (const std::string why = why_overwritten(corpus.diff, {scene, corpus.diff.pair.mask}); !why.empty()) return fail(why), int(Verdict::error);
    if (corpus.defaults.spp != 0 && !against.random) return usage(fmt::format("--spp says nothing to {}: its words, such as +A0.3, come after --", against.title));
    if (const std::string why = why_not_writable(corpus.diff); !why.empty()) return fail(why), int(Verdict::error);
    corpus.defaults.results = corpus.out;
    corpus.defaults.cache = std::filesystem::absolute(corpus.defaults.cache).string();
    corpus.words = as_one_line(app);
    if (corpus.defaults.seeds == 1) set_default_rules(corpus.diff.rules, "pov");
    clean_up_on_signal();
    return scene.empty() ? compare_many(words) : compare_one(words);
}

}  // namespace alidade
