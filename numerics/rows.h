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
Check roots();
Check scale_image();
Check offset_image();
Check axes_permute();
Check accel_equal();
Check axis_parallel();
Check self_hit();
Check contacts();
Check bad_input();
Check transform_extreme();
Check csg_coincident();
Check refraction();
Check fresnel_energy();
Check white_furnace();
Check determinism();
Check mesh_files();

}  // namespace alidade::numerics
