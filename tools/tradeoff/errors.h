// SPDX-License-Identifier: Apache-2.0
/// How far a setting's picture is from the reference, by the metrics' registry.
#pragma once

#include "core/image.h"
#include "tools/values.h"

#include <map>
#include <span>

namespace alidade::tradeoff {

/// A number of a metric: a visible table. Its name is what --metric and --require take.
struct ErrorColumn {
    const char* name;
    const char* metric;
    const char* number;
    bool display;      ///< of display values (sRGB-encoded, 0 .. 1); else of linear ones
    bool is_error;     ///< less is better, and 0 is equal: what a front can be made of
    int halves;        ///< the mean of two halves is off by their difference divided by this; 0: no such law is known
    const char* doc;
};
std::span<const ErrorColumn> error_columns();
const ErrorColumn* find_error(std::string_view name);

using Errors = std::map<std::string, double>;   ///< by the column's name

struct MeasuredErrors {
    Errors values;
    std::vector<float> flip;      ///< error of each pixel, 0 .. 1
    size_t non_finite = 0;        ///< pixels of the test with a NaN or an infinity: like those of the reference, they are not measured
};
/// Both linear, R G B, of one size, with `clip` cut off at 0 and 1 (what a file of 8 bits can hold).
MeasuredErrors measure_errors(const Picture& reference, const Picture& test, bool clip);

/// Pixels with a NaN or an infinity.
size_t count_non_finite(const Picture& picture);

/// What is left of the reference's own error, from its two halves.
Errors errors_of_halves(const Picture& a, const Picture& b, bool clip);

}  // namespace alidade::tradeoff
