// SPDX-License-Identifier: Apache-2.0
#include "eval/noise/noises.h"

#include "eval/noise/lattice_noise.h"
#include "eval/noise/single.h"

namespace alidade {

namespace {

double clamped(double v) { return std::clamp(v, 0.0, 1.0); }

const LatticeNoise kFastest = lattice_noises().back();

/// What the first two generators make of the lattice's noise.
double of_lattice(double n, NoiseGenerator generator) { return clamped(generator == NoiseGenerator::original ? n + 0.5 : (n + 1.05242) * 0.48985582); }

/// One octave: of generators 2 and 3 the contrast is doubled.
double octave(double n, NoiseGenerator generator) { return generator == NoiseGenerator::original ? n : 2 * n - 0.5; }

}  // namespace

double noise(const Vec3& p, NoiseGenerator generator) {
    if (generator == NoiseGenerator::perlin) return clamped((1.59 * gradient_noise(p) + 0.985) * 0.5);
    return of_lattice(kFastest.value(p), generator);
}

void noises(const Vec3* points, int count, NoiseGenerator generator, double* out) {
    if (generator == NoiseGenerator::perlin || count < 3) {   // four at once cost less than three alone
        for (int i = 0; i < count; ++i) out[i] = noise(points[i], generator);
        return;
    }
    double values[4];
    if (count == 4) {
        kFastest.four(points, values);
    } else {
        const Vec3 all[4] = {points[0], points[1], points[2], points[2]};
        kFastest.four(all, values);
    }
    for (int i = 0; i < count; ++i) out[i] = of_lattice(values[i], generator);
}

Vec3 vector_noise(const Vec3& p) { return kFastest.vector(p); }

double turbulence(const Vec3& p, const Turbulence& t, NoiseGenerator generator) {
    const double omega = single(t.omega), lambda = single(t.lambda);   // POV-Ray keeps both in single precision
    double sum = 0, weight = 1, frequency = 1;
    for (int first = 0; first == 0 || first < t.octaves; first += 4) {
        const int count = std::clamp(t.octaves - first, 1, 4);
        Vec3 places[4];
        double values[4];
        for (int i = 0; i < count; ++i, frequency *= lambda) places[i] = p * frequency;
        noises(places, count, generator, values);
        for (int i = 0; i < count; ++i, weight *= omega) {
            const double own = octave(values[i], generator);
            if (first + i == 0) sum = generator == NoiseGenerator::original ? own : clamped(own);   // the first octave alone
            else sum += weight * own;
        }
    }
    return sum;
}

Vec3 vector_turbulence(const Vec3& p, const Turbulence& t) { return kFastest.octaves(p, {t.octaves, single(t.omega), single(t.lambda)}); }

}  // namespace alidade
