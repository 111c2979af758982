// SPDX-License-Identifier: Apache-2.0
/// Scans, spheres, the stadium, hair and soup.
#include "stress/builder.h"

namespace alidade {

size_t ball_side(size_t triangles) { return std::max<size_t>(1, size_t(std::lround(std::sqrt(double(triangles) / 12)))); }

void show(StressScene& scene, const Vec3& eye, double window) {
    scene.camera = StressCamera::look(eye, Vec3(0), window);
    scene.lamps = {StressLamp()};
}

namespace {

/// A figure of radius about `size`, as rough as a scan.
void add_figure(StressMesh& mesh, size_t triangles, const Vec3& center, double size, Draws& draws) {
    const Ripples hills(7, 2.5, draws);
    add_ball(mesh, ball_side(triangles), center, 0.3, draws, [&](const Vec3& p) { return size * (1 + 0.45 * hills(p)); });
}

}  // namespace

StressScene make_scan(size_t triangles, uint64_t seed) {
    StressScene scene;
    Draws draws(RandomKey(seed, 1, 0, 0));
    add_figure(scene.mesh(), triangles, Vec3(0), 1, draws);
    show(scene, Vec3(1.5, 1, 3), 0.35);
    return scene;
}

StressScene make_sphere(size_t triangles, uint64_t seed) {
    StressScene scene;
    Draws draws(RandomKey(seed, 2, 0, 0));
    const Ripples hills(3, 9, draws);
    add_ball(scene.mesh(), ball_side(triangles), Vec3(0), 0, draws, [&](const Vec3& p) { return 1 + 0.25 * hills(p); });
    show(scene, Vec3(0.5, 1, 2.5), 0.4);
    return scene;
}

StressScene make_stadium(size_t triangles, uint64_t seed) {
    StressScene scene;
    Draws draws(RandomKey(seed, 3, 0, 0));
    const Vec3 place(3.2, 0.25, -2.1);
    add_figure(scene.mesh(), triangles * 3 / 5, place, 0.25, draws);
    const auto rows = std::max<size_t>(2, size_t(std::sqrt(double(triangles) / 5 / 4)));
    add_patch(scene.mesh(), rows, 4 * rows, [&](size_t i, size_t j) {   // half a sphere, open above, with a drain below
        const double down = 0.5 * kPi * (double(i) + 0.02) / (double(rows) + 0.02), around = 2 * kPi * double(j) / double(4 * rows);
        return Vec3(1000 * std::sin(down) * std::cos(around), 1000 * (1 - std::cos(down)), 1000 * std::sin(down) * std::sin(around));
    });
    scene.camera = StressCamera::look(place + Vec3(0.4, 0.5, 0.9), place, 0.5), scene.lamps = {{Vec3(300, 700, 200)}};
    return scene;
}

StressScene make_hair(size_t triangles, uint64_t seed) {
    constexpr size_t kSlivers = 24;
    StressScene scene;
    Draws draws(RandomKey(seed, 4, 0, 0));
    const size_t ball = triangles / 13, hairs = std::max<size_t>(1, (triangles - ball) / kSlivers);
    add_ball(scene.mesh(), ball_side(ball), Vec3(0), 0, draws, [](const Vec3&) { return 1.0; });
    for (size_t hair = 0; hair < hairs; ++hair) {
        const Vec3 root = draws.direction(), lean = draws.direction(), side = 0.0015 * normalized(cross(root, lean));
        const double bend = draws.uniform(0.2, 0.6);
        add_patch(scene.mesh(), kSlivers / 2, 1, [&](size_t i, size_t j) {
            const double s = double(i) / (kSlivers / 2);
            return (1 + 0.4 * s) * root + bend * s * s * (lean - Vec3(0, 0.8, 0)) + (j ? 1.02 - s : s - 1.02) * side;
        });
    }
    show(scene, Vec3(1, 0.5, 3.5), 0.5);
    return scene;
}

StressScene make_soup(size_t triangles, uint64_t seed) {
    StressScene scene;
    Draws draws(RandomKey(seed, 5, 0, 0));
    const double size = 1.2 / std::cbrt(double(triangles));
    for (size_t i = 0; i < triangles; ++i) {
        const Vec3 center = draws.in_box(Vec3(-1), Vec3(1));
        const auto corner = [&] { return center + size * draws.in_box(Vec3(-1), Vec3(1)); };
        const Vec3 a = corner(), b = corner(), c = corner();
        add_triangle(scene.mesh(), a, b, c);
    }
    show(scene, Vec3(1.5, 1.2, 3.2), 0.5);
    return scene;
}

}  // namespace alidade
