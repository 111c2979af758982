// SPDX-License-Identifier: Apache-2.0
/// The gate: how far is a picture from its reference, where, and is it good enough?
#include "tools/diff/words.h"
#include "tools/options.h"
#include "tools/report/report.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alidade {

int run_diff(const Verb& verb, const Words& given) {
    DiffRequest request;
    std::string reference, test;
    CLI::App app;
    app.add_option("REFERENCE", reference, "the picture that is right")->type_name("FILE")->required();
    app.add_option("TEST", test, "the picture that is asked how far it is from it")->type_name("FILE")->required();
    add_rule_words(app, request.rules);
    add_pair_words(app, request);
    add_output_words(app, request);
    if (const auto code = parse_words(app, verb, with_two_dashes(app, given))) return *code == kDone ? int(kDone) : int(Verdict::error);
    if (const std::string why = why_not_writable(request); !why.empty()) return fail(why), int(Verdict::error);
    if (const std::string why = why_overwritten(request, {reference, test, request.pair.mask}); !why.empty()) return fail(why), int(Verdict::error);
    set_default_rules(request.rules, "exact");
    Words line = {"alidade", "diff"};
    line.insert(line.end(), given.begin(), given.end());
    request.commands = {shell_line(line)};
    const Comparison comparison = compare_files(reference, test, request);
    if (request.json) fmt::print("{}", as_json_text(to_json(comparison)));
    else if (comparison.judgement.verdict == Verdict::error) fail(comparison.judgement.reason);
    else fmt::print("{}", as_lines(comparison));
    if (auto written = write_files(comparison, request); !written) return fail(written.error()), int(Verdict::error);
    return int(comparison.judgement.verdict);
}

}  // namespace alidade
