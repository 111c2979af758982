// SPDX-License-Identifier: Apache-2.0
/// What accelerators find hard: faces on faces, needles, clusters of clusters, degenerate triangles.
#include "stress/builder.h"

namespace alidade {

namespace {

void add_cube(StressMesh& mesh, const Vec3& low, double size) {
    for (int side = 0; side < 6; ++side) {
        add_patch(mesh, 1, 1, [&](size_t i, size_t j) {
            Vec3 p;
            p[side / 2] = side % 2, p[(side / 2 + 1) % 3] = double(i), p[(side / 2 + 2) % 3] = double(j);
            return low + size * p;
        });
    }
}

/// Any triangle of about `size` around `center`.
void add_scrap(StressMesh& mesh, const Vec3& center, double size, Draws& draws) {
    const auto corner = [&] { return center + size * draws.in_box(Vec3(-1), Vec3(1)); };
    const Vec3 a = corner(), b = corner(), c = corner();
    add_triangle(mesh, a, b, c);
}

void add_sliver(StressMesh& mesh, double width, Draws& draws) {
    const Vec3 from = draws.in_box(Vec3(-1), Vec3(1)), to = draws.in_box(Vec3(-1), Vec3(1));
    add_triangle(mesh, from, to, from + width * draws.direction());
}

/// Without area: a point, a line, or a line whose corners are in other order.
void add_nothing(StressMesh& mesh, const Vec3& at, size_t which) {
    const Vec3 along(0.0625, 0, 0);   // so that the float corners are on one line, too
    const Vec3 a{Vec3f(at)};
    if (which == 0) add_triangle(mesh, a, a, a);
    else if (which == 1) add_triangle(mesh, a, a, a + along);
    else add_triangle(mesh, a + along, a, a + along);
}

}  // namespace

StressScene make_lattice(size_t triangles, uint64_t seed) {
    StressScene scene;
    Draws draws(RandomKey(seed, 9, 0, 0));
    const auto n = std::max<size_t>(1, size_t(std::lround(std::cbrt(double(triangles) * 8 / 7 / 12))));
    for (size_t i = 0; i < n * n * n; ++i) {
        if (n > 1 && draws.below(8) == 0) continue;
        add_cube(scene.mesh(), Vec3(double(i % n), double(i / n % n), double(i / n / n)) * (2 / double(n)) - Vec3(1), 2 / double(n));
    }
    show(scene, Vec3(1.8, 1.3, 3.5), 0.5);
    return scene;
}

StressScene make_needle(size_t triangles, uint64_t seed) {
    StressScene scene;
    Draws draws(RandomKey(seed, 10, 0, 0));
    const double width = std::max(1e-6, 6 / double(triangles));   // a line through the middle meets about one
    for (size_t i = 0; i < triangles; ++i) add_sliver(scene.mesh(), width, draws);
    show(scene, Vec3(1.2, 0.8, 3), 0.4);
    return scene;
}

StressScene make_nested(size_t triangles, uint64_t seed) {
    constexpr int kCopies = 8, kLevels = 4;
    StressScene scene;
    Draws draws(RandomKey(seed, 11, 0, 0));
    const Ripples hills(4, 3, draws);
    add_ball(scene.mesh(), ball_side(triangles), Vec3(0), 0.2, draws, [&](const Vec3& p) { return 0.8 * (1 + 0.3 * hills(p)); });
    std::vector<Transform> level{Transform()};
    for (int i = 0; i < kLevels; ++i) {
        std::vector<Transform> next;
        for (const Transform& parent : level) {
            for (int k = 0; k < kCopies; ++k) {
                const Vec3 axis = draws.direction(), corner(k & 1 ? 0.55 : -0.55, k & 2 ? 0.55 : -0.55, k & 4 ? 0.55 : -0.55);
                const double turn = draws.uniform(0, 2 * kPi), size = draws.uniform(0.3, 0.45);
                next.push_back(parent * Transform::translate(corner) * Transform::rotate(axis, turn) * Transform::scale(Vec3(size)));
            }
        }
        level.swap(next);
    }
    for (const Transform& place : level) scene.places.push_back({place});
    show(scene, Vec3(1, 0.7, 2.5), 0.4);
    return scene;
}

StressScene make_zoo(size_t triangles, uint64_t seed) {
    StressScene scene;
    StressMesh& mesh = scene.mesh();
    Draws draws(RandomKey(seed, 12, 0, 0));
    const double size = 1.2 / std::cbrt(double(triangles));
    Vec3 nest(0);
    for (size_t i = 0; i < triangles; ++i) {
        const Vec3 center = draws.in_box(Vec3(-1), Vec3(1));
        if (i % 16 == 0) nest = center;
        const size_t species = i % 1024 == 1023 ? 16 : i % 16;
        switch (species) {
            case 0: add_nothing(mesh, center, i / 16 % 3); break;
            case 2: mesh.triangles.push_back(mesh.triangles.back()); break;   // the same corners again
            case 11: mesh.triangles.push_back(mesh.triangles[i / 2]); break;   // those of any before
            case 3: case 4: case 5: add_scrap(mesh, nest, 2 * size / double(species), draws); break;
            case 6: case 7: add_triangle(mesh, Vec3(center.x, 0.25, center.z), Vec3(center.x + 3 * size, 0.25, center.z), Vec3(center.x, 0.25, center.z + 3 * size)); break;
            case 8: add_scrap(mesh, center, 1e-6 * size, draws); break;
            case 9: add_scrap(mesh, 1e4 * center, size, draws); break;
            case 10: add_sliver(mesh, 1e-3 * size, draws); break;
            case 16: add_scrap(mesh, center, 100, draws); break;
            default: add_scrap(mesh, center, size, draws);
        }
    }
    show(scene, Vec3(1.5, 1.2, 3.2), 0.4);
    return scene;
}

}  // namespace alidade
