// SPDX-License-Identifier: Apache-2.0
/// A list of scenes, compared one by one into one table and one report.
#pragma once

#include "tools/compare/compare_scene.h"

#include <nlohmann/json.hpp>

namespace alidade {

struct CorpusRequest {
    std::string list;              ///< a CSV file with a column `path`, or one path a line
    std::string scenes;            ///< the folder that paths are relative to; "": the list's
    std::vector<std::string> where;///< "tier<=3", "category=lights": rows that count
    std::string out;               ///< the folder of results.jsonl, pictures and report.html
    int jobs = 1;
    CompareJob defaults;
    Request reading;               ///< how scenes are read that go through an exporter
    std::string words;             ///< stands for what was asked for: results of other words are not taken
    DiffRequest diff;
};

struct CorpusEntry {
    CompareJob job;
    std::string name, group;
};

/// Rows of the list that count. Columns that are understood: path, status (rows other than "ok" are left out), width, height, frame_args (words for both
/// programs), extra_library_dirs (separated by ";"), category (a group of the report). An error is one sentence.
tl::expected<std::vector<CorpusEntry>, std::string> read_corpus(const CorpusRequest& request);

/// One scene's outcome, as results.jsonl keeps it.
struct CorpusResult {
    CorpusEntry entry;
    Json document;       ///< to_json(SceneComparison), and `key`
    bool kept = false;   ///< taken from an earlier run: neither the scene nor a program has changed
};

/// Compares every entry, `jobs` at a time. Results are appended as they come, so that a run that was interrupted goes on; a scene that failed is one row.
std::vector<CorpusResult> compare_corpus(const CorpusRequest& request, const std::vector<CorpusEntry>& entries);

/// Scenes by group and grade, and the sum.
std::string corpus_table(const std::vector<CorpusResult>& results);

}  // namespace alidade
