// SPDX-License-Identifier: Apache-2.0
/// How near a picture is to another renderer's of the same scene, in one word.
#pragma once

#include "tools/metrics/metric.h"

namespace alidade {

/// From the best on. `error`: there is no picture to grade.
enum class Grade { exact, match, close, off, error };
const char* name_of(Grade grade);

struct Graded {
    Grade grade = Grade::error;
    double rmse = 0;       ///< of display values; where `noisy`, after 4 x 4 pixels were averaged
    double over2 = 0;      ///< share of pixels that differ by more than 2/255
    double envelope = 0;   ///< share of pixels more than 8/255 outside the reference's 3x3 range
};

/// exact: over2 <= 0.5 %. match: rmse <= 0.02 and envelope <= 1 %; where the scene has random effects (`noisy`) rmse <= 0.03. close: rmse <= 0.06.
/// Display values; alpha plays no part.
Graded grade(const PicturePair& pair, bool noisy);

}  // namespace alidade
