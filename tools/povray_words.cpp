// SPDX-License-Identifier: Apache-2.0
#include "tools/povray_words.h"

#include "tools/povray_table.h"
#include "tools/values.h"
#include "tools/verbs.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <limits>
#include <string_view>

namespace alidade {

namespace {

std::string unknown(const std::string& word) {
    std::vector<std::string> known;
    for (const PovrayRow& row : povray_table()) known.push_back(lower(row.key));
    std::string near = nearest(lower(word.substr(0, word.find('='))), known);
    for (const PovrayRow& row : povray_table())
        if (!near.empty() && near == lower(row.key)) near = row.key;
    return fmt::format("'{}' is no word of POV-Ray{}", word, near.empty() ? "" : fmt::format("; did you mean '{}='?", near));
}

constexpr std::string_view kSeed = "--seed=", kAllowWrite = "--allow-write=", kLimit = "--limit=";   // ours alone

std::string unquoted(const std::string& text) {
    return text.size() > 1 && (text[0] == '"' || text[0] == '\'') && text.back() == text[0] ? text.substr(1, text.size() - 2) : text;
}

/// Where one of `marks` stands outside of quotes, from `at` on; the end if none does. A quote that is not closed belongs to a name.
size_t find_unquoted(const std::string& line, std::string_view marks, size_t at) {
    for (char quote = 0; at < line.size(); ++at) {
        const char c = line[at];
        if (quote == 0 && marks.find(c) != std::string_view::npos) return at;
        if (c == quote) quote = 0;
        else if (quote == 0 && (c == '"' || c == '\'') && line.find(c, at + 1) != std::string::npos) quote = c;
    }
    return at;
}

/// One command line, with the INI files that it names.
class Reading {
  public:
    std::string take(const std::string& word) {
        if (word.empty()) return {};
        if (word.rfind(kSeed, 0) == 0) return take_seed(word);
        if (word.rfind(kAllowWrite, 0) == 0 && word.size() > kAllowWrite.size()) return request.write_folder = word.substr(kAllowWrite.size()), std::string();
        if (word.rfind(kLimit, 0) == 0) return pov::set_limit(request.limits, std::string_view(word).substr(kLimit.size()));
        if (word[0] == '+' || word[0] == '-') return take_switch(word);
        const size_t equals = word.find('=');
        if (equals != std::string::npos) return take_key(word, equals);
        const std::string name = lower(word.substr(0, word.find('[')));
        if (std::filesystem::path(name).extension() == ".pov") return request.input = word, std::string();
        return take_ini(word);
    }

    /// What holds before all words.
    std::string take_defaults() {
        namespace fs = std::filesystem;
        const char *named = std::getenv("POVINI"), *home = std::getenv("HOME");
        std::vector<fs::path> places;
        if (named) places.emplace_back(named);
        places.emplace_back("povray.ini");
        if (home) places.push_back(fs::path(home) / ".povray/3.7/povray.ini");
        places.emplace_back("/etc/povray/3.7/povray.ini");
        for (const fs::path& place : places)
            if (fs::is_regular_file(place)) return take_ini(place.string());
        return {};
    }

    PovrayRequest request;

  private:
    std::string apply(const PovrayRow& row, const PovrayWord& value, const std::string& word) {
        if (row.apply(request, value)) return {};
        return fmt::format("'{}' has no value that {} can take", word, row.key);
    }

    std::string take_seed(const std::string& word) {
        const auto seed = parse_integer(word.substr(kSeed.size()), 0, std::numeric_limits<int64_t>::max());
        return seed ? (request.seed = uint64_t(*seed), std::string()) : fmt::format("'{}': {}", word, seed.error());
    }

    /// The row whose letters are the longest beginning of the word.
    std::string take_switch(const std::string& word) {
        const std::string text = lower(word.substr(1));
        const PovrayRow* best = nullptr;
        size_t length = 0;
        for (const PovrayRow& row : povray_table()) {
            const std::string letters = lower(row.letters);
            if (letters.size() > length && text.rfind(letters, 0) == 0) best = &row, length = letters.size();
        }
        if (!best) return unknown(word);
        return apply(*best, {unquoted(word.substr(1 + length)), word[0] == '+'}, word);
    }

    std::string take_key(const std::string& word, size_t equals) {
        const std::string key = lower(word.substr(0, equals));
        const std::string value = unquoted(word.substr(equals + 1));
        if (key == "include_ini") return take_ini(value);
        for (const PovrayRow& row : povray_table()) {
            if (key != lower(row.key)) continue;
            const bool switched = row.apply == static_cast<ApplyPovrayWord>(file_switch);   // the key's value says on or off
            const auto on = truth(value);
            return apply(row, switched ? PovrayWord{"", on.value_or(true)} : PovrayWord{value, on.value_or(true)}, word);
        }
        return unknown(word);
    }

    std::string take_ini(const std::string& word) {
        constexpr int kDeepest = 10;
        const size_t bracket = word.find('[');
        std::string path = word.substr(0, bracket);
        const std::string wanted = bracket == std::string::npos ? "" : lower(word.substr(bracket + 1, word.find(']', bracket) - bracket - 1));
        if (!std::filesystem::is_regular_file(path) && std::filesystem::is_regular_file(path + ".ini")) path += ".ini";
        std::ifstream in(path);
        if (!std::filesystem::is_regular_file(path) || !in) return unknown(word) + ", and no INI file of that name can be read";
        if (++depth_ > kDeepest) return fmt::format("INI files include one another more than {} deep", kDeepest);
        std::string section;
        for (std::string line; std::getline(in, line);) {
            if (const std::string wrong = take_line(line, section, wanted); !wrong.empty()) return fmt::format("{}: {}", path, wrong);
        }
        --depth_;
        return {};
    }

    /// `[section]`, `Key=Value`, or switches; `;` and `#` begin a comment where nothing is quoted. What stands before all sections always holds.
    std::string take_line(std::string line, std::string& section, const std::string& wanted) {
        line.resize(find_unquoted(line, ";#", 0));
        const size_t first = line.find_first_not_of(" \t\r"), last = line.find_last_not_of(" \t\r");
        if (first == std::string::npos) return {};
        line = line.substr(first, last - first + 1);
        if (line[0] == '[') return section = lower(line.substr(1, line.find(']') - 1)), std::string();
        if (!section.empty() && section != wanted) return {};
        if (line[0] != '+' && line[0] != '-') {
            const size_t equals = line.find('=');
            if (equals == std::string::npos) return take(unquoted(line));
            const auto trim = [](std::string s) {
                const size_t a = s.find_first_not_of(" \t"), b = s.find_last_not_of(" \t");
                return a == std::string::npos ? std::string() : s.substr(a, b - a + 1);
            };
            const std::string key = trim(line.substr(0, equals)), value = trim(line.substr(equals + 1));
            return take(key + "=" + value.substr(0, length_of_value(key, value)));
        }
        for (size_t at = 0; at < line.size();) {
            const size_t end = find_unquoted(line, " \t", at);
            if (end > at)
                if (const std::string wrong = take(line.substr(at, end - at)); !wrong.empty()) return wrong;
            at = end + 1;
        }
        return {};
    }

    /// Where a blank, a sign and a letter stand in a name: ` - b` and ` -2` are parts of it.
    static size_t begin_of_switch(const std::string& name) {
        for (size_t i = 0; i + 2 < name.size(); ++i)
            if (name[i] == ' ' && (name[i + 1] == '+' || name[i + 1] == '-') && std::isalpha(static_cast<unsigned char>(name[i + 2]))) return i;
        return std::string::npos;
    }

    /// POV-Ray reads one Key=Value a line: to the end of what is quoted, to a switch behind a blank if it is a name, or to a blank. What follows is told.
    size_t length_of_value(const std::string& key, const std::string& value) {
        const bool quoted = !value.empty() && (value[0] == '"' || value[0] == '\'');
        const auto table = povray_table();
        const bool name = lower(key) == "include_ini" || std::any_of(table.begin(), table.end(), [&](const PovrayRow& row) { return lower(row.key) == lower(key) && takes_name(row); });
        size_t end = quoted ? value.find(value[0], 1) : name ? begin_of_switch(value) : value.find_first_of(" \t");
        if (end == std::string::npos) return end;
        end += quoted;
        if (end < value.size()) request.notes.push_back(fmt::format("'{}={}': what follows the value is left out, as POV-Ray does: one Key=Value a line", key, value));
        return end;
    }

    int depth_ = 0;
};

}  // namespace

tl::expected<PovrayRequest, std::string> parse_povray_words(const std::vector<std::string>& words) {
    Reading reading;
    if (std::string wrong = reading.take_defaults(); !wrong.empty()) return tl::unexpected(std::move(wrong));
    for (const std::string& word : words)
        if (std::string wrong = reading.take(word); !wrong.empty()) return tl::unexpected(std::move(wrong));
    if (reading.request.input.empty()) return tl::unexpected(std::string("no scene is named: +Iscene.pov"));
    reading.request.final_frame = std::max(reading.request.initial_frame, reading.request.final_frame);
    return std::move(reading.request);
}

}  // namespace alidade
