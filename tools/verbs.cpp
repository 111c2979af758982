// SPDX-License-Identifier: Apache-2.0
#include "tools/verbs.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <fmt/format.h>
#include <new>

namespace alidade {

namespace {

constexpr const char* kExits = "0 done, 1 error in input or run, 2 interrupted, 64 usage";

constexpr Verb kVerbs[] = {
    {"render", "render SCENE [-o FILE] [options]", "makes a picture of a scene", kExits, run_render},
    {"povray", "povray WORDS", "renders a POV-Ray scene as POV-Ray's own words ask", "as POV-Ray: 0 done, 1 error, also of an unknown word, 2 interrupted", run_povray},
    {"info", "info SCENE [options] | info --features", "tells what a scene holds and requires, or what the program can do", kExits, run_info},
    {"convert", "convert SCENE OUT [options]", "writes a scene in another format, and lists what that cannot hold", kExits, run_convert},
    {"diff", "diff REFERENCE TEST [options]", "tells how far a picture is from another, where, and whether that is good enough",
     "0 pass, 1 warn, 2 fail, 3 incomparable, 4 file or usage", run_diff, 4},
    {"compare", "compare SCENE | --corpus LIST --out DIR [options] [-- POV-Ray's words]", "renders with POV-Ray or Cycles too, and tells how far the pictures are apart",
     "as diff, the worst of a list; 2 also if a program made no picture; 4 also if the other program is missing", run_compare, 4},
    {"selftest", "selftest --numerics [ROW ...] [options]", "asks this machine for the program's numbers, and compares them with exact ones", "0 all goals are met, 1 some are not, 2 interrupted, 64 usage", run_selftest},
    {"tradeoff", "tradeoff SCENE --vary NAME=V1,V2,... [options]", "measures what accuracy costs: settings of a render, their errors and costs, and which of them are worth it",
     "0 done, 1 error in input or run, or an option changed a picture that it may not, 2 no setting meets a --require, or interrupted, 64 usage", run_tradeoff},
    {"stress", "stress SCENE | --generate KIND[:N][:SEED] [options]", "measures all accelerators side by side, on a scene of yours or on one that is made, and holds their hits against brute force",
     "0 done, 1 error in input or run, or hits that differ, 2 interrupted, 64 usage", run_stress},
};

std::string help() {
    std::string out = "alidade: reads a scene, renders it with the accelerator you choose, and measures what that cost\n\n";
    for (const Verb& verb : kVerbs) out += fmt::format("  alidade {:<40} {}\n", verb.usage, verb.doc);
    out += "\n  alidade VERB --help lists the verb's options; alidade --version tells the version\n";
    out += fmt::format("\nExit codes: {}.\n", kExits);
    return out;
}

int unknown_verb(const std::string& word) {
    std::vector<std::string> names;
    for (const Verb& verb : kVerbs) names.emplace_back(verb.name);
    const std::string near = nearest(word, names);
    const std::string hint = near.empty() ? "`alidade --help` lists the verbs" : fmt::format("did you mean '{}'?", near);
    fmt::print(stderr, "alidade: unknown verb '{}'; {}\n", word, hint);
    return kUsage;
}

/// Edits between two words, a swap of neighbours being one.
/// Source   the "optimal string alignment" distance: Boytsov, "Indexing methods for approximate dictionary searching", JEA 16 (2011), section 2.1.
size_t edits(std::string_view a, std::string_view b) {
    std::vector<size_t> before(b.size() + 1), above(b.size() + 1), row(b.size() + 1);
    for (size_t j = 0; j <= b.size(); ++j) above[j] = j;
    for (size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + size_t(a[i - 1] != b[j - 1])});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) row[j] = std::min(row[j], before[j - 2] + 1);
        }
        before.swap(above), above.swap(row);
    }
    return above[b.size()];
}

}  // namespace

std::span<const Verb> verbs() { return kVerbs; }

std::string nearest(std::string_view word, std::span<const std::string> candidates) {
    std::string best;
    size_t least = std::max<size_t>(1, word.size() / 3) + 1;
    for (const std::string& candidate : candidates) {
        const size_t n = edits(word, candidate);
        if (n < least) least = n, best = candidate;
    }
    return best;
}

int fail(const std::string& sentence) {
    fmt::print(stderr, "alidade: error: {}\n", sentence);
    return kError;
}

namespace {

/// What run_words does, without its care for what is thrown. `broken` becomes the verb's exit code for that.
int run_verb(const Words& words, int& broken) {
    if (words.empty()) {
        fmt::print(stderr, "{}", help());
        return kUsage;
    }
    if (words[0] == "--help" || words[0] == "-h") {
        fmt::print("{}", help());
        return kDone;
    }
    if (words[0] == "--version") {
        fmt::print("alidade {}\n", ALIDADE_VERSION);
        return kDone;
    }
    for (const Verb& verb : kVerbs)
        if (words[0] == verb.name) return broken = verb.broken, verb.run(verb, Words(words.begin() + 1, words.end()));
    return unknown_verb(words[0]);
}

}  // namespace

int run_words(const Words& words) {
    int broken = kError;
    std::string why;
    try {
        const int code = run_verb(words, broken);
        if (std::fflush(stdout) == 0 && !std::ferror(stdout)) return code;
    } catch (const std::bad_alloc&) {
        why = "out of memory";
    } catch (const std::exception& e) {
        why = e.what();
    }
    if (why.empty() || std::ferror(stdout)) why = "stdout cannot be written to";   // which fmt throws where the buffer was full
    std::fputs(("alidade: error: " + why + "\n").c_str(), stderr);
    return broken;
}

}  // namespace alidade
