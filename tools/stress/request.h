// SPDX-License-Identifier: Apache-2.0
/// What a user asks of `alidade stress`.
#pragma once

#include "stress/ray_file.h"
#include "stress/run.h"
#include "tools/options.h"
#include "tools/progress.h"
#include "tools/values.h"

namespace alidade {

/// Scenes of one kind, of one size or several, or the scene of a file.
struct StressSource {
    std::string name;                  ///< of the kind, or the file
    const StressKind* kind = nullptr;  ///< null: a file
    std::vector<size_t> sizes;         ///< triangles, rising; of a file one 0
    uint64_t seed = 1;                 ///< of the scene and its rays
};

/// KIND, KIND:N, KIND:LOW..HIGH, each with :SEED behind it. `growth`: where no number is given, LOW and HIGH are 1e3 and 1e7.
Value<StressSource> parse_source(const std::string& word, bool growth);
/// Two sizes a decade from `low` to `high`, both with them.
std::vector<size_t> sizes_between(size_t low, size_t high);

struct StressRequest {
    Request scene;                          ///< the file and how it is read, where one is given
    std::vector<StressSource> sources;
    std::vector<const AcceleratorEntry*> accelerators;
    std::vector<Precision> precisions;
    std::vector<Intersect> tests{Intersect::exact};
    bool embree = false, growth = false;
    size_t side = 128;                      ///< primary rays are side x side
    int rounds = 5, threads = 1;            ///< threads: of the builds
    std::optional<double> seconds, bytes;   ///< budgets; without the second, 8/10 of what the system has available
    std::string rays, dump_rays, trees, csv, json, report;
    bool prints_json = false;   ///< instead of tables
    RayNumbers dump_numbers = RayNumbers::float32;
    ProgressMode progress = ProgressMode::bar;
    Words words;                            ///< as they were given
};

/// The request, or the exit code that ends the verb.
tl::expected<StressRequest, int> parse_stress_words(const Verb& verb, const Words& given);

}  // namespace alidade
