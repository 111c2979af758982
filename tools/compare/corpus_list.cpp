// SPDX-License-Identifier: Apache-2.0
/// Reads lists of scenes.
#include "tools/compare/corpus.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <map>

namespace alidade {

namespace fs = std::filesystem;

namespace {

using Row = std::map<std::string, std::string>;

constexpr int kMostPixels = 65535;   // a side

/// The cells of a line of CSV (RFC 4180, without line breaks inside of quotes).
std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells(1);
    bool quoted = false;
    for (size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (quoted && c == '"' && i + 1 < line.size() && line[i + 1] == '"') cells.back() += c, ++i;
        else if (c == '"') quoted = !quoted;
        else if (c == ',' && !quoted) cells.emplace_back();
        else if (c != '\r') cells.back() += c;
    }
    return cells;
}

std::vector<std::string> split(const std::string& text, char at) {
    std::vector<std::string> parts;
    for (size_t begin = 0; begin < text.size();) {
        const size_t end = std::min(text.find(at, begin), text.size());
        if (end > begin) parts.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

std::optional<double> number(const std::string& text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

/// Does the row keep a condition, COLUMN=VALUE, COLUMN<=NUMBER or COLUMN>=NUMBER?
tl::expected<bool, std::string> keeps(const Row& row, const std::string& condition) {
    const size_t sign = condition.find_first_of("<>=");
    if (sign == condition.npos || sign == 0) return tl::unexpected(fmt::format("'{}' is not COLUMN=VALUE, COLUMN<=NUMBER or COLUMN>=NUMBER", condition));
    const auto cell = row.find(condition.substr(0, sign));
    if (cell == row.end()) return tl::unexpected(fmt::format("the list has no column '{}'", condition.substr(0, sign)));
    if (condition[sign] == '=') return cell->second == condition.substr(sign + 1);
    const auto limit = condition[sign + 1] == '=' ? number(condition.substr(sign + 2)) : std::nullopt;
    if (!limit) return tl::unexpected(fmt::format("'{}' is not COLUMN=VALUE, COLUMN<=NUMBER or COLUMN>=NUMBER", condition));
    const auto value = number(cell->second);
    return value && (condition[sign] == '<' ? *value <= *limit : *value >= *limit);
}

/// An error is one sentence.
tl::expected<CorpusEntry, std::string> entry_of(const CorpusRequest& request, const fs::path& folder, Row& row) {
    CorpusEntry entry{request.defaults, row["path"], row["category"]};
    entry.job.scene = (folder / row["path"]).string();
    for (const auto& [column, target] : {std::pair("width", &entry.job.width), std::pair("height", &entry.job.height)})
        if (const std::string& cell = row[column]; !cell.empty()) {
            const auto value = number(cell);
            if (!value || !(*value >= 1 && *value <= kMostPixels)) return tl::unexpected(fmt::format("{}: the {} '{}' is not a number from 1 to {}", row["path"], column, cell, kMostPixels));
            *target = int(*value);
        }
    for (const std::string& word : split(row["frame_args"], ' ')) entry.job.words.push_back(word);
    for (const std::string& word : split(row["extra_library_dirs"], ';')) entry.job.words.push_back("+L" + word);
    return entry;
}

}  // namespace

tl::expected<std::vector<CorpusEntry>, std::string> read_corpus(const CorpusRequest& request) {
    std::ifstream file(request.list);
    if (!file) return tl::unexpected(fmt::format("cannot read {}", request.list));
    const fs::path folder = request.scenes.empty() ? fs::path(request.list).parent_path() : fs::path(request.scenes);
    std::vector<std::string> columns;
    std::vector<CorpusEntry> entries;
    for (std::string line; std::getline(file, line);) {
        if (columns.empty() && line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);   // UTF-8's mark, as spreadsheets write it
        const std::vector<std::string> cells = cells_of(line);
        if (std::all_of(cells.begin(), cells.end(), [](const std::string& cell) { return cell.empty(); }) || cells[0].starts_with('#')) continue;
        if (columns.empty() && std::find(cells.begin(), cells.end(), "path") != cells.end()) {
            columns = cells;
            continue;
        }
        if (columns.empty()) columns = {"path"};
        Row row;
        for (size_t i = 0; i < columns.size(); ++i) row[columns[i]] = i < cells.size() ? cells[i] : "";
        bool counts = !row.contains("status") || row["status"] == "ok";
        for (const std::string& condition : request.where) {
            const auto kept = keeps(row, condition);
            if (!kept) return tl::unexpected(kept.error());
            counts = counts && *kept;
        }
        if (!counts) continue;
        auto entry = entry_of(request, folder, row);
        if (!entry) return tl::unexpected(entry.error());
        entries.push_back(std::move(*entry));
    }
    if (entries.empty()) return tl::unexpected(fmt::format("{} lists no scene that counts", request.list));
    return entries;
}

}  // namespace alidade
