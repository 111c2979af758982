// SPDX-License-Identifier: Apache-2.0
/// A nave of two storeys along x, 40 long, 12 wide, 12 high.
#include "stress/builder.h"

namespace alidade {

namespace {

constexpr double kBay = 4;        ///< from column to column
constexpr int kColumns = 11;

struct Part {
    StressMesh& mesh;
    double detail;                ///< multiplies the quads of a patch
    size_t quads(double count) const { return std::max<size_t>(2, size_t(std::lround(count * std::sqrt(detail)))); }
};

/// Few rows, many columns: each flute is a long thin triangle.
void add_column(const Part& part, const Vec3& foot, double height, double radius) {
    const size_t around = part.quads(160), rows = part.quads(6);
    add_patch(part.mesh, rows, around, [&](size_t i, size_t j) {
        const double s = double(i) / double(rows), a = 2 * kPi * double(j) / double(around);
        const double r = radius * (1.1 - 0.2 * s) * (1 + 0.06 * std::cos(20 * a));
        return foot + Vec3(r * std::cos(a), height * s, r * std::sin(a));
    });
}

/// Half a ring from one column to the next.
void add_arch(const Part& part, const Vec3& middle, double radius, double thick) {
    const size_t along = part.quads(24), around = part.quads(16);
    add_patch(part.mesh, along, around, [&](size_t i, size_t j) {
        const double s = kPi * double(i) / double(along), a = 2 * kPi * double(j) / double(around), r = radius + thick * std::cos(a);
        return middle + Vec3(r * std::cos(s), r * std::sin(s), thick * std::sin(a));
    });
}

void add_box(StressMesh& mesh, const Vec3& low, const Vec3& high) {
    for (int axis = 0; axis < 3; ++axis) {
        for (const double at : {low[axis], high[axis]}) {
            add_patch(mesh, 1, 1, [&](size_t i, size_t j) {
                Vec3 p;
                p[axis] = at, p[(axis + 1) % 3] = i ? high[(axis + 1) % 3] : low[(axis + 1) % 3], p[(axis + 2) % 3] = j ? high[(axis + 2) % 3] : low[(axis + 2) % 3];
                return p;
            });
        }
    }
}

void add_rows(const Part& part) {
    for (int column = 0; column < kColumns; ++column) {
        for (const double z : {-4.0, 4.0}) {
            const double x = kBay * (column - kColumns / 2);
            add_column(part, Vec3(x, 0, z), 4, 0.4), add_column(part, Vec3(x, 6, z), 3, 0.25);
            if (column + 1 == kColumns) continue;
            for (const double y : {4.0, 9.0}) add_arch(part, Vec3(x + kBay / 2, y, z), kBay / 2 - 0.2, y < 5 ? 0.25 : 0.18);
        }
    }
}

/// Tiles of the floor, battens along the walls and across the roof, each a box.
void add_woodwork(const Part& part, Draws& draws) {
    const size_t tiles = part.quads(90), battens = part.quads(120);
    for (size_t i = 0; i < tiles; ++i) {
        for (size_t j = 0; j < tiles / 3; ++j) {
            const double w = 44.0 / double(tiles), d = 36.0 / double(tiles), x = -22 + w * double(i), z = -6 + d * double(j);
            add_box(part.mesh, Vec3(x, -0.2, z), Vec3(x + 0.97 * w, draws.uniform(-0.01, 0.01), z + 0.97 * d));
        }
    }
    for (size_t i = 0; i < battens; ++i) {
        const double s = double(i) / double(battens), y = 12 * s, x = 44 * s - 22;
        for (const double from : {-22.0, -7.0, 8.0}) {
            for (const double z : {-6.0, 6.0}) add_box(part.mesh, Vec3(from, y, z), Vec3(from + 14, y + 7.0 / double(battens), z + 0.05));
        }
        add_box(part.mesh, Vec3(x, 12, -6), Vec3(x + 26.0 / double(battens), 12.1, 6));
    }
}

void add_cloth(const Part& part, const Ripples& folds) {
    const size_t rows = part.quads(48);
    for (int i = 0; i < 8; ++i) {
        const Vec3 hook(kBay * (i - 3.5), 9.5, i % 2 ? -2 : 2);
        add_patch(part.mesh, rows, rows, [&](size_t r, size_t c) {
            const double u = double(c) / double(rows), v = double(r) / double(rows);
            return hook + Vec3(2.4 * (u - 0.5), -4 * v, 0.5 * v * folds(Vec3(8 * u, 2 * v, i)));
        });
    }
}

}  // namespace

StressScene make_architecture(size_t triangles, uint64_t seed) {
    StressScene scene;
    Draws draws(RandomKey(seed, 6, 0, 0));
    const Part part{scene.mesh(), double(triangles) / 196000};
    add_rows(part);
    add_woodwork(part, draws);
    add_cloth(part, Ripples(3, 4, draws));
    const Transform turn = Transform::rotate(Vec3(0, 1, 0), 30 * kPi / 180) * Transform::rotate(Vec3(1, 0, 0), 7 * kPi / 180);
    for (Vec3f& p : scene.mesh().positions) p = Vec3f(turn.point(Vec3(p)));
    scene.camera = StressCamera::look(turn.point(Vec3(-18, 2, 1)), turn.point(Vec3(10, 5, -1)), 0.8);
    scene.lamps = {{turn.point(Vec3(1, 11, 0.5))}};
    return scene;
}

}  // namespace alidade
