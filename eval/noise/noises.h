// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "eval/noise/noise.h"

namespace alidade {

/// noise() of one to four points, which sums of octaves ask for together.
void noises(const Vec3* points, int count, NoiseGenerator generator, double* out);

}  // namespace alidade
