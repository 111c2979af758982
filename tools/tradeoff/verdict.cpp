// SPDX-License-Identifier: Apache-2.0
#include "tools/tradeoff/verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace alidade::tradeoff {
namespace {

bool is_measured(const Row& row) { return row.non_finite == 0 && !row.errors.empty(); }

std::vector<Point> points_of(const Experiment& e, const std::string& metric) {
    std::vector<Point> points;
    for (const Row& row : e.rows) points.push_back({row.time(), is_measured(row) ? row.error(metric) : kInf});
    return points;
}

bool dominates(const Point& a, const Point& b) {
    const bool cheaper = differ(a.cost, b.cost) && a.cost.median < b.cost.median, dearer = differ(a.cost, b.cost) && a.cost.median > b.cost.median;
    return (a.error < b.error && !dearer) || (a.error <= b.error && cheaper);
}

std::vector<size_t> by_time(const Experiment& e) {
    std::vector<size_t> order;
    for (size_t i = 0; i < e.rows.size(); ++i)
        if (is_measured(e.rows[i])) order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return e.rows[a].time().median < e.rows[b].time().median; });
    return order;
}

void recommend(const Experiment& e, const Questions& q, Verdicts& v) {
    const Row& usual = e.default_row();
    v.most_error = q.error.value_or(usual.error(v.metric));
    v.most_time = q.time.value_or(usual.time().median);
    const std::vector<size_t> order = by_time(e);
    for (const size_t i : order) {
        const double error = e.rows[i].error(v.metric);
        if (!v.fastest && error <= v.most_error) v.fastest = i;
        const bool in_time = e.rows[i].time().median <= v.most_time || (!q.time && !differ(e.rows[i].time(), usual.time()));
        if (in_time && (!v.best || error < e.rows[*v.best].error(v.metric))) v.best = i;
    }
    std::vector<size_t> members;
    std::vector<Point> front;
    for (const size_t i : order)
        if (v.front[i]) members.push_back(i), front.push_back({e.rows[i].time(), e.rows[i].error(v.metric)});
    if (const auto knee = knee_of(front)) v.knee = members[*knee];
}

std::string value_of(const std::string& text, size_t from) { return text.substr(from, text.find_last_not_of(' ') + 1 - from); }

bool holds(const MetricRule& rule, double value) {
    using Is = MetricRule::Is;
    switch (rule.is) {
        case Is::less: return value < rule.limit;
        case Is::less_or_equal: return value <= rule.limit;
        case Is::greater: return value > rule.limit;
        default: return value >= rule.limit;
    }
}

std::vector<std::string> cost_names() {
    return {"time", "instructions", "rays", "camera_rays", "shadow_rays", "secondary_rays", "boxes", "filtered", "primitives", "exact", "texture_reads"};
}

/// The name before the sign, in place of one that `known` rules take.
Value<MetricRule> parse_rule(const std::string& text, const std::vector<std::string>& names, const char* what) {
    const size_t begin = text.find_first_not_of(' '), sign = text.find_first_of("<>");
    if (begin == text.npos || sign == text.npos) return tl::unexpected(fmt::format("'{}' is not NAME<LIMIT", text));
    const std::string name = value_of(text.substr(0, sign), begin);
    if (std::find(names.begin(), names.end(), name) == names.end()) {
        const std::string near = nearest(name, names);
        return tl::unexpected(fmt::format("no {} is called '{}'; {}", what, name, near.empty() ? fmt::format("there are {}", fmt::join(names, ", ")) : fmt::format("did you mean '{}'?", near)));
    }
    auto rule = parse_metric_rule("rmse" + text.substr(sign));   // signs and limits as `diff` takes them
    if (!rule) return tl::unexpected(fmt::format("'{}' has no limit that is a number, such as 0.02, 0.5% or 2e6", text));
    rule->metric = name, rule->text = text;
    return *rule;
}

Met met(const Experiment& e, const Requirement& requirement) {
    Met out{requirement, {}};
    for (const size_t i : by_time(e)) {
        const auto cost = cost_named(e.rows[i], requirement.cost.metric);
        const auto error = e.rows[i].errors.find(requirement.error.metric);
        if (cost && error != e.rows[i].errors.end() && holds(requirement.error, error->second) && holds(requirement.cost, *cost)) out.rows.push_back(i);
    }
    return out;
}

/// The options that may change the picture, in an order of their own: settings have the varied ones last.
std::string paid_part(const Row& row) {
    Setting paid = row.options;
    const bool structures_agree = row.request.compile.intersect == Intersect::exact;   // others see the boxes and cells that led to a triangle
    std::erase_if(paid, [&](const Choice& choice) { return must_be_free(choice.name) && (structures_agree || choice.name != "accel"); });
    std::stable_sort(paid.begin(), paid.end(), [](const Choice& a, const Choice& b) { return a.name < b.name; });
    return label(paid);
}

/// What it says of an option, if anything.
std::string said_of(const Row& row, const std::string& option) {
    const auto found = std::find_if(row.options.begin(), row.options.end(), [&](const Choice& choice) { return choice.name == option; });
    return found == row.options.end() ? "" : found->value;
}

/// Pictures are not kept: both are made once more.
std::string first_difference(const Experiment& e, const Row& a, const Row& b) {
    Renderer renderer;
    const auto one = renderer.run(a.request, reading_of(a.options)), two = renderer.run(b.request, reading_of(b.options));
    if (!one || !two) return "";
    const Picture &p = one->picture, &q = two->picture;
    for (size_t i = 0; i < p.values.size(); ++i) {
        if (std::bit_cast<uint32_t>(p.values[i]) == std::bit_cast<uint32_t>(q.values[i])) continue;
        const size_t pixel = i / size_t(p.channels);
        return fmt::format(": pixel {},{} has {} {} with {}, and {} with {}", pixel % size_t(p.width), pixel / size_t(p.width), p.names[i % size_t(p.channels)], p.values[i], a.name(e.job),
                           q.values[i], b.name(e.job));
    }
    return "; made once more they are equal";
}

void check_free_axes(const Experiment& e, Verdicts& v) {
    for (const size_t i : e.unrepeatable) v.not_free.push_back({i, i, fmt::format("{}: another run made another picture, which is a bug", e.rows[i].name(e.job))});
    std::set<std::string> compared;
    std::map<std::string, size_t> first;
    for (size_t i = 0; i < e.rows.size(); ++i) {
        const Row& row = e.rows[i];
        if (row.external >= 0) continue;
        const size_t other = first.emplace(paid_part(row), i).first->second;
        for (const Axis& axis : e.job.axes)
            if (said_of(row, axis.name) != said_of(e.rows[other], axis.name)) compared.insert(axis.name);
        if (row.fingerprint == e.rows[other].fingerprint) continue;
        v.not_free.push_back({other, i, fmt::format("{} and {} made different pictures, which is a bug{}", e.rows[other].name(e.job), row.name(e.job), first_difference(e, e.rows[other], row))});
    }
    for (const Axis& axis : e.job.axes)
        if (must_be_free(axis.name)) (compared.contains(axis.name) ? v.free_axes : v.unchecked_axes).push_back(axis.name);
}

}  // namespace

bool must_be_free(const std::string& option) {
    static const std::set<std::string> names{"accel", "isa", "threads", "tile", "lazy", "full-kernel"};
    return names.contains(option);
}

std::vector<bool> front_of(const std::vector<Point>& points) {
    std::vector<bool> front(points.size());
    for (size_t i = 0; i < points.size(); ++i) front[i] = std::none_of(points.begin(), points.end(), [&](const Point& other) { return dominates(other, points[i]); });
    return front;
}

std::optional<size_t> knee_of(const std::vector<Point>& front) {
    if (front.size() < 3) return std::nullopt;
    double least = kInf;   // an error of 0 stands a decade below the least other one
    for (const Point& point : front)
        if (point.error > 0) least = std::min(least, point.error);
    const auto x = [](const Point& point) { return std::log(std::max(point.cost.median, 1e-9)); };
    const auto y = [least](const Point& point) { return std::log(point.error > 0 ? point.error : 0.1 * least); };
    const double x0 = x(front.front()), x1 = x(front.back()), y0 = y(front.front()), y1 = y(front.back());
    if (!(x1 > x0 && y1 < y0)) return std::nullopt;
    std::optional<size_t> knee;
    double farthest = 1e-9;
    for (size_t i = 1; i + 1 < front.size(); ++i) {
        const double below = 1 - (x(front[i]) - x0) / (x1 - x0) - (y(front[i]) - y1) / (y0 - y1);
        if (below > farthest) farthest = below, knee = i;
    }
    return knee;
}

Value<Requirement> parse_requirement(const std::string& text) {
    const size_t at = text.find('@');
    if (at == text.npos) return tl::unexpected(fmt::format("--require: '{}' is not ERROR<LIMIT @ COST<LIMIT, such as 'rmse<0.01 @ rays<2e6'", text));
    std::vector<std::string> errors;
    for (const ErrorColumn& column : error_columns()) errors.emplace_back(column.name);
    const auto error = parse_rule(text.substr(0, at), errors, "error");
    if (!error) return tl::unexpected(fmt::format("--require: {}", error.error()));
    const auto cost = parse_rule(text.substr(at + 1), cost_names(), "cost");
    if (!cost) return tl::unexpected(fmt::format("--require: {}", cost.error()));
    return Requirement{text, *error, *cost};
}

std::optional<double> cost_named(const Row& row, const std::string& name) {
    if (name == "time") return row.time().median;
    if (name == "instructions") return row.instructions;
    const auto found = row.counts.find(name);
    return found == row.counts.end() ? std::nullopt : std::optional(found->second);
}

Verdicts judge(const Experiment& e, const Questions& q) {
    Verdicts v;
    v.metric = q.metric;
    v.front = front_of(points_of(e, v.metric));
    const auto own = e.reference.own.find(v.metric);
    for (size_t i = 0; i < e.rows.size(); ++i) {
        if (!is_measured(e.rows[i])) v.front[i] = false;
        v.uncertain.push_back(own != e.reference.own.end() && e.rows[i].error(v.metric) <= own->second);
    }
    recommend(e, q, v);
    for (const Requirement& requirement : q.require) v.required.push_back(met(e, requirement));
    check_free_axes(e, v);
    return v;
}

}  // namespace alidade::tradeoff
