// SPDX-License-Identifier: Apache-2.0
#include "eval/noise/lattice_noise.h"

#include "eval/noise/lattice_cell.h"

namespace alidade {

namespace {

double at(const LatticeCorner& c, double x, double y, double z) { return c.value + c.gx * x + c.gy * y + c.gz * z; }

/// The corners' values at the point, weighted. `shift` is 0, 4, 8 for the three noises.
double sum(const LatticeCell& cell, unsigned shift, double sx, double sy, double sz) {
    const double x0 = cell.x.offset, y0 = cell.y.offset, z0 = cell.z.offset;
    double rows[4];
    for (int i = 0; i < 4; ++i) {
        const double dy = i & 1 ? y0 - 1 : y0, dz = i & 2 ? z0 - 1 : z0;
        const double low = at(kLatticeCorners[cell.hash[2 * i] + shift], x0, dy, dz), high = at(kLatticeCorners[cell.hash[2 * i + 1] + shift], x0 - 1, dy, dz);
        rows[i] = low * (1 - sx) + high * sx;
    }
    return (rows[0] * (1 - sy) + rows[1] * sy) * (1 - sz) + (rows[2] * (1 - sy) + rows[3] * sy) * sz;
}

double lattice_noise(const Vec3& p) {
    const LatticeCell cell(p);
    return sum(cell, 0, smooth_step(cell.x.offset), smooth_step(cell.y.offset), smooth_step(cell.z.offset));
}

Vec3 vector_lattice_noise(const Vec3& p) {
    const LatticeCell cell(p);
    const double sx = smooth_step(cell.x.offset), sy = smooth_step(cell.y.offset), sz = smooth_step(cell.z.offset);
    return {sum(cell, 0, sx, sy, sz), sum(cell, 4, sx, sy, sz), sum(cell, 8, sx, sy, sz)};
}

Vec3 octaves(const Vec3& p, const Octaves& octaves) {
    Vec3 sum = vector_lattice_noise(p);
    double weight = octaves.omega, frequency = octaves.lambda;
    for (int i = 1; i < octaves.count; ++i, weight *= octaves.omega, frequency *= octaves.lambda) sum += weight * vector_lattice_noise(p * frequency);
    return sum;
}

void four(const Vec3* points, double* values) {
    for (int i = 0; i < 4; ++i) values[i] = lattice_noise(points[i]);
}

constexpr LatticeNoise kLatticeNoises[] = {
    {"plain", lattice_noise, vector_lattice_noise, octaves, four},
#ifdef __x86_64__
    {"avx2", avx2::lattice_noise, avx2::vector_lattice_noise, avx2::octaves, avx2::four},
#endif
};

}  // namespace

std::span<const LatticeNoise> lattice_noises() {
#ifdef __x86_64__
    if (!__builtin_cpu_supports("avx2")) return std::span(kLatticeNoises).first(1);
#endif
    return kLatticeNoises;
}

}  // namespace alidade
