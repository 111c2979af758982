// SPDX-License-Identifier: Apache-2.0
#include "tools/compare/corpus.h"

#include "core/fingerprint.h"
#include "core/parallel.h"
#include "tools/compare/povray_reference.h"
#include "tools/compare/program.h"
#include "tools/progress.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <mutex>

namespace alidade {

namespace fs = std::filesystem;

namespace {

/// One row of a list: the same scene may stand there in two sizes, or with other words.
std::string row_id(const CorpusEntry& entry) { return fmt::format("{} {}x{} {}", entry.name, entry.job.width, entry.job.height, fmt::join(entry.job.words, " ")); }

/// "advanced__abyss.pov-01234567.png": a row's picture in the folder of results.
std::string picture_name(const CorpusEntry& entry, const char* ending) {
    std::string plain = entry.name;
    for (size_t at; (at = plain.find('/')) != plain.npos;) plain.replace(at, 1, "__");
    return fmt::format("{}-{:08x}{}", plain, uint32_t(fingerprint(row_id(entry))), ending);
}

/// Results of an earlier run, by row.
std::map<std::string, Json> earlier_results(const std::string& path) {
    std::map<std::string, Json> results;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        Json row = Json::parse(line, nullptr, false);   // a line that was cut short by a kill is none
        const auto is_text = [&](const char* key) { return row.is_object() && row.contains(key) && row[key].is_string(); };
        if (!is_text("row") || !is_text("key") || !is_text("verdict")) continue;
        const std::string id = row["row"].get<std::string>();
        results[id] = std::move(row);
    }
    return results;
}

/// Does the last line lack its end, as a kill leaves it?
bool is_cut_short(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return file.seekg(-1, std::ios::end) && file.get() != '\n';
}

/// Stands for the scene, both programs (ours: `program`) and the words.
std::string key_of(const CorpusEntry& entry, uint64_t program, const std::string& words) {
    const auto reference = reference_key(entry.job);
    return fmt::format("{:016x}-{}", fingerprint(words, program), reference ? *reference : reference.error());
}

class Run {
  public:
    Run(const CorpusRequest& request, const std::vector<CorpusEntry>& entries)
        : request_(request), entries_(entries), results_(entries.size()), earlier_(earlier_results(results_path())), progress_(ProgressMode::bar, stderr),
          log_(results_path(), std::ios::app) {
        if (is_cut_short(results_path())) log_ << "\n";
        const auto program = read_file(own_program());
        program_ = program ? fingerprint(std::span(*program)) : 0;
    }

    std::vector<CorpusResult> all() {
        parallel_for(entries_.size(), request_.jobs, [this](size_t i) { one(i); });
        return std::move(results_);
    }

  private:
    std::string results_path() const { return request_.out + "/results.jsonl"; }

    void one(size_t i) {
        const CorpusEntry& entry = entries_[i];
        const std::string key = key_of(entry, program_, request_.words);
        const auto before = earlier_.find(row_id(entry));
        const bool kept = before != earlier_.end() && before->second["key"] == key && is_whole(before->second);
        CorpusResult result{entry, kept ? before->second : compared(entry, key), kept};
        const std::scoped_lock lock(mutex_);
        if (!kept) log_ << result.document.dump(-1, ' ', false, Json::error_handler_t::replace) << "\n" << std::flush;
        results_[i] = std::move(result);
        progress_.update(++done_, entries_.size());
    }

    /// What made no picture is tried again, and what has lost one.
    bool is_whole(const Json& document) const {
        const auto there = [&](const char* key) { return document.contains(key) && document[key].is_string() && fs::exists(fs::path(request_.out) / document[key].get<std::string>()); };
        return document["verdict"] != "error" && there("test_picture") && there("reference_picture");
    }

    Json compared(const CorpusEntry& entry, const std::string& key) const {
        DiffRequest diff = request_.diff;
        diff.pair.threads = 1;
        const SceneComparison scene = compare_scene(request_.reading, entry.job, diff);
        Json out = to_json(scene);
        out["name"] = entry.name, out["group"] = entry.group, out["row"] = row_id(entry), out["key"] = key;
        if (!scene.test || !scene.reference) return out;
        const std::string name = picture_name(entry, entry.job.against->ending);
        if (keep(scene.test->picture, name)) out["test_picture"] = name;
        if (keep(scene.reference->picture, "reference__" + name)) out["reference_picture"] = "reference__" + name;
        return out;
    }

    bool keep(const std::string& picture, const std::string& name) const {
        const auto bytes = read_file(picture);
        return bytes && write_file(request_.out + "/" + name, *bytes);
    }

    const CorpusRequest& request_;
    const std::vector<CorpusEntry>& entries_;
    std::vector<CorpusResult> results_;
    std::map<std::string, Json> earlier_;
    Progress progress_;
    std::ofstream log_;
    std::mutex mutex_;
    size_t done_ = 0;
    uint64_t program_ = 0;
};

}  // namespace

std::vector<CorpusResult> compare_corpus(const CorpusRequest& request, const std::vector<CorpusEntry>& entries) { return Run(request, entries).all(); }

std::string corpus_table(const std::vector<CorpusResult>& results) {
    constexpr std::array<const char*, 5> kGrades = {"exact", "match", "close", "off", "error"};
    std::map<std::string, std::array<size_t, kGrades.size()>> groups;
    std::array<size_t, kGrades.size()> sum{};
    size_t width = 5;
    for (const CorpusResult& result : results) {
        const std::string grade = result.document["grade"]["name"].get<std::string>();
        const size_t at = size_t(std::find(kGrades.begin(), kGrades.end(), grade) - kGrades.begin());
        if (at == kGrades.size()) continue;
        ++groups[result.entry.group][at], ++sum[at];
        width = std::max(width, result.entry.group.size());
    }
    std::string out = fmt::format("{:<{}} {:>6} {:>6} {:>6} {:>6} {:>6}\n", "group", width, kGrades[0], kGrades[1], kGrades[2], kGrades[3], kGrades[4]);
    const auto line = [&](const std::string& name, const std::array<size_t, kGrades.size()>& n) {
        out += fmt::format("{:<{}} {:>6} {:>6} {:>6} {:>6} {:>6}\n", name, width, n[0], n[1], n[2], n[3], n[4]);
    };
    for (const auto& [group, counts] : groups) line(group.empty() ? "-" : group, counts);
    line("all", sum);
    return out;
}

}  // namespace alidade
