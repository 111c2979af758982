// SPDX-License-Identifier: Apache-2.0
#include "eval/noise/hash.h"
#include "eval/noise/noise.h"

#include <memory>

namespace alidade {

namespace {

constexpr unsigned kSize = 2048;
/// Moves the origin away from a lattice point, and small coordinates away from negative ones.
constexpr double kShift = 10000000.023157213;

/// Unit vectors and a permutation, both written beyond their end so that no index is reduced.
/// Source   K. Perlin, "An Image Synthesizer", SIGGRAPH 1985; POV-Ray's sizes and its order of drawing, found by experiment.
struct GradientTables {
    std::array<Vec3, 2 * kSize + 2> gradient;
    std::array<uint16_t, 2 * kSize + 2> permutation{};

    GradientTables() {
        NoiseSequence sequence(1);
        for (unsigned i = 0; i < kSize; ++i) gradient[i] = unit_vector(sequence);
        for (unsigned i = 0; i < kSize; ++i) permutation[i] = uint16_t(i);
        for (unsigned i = kSize; i > 0; i -= 2) std::swap(permutation[i], permutation[sequence.next() % kSize]);   // [kSize] is a 0 beyond the end
        for (unsigned i = 0; i < kSize + 2; ++i) {
            permutation[kSize + i] = permutation[i];
            gradient[kSize + i] = gradient[i];
        }
    }

    static Vec3 unit_vector(NoiseSequence& sequence) {
        for (;;) {
            Vec3 v;
            for (int k = 0; k < 3; ++k) v[k] = (double(sequence.next() % 4096) - 2048) / 2048;
            const double square = dot(v, v);
            if (square >= 1e-5 && square <= 1) return v / std::sqrt(square);
        }
    }
};

const GradientTables& tables() {
    static const auto all = std::make_unique<const GradientTables>();
    return *all;
}

double mix(double a, double b, double t) { return a + t * (b - a); }

}  // namespace

double gradient_noise(const Vec3& p) {
    const GradientTables& all = tables();
    unsigned cell[3];
    Vec3 at;
    for (int k = 0; k < 3; ++k) {
        const double x = p[k] + kShift;
        const int32_t whole = truncated(std::floor(x));
        cell[k] = uint32_t(whole) % kSize;
        at[k] = x - whole;
    }
    const unsigned x0 = all.permutation[cell[0]], x1 = all.permutation[cell[0] + 1];
    double planes[2];
    for (unsigned dz = 0; dz < 2; ++dz) {
        double rows[2];
        for (unsigned dy = 0; dy < 2; ++dy) {
            const Vec3 low = at - Vec3(0, dy, dz), high = low - Vec3(1, 0, 0);
            const double a = dot(all.gradient[all.permutation[x0 + cell[1] + dy] + cell[2] + dz], low);
            const double b = dot(all.gradient[all.permutation[x1 + cell[1] + dy] + cell[2] + dz], high);
            rows[dy] = mix(a, b, smooth_step(at.x));
        }
        planes[dz] = mix(rows[0], rows[1], smooth_step(at.y));
    }
    return mix(planes[0], planes[1], smooth_step(at.z));
}

}  // namespace alidade
