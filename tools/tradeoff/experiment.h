// SPDX-License-Identifier: Apache-2.0
/// What `tradeoff` is asked, and what it measures: settings to errors and costs.
#pragma once

#include "tools/progress.h"
#include "tools/store.h"
#include "tools/tradeoff/axes.h"
#include "tools/tradeoff/errors.h"
#include "tools/tradeoff/external.h"
#include "tools/tradeoff/renderer.h"
#include "tools/tradeoff/statistics.h"

#include <set>

namespace alidade::tradeoff {

struct Job {
    std::string scene;
    Setting base;                        ///< of every setting, where it is not varied
    std::vector<Axis> axes;
    Mode mode;
    std::vector<External> externals;
    std::string reference;               ///< "self", "self:SPP", "povray", "exact" (of an analytic scene), or a file; "": exact where there is one, else self
    Setting reference_with;              ///< options of the own reference, instead of the best that are varied
    int repeat = 5, seeds = 1;
    bool instructions = false;
    std::string out;                     ///< the folder of what is measured; "" for none
    double timeout = 600;                ///< seconds that another program has
    ProgressMode progress = ProgressMode::bar;
};

/// Of pictures of several seeds, linear: the mean squared error is bias^2 + variance.
struct Noise {
    double bias2 = 0;      ///< may be below 0 by chance, where there is no bias
    double variance = 0;
};

/// One setting of ours, or one command of another program, and what is known of it.
struct Row {
    Setting setting;                     ///< what is varied of it
    bool is_default = false;             ///< nothing is
    int external = -1;                   ///< of Job::externals; -1: ours
    Setting options;                     ///< ours: all of them
    Request request;
    std::string command;                 ///< as a shell takes it

    Errors errors;
    std::map<std::string, double> counts;   ///< rays, boxes, ...; ours alone
    std::optional<Noise> noise;          ///< with seeds
    size_t non_finite = 0;               ///< pixels that are no numbers: it is in no front
    uint64_t fingerprint = 0;            ///< of the picture
    std::string thumbnail, flip;         ///< PNG in base64
    std::vector<double> seconds, build_seconds;   ///< CPU; one a round: building and rendering, and building alone
    std::optional<double> instructions;

    std::string name(const Job& job) const;
    Cost time() const { return cost_of(seconds); }
    double error(const std::string& column) const;
};

struct Reference {
    std::string what;                    ///< one sentence
    Picture picture;                     ///< R G B, linear
    Errors own;                          ///< its own error, as far as it is known
    bool display = false;                ///< made of display values
};

struct Experiment {
    Job job;
    std::vector<Row> rows;               ///< the default first, if it is none of the settings
    Reference reference;
    bool clip = false;                   ///< values are cut off at 0 and 1, what files of 8 bits can hold
    std::vector<std::string> warnings;
    std::set<size_t> unrepeatable;       ///< rows whose next run made another picture, which is a bug
    /// rows_of() leaves one whatever is varied.
    const Row& default_row() const;
};

/// The settings, each one checked by the parser: an error is a usage error.
Value<std::vector<Row>> rows_of(const Job& job);

/// Renders, measures, and times in rounds of random order. An error is one sentence, or "" if it was said.
Value<Experiment> run_experiment(const Job& job, std::vector<Row> rows);

/// The reference picture of a job; what it costs is not measured.
Value<Reference> make_reference(const Job& job, const std::vector<Row>& rows, Renderer& renderer, Store& store, bool clip);
/// No reference is named, and the scene has no exact one.
bool is_usual_reference(const Job& job);
bool is_reference_file(const Job& job);
/// Which reference it is, in a word or two, before anything is rendered: an error is a usage error.
Value<std::string> reference_name(const Job& job, const std::vector<Row>& rows);

/// Stands for what decides how a scene is read.
std::string reading_of(const Setting& options);

}  // namespace alidade::tradeoff
