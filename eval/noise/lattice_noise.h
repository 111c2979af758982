// SPDX-License-Identifier: Apache-2.0
/// POV-Ray's lattice noise around 0, which noise() and vector_noise() are made of, in the ways that this machine can calculate it.
#pragma once

#include "core/vec.h"

#include <span>

namespace alidade {

/// Octaves of vector noise: the frequency of each is lambda times, its weight omega times that of the one before.
struct Octaves {
    int count;
    double omega, lambda;
};

/// One way to calculate: all give the same numbers, bit for bit.
struct LatticeNoise {
    const char* name;
    double (*value)(const Vec3& p);
    Vec3 (*vector)(const Vec3& p);
    Vec3 (*octaves)(const Vec3& p, const Octaves& octaves);
    void (*four)(const Vec3* points, double* values);   ///< value() of four points
};

/// The first is the plain one, the last the fastest.
std::span<const LatticeNoise> lattice_noises();

/// Four numbers at a time. Only for machines that have AVX2.
namespace avx2 {
double lattice_noise(const Vec3& p);
Vec3 vector_lattice_noise(const Vec3& p);
Vec3 octaves(const Vec3& p, const Octaves& octaves);
void four(const Vec3* points, double* values);
}  // namespace avx2

}  // namespace alidade
