// SPDX-License-Identifier: Apache-2.0
#include "eval/noise/noise.h"

#include "eval/noise/hash.h"
#include "eval/noise/lattice_values.h"
#include "eval/noise/single.h"

namespace alidade {

namespace {

/// Value and gradient at a lattice point, side by side.
struct alignas(32) Corner {
    double value, gx, gy, gz;
    double at(double x, double y, double z) const { return value + gx * x + gy * y + gz * z; }
};

constexpr std::array<Corner, 264> kCorners = [] {
    std::array<Corner, 264> all{};
    for (size_t m = 0; m < all.size(); ++m) all[m] = {kLatticeValues[m] * 0.5, kLatticeValues[m + 1], kLatticeValues[m + 2], kLatticeValues[m + 3]};
    return all;
}();

double clamped(double v) { return std::clamp(v, 0.0, 1.0); }

/// The cell of a coordinate, and where in it the coordinate is. A negative integer belongs to the cell below it, up to 1e-10.
struct Place {
    double offset;
    unsigned index;
    explicit Place(double x) {
        const int32_t cell = truncated(x >= 0 ? x : x - (1 - 1e-10));
        offset = x - cell;
        index = (uint32_t(cell) + 10000u) & 4095u;
    }
};

/// What the eight corners around a point are: their hashes, their distances and their weights.
struct Cell {
    Place x, y, z;
    unsigned hash[8];   ///< bit 0: x, bit 1: y, bit 2: z

    explicit Cell(const Vec3& p) : x(p.x), y(p.y), z(p.z) {
        const auto& h = kLatticeHash;
        const unsigned x0 = h[x.index], x1 = h[x.index + 1];
        const unsigned columns[4] = {h[x0 ^ y.index], h[x1 ^ y.index], h[x0 ^ (y.index + 1)], h[x1 ^ (y.index + 1)]};
        for (int i = 0; i < 4; ++i) {
            hash[i] = h[columns[i] ^ z.index] & 255u;
            hash[i + 4] = h[columns[i] ^ (z.index + 1)] & 255u;
        }
    }

    /// The corners' values at the point, weighted. `shift` is 0, 4, 8 for the three noises.
    double sum(unsigned shift, double sx, double sy, double sz) const {
        const double x0 = x.offset, y0 = y.offset, z0 = z.offset;
        double rows[4];
        for (int i = 0; i < 4; ++i) {
            const double dy = i & 1 ? y0 - 1 : y0, dz = i & 2 ? z0 - 1 : z0;
            const double low = kCorners[hash[2 * i] + shift].at(x0, dy, dz), high = kCorners[hash[2 * i + 1] + shift].at(x0 - 1, dy, dz);
            rows[i] = low * (1 - sx) + high * sx;
        }
        return (rows[0] * (1 - sy) + rows[1] * sy) * (1 - sz) + (rows[2] * (1 - sy) + rows[3] * sy) * sz;
    }
};

double lattice_noise(const Vec3& p) {
    const Cell cell(p);
    return cell.sum(0, smooth_step(cell.x.offset), smooth_step(cell.y.offset), smooth_step(cell.z.offset));
}

/// One octave: of generators 2 and 3 the contrast is doubled.
double octave(const Vec3& p, NoiseGenerator generator) {
    const double n = noise(p, generator);
    return generator == NoiseGenerator::original ? n : 2 * n - 0.5;
}

}  // namespace

double noise(const Vec3& p, NoiseGenerator generator) {
    switch (generator) {
        case NoiseGenerator::original: return clamped(lattice_noise(p) + 0.5);
        case NoiseGenerator::range_corrected: return clamped((lattice_noise(p) + 1.05242) * 0.48985582);
        case NoiseGenerator::perlin: break;
    }
    return clamped((1.59 * gradient_noise(p) + 0.985) * 0.5);
}

Vec3 vector_noise(const Vec3& p) {
    const Cell cell(p);
    const double sx = smooth_step(cell.x.offset), sy = smooth_step(cell.y.offset), sz = smooth_step(cell.z.offset);
    return {cell.sum(0, sx, sy, sz), cell.sum(4, sx, sy, sz), cell.sum(8, sx, sy, sz)};
}

double turbulence(const Vec3& p, const Turbulence& t, NoiseGenerator generator) {
    const double omega = single(t.omega), lambda = single(t.lambda);   // POV-Ray keeps both in single precision
    double sum = octave(p, generator), weight = omega, frequency = lambda;
    if (generator != NoiseGenerator::original) sum = clamped(sum);   // the first octave alone
    for (int i = 1; i < t.octaves; ++i, weight *= omega, frequency *= lambda) sum += weight * octave(p * frequency, generator);
    return sum;
}

Vec3 vector_turbulence(const Vec3& p, const Turbulence& t) {
    const double omega = single(t.omega), lambda = single(t.lambda);
    Vec3 sum = vector_noise(p);
    double weight = omega, frequency = lambda;
    for (int i = 1; i < t.octaves; ++i, weight *= omega, frequency *= lambda) sum += weight * vector_noise(p * frequency);
    return sum;
}

}  // namespace alidade
