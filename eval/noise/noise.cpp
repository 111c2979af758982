// SPDX-License-Identifier: Apache-2.0
#include "eval/noise/noise.h"

#include "eval/noise/lattice_noise.h"
#include "eval/noise/single.h"

namespace alidade {

namespace {

double clamped(double v) { return std::clamp(v, 0.0, 1.0); }

const LatticeNoise kFastest = lattice_noises().back();

/// One octave: of generators 2 and 3 the contrast is doubled.
double octave(const Vec3& p, NoiseGenerator generator) {
    const double n = noise(p, generator);
    return generator == NoiseGenerator::original ? n : 2 * n - 0.5;
}

}  // namespace

double noise(const Vec3& p, NoiseGenerator generator) {
    switch (generator) {
        case NoiseGenerator::original: return clamped(kFastest.value(p) + 0.5);
        case NoiseGenerator::range_corrected: return clamped((kFastest.value(p) + 1.05242) * 0.48985582);
        case NoiseGenerator::perlin: break;
    }
    return clamped((1.59 * gradient_noise(p) + 0.985) * 0.5);
}

Vec3 vector_noise(const Vec3& p) { return kFastest.vector(p); }

double turbulence(const Vec3& p, const Turbulence& t, NoiseGenerator generator) {
    const double omega = single(t.omega), lambda = single(t.lambda);   // POV-Ray keeps both in single precision
    double sum = octave(p, generator), weight = omega, frequency = lambda;
    if (generator != NoiseGenerator::original) sum = clamped(sum);   // the first octave alone
    for (int i = 1; i < t.octaves; ++i, weight *= omega, frequency *= lambda) sum += weight * octave(p * frequency, generator);
    return sum;
}

Vec3 vector_turbulence(const Vec3& p, const Turbulence& t) { return kFastest.octaves(p, {t.octaves, single(t.omega), single(t.lambda)}); }

}  // namespace alidade
