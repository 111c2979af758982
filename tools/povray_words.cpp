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

std::string trimmed(const std::string& text) {
    const size_t first = text.find_first_not_of(" \t\r"), last = text.find_last_not_of(" \t\r");
    return first == std::string::npos ? std::string() : text.substr(first, last - first + 1);
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
        const std::string wanted = row.apply(request, value);
        return wanted.empty() ? "" : fmt::format("'{}' has no value that {} can take: {}", word, row.key, wanted);
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
        const std::string value = closed(unquoted(word.substr(equals + 1)), word);
        if (key == "include_ini") return take_ini(value);
        for (const PovrayRow& row : povray_table()) {
            if (key != lower(row.key)) continue;
            const bool switched = row.apply == static_cast<ApplyPovrayWord>(file_switch);   // the key's value says on or off
            const auto on = truth(value);
            return apply(row, switched ? PovrayWord{"", on.value_or(true)} : PovrayWord{value, on.value_or(true)}, word);
        }
        return unknown(word);
    }

    void note(const std::string& sentence) { request.notes.push_back(where_ + sentence); }

    /// A quote that begins a value and is not closed is none of it, as in POV-Ray.
    std::string closed(const std::string& value, const std::string& word) {
        if (value.empty() || (value[0] != '"' && value[0] != '\'')) return value;
        note(fmt::format("'{}': the quote is not closed, and is left out", word));
        return value.substr(1);
    }

    /// An INI file, and which of its sections is asked for.
    struct IniFile {
        std::string path, wanted;
        std::vector<std::string> sections;   ///< that it has, as far as it is read
        bool in_wanted = true;               ///< what stands before all sections always holds
    };

    std::string take_ini(const std::string& word) {
        constexpr int kDeepest = 10;
        const size_t bracket = word.find('[');
        if (bracket != std::string::npos && word.find(']', bracket) == std::string::npos) return fmt::format("'{}' has no ] behind the section's name", word);
        std::string path = word.substr(0, bracket);
        const std::string wanted = bracket == std::string::npos ? "" : lower(word.substr(bracket + 1, word.find(']', bracket) - bracket - 1));
        if (!std::filesystem::is_regular_file(path) && std::filesystem::is_regular_file(path + ".ini")) path += ".ini";
        std::ifstream in(path);
        if (!std::filesystem::is_regular_file(path) || !in) return unknown(word) + ", and no INI file of that name can be read";
        if (++depth_ > kDeepest) return fmt::format("INI files include one another more than {} deep", kDeepest);
        IniFile file{path, wanted, {}};
        const std::string outside = where_;
        int number = 0;
        for (std::string line; std::getline(in, line);) {
            where_ = fmt::format("{}:{}: ", path, ++number);
            if (const std::string wrong = take_line(line, file); !wrong.empty()) return fmt::format("{}:{}: {}", path, number, wrong);
        }
        where_ = outside;
        --depth_;
        if (!wanted.empty() && std::find(file.sections.begin(), file.sections.end(), wanted) == file.sections.end())
            note(fmt::format("{} has no section [{}]; it has {}", path, wanted, file.sections.empty() ? "none" : fmt::format("[{}]", fmt::join(file.sections, "], ["))));
        return {};
    }

    /// `[section]`: what follows holds if it is asked for.
    std::string begin_section(const std::string& line, IniFile& file) {
        const size_t end = line.find(']');
        if (end == std::string::npos) note(fmt::format("'{}' has no ] behind the section's name", line));
        file.sections.push_back(lower(line.substr(1, end - 1)));
        file.in_wanted = file.sections.back().empty() || file.sections.back() == file.wanted;
        return end == std::string::npos ? "" : line.substr(end + 1);
    }

    /// `[section]`, `Key=Value`, or switches; `;` and `#` begin a comment where nothing is quoted. What stands before all sections always holds.
    std::string take_line(std::string line, IniFile& file) {
        line.resize(find_unquoted(line, ";#", 0));
        line = trimmed(line);
        while (!line.empty() && line[0] == '[') line = trimmed(begin_section(line, file));
        if (line.empty()) return {};
        if (!file.in_wanted) return {};
        if (line[0] != '+' && line[0] != '-') {
            const size_t equals = line.find('=');
            if (equals == std::string::npos) return take(unquoted(line));
            const std::string key = trimmed(line.substr(0, equals)), value = trimmed(line.substr(equals + 1));
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
        if (end < value.size()) note(fmt::format("'{}={}': what follows the value is left out, as POV-Ray does: one Key=Value a line", key, value));
        return end;
    }

    int depth_ = 0;
    std::string where_;   ///< file:line: of what is being read, or ""
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
