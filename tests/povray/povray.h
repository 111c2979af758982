// SPDX-License-Identifier: Apache-2.0
/// POV-Ray as the oracle: what it prints for expressions, and the table of what it printed once.
#pragma once

#include "core/vec.h"

#include <string>
#include <vector>

namespace alidade {

bool povray_is_installed();

/// What one run of povray prints with #debug for `scene`, to which a sphere is added. A failed expectation, with povray's words, if it refuses the scene.
std::string povray_debug(const std::string& scene);

/// The values of float expressions, printed with 17 digits after the point by one run of povray. `prelude` are statements before the first of them.
/// Empty, and a failed expectation, if povray refuses the scene.
std::vector<double> povray_values(const std::string& prelude, const std::vector<std::string>& expressions);

/// A vector as POV-Ray text that reads back as the same numbers.
std::string pov_text(const Vec3& p);

/// One row of pov-pattern-vectors.csv: what POV-Ray 3.7 printed with 15 digits.
struct PovVector {
    std::string kind, declaration;
    Vec3 point;
    double value;
};

/// All rows; none where the shared research is not at hand.
std::vector<PovVector> pov_vectors();

/// One row of pov-object-vectors.csv: what trace() found on a declared object. Where nothing was hit, `normal` is 0.
struct PovObjectVector {
    std::string declaration, label;
    Vec3 origin, dir, hit, normal;
};

/// All rows; none where the shared research is not at hand.
std::vector<PovObjectVector> pov_object_vectors();

}  // namespace alidade
