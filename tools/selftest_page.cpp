// SPDX-License-Identifier: Apache-2.0
#include "tools/selftest_page.h"

#include "numerics/peers.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace alidade {

namespace {

/// 12,345,678
std::string grouped(uint64_t n) {
    std::string text = std::to_string(n);
    for (size_t i = text.size(); i > 3;) text.insert(i -= 3, ",");
    return text;
}

/// Nothing where no error was ever measured.
std::string short_number(double x) { return x == 0 ? "" : fmt::format("{:.2g}", x); }

std::string row_line(const NumericsDone& done) {
    const NumericsFound& found = done.tally.found();
    std::string asked = grouped(found.asked);
    if (found.cases < done.row->full) asked += fmt::format(" ({:.2g} % of a whole run)", 100.0 * double(found.cases) / double(done.row->full));
    const std::string known = *done.row->falls_short ? fmt::format("; known to fall short: {}", done.row->falls_short) : "";
    return fmt::format("| {} {} | {} | {}{} | {} | {} | {} | {} |\n", done.row->id, done.row->name, done.row->asks, done.row->goal, known, asked, grouped(found.wrong), short_number(found.worst), peers_text(done.row->id));
}

/// "on DAY", or the first and the last day.
std::string days(const std::vector<NumericsDone>& rows) {
    if (rows.empty()) return "";
    std::string first = rows[0].begun, last = rows[0].day;
    for (const NumericsDone& done : rows) first = std::min(first, done.begun), last = std::max(last, done.day);
    return first == last ? fmt::format(", on {}", first) : fmt::format(", from {} to {}", first, last);
}

/// How much it was in all, and which rows have wrong answers.
std::string sum_line(const std::vector<NumericsDone>& rows) {
    uint64_t asked = 0;
    double seconds = 0;
    std::string wrong;
    for (const NumericsDone& done : rows) {
        asked += done.tally.asked(), seconds += done.cpu_seconds;
        if (done.tally.wrong()) wrong += fmt::format("{} {} of {}", wrong.empty() ? "" : ",", grouped(done.tally.wrong()), done.row->id);
    }
    return fmt::format("{} answers in {:.2g} hours of one processor core{}; wrong:{}.\n\n", grouped(asked), seconds / 3600, days(rows), wrong.empty() ? " none" : wrong);
}

/// Neighbouring decades whose answers are all right, or none of which are.
struct Stretch {
    NumericsBand sum;
    int last;   ///< decade
};

std::vector<Stretch> stretches(std::vector<NumericsBand> bands) {
    std::sort(bands.begin(), bands.end(), [](const NumericsBand& a, const NumericsBand& b) { return std::pair(a.scale, a.decade) < std::pair(b.scale, b.decade); });
    std::vector<Stretch> all;
    for (const NumericsBand& b : bands) {
        const bool goes_on = !all.empty() && all.back().sum.scale == b.scale && all.back().last + 1 == b.decade && (all.back().sum.wrong == 0) == (b.wrong == 0);
        if (!goes_on) all.push_back({{b.scale, b.decade}, b.decade});
        NumericsBand& sum = all.back().sum;
        sum.asked += b.asked, sum.wrong += b.wrong, all.back().last = b.decade;
        if (!(b.worst <= sum.worst)) sum.worst = b.worst;
    }
    return all;
}

std::string stretch_lines(const NumericsDone& done) {
    std::string lines;
    for (const auto& [sum, last] : stretches(done.tally.found().bands))
        lines += fmt::format("| {} {} | {} | 1e{} to 1e{} | {} | {} | {} |\n", done.row->id, done.row->name, name(sum.scale), sum.decade, last + 1, grouped(sum.asked), grouped(sum.wrong), short_number(sum.worst));
    return lines;
}

/// Every bit of it, infinities and NaN too.
std::string exactly(double x) { return fmt::format("{:a}", x); }

}  // namespace

std::string as_markdown(const std::vector<NumericsDone>& rows) {
    std::string page = sum_line(rows) + "| row | asks | goal | answers | wrong | worst | others, measured |\n|---|---|---|--:|--:|--:|---|\n", where;
    for (const NumericsDone& done : rows) page += row_line(done), where += stretch_lines(done);
    if (where.empty()) return page;
    return page + "\n| row | by | from, to | answers | wrong | worst |\n|---|---|---|--:|--:|--:|\n" + where;
}

Json to_json(const NumericsDone& done) {
    const NumericsFound& found = done.tally.found();
    Json bands = Json::array();
    for (const NumericsBand& b : found.bands) bands.push_back({int(b.scale), b.decade, b.asked, b.wrong, exactly(b.worst)});
    return {{"begun", done.begun}, {"day", done.day}, {"wanted", done.wanted}, {"cpu seconds", done.cpu_seconds}, {"cases", found.cases}, {"asked", found.asked}, {"wrong", found.wrong}, {"excused", found.excused}, {"first wrong", found.first_wrong},
            {"worst case", found.worst_case}, {"worst", exactly(found.worst)}, {"why", found.why}, {"bands", bands}};
}

bool from_json(const Json& json, NumericsDone& done) {
    try {
        NumericsFound found;
        const auto number = [](const Json& text) { return std::strtod(text.get_ref<const std::string&>().c_str(), nullptr); };
        const auto count = [&json](const char* key) { return json.at(key).is_number_unsigned() ? json.at(key).get<uint64_t>() : throw Json::other_error::create(500, key, &json); };
        done.begun = json.at("begun").get<std::string>(), done.day = json.at("day").get<std::string>();
        done.wanted = count("wanted"), done.cpu_seconds = json.at("cpu seconds").get<double>();
        found.cases = count("cases"), found.asked = count("asked"), found.wrong = count("wrong"), found.excused = count("excused");
        found.first_wrong = count("first wrong"), found.worst_case = count("worst case");
        found.worst = number(json.at("worst")), found.why = json.at("why").get<std::string>();
        for (const Json& b : json.at("bands")) {
            const int scale = b.at(0).get<int>();
            if (scale < 0 || scale > int(NumericsScale::gap)) return false;
            found.bands.push_back({NumericsScale(scale), b.at(1).get<int>(), b.at(2).get<uint64_t>(), b.at(3).get<uint64_t>(), number(b.at(4))});
        }
        if (found.cases > done.wanted || found.excused > found.wrong || found.wrong > found.asked) return false;
        done.tally = NumericsTally(std::move(found));
        return true;
    } catch (const Json::exception&) {
        return false;
    }
}

}  // namespace alidade
