// SPDX-License-Identifier: Apache-2.0
/// A curve that takes the reference's values to the test's: what a slip in colour handling leaves.
#pragma once

#include "tools/metrics/metric.h"

#include <string>

namespace alidade {

struct Transfer {
    std::string name;       ///< "encoding", "gamma", "exposure", "offset"
    std::string sentence;
    double explained = 0;   ///< the share of the squared error that is gone after it
};

/// The curve that explains most: sRGB put on or taken off, scale x value ^ gamma (by least squares on logarithms), or a constant added.
Transfer find_transfer(const PicturePair& pair);

}  // namespace alidade
