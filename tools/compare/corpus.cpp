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

/// "advanced__abyss.pov.png": a scene's picture in the folder of results.
std::string picture_name(const std::string& name, const char* ending) {
    std::string plain = name;
    for (size_t at; (at = plain.find('/')) != plain.npos;) plain.replace(at, 1, "__");
    return plain + ending;
}

/// Results of an earlier run, by scene.
std::map<std::string, Json> earlier_results(const std::string& path) {
    std::map<std::string, Json> results;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        Json row = Json::parse(line, nullptr, false);   // a line that was cut short by a kill is none
        if (!row.is_object() || !row.contains("name") || !row.contains("key")) continue;
        const std::string name = row["name"].get<std::string>();
        results[name] = std::move(row);
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
        const auto before = earlier_.find(entry.name);
        const bool kept = before != earlier_.end() && before->second["key"] == key;
        CorpusResult result{entry, kept ? before->second : compared(entry, key), kept};
        const std::scoped_lock lock(mutex_);
        if (!kept) log_ << result.document.dump(-1, ' ', false, Json::error_handler_t::replace) << "\n" << std::flush;
        results_[i] = std::move(result);
        progress_.update(++done_, entries_.size());
    }

    Json compared(const CorpusEntry& entry, const std::string& key) const {
        DiffRequest diff = request_.diff;
        diff.pair.threads = 1;
        const SceneComparison scene = compare_scene(request_.reading, entry.job, diff);
        Json out = to_json(scene);
        out["name"] = entry.name, out["group"] = entry.group, out["key"] = key;
        if (!scene.test) return out;
        const auto bytes = read_file(scene.test->picture);
        const std::string name = picture_name(entry.name, entry.job.against->ending);
        if (bytes && write_file(request_.out + "/" + name, *bytes)) out["test_picture"] = name;
        if (scene.reference) out["reference_picture"] = kept_reference(scene, name);
        return out;
    }

    /// The reference lies in the cache; if that could not be written it is kept here.
    std::string kept_reference(const SceneComparison& scene, const std::string& name) const {
        if (scene.reference->from_cache) return scene.reference->picture;
        const std::string there = "reference__" + name;
        const auto bytes = read_file(scene.reference->picture);
        return bytes && write_file(request_.out + "/" + there, *bytes) ? there : "";
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
