// SPDX-License-Identifier: Apache-2.0
#include "tools/tradeoff/document.h"

#include "core/parallel.h"

#include <fmt/format.h>

namespace alidade::tradeoff {
namespace {

Json setting_of(const Row& row) {
    Json out = Json::object();
    for (const Choice& choice : row.setting) out[choice.name] = choice.value;
    return out;
}

Json ratio(double value, double usual) { return usual > 0 ? number_or_null(value / usual) : Json(); }

Json row_of(const Experiment& e, const Verdicts& v, size_t i) {
    const Row& row = e.rows[i];
    const Cost time = row.time();
    const Interval interval = median_interval(row.seconds);
    Json out = {{"name", row.name(e.job)}, {"program", row.external < 0 ? "alidade" : e.job.externals[size_t(row.external)].words[0]}, {"setting", setting_of(row)},
                {"command", row.command}, {"default", row.is_default}, {"front", bool(v.front[i])}, {"within_reference_error", bool(v.uncertain[i])},
                {"cpu_seconds", number_or_null(time.median)}, {"cpu_seconds_mad", number_or_null(time.deviation)}, {"cpu_seconds_95", {interval.low, interval.high}}, {"build_seconds", number_or_null(median(row.build_seconds))},
                {"rounds", row.seconds}, {"counts", row.counts}, {"instructions", row.instructions ? number_or_null(*row.instructions) : Json()}};
    Json& errors = out["errors"] = Json::object();
    for (const ErrorColumn& column : error_columns())
        errors[column.name] = row.errors.contains(column.name) ? number_or_null(row.error(column.name)) : Json();
    out["noise"] = row.noise ? Json{{"bias2", row.noise->bias2}, {"variance", row.noise->variance}} : Json();
    out["non_finite"] = row.non_finite;
    const Row& usual = e.default_row();
    out["times_default_cost"] = ratio(time.median, usual.time().median);
    out["times_default_error"] = ratio(row.error(v.metric), usual.error(v.metric));
    out["cost_differs_from_default"] = differ(time, usual.time());
    return out;
}

Json axes_of(const Job& job) {
    Json axes = Json::array();
    for (const Axis& axis : job.axes) axes.push_back({{"name", axis.name}, {"values", axis.values}, {"must_be_free", must_be_free(axis.name)}});
    return axes;
}

Json index(const std::optional<size_t>& row) { return row ? Json(*row) : Json(); }

std::string csv_value(const Json& value) {
    if (value.is_string()) return csv_cell(value.get<std::string>());
    return value.is_null() ? "" : value.dump();
}

void flatten(const std::string& name, const Json& value, std::vector<std::pair<std::string, std::string>>& cells) {
    if (!value.is_object()) return cells.emplace_back(name, csv_value(value)), void();
    for (const auto& [key, each] : value.items()) cells.emplace_back(key, csv_value(each));
}

}  // namespace

Json as_document(const Experiment& e, const Verdicts& v) {
    Json base = Json::array(), rows = Json::array(), required = Json::array(), not_free = Json::array();
    for (const std::string& word : as_words(e.job.base)) base.push_back(word);
    for (size_t i = 0; i < e.rows.size(); ++i) rows.push_back(row_of(e, v, i));
    for (const Met& met : v.required) required.push_back({{"rule", met.requirement.text}, {"met", !met.rows.empty()}, {"rows", met.rows}});
    for (const NotFree& each : v.not_free) not_free.push_back({{"rows", {each.a, each.b}}, {"sentence", each.sentence}});
    return {{"schema", 1}, {"scene", e.job.scene}, {"options", base}, {"width", e.reference.picture.width}, {"height", e.reference.picture.height},
            {"axes", axes_of(e.job)}, {"repeat", e.job.repeat}, {"seeds", e.job.seeds}, {"metric", v.metric},
            {"reference", {{"what", e.reference.what}, {"own_error", e.reference.own}, {"cut_off", e.clip}}},
            {"machine", {{"processor", processor()}, {"threads", hardware_threads()}}}, {"rows", rows},
            {"recommended", {{"error", number_or_null(v.most_error)}, {"fastest_within_error", index(v.fastest)}, {"cpu_seconds", number_or_null(v.most_time)},
                             {"best_within_time", index(v.best)}, {"knee", index(v.knee)}}},
            {"free_axes", v.free_axes}, {"unchecked_axes", v.unchecked_axes}, {"not_free", not_free}, {"required", required}, {"warnings", e.warnings}};
}

std::string as_csv(const Experiment& e, const Verdicts& v) {
    std::string out;
    for (size_t i = 0; i < e.rows.size(); ++i) {
        std::vector<std::pair<std::string, std::string>> cells;
        Json row = row_of(e, v, i);
        for (const char* left_out : {"rounds", "setting", "cpu_seconds_95"}) row.erase(left_out);
        Json settings = Json::object();
        for (const Axis& axis : e.job.axes) settings["set_" + axis.name] = Json();   // a column an axis, empty where it is not varied
        for (const Choice& choice : e.rows[i].setting) settings["set_" + choice.name] = choice.value;
        Json counts = Json::object();   // other programs have none
        for (const auto& [name, unused] : e.rows[0].counts) counts[name] = row["counts"].contains(name) ? row["counts"][name] : Json();
        row["counts"] = counts;
        if (row["noise"].is_null()) row["noise"] = {{"bias2", Json()}, {"variance", Json()}};
        flatten("", settings, cells);
        for (const auto& [key, value] : row.items()) flatten(key, value, cells);
        const auto line = [&](auto member) {
            std::string text;
            for (const auto& cell : cells) text += (text.empty() && &cell == &cells.front() ? "" : ",") + cell.*member;
            return text + "\n";
        };
        if (i == 0) out += line(&std::pair<std::string, std::string>::first);
        out += line(&std::pair<std::string, std::string>::second);
    }
    return out;
}

}  // namespace alidade::tradeoff
