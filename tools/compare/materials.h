// SPDX-License-Identifier: Apache-2.0
/// How far two pictures of a scene are apart where each of its materials is seen.
#pragma once

#include "exporters/losses.h"
#include "tools/diff/words.h"
#include "tools/json.h"

namespace alidade {

struct CompiledScene;

/// The pixels in whose middle a material is the first surface that is there.
struct ComparedMaterial {
    WrittenMaterial material;        ///< without losses: the file shows it as it is
    size_t pixels = 0;
    double flip = 0;                 ///< the mean
    double reference = 0, test = 0;  ///< mean luminance of what is displayed, linear

    /// How much brighter our picture is, as a part of the reference's luminance.
    double brighter() const { return reference > 0 ? test / reference - 1 : test > 0; }
    void add(double error, double of_reference, double of_test);
    void finish();   ///< from sums to means
};

/// Rows of the materials that are seen, in the exporter's order; and all that the file shows as they are, together.
struct ComparedMaterials {
    std::vector<ComparedMaterial> each;
    ComparedMaterial expressed;
};

/// None where the pictures are not of the size `width` x `height`, or were not measured.
std::optional<ComparedMaterials> compare_materials(const CompiledScene& scene, const std::vector<WrittenMaterial>& written, const Comparison& comparison, int width, int height);

/// Adds the keys `materials` and `expressed`.
void put_into(Json& document, const ComparedMaterials& materials);
std::string as_lines(const ComparedMaterials& materials);

}  // namespace alidade
