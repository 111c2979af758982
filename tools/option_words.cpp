// SPDX-License-Identifier: Apache-2.0
#include "tools/option_words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace alidade {

Value<size_t> one_of(const std::string& word, const std::vector<std::string>& names) {
    const auto at = std::find(names.begin(), names.end(), word);
    if (at != names.end()) return size_t(at - names.begin());
    const std::string near = nearest(word, names);
    return tl::unexpected(fmt::format("'{}' is not one of {}{}", word, fmt::join(names, ", "), near.empty() ? "" : fmt::format("; did you mean '{}'?", near)));
}

Value<std::vector<size_t>> list_of(const std::string& word, const std::vector<std::string>& names) {
    std::vector<size_t> chosen;
    for (const std::string& name : split(word, ',')) {
        const auto one = one_of(name, names);
        if (!one) return tl::unexpected(one.error());
        if (std::find(chosen.begin(), chosen.end(), *one) == chosen.end()) chosen.push_back(*one);
    }
    return chosen;
}

void group_options(CLI::App& app, const char* group) {
    for (CLI::Option* option : app.get_options())
        if (option->get_group() == "Options" && option != app.get_help_ptr()) option->group(group);
}

std::vector<std::string> split(std::string_view text, char separator) {
    std::vector<std::string> parts(1);
    for (const char c : text) {
        if (c == separator) parts.emplace_back();
        else parts.back() += c;
    }
    return parts;
}

}  // namespace alidade
