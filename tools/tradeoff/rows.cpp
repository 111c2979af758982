// SPDX-License-Identifier: Apache-2.0
/// Axes to rows.
#include "tools/tradeoff/experiment.h"

#include "tools/report/report.h"

#include <fmt/format.h>

#include <algorithm>

namespace alidade::tradeoff {
namespace {

bool names(const std::vector<Axis>& axes, const std::string& name) {
    return std::any_of(axes.begin(), axes.end(), [&](const Axis& axis) { return axis.name == name; });
}

bool is_placeholder(const Job& job, const std::string& name) {
    return std::any_of(job.externals.begin(), job.externals.end(), [&](const External& external) { return std::find(external.axes.begin(), external.axes.end(), name) != external.axes.end(); });
}

/// What would make pictures that cannot be compared with the reference.
constexpr const char* kNotVaried[] = {"size", "region", "aov", "camera", "exposure", "time"};

std::string why_no_axes(const Job& job) {
    if (std::any_of(job.base.begin(), job.base.end(), [](const Choice& choice) { return choice.name == "region"; })) return "--region: errors are those of whole pictures; take a smaller --size";
    for (size_t i = 0; i < job.axes.size(); ++i) {
        const Axis& axis = job.axes[i];
        if (std::any_of(job.axes.begin(), job.axes.begin() + long(i), [&](const Axis& other) { return other.name == axis.name; })) return fmt::format("--vary: '{}' is varied twice", axis.name);
        if (axis.name == "seed" && job.seeds > 1) return "--vary seed: --seeds varies it already";
        for (const char* name : kNotVaried)
            if (axis.name == name) return fmt::format("--vary {}: pictures of another {} cannot be compared with one reference", name, name);
        if (is_placeholder(job, axis.name) && !render_options().contains(axis.name)) continue;
        for (const std::string& value : axis.values)
            if (const auto parsed = parse_request(job.scene, combined(job.base, {{axis.name, value}})); !parsed) return fmt::format("--vary: {}", parsed.error());
    }
    for (const External& external : job.externals)
        for (const std::string& name : external.axes)
            if (!names(job.axes, name)) return fmt::format("--external: '{{{}}}' is not varied; give its values: --vary {}=V1,V2", name, name);
    return {};
}

/// In the order of the axes.
std::vector<Axis> chosen(const std::vector<Axis>& axes, const std::function<bool(const Axis&)>& choose) {
    std::vector<Axis> out;
    std::copy_if(axes.begin(), axes.end(), std::back_inserter(out), choose);
    return out;
}

Value<Row> own_row(const Job& job, const Setting& setting) {
    Row row;
    row.setting = setting;
    row.options = combined(job.base, setting);
    row.is_default = setting.empty();
    const auto request = parse_request(job.scene, row.options);
    if (!request) return tl::unexpected(request.error());
    row.request = *request;
    Words words{"alidade", "render", job.scene};
    for (const std::string& word : as_words(row.options)) words.push_back(word);
    row.command = shell_line(words);
    return row;
}

/// The same options, in whatever order.
bool same_options(Setting a, Setting b) {
    const auto less = [](const Choice& x, const Choice& y) { return std::tie(x.name, x.value) < std::tie(y.name, y.value); };
    std::sort(a.begin(), a.end(), less), std::sort(b.begin(), b.end(), less);
    return a == b;
}

Value<std::vector<Row>> own_rows(const Job& job) {
    std::vector<Row> rows;
    const std::vector<Axis> axes = chosen(job.axes, [](const Axis& axis) { return render_options().contains(axis.name); });
    auto settings = axes.empty() ? Value<std::vector<Setting>>(std::vector<Setting>{}) : expand(axes, job.mode);
    if (!settings) return tl::unexpected(settings.error());
    settings->insert(settings->begin(), Setting{});
    for (const Setting& setting : *settings) {
        auto row = own_row(job, setting);
        if (!row) return tl::unexpected(row.error());
        const bool as_default = !setting.empty() && !rows.empty() && rows[0].is_default && same_options(row->options, rows[0].options);
        if (as_default) row->is_default = true, rows.erase(rows.begin());
        rows.push_back(std::move(*row));
    }
    return rows;
}

}  // namespace

std::string Row::name(const Job& job) const { return external < 0 ? label(setting) : fmt::format("{}{}", job.externals[size_t(external)].words[0], setting.empty() ? "" : " " + label(setting)); }

double Row::error(const std::string& column) const {
    const auto found = errors.find(column);
    return found == errors.end() ? kInf : found->second;
}

const Row& Experiment::default_row() const {
    return *std::find_if(rows.begin(), rows.end(), [](const Row& row) { return row.is_default; });
}

Value<std::vector<Row>> rows_of(const Job& job) {
    if (std::string why = why_no_axes(job); !why.empty()) return tl::unexpected(std::move(why));
    auto rows = own_rows(job);
    if (!rows) return rows;
    for (size_t i = 0; i < job.externals.size(); ++i) {
        const External& external = job.externals[i];
        const auto is_own = [&](const Axis& axis) { return std::find(external.axes.begin(), external.axes.end(), axis.name) != external.axes.end(); };
        const auto settings = expand(chosen(job.axes, is_own), Mode{});
        if (!settings) return tl::unexpected(settings.error());
        for (const Setting& setting : *settings) {
            Row row;
            row.setting = setting, row.external = int(i);
            row.command = command_line(external, setting, {job.scene, (*rows)[0].request.render.width, (*rows)[0].request.render.height, 0}, "out");
            rows->push_back(std::move(row));
        }
    }
    if (rows->size() > kMostSettings) return tl::unexpected(fmt::format("{} settings are more than {}", rows->size(), kMostSettings));
    return rows;
}

std::string reading_of(const Setting& options) {
    std::string text;
    for (const Choice& choice : options)
        if (reading_options().contains(choice.name)) text += fmt::format("{}={}\n", choice.name, choice.value);
    return text;
}

}  // namespace alidade::tradeoff
