// SPDX-License-Identifier: Apache-2.0
/// What `tradeoff` tells people.
#include "tools/tradeoff/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace alidade::tradeoff {
namespace {

std::string times(double value, double usual) { return usual > 0 && std::isfinite(value) ? fmt::format("{:.3g}", value / usual) : "-"; }

/// Columns: their heads, and whether they stand to the right.
using Line = std::vector<std::string>;

std::string aligned(const std::vector<Line>& lines) {
    std::vector<size_t> widths(lines[0].size());
    for (const Line& line : lines)
        for (size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
    std::string out;
    for (const Line& line : lines) {
        std::string text;
        for (size_t i = 0; i + 1 < line.size(); ++i) text += fmt::format("{:>{}}  ", line[i], widths[i]);
        out += text + line.back() + "\n";
    }
    return out;
}

/// Is there a texture that anything reads?
bool reads_textures(const Experiment& e) {
    return std::any_of(e.rows.begin(), e.rows.end(), [](const Row& row) { return row.counts.contains("texture_reads") && row.counts.at("texture_reads") > 0; });
}

std::string millions(const Row& row, const char* count) {
    const auto found = row.counts.find(count);
    return found == row.counts.end() ? "-" : fmt::format("{:.4g}", found->second / 1e6);
}

Line line_of(const Experiment& e, const Verdicts& v, size_t i) {
    const Row& row = e.rows[i];
    const Cost time = row.time();
    Line line{v.front[i] ? "*" : "", fmt::format("{:.4g}", time.median), fmt::format("{:.2g}", time.deviation), millions(row, "rays")};
    if (reads_textures(e)) line.push_back(millions(row, "texture_reads"));
    const auto error = [&](const char* name) { return row.errors.contains(name) ? fmt::format("{:.4g}", row.error(name)) : "-"; };
    const std::string mark = v.uncertain[i] ? "~" : "";   // before the error that decides it
    line.push_back((v.metric == "rmse" ? mark : "") + error("rmse"));
    if (v.metric != "rmse" && v.metric != "flip" && v.metric != "over4") line.push_back(mark + error(v.metric.c_str()));
    line.push_back(error("flip"));
    line.push_back(row.errors.contains("over4") ? fmt::format("{:.3g}", 100 * row.error("over4")) : "-");
    if (e.job.seeds > 1) {
        line.push_back(row.noise ? fmt::format("{:.2g}", row.noise->bias2) : "-");
        line.push_back(row.noise ? fmt::format("{:.2g}", row.noise->variance) : "-");
    }
    if (e.job.instructions) line.push_back(row.instructions ? fmt::format("{:.5g}", *row.instructions / 1e6) : "-");
    const Row& usual = e.default_row();
    line.push_back(differ(time, usual.time()) ? times(time.median, usual.time().median) : "=");
    line.push_back(times(row.error(v.metric), usual.error(v.metric)));
    line.push_back(row.name(e.job) + (row.is_default && !row.setting.empty() ? "  (default)" : ""));
    return line;
}

Line head_of(const Experiment& e, const Verdicts& v) {
    Line head{"", "CPU s", "+-", "Mrays"};
    if (reads_textures(e)) head.emplace_back("Mtexels");
    head.emplace_back("rmse");
    if (v.metric != "rmse" && v.metric != "flip" && v.metric != "over4") head.push_back(v.metric);
    head.insert(head.end(), {"flip", ">4/255 %"});
    if (e.job.seeds > 1) head.insert(head.end(), {"bias^2", "variance"});
    if (e.job.instructions) head.emplace_back("Minstr");
    head.insert(head.end(), {"x time", "x error", "setting"});
    return head;
}

std::string recommendations(const Experiment& e, const Verdicts& v) {
    const auto row = [&](size_t i) { return fmt::format("{} ({:.4g} s, {} {:.4g})", e.rows[i].name(e.job), e.rows[i].time().median, v.metric, e.rows[i].error(v.metric)); };
    std::string out = fmt::format("fastest with {} <= {:.4g}: {}\n", v.metric, v.most_error, v.fastest ? row(*v.fastest) : "none");
    out += fmt::format("best within {:.4g} s: {}\n", v.most_time, v.best ? row(*v.best) : "none");
    return out + fmt::format("knee of the front: {}\n", v.knee ? row(*v.knee) : "none");
}

}  // namespace

std::string as_lines(const Experiment& e, const Verdicts& v) {
    std::vector<size_t> order(e.rows.size());
    for (size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return e.rows[a].time().median < e.rows[b].time().median; });
    std::vector<Line> lines{head_of(e, v)};
    for (const size_t i : order) lines.push_back(line_of(e, v, i));
    std::string out = fmt::format("reference: {}\n", e.reference.what);
    if (const auto own = e.reference.own.find(v.metric); own != e.reference.own.end()) out += fmt::format("its own error: {} {:.3g} (~: no more than that)\n", v.metric, own->second);
    out += fmt::format("CPU time of building and rendering, medians of {} rounds +- median deviation; =: within 2 of them of the default's; *: on the front of {}\n\n", e.job.repeat, v.metric);
    out += aligned(lines) + "\n" + recommendations(e, v);
    for (const Met& met : v.required)
        out += fmt::format("{}: {}\n", met.requirement.text, met.rows.empty() ? "NO SETTING MEETS IT" : fmt::format("met by {} settings, first {}", met.rows.size(), e.rows[met.rows[0]].name(e.job)));
    if (!v.free_axes.empty() && v.not_free.empty()) out += fmt::format("free, bit for bit: {}\n", fmt::join(v.free_axes, ", "));
    if (!v.unchecked_axes.empty()) out += fmt::format("not checked, as no two settings differ in nothing else: {}\n", fmt::join(v.unchecked_axes, ", "));
    return out;
}

}  // namespace alidade::tradeoff
