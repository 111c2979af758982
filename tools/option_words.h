// SPDX-License-Identifier: Apache-2.0
/// What options are made of: words that go through a parser, names of tables' rows, groups in the help.
#pragma once

#include "tools/values.h"
#include "tools/verbs.h"

#include <CLI/CLI.hpp>

namespace alidade {

/// An option whose word goes through `parse` (tools/values.h) to `store`.
template <class Parse, class Store> CLI::Option* add(CLI::App& app, const char* option, const char* kind, Parse parse, Store store, const std::string& doc) {
    const auto take = [option, parse, store](const std::string& word) {
        const auto value = parse(word);
        if (!value) throw CLI::ValidationError(option, value.error());
        store(*value);
    };
    return app.add_option_function<std::string>(option, take, doc)->type_name(kind);
}

template <class T> void add_integer(CLI::App& app, const char* option, T& target, int64_t low, int64_t high, const std::string& doc) {
    add(app, option, "N", [low, high](const std::string& word) { return parse_integer(word, low, high); }, [&target](int64_t n) { target = T(n); }, doc);
}

template <class Store> void add_number(CLI::App& app, const char* option, const char* kind, double low, Store store, const std::string& doc, double high = kInf) {
    add(app, option, kind, [low, high](const std::string& word) { return parse_number(word, low, high); }, store, doc);
}

template <class Rows> std::vector<std::string> names_of(const Rows& rows) {
    std::vector<std::string> names;
    for (const auto& row : rows) names.emplace_back(row.name);
    return names;
}

/// The place of a word among `names`; the error says which names there are.
Value<size_t> one_of(const std::string& word, const std::vector<std::string>& names);
/// Of names with commas between them, each once.
Value<std::vector<size_t>> list_of(const std::string& word, const std::vector<std::string>& names);

/// Options that no group has yet go to `group`, in the help.
void group_options(CLI::App& app, const char* group);

/// What stands between separators; the empty word between two is one, too.
std::vector<std::string> split(std::string_view text, char separator);

}  // namespace alidade
