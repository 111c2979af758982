// SPDX-License-Identifier: Apache-2.0
/// Are the numbers on this machine what they should be?
#include "numerics/peers.h"
#include "numerics/suite.h"
#include "numerics/triangles/compare.h"
#include "tools/identity.h"
#include "tools/interrupt.h"
#include "tools/json.h"
#include "tools/load.h"
#include "tools/option_words.h"
#include "tools/options.h"
#include "tools/progress.h"
#include "tools/selftest_page.h"
#include "tools/store.h"

#include <CLI/CLI.hpp>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <ctime>
#include <limits>
#include <sys/resource.h>

namespace alidade {

namespace {

struct SelftestWords {
    std::vector<std::string> rows;   ///< ids or names; empty: all
    bool full = false, json = false, numerics = false, markdown = false, told = false;
    double share = 1;
    int threads = 0;
    std::string state;               ///< folder; empty: none
    NumericsAsked asked;
    std::optional<uint64_t> only;    ///< this case alone
};

Json peers_json(const NumericsRow& row) {
    Json list = Json::array();
    for (const NumericsPeer& peer : numerics_peers())
        if (std::string_view(row.id) == peer.row) list.push_back({{"program", peer.program}, {"figure", peer.figure}, {"inputs", peer.inputs}});
    return list;
}

/// As the table tells it; whole: for programs.
Json row_json(const NumericsDone& done, bool whole) {
    const auto& [row, wanted, seconds, tally, begun, day] = done;
    return {{"id", row->id}, {"name", row->name}, {"asked", tally.asked()}, {"wrong", tally.wrong()}, {"excused", tally.excused()}, {"worst", number_or_null(tally.worst())}, {"cases", tally.cases()}, {"cpu seconds", std::round(seconds * 10) / 10}, {"goal", row->goal}, {"of others", whole ? peers_json(*row) : Json(peers_text(row->id))}};
}

std::vector<const NumericsRow*> chosen(const SelftestWords& words, std::string& unknown) {
    std::vector<const NumericsRow*> rows;
    if (words.rows.empty())
        for (const NumericsRow& row : numerics_suite()) rows.push_back(&row);
    for (const std::string& word : words.rows) {
        const NumericsRow* row = find_numerics(word);
        if (!row) unknown = word;
        else if (std::find(rows.begin(), rows.end(), row) == rows.end()) rows.push_back(row);
    }
    return rows;
}

std::string hint_for(const std::string& word) {
    std::vector<std::string> names;
    for (const NumericsRow& row : numerics_suite()) names.emplace_back(row.id), names.emplace_back(row.name);
    const std::string near = nearest(word, names);
    return near.empty() ? "it has " + fmt::format("{}", fmt::join(names, ", ")) : fmt::format("did you mean '{}'?", near);
}

/// Of the whole process.
double cpu_seconds() {
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
    return seconds(used.ru_utime) + seconds(used.ru_stime);
}

std::string today() { return fmt::format("{:%F}", fmt::gmtime(std::time(nullptr))); }

/// Runs rows from where the state says that they are, and writes there how far they are now.
class Suite {
  public:
    Suite(const SelftestWords& words, tradeoff::Store store, const std::atomic<bool>* stop) : words_(words), store_(std::move(store)), stop_(stop) {}

    NumericsDone known(const NumericsRow& row) const {
        NumericsDone done{&row, std::max<uint64_t>(1, uint64_t(double(words_.full ? row.full : row.ci) * words_.share)), 0, {}, today(), today()};
        NumericsDone kept = done;
        const Json* json = store_.find(row.id);
        return json && from_json(*json, kept) && (words_.told || kept.wanted == done.wanted) ? kept : done;
    }

    bool knows(const NumericsRow& row) const { return store_.find(row.id); }
    bool can_read(const NumericsRow& row) const {
        NumericsDone done{&row, 0, 0, {}};
        return from_json(*store_.find(row.id), done);
    }

    NumericsDone run(const NumericsRow& row) {
        const NumericsDone before = known(row);
        NumericsDone now = before;
        now.day = today();
        const double start = cpu_seconds();
        Progress progress(words_.json ? ProgressMode::none : ProgressMode::bar, stderr);
        NumericsWatch watch{words_.threads, stop_, {}};
        watch.tell = [&](const NumericsTally& so_far) {
            progress.update(before.tally.cases() + so_far.cases(), before.wanted);
            if (store_.folder().empty() || seconds_now() - kept_at_ < 10) return;
            now.tally = before.tally, now.tally.add(so_far), now.cpu_seconds = before.cpu_seconds + cpu_seconds() - start;
            keep(now);
        };
        const NumericsTally found = run_numerics(row, before.tally.cases(), before.wanted - before.tally.cases(), watch);
        now.tally = before.tally, now.tally.add(found), now.cpu_seconds = before.cpu_seconds + cpu_seconds() - start;
        if (found.cases()) keep(now);
        return now;
    }
    /// Why the state was not written last; "" if it was.
    const std::string& error() const { return error_; }

  private:
    void keep(const NumericsDone& done) {
        const auto kept = store_.keep(done.row->id, to_json(done));
        error_ = kept ? "" : kept.error();
        kept_at_ = seconds_now();
    }

    const SelftestWords& words_;
    tradeoff::Store store_;
    const std::atomic<bool>* stop_;
    double kept_at_ = seconds_now();
    std::string error_;
};

std::string precision_name(const SelftestWords& words) { return words.asked.precision ? numerics::name(*words.asked.precision) : "both"; }

Json failure_json(const SelftestWords& words, const NumericsDone& done) {
    const auto& [row, wanted, seconds, tally, begun, day] = done;
    std::string asked = words.asked.intersect == Intersect::exact ? "" : fmt::format(" --intersect {}", name(words.asked.intersect));
    if (words.asked.precision) asked += " --precision " + precision_name(words);
    return {{"row", row->id}, {"case", tally.first_wrong()}, {"what", tally.why()}, {"known", done.as_known() ? row->falls_short : ""}, {"again", fmt::format("alidade selftest --numerics {} --case {}{}", row->id, tally.first_wrong(), asked)}};
}

void print(const SelftestWords& words, const std::vector<NumericsDone>& rows) {
    Json table = Json::array(), failures = Json::array();
    for (const NumericsDone& done : rows) {
        table.push_back(row_json(done, words.json));
        if (done.tally.wrong()) failures.push_back(failure_json(words, done));
    }
    const Json document = {{"rows", table}, {"failures", failures}};
    fmt::print("{}", words.markdown ? as_markdown(rows) : words.json ? as_json_text(document) : as_text(document));
}

/// What a state is of: another program may find something else. What is only told may be of any.
Value<tradeoff::Store> state_of(const SelftestWords& words) {
    if (words.state.empty()) return tradeoff::Store();
    if (words.told) return tradeoff::Store::read(words.state);
    return tradeoff::Store::open(words.state, {{"program", program_identity()}, {"full", words.full}, {"intersect", name(words.asked.intersect)}, {"precision", precision_name(words)}, {"share", words.share}});
}

/// What is told is of what the state asked about.
void take_head(const tradeoff::Store& store, SelftestWords& words) {
    const Json* head = store.find("head");
    if (!words.told || !head || !head->is_object()) return;
    for (const IntersectEntry& entry : intersects())
        if (head->value("intersect", std::string()) == entry.name) words.asked.intersect = entry.value;
    for (const Precision precision : {Precision::float_, Precision::double_})
        if (head->value("precision", std::string()) == numerics::name(precision)) words.asked.precision = precision;
}

/// Runs the rows one after the other, and tells of them.
int run_rows(SelftestWords words, const std::vector<const NumericsRow*>& rows) {
    auto store = state_of(words);
    if (!store) return fail(store.error());
    take_head(*store, words);
    std::optional<StopOnSignal> signals;
    if (words.state.empty()) exit_on_signal();
    else signals.emplace();
    Suite suite(words, std::move(*store), signals ? &signals->stop() : nullptr);
    std::vector<NumericsDone> done;
    bool as_known = true, whole = true;
    for (const NumericsRow* row : rows) {
        if (words.told && !suite.knows(*row)) {
            if (!words.rows.empty()) return fail(fmt::format("{} holds nothing of {}", words.state, row->id));
            continue;
        }
        if (words.told && !suite.can_read(*row)) return fail(fmt::format("{}: what is kept of {} cannot be read", words.state, row->id));
        if (words.only) done.push_back({row, 1, 0, run_numerics(*row, *words.only, 1), today(), today()});
        else done.push_back(words.told ? suite.known(*row) : suite.run(*row));
        as_known = as_known && (done.back().tally.wrong() == 0 || done.back().as_known());
        whole = whole && done.back().tally.cases() == done.back().wanted;
        if (!suite.error().empty()) return print(words, done), fail(suite.error());
        if (signals && signals->stop()) break;
    }
    if (!words.told && (!whole || done.size() < rows.size())) return fmt::print(stderr, "alidade: interrupted; the same words go on from {}\n", words.state), kInterrupted;
    print(words, done);
    return as_known ? kDone : kError;
}

}  // namespace

int run_selftest(const Verb& verb, const Words& given) {
    SelftestWords words;
    CLI::App app;
    app.add_option("ROW", words.rows, "rows by id or name (all)");
    app.add_flag("--numerics", words.numerics, "the numerical suite, the only one there is");
    app.add_flag("--full", words.full, "as many cases as the goals are stated for: hours");
    add_number(app, "--share", "X", 1e-9, [&words](double value) { words.share = value; }, "a part of the cases, or more of them (1)", 1e6);
    auto* only = add(app, "--case", "N", [](const std::string& word) { return parse_integer(word, 0, std::numeric_limits<int64_t>::max()); }, [&words](int64_t number) { words.only = uint64_t(number); }, "this case alone, as a failure names it");
    app.add_option("--threads", words.threads, "threads (0: as many as the machine has); what is found does not depend on them")->type_name("N")->check(CLI::Range(0, 1024));
    app.add_option("--state", words.state, "a folder in which it is written how far the run is: one that was ended goes on from there")->type_name("FOLDER")->excludes(only);
    auto* told = app.add_flag("--told", words.told, "asks nothing: tells what --state holds, of any program, whole or not");
    auto* json = app.add_flag("--json", words.json, "prints JSON instead of text");
    app.add_flag("--markdown", words.markdown, "prints the tables of docs/numerics.md instead of text")->excludes(json);
    told->needs("--state");
    add_choice(app, "--intersect", names_of(intersects()), [&words](size_t i) { words.asked.intersect = intersects()[i].value; }, "the test of triangles in T01 to T06 and T15 to T18; goals are those of exact");
    add_choice(app, "--precision", {"float", "double"}, [&words](size_t i) { words.asked.precision = i ? Precision::double_ : Precision::float_; }, "structures of this precision alone, in the same rows");
    if (const auto code = parse_words(app, verb, given)) return *code;
    if (!words.numerics) return usage_error(verb, "say what to test: --numerics");
    std::string unknown;
    const auto rows = chosen(words, unknown);
    if (!unknown.empty()) return usage_error(verb, fmt::format("the suite has no row '{}'; {}", unknown, hint_for(unknown)));
    ask_numerics(words.asked);
    return run_rows(words, rows);
}

}  // namespace alidade
