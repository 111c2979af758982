// SPDX-License-Identifier: Apache-2.0
/// A scene rendered by two programs, and how far their pictures are apart.
#pragma once

#include "exporters/losses.h"
#include "tools/compare/grade.h"
#include "tools/compare/materials.h"
#include "tools/compare/seeds.h"
#include "tools/diff/words.h"
#include "tools/load.h"
#include "tools/report/report.h"

#include <memory>

namespace alidade {

struct SceneComparison {
    CompareJob job;
    Comparison comparison;                      ///< its verdict is `error` where a picture is missing
    Graded graded;
    bool noisy = false;                         ///< the scene has random effects: area lights, a lens, grainy finishes, or what is not modelled and is random
    bool missing_program = false;
    std::optional<SeedComparison> seeds;        ///< if job.seeds are more than one
    std::optional<ReportObjects> objects;       ///< if job.objects; of the pixels that are compared
    std::vector<Loss> lost;                     ///< what the exporter could not write for the reference program
    std::optional<ComparedMaterials> materials; ///< of what was exported to a format that tells
    std::optional<Rendered> reference, test;    ///< their pictures live as long as `scratch`
    std::shared_ptr<void> scratch;
};

/// Beside POV-Ray, its own scenes are read by both programs. Else the reference program reads what our exporter makes of the scene as `reading` has it
/// (its own name of a scene plays no part: job.scene is the scene).
SceneComparison compare_scene(const Request& reading, const CompareJob& job, const DiffRequest& request);

/// By its ending, in any case of letters.
bool is_povray_scene(const std::string& path);
/// Of the verb: the verdict's, but a program that made no picture fails; one that is not there is an error of the machine.
int exit_code(const SceneComparison& compared);

/// What `diff --json` tells, and the grade, the programs and what they cost.
Json to_json(const SceneComparison& compared);
std::string as_lines(const SceneComparison& compared);

}  // namespace alidade
