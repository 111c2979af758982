// SPDX-License-Identifier: Apache-2.0
/// Whether a mesh keeps what is inside of it in its box, beside points outside of the box that are asked.
#include "eval/mesh_inside.h"

#include "accel/accelerator.h"

#include <gtest/gtest.h>
#include <random>

namespace alidade {
namespace {

/// Each triangle with corners of its own, as POV-Ray's mesh has them.
Mesh mesh_of(const std::vector<std::array<Vec3f, 3>>& triangles) {
    Mesh mesh;
    for (const auto& t : triangles) {
        const auto first = uint32_t(mesh.positions.size());
        mesh.positions.insert(mesh.positions.end(), t.begin(), t.end());
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    mesh.inside_vector = Vec3(0.1, 1, 0.2);
    return mesh;
}

std::vector<std::array<Vec3f, 3>> tetrahedron(const Vec3f& at, float size) {
    const Vec3f a = at, b = at + Vec3f(size, 0, 0), c = at + Vec3f(0, size, 0), d = at + Vec3f(0, 0, size);
    return {{a, b, c}, {a, c, d}, {a, d, b}, {b, d, c}};
}

/// Points outside of the box that are inside of the mesh.
int insides_beyond_the_box(const Mesh& mesh) {
    const auto triangles = find_accelerator("bvh")->over_triangles({mesh.positions, mesh.exact_positions, mesh.triangles}, {});
    std::mt19937 random(7);
    std::uniform_real_distribution<double> at(-3, 3);
    WorkCounters work;
    int found = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3 p(at(random), at(random), at(random));
        found += !triangles->bounds().contains(p) && inside_mesh(mesh, *triangles, p, work);
    }
    return found;
}

TEST(MeshInside, ClosedMeshesKeepItInTheirBox) {
    auto two = tetrahedron(Vec3f(0), 1);
    const auto other = tetrahedron(Vec3f(0.3f, -0.4f, 0.1f), 1.5f);
    two.insert(two.end(), other.begin(), other.end());
    for (const auto& triangles : {tetrahedron(Vec3f(0), 1), two}) {
        const Mesh closed = mesh_of(triangles);
        EXPECT_TRUE(keeps_inside_in_box(closed));
        EXPECT_EQ(insides_beyond_the_box(closed), 0);
    }
}

TEST(MeshInside, BehindHolesItGoesOnForEver) {
    for (size_t missing = 0; missing < 4; ++missing) {
        auto triangles = tetrahedron(Vec3f(0), 1);
        triangles.erase(triangles.begin() + std::ptrdiff_t(missing));
        EXPECT_FALSE(keeps_inside_in_box(mesh_of(triangles))) << missing;
    }
    auto open = tetrahedron(Vec3f(0), 1);
    open.pop_back();
    EXPECT_GT(insides_beyond_the_box(mesh_of(open)), 0);
}

TEST(MeshInside, TwiceTheSameTriangleIsNone) {
    auto triangles = tetrahedron(Vec3f(0), 1);
    triangles.push_back(triangles.front()), triangles.push_back(triangles.front());
    EXPECT_TRUE(keeps_inside_in_box(mesh_of(triangles)));
    EXPECT_TRUE(keeps_inside_in_box(mesh_of({{Vec3f(0), Vec3f(1), Vec3f(1)}})));
    EXPECT_TRUE(keeps_inside_in_box(Mesh()));
}

}  // namespace
}  // namespace alidade
