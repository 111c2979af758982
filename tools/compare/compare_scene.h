// SPDX-License-Identifier: Apache-2.0
/// A scene rendered by two programs, and how far their pictures are apart.
#pragma once

#include "exporters/losses.h"
#include "tools/compare/grade.h"
#include "tools/compare/povray_reference.h"
#include "tools/diff/words.h"
#include "tools/load.h"

#include <memory>

namespace alidade {

struct SceneComparison {
    PovJob job;
    Comparison comparison;                      ///< its verdict is `error` where a picture is missing
    Graded graded;
    bool noisy = false;                         ///< the scene has random effects: area lights, a lens, grainy finishes, or what is not modelled and is random
    bool missing_program = false;
    std::vector<Loss> lost;                     ///< what the exporter could not write for POV-Ray
    std::optional<Rendered> reference, test;    ///< their pictures live as long as `scratch`
    std::shared_ptr<void> scratch;
};

/// A POV-Ray scene: both programs read the file.
SceneComparison compare_with_povray(const PovJob& job, const DiffRequest& request);
/// Any other scene: POV-Ray reads what our exporter makes of it. One sample at the centre of each pixel.
SceneComparison compare_exported(const Request& scene, const PovJob& job, const DiffRequest& request);

/// What `diff --json` tells, and the grade, the programs and what they cost.
Json to_json(const SceneComparison& compared);
std::string as_lines(const SceneComparison& compared);

}  // namespace alidade
