// SPDX-License-Identifier: Apache-2.0
/// The rows' cases, one file a subject.
#pragma once

#include "numerics/suite.h"

namespace alidade::numerics {

using Check = std::function<void(uint64_t number, NumericsTally&)>;

Check leak_edge();
Check leak_vertex();
Check leak_scale();
Check parity();
Check tri_exact();
Check tri_underflow();
Check sphere_far();
Check sphere_tangent();
Check quadric_cancel();
Check quartic_far();
Check scale_image();
Check offset_image();
Check accel_equal();
Check axis_parallel();
Check self_hit();
Check contacts();
Check determinism();

}  // namespace alidade::numerics
