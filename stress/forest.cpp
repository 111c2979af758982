// SPDX-License-Identifier: Apache-2.0
/// A tree, and where it stands.
#include "stress/builder.h"

namespace alidade {

namespace {

constexpr int kTreesAside = 32;

void add_branch(StressMesh& mesh, const Vec3& from, const Vec3& to, double thick) {
    const Vec3 along = normalized(to - from), side = normalized(cross(along, std::abs(along.y) < 0.9 ? Vec3(0, 1, 0) : Vec3(1, 0, 0))), up = cross(along, side);
    add_patch(mesh, 2, 6, [&](size_t i, size_t j) {
        const double a = 2 * kPi * double(j) / 6, r = thick * (1 - 0.4 * double(i));
        return from + 0.5 * double(i) * (to - from) + r * (std::cos(a) * side + std::sin(a) * up);
    });
}

void add_leaf(StressMesh& mesh, const Vec3& at, double size, Draws& draws) {
    const Vec3 along = size * draws.direction(), across = size * draws.direction();
    add_triangle(mesh, at, at + along + 0.3 * across, at + along - 0.3 * across);
}

}  // namespace

StressScene make_forest(size_t triangles, uint64_t seed) {
    StressScene scene;
    StressMesh& mesh = scene.mesh();
    Draws draws(RandomKey(seed, 7, 0, 0));
    const size_t branches = std::max<size_t>(1, triangles / 100);
    add_branch(mesh, Vec3(0), Vec3(0, 2, 0), 0.08), add_branch(mesh, Vec3(0, 2, 0), Vec3(0.1, 4, 0.1), 0.05);
    for (size_t i = 0; i < branches; ++i) {
        const double height = draws.uniform(0.8, 4), angle = draws.uniform(0, 2 * kPi), reach = 0.4 * (4.6 - height);
        const double rise = draws.uniform(0.1, 0.6);
        const Vec3 from(0, height, 0), to = from + reach * Vec3(std::cos(angle), rise, std::sin(angle));
        add_branch(mesh, from, to, 0.015);
        while (mesh.triangles.size() < (i + 1) * triangles / branches) {
            const Vec3 along = draws.uniform(0.3, 1) * (to - from), aside = 0.1 * draws.direction();
            const double size = draws.uniform(0.03, 0.08);
            add_leaf(mesh, from + along + aside, size, draws);
        }
    }
    for (int i = 0; i < kTreesAside * kTreesAside; ++i) {
        const Vec3 off = draws.in_box(Vec3(-0.4, -0.3, -0.4), Vec3(0.4, 0, 0.4));
        const Vec3 place(2.2 * (i % kTreesAside - kTreesAside / 2 + off.x), off.y, 2.2 * (i / kTreesAside - kTreesAside / 2 + off.z));
        const double turn = draws.uniform(0, 2 * kPi), size = draws.uniform(0.7, 1.3);
        scene.places.push_back({Transform::translate(place) * Transform::rotate(Vec3(0, 1, 0), turn) * Transform::scale(Vec3(size))});
    }
    scene.camera = StressCamera::look(Vec3(-38, 9, -30), Vec3(0, 1, 0), 0.5), scene.lamps = {{Vec3(20, 60, -30)}};
    return scene;
}

}  // namespace alidade
