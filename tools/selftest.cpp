// SPDX-License-Identifier: Apache-2.0
/// Are the numbers on this machine what they should be?
#include "numerics/suite.h"
#include "tools/interrupt.h"
#include "tools/json.h"
#include "tools/load.h"
#include "tools/options.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace alidade {

namespace {

struct SelftestWords {
    std::vector<std::string> rows;   ///< ids or names; empty: all
    bool full = false, json = false, numerics = false;
    double share = 1;
    std::optional<uint64_t> only;    ///< this case alone
};

/// As the table tells it; `seconds` went by.
Json row_json(const NumericsRow& row, const NumericsTally& tally, double seconds) {
    Json json = {{"id", row.id}, {"name", row.name}, {"asked", tally.asked()}, {"wrong", tally.wrong()}, {"worst", tally.worst()}, {"seconds", std::round(seconds * 10) / 10}, {"goal", row.goal}, {"of others", row.peers}};
    return json;
}

std::vector<const NumericsRow*> chosen(const SelftestWords& words, std::string& unknown) {
    std::vector<const NumericsRow*> rows;
    if (words.rows.empty())
        for (const NumericsRow& row : numerics_suite()) rows.push_back(&row);
    for (const std::string& word : words.rows) {
        if (const NumericsRow* row = find_numerics(word)) rows.push_back(row);
        else unknown = word;
    }
    return rows;
}

std::string hint_for(const std::string& word) {
    std::vector<std::string> names;
    for (const NumericsRow& row : numerics_suite()) names.emplace_back(row.id), names.emplace_back(row.name);
    const std::string near = nearest(word, names);
    return near.empty() ? "it has " + fmt::format("{}", fmt::join(names, ", ")) : fmt::format("did you mean '{}'?", near);
}

/// Runs the rows one after the other; true if all meet their goals, but for what they are known to miss.
bool run_rows(const SelftestWords& words, const std::vector<const NumericsRow*>& rows) {
    Json table = Json::array(), failures = Json::array();
    bool as_known = true;
    for (const NumericsRow* row : rows) {
        const double start = seconds_now();
        const uint64_t all = words.full ? row->full : row->ci, count = std::max<uint64_t>(1, uint64_t(double(all) * words.share));
        const NumericsTally tally = words.only ? run_numerics(*row, *words.only, 1) : run_numerics(*row, 0, count);
        table.push_back(row_json(*row, tally, seconds_now() - start));
        const bool known = *row->falls_short && tally.wrong() * 1000 <= tally.asked();
        as_known = as_known && (known || tally.wrong() == 0);
        if (tally.wrong()) failures.push_back({{"row", row->id}, {"case", tally.first_wrong()}, {"what", tally.why()}, {"known", known ? row->falls_short : ""}, {"again", fmt::format("alidade selftest --numerics {} --case {}", row->id, tally.first_wrong())}});
    }
    const Json document = {{"rows", table}, {"failures", failures}};
    fmt::print("{}", words.json ? as_json_text(document) : as_text(document));
    return as_known;
}

}  // namespace

int run_selftest(const Verb& verb, const Words& given) {
    SelftestWords words;
    CLI::App app;
    app.add_option("ROW", words.rows, "rows by id or name (all)");
    app.add_flag("--numerics", words.numerics, "the numerical suite, the only one there is");
    app.add_flag("--full", words.full, "as many cases as the goals are stated for: hours");
    app.add_option("--share", words.share, "a part of the cases, or more of them (1)")->type_name("X")->check(CLI::Range(1e-9, 1e6));
    app.add_option("--case", words.only, "this case alone, as a failure names it")->type_name("N");
    app.add_flag("--json", words.json, "prints JSON instead of text");
    if (const auto code = parse_words(app, verb, given)) return *code;
    if (!words.numerics) return usage_error(verb, "say what to test: --numerics");
    std::string unknown;
    const auto rows = chosen(words, unknown);
    if (!unknown.empty()) return usage_error(verb, fmt::format("the suite has no row '{}'; {}", unknown, hint_for(unknown)));
    exit_on_signal();
    return run_rows(words, rows) ? kDone : kError;
}

}  // namespace alidade
