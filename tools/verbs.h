// SPDX-License-Identifier: Apache-2.0
/// The verbs of the command line: a visible table. A verb is one file and one row.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace alidade {

/// What the process returns; a verb that needs other numbers says so in its row.
enum ExitCode { kDone = 0, kError = 1, kInterrupted = 2, kUsage = 64 };

using Words = std::vector<std::string>;

struct Verb {
    const char* name;
    const char* usage;   ///< the words after the program's name
    const char* doc;
    const char* exits;   ///< what its exit codes mean
    int (*run)(const Verb& verb, const Words& words);   ///< `words` are those after the verb
    int broken = kError;   ///< exit code where memory ends, or what was printed could not be written
};

std::span<const Verb> verbs();

/// The candidate that `word` is most likely a slip of, or "" if none is near: at most one edit (insertion, removal, replacement or swap of
/// neighbours) for every three letters, and at least one.
std::string nearest(std::string_view word, std::span<const std::string> candidates);

/// Runs the verb that `words` (without the program's name) begin with; also --help and --version. Throws nothing.
int run_words(const Words& words);

/// Says the sentence as an error, and returns kError.
int fail(const std::string& sentence);

// The rows' functions, one a file.
int run_render(const Verb& verb, const Words& words);
int run_info(const Verb& verb, const Words& words);
int run_povray(const Verb& verb, const Words& words);
int run_convert(const Verb& verb, const Words& words);
int run_diff(const Verb& verb, const Words& words);
int run_compare(const Verb& verb, const Words& words);
int run_selftest(const Verb& verb, const Words& words);
int run_tradeoff(const Verb& verb, const Words& words);
int run_stress(const Verb& verb, const Words& words);

}  // namespace alidade
