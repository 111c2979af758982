// SPDX-License-Identifier: Apache-2.0
/// The words that `diff` and `compare` share, and what they do with two pictures.
#pragma once

#include "tools/diff/document.h"
#include "tools/verbs.h"

namespace CLI {
class App;
}

namespace alidade {

/// What a user asks of a pair of pictures.
struct DiffRequest {
    PairOptions pair;
    Rules rules;
    bool align = false, json = false;
    std::string junit, heatmap, report;
    std::vector<std::string> commands;   ///< as the report shows them
};

/// --fail, --warn and their kin, --require, --preset.
void add_rule_words(CLI::App& app, Rules& rules);
/// What is compared: --mask, --crop, --layer, --align, --threads.
void add_pair_words(CLI::App& app, DiffRequest& request);
/// What is left: --json, --junit, --heatmap, --report.
void add_output_words(CLI::App& app, DiffRequest& request);
/// Sets `rules` to the preset of this name if the user gave no rule.
void set_default_rules(Rules& rules, const std::string& preset);

/// Words with one dash, as idiff's users write them, with two.
Words with_two_dashes(const CLI::App& app, const Words& given);
/// Why one of the files that were asked for cannot be written, or "".
std::string why_not_writable(const DiffRequest& request);
/// Why one of them would destroy a file that is read (`taken`) or another of them, or "".
std::string why_overwritten(const DiffRequest& request, std::vector<std::string> taken);

/// Reads, measures, judges.
Comparison compare_files(const std::string& reference, const std::string& test, const DiffRequest& request);
/// Writes the files that were asked for.
tl::expected<void, std::string> write_files(const Comparison& comparison, const DiffRequest& request);

}  // namespace alidade
