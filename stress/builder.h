// SPDX-License-Identifier: Apache-2.0
/// What the generators have in common.
#pragma once

#include "core/draws.h"
#include "stress/scene.h"

#include <cmath>

namespace alidade {

/// Adds a patch of rows x columns quads over point(i, j), i in 0..rows, j in 0..columns: 2 rows columns triangles.
template <class F> void add_patch(StressMesh& mesh, size_t rows, size_t columns, F&& point) {
    const auto first = uint32_t(mesh.positions.size()), width = uint32_t(columns) + 1;
    for (size_t i = 0; i <= rows; ++i) {
        for (size_t j = 0; j <= columns; ++j) mesh.positions.emplace_back(point(i, j));
    }
    for (uint32_t i = 0; i < uint32_t(rows); ++i) {
        for (uint32_t j = 0; j + 1 < width; ++j) {
            const uint32_t a = first + i * width + j, b = a + 1, c = a + width, d = c + 1;
            mesh.triangles.emplace_back(a, b, d), mesh.triangles.emplace_back(a, d, c);
        }
    }
}

void add_triangle(StressMesh& mesh, const Vec3& a, const Vec3& b, const Vec3& c);

/// A sphere of six square patches, 12 n^2 triangles: the radius at a direction is `radius(direction)`, vertices stand up to `jitter` of a square aside.
template <class F> void add_ball(StressMesh& mesh, size_t n, const Vec3& center, double jitter, Draws& draws, F&& radius) {
    for (int side = 0; side < 6; ++side) {
        add_patch(mesh, n, n, [&](size_t i, size_t j) {
            const bool border = i == 0 || j == 0 || i == n || j == n;   // is shared with the next side
            const double aside = border ? 0 : jitter;
            const double u = (double(i) + draws.uniform(-aside, aside)) / double(n) * 2 - 1, v = (double(j) + draws.uniform(-aside, aside)) / double(n) * 2 - 1;
            Vec3 p;
            p[side / 2] = side % 2 ? 1 : -1, p[(side / 2 + 1) % 3] = side % 2 ? u : v, p[(side / 2 + 2) % 3] = side % 2 ? v : u;
            p = normalized(p);
            return center + radius(p) * p;
        });
    }
}

/// Waves in random directions, octaves of them, each half as high and twice as dense as the one before.
class Ripples {
  public:
    Ripples(int octaves, double frequency, Draws& draws);
    double operator()(const Vec3& p) const;   ///< within [-1, 1]

  private:
    struct Wave {
        Vec3 direction;
        double phase, height;
    };
    std::vector<Wave> waves_;
};

// The generators, a row of stress_kinds() each.
StressScene make_scan(size_t triangles, uint64_t seed);
StressScene make_architecture(size_t triangles, uint64_t seed);
StressScene make_stadium(size_t triangles, uint64_t seed);
StressScene make_hair(size_t triangles, uint64_t seed);
StressScene make_soup(size_t triangles, uint64_t seed);
StressScene make_sphere(size_t triangles, uint64_t seed);
StressScene make_forest(size_t triangles, uint64_t seed);
StressScene make_lattice(size_t triangles, uint64_t seed);
StressScene make_needle(size_t triangles, uint64_t seed);
StressScene make_nested(size_t triangles, uint64_t seed);
StressScene make_zoo(size_t triangles, uint64_t seed);

/// The n with 12 n^2 the nearest to `triangles`, at least 1: what add_ball takes.
size_t ball_side(size_t triangles);
/// A camera that looks at the middle, and a lamp.
void show(StressScene& scene, const Vec3& eye, double window);

}  // namespace alidade
