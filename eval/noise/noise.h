// SPDX-License-Identifier: Apache-2.0
/// POV-Ray's three noises of space, and the turbulence that is made of them.
///
/// Units    a lattice of unit cells; values in [0, 1]
/// Source   the POV-Ray 3.7 manual (3.3.1.9.7 "noise_generator", 3.4.7.6 "Turbulence"); constants and formulas by experiments with POV-Ray 3.7, not from its source
/// Error    <= 1e-14 of what POV-Ray prints, for coordinates below 2^31 (held by noise_test)
#pragma once

#include "core/vec.h"
#include "scene/material.h"

namespace alidade {

/// Noise by POV-Ray's `noise_generator`; clamped to [0, 1].
double noise(const Vec3& p, NoiseGenerator generator);

/// Three noises around 0, the same for every generator (POV-Ray calls it DNoise).
Vec3 vector_noise(const Vec3& p);

/// Sum of noises whose frequency grows by lambda and whose weight by omega (`t.amount` is left to the caller). Above 1 where many octaves add up.
double turbulence(const Vec3& p, const Turbulence& t, NoiseGenerator generator);
Vec3 vector_turbulence(const Vec3& p, const Turbulence& t);

/// Gradient noise, in about [-1, 1]: what generator 3 scales.
double gradient_noise(const Vec3& p);

}  // namespace alidade
