// SPDX-License-Identifier: Apache-2.0
#include "tools/tradeoff/axes.h"

#include "tools/option_words.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>

namespace alidade::tradeoff {
namespace {

void add_options(CLI::App& app, Request& request) {
    app.set_help_flag();
    add_scene_options(app, request);
    add_render_options(app, request);
    add_compile_options(app, request);
}

std::string plain_name(const CLI::Option& option) {
    if (!option.get_lnames().empty()) return option.get_lnames()[0];
    return option.get_snames().empty() ? "" : option.get_snames()[0];
}

std::set<std::string> option_names(void (*add)(CLI::App&, Request&)) {
    CLI::App app;
    Request request;
    add(app, request);
    std::set<std::string> names;
    for (const CLI::Option* option : app.get_options())
        if (const std::string name = plain_name(*option); !name.empty() && option != app.get_help_ptr()) names.insert(name);
    return names;
}

/// What may be given more than once.
bool is_repeatable(const std::string& name) { return name == "I" || name == "declare"; }

Value<std::vector<Setting>> too_many(const std::string& count) {
    return tl::unexpected(fmt::format("{} settings are more than {}; vary less, or take --mode one or --mode halton:N", count, kMostSettings));
}

Value<std::vector<Setting>> every_combination(std::span<const Axis> axes) {
    double count = 1;
    for (const Axis& axis : axes) count *= double(axis.values.size());
    if (count > double(kMostSettings)) return too_many(fmt::format("{:.6g}", count));
    std::vector<Setting> all{{}};
    for (const Axis& axis : axes) {
        std::vector<Setting> longer;
        for (const Setting& setting : all)
            for (const std::string& value : axis.values) longer.push_back(setting), longer.back().push_back({axis.name, value});
        all = std::move(longer);
    }
    return all;
}

Value<std::vector<Setting>> one_at_a_time(std::span<const Axis> axes) {
    std::vector<Setting> all;
    for (const Axis& axis : axes)
        for (const std::string& value : axis.values) all.push_back({{axis.name, value}});
    return all.size() > kMostSettings ? too_many(std::to_string(all.size())) : Value<std::vector<Setting>>(all);
}

/// The digits of `index` in base `prime`, mirrored at the point: in [0, 1).
double radical_inverse(uint64_t index, uint64_t prime) {
    double value = 0, digit = 1;
    for (; index > 0; index /= prime) value += double(index % prime) * (digit /= double(prime));
    return value;
}

std::vector<uint64_t> first_primes(size_t count) {
    std::vector<uint64_t> primes;
    for (uint64_t n = 2; primes.size() < count; ++n)
        if (std::none_of(primes.begin(), primes.end(), [n](uint64_t p) { return n % p == 0; })) primes.push_back(n);
    return primes;
}

Value<std::vector<Setting>> spread(std::span<const Axis> axes, size_t points) {
    if (points > kMostSettings) return too_many(std::to_string(points));
    const std::vector<uint64_t> primes = first_primes(axes.size());
    std::vector<Setting> all;
    for (uint64_t index = 1; all.size() < points && index <= 64 * points; ++index) {
        Setting setting;
        for (size_t i = 0; i < axes.size(); ++i) {
            const auto& values = axes[i].values;
            const auto at = size_t(radical_inverse(index, primes[i]) * double(values.size()));
            setting.push_back({axes[i].name, values[std::min(at, values.size() - 1)]});
        }
        if (std::find(all.begin(), all.end(), setting) == all.end()) all.push_back(std::move(setting));
    }
    return all;
}

}  // namespace

Value<Axis> parse_axis(const std::string& text) {
    const size_t equal = text.find('=');
    if (equal == 0 || equal == text.npos) return tl::unexpected(fmt::format("--vary: '{}' is not NAME=V1,V2,..., such as spp=1,4,16", text));
    Axis axis{text.substr(0, equal), {}};
    while (!axis.name.empty() && axis.name[0] == '-') axis.name.erase(0, 1);
    const std::string values = text.substr(equal + 1);
    for (std::string& value : split(values, values.find(';') == values.npos ? ',' : ';')) {
        if (value.empty()) return tl::unexpected(fmt::format("--vary: '{}' has an empty value", text));
        if (std::find(axis.values.begin(), axis.values.end(), value) != axis.values.end()) return tl::unexpected(fmt::format("--vary: '{}' has the value '{}' twice", text, value));
        axis.values.push_back(std::move(value));
    }
    return axis;
}

Value<Mode> parse_mode(const std::string& word) {
    if (word == "full") return Mode{};
    if (word == "one") return Mode{Mode::Kind::one, 0};
    if (word.starts_with("halton:"))
        if (const auto points = parse_integer(std::string_view(word).substr(7), 1, int64_t(kMostSettings))) return Mode{Mode::Kind::halton, size_t(*points)};
    return tl::unexpected(fmt::format("'{}' is not full, one or halton:N with N from 1 to {}", word, kMostSettings));
}

Value<std::vector<Setting>> expand(std::span<const Axis> axes, const Mode& mode) {
    if (mode.kind == Mode::Kind::one) return one_at_a_time(axes);
    return mode.kind == Mode::Kind::halton ? spread(axes, mode.points) : every_combination(axes);
}

Setting combined(const Setting& base, const Setting& setting) {
    Setting all;
    for (const Choice& choice : base) {
        const bool replaced = std::any_of(setting.begin(), setting.end(), [&](const Choice& other) { return other.name == choice.name; });
        if (!replaced || is_repeatable(choice.name)) all.push_back(choice);
    }
    all.insert(all.end(), setting.begin(), setting.end());
    return all;
}

Words as_words(const Setting& setting) {
    Words words;
    for (const Choice& choice : setting) words.push_back(choice.name.size() == 1 ? fmt::format("-{}{}", choice.name, choice.value) : fmt::format("--{}={}", choice.name, choice.value));
    return words;
}

std::string label(const Setting& setting) {
    std::string text;
    for (const Choice& choice : setting) text += fmt::format("{}{}={}", text.empty() ? "" : " ", choice.name, choice.value);
    return text.empty() ? "default" : text;
}

Value<Request> parse_request(const std::string& scene, const Setting& setting) {
    Request request;
    CLI::App app;
    add_options(app, request);
    Words words = as_words(setting);
    words.insert(words.begin(), scene);
    if (std::string sentence = why_not_parsed(app, words); !sentence.empty()) return tl::unexpected(std::move(sentence));
    request.import.frame.image_width = request.render.width, request.import.frame.image_height = request.render.height;
    request.import.frame.clock = request.time.value_or(0);
    return request;
}

Setting given_options(const CLI::App& app) {
    Setting given;
    for (const CLI::Option* option : app.get_options()) {
        const std::string name = plain_name(*option);
        if (!render_options().contains(name)) continue;
        for (const std::string& value : option->results()) given.push_back({name, value});
    }
    return given;
}

const std::set<std::string>& render_options() {
    static const std::set<std::string> names = option_names(add_options);
    return names;
}

const std::set<std::string>& reading_options() {
    static const std::set<std::string> names = option_names(add_scene_options);
    return names;
}

}  // namespace alidade::tradeoff
