// SPDX-License-Identifier: Apache-2.0
/// Tangents in closed form, and relations that hold for any mesh. tests/scenes compares them with Blender's.
#include "eval/tangents.h"

#include "core/transform.h"
#include "tests/core/draw.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

/// A grid of n x n squares over [0, 1]^2 in the plane that `map` sends it to; one vertex a point.
template <class Uv> Mesh grid(int n, const Transform& map, const Uv& uv) {
    Mesh mesh;
    mesh.uvs.resize(1);
    for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) {
            const Vec2 at(double(i) / n, double(j) / n);
            mesh.positions.emplace_back(map.point({at.x, at.y, 0}));
            mesh.normals.values.emplace_back(normalized(inverse(map)->transposed({0, 0, 1})));
            mesh.uvs[0].values.emplace_back(uv(at));
        }
    }
    for (uint32_t j = 0; j < uint32_t(n); ++j) {
        for (uint32_t i = 0; i < uint32_t(n); ++i) {
            const uint32_t a = j * uint32_t(n + 1) + i, d = a + uint32_t(n + 1);
            mesh.triangles.emplace_back(a, a + 1, d + 1);
            mesh.triangles.emplace_back(a, d + 1, d);
        }
    }
    return mesh;
}

Vec4 tangent_at(const Attribute<Vec4f>& tangents, const Mesh& mesh, size_t triangle, int corner) {
    return Vec4(tangents.values[tangents.index(triangle, corner, mesh.triangles[triangle])]);
}
Vec3 direction(const Vec4& t) { return Vec3(t); }

/// u along x and v against y, as a picture hangs: the tangent is x, and cross(normal, tangent) is up, where v falls.
TEST(Tangents, OfAPictureOnAWall) {
    const Mesh mesh = grid(3, Transform(), [](const Vec2& p) { return Vec2(p.x, 1 - p.y); });
    const Attribute<Vec4f> tangents = make_tangents(mesh, 0);
    EXPECT_EQ(tangents.values.size(), 16u) << "one a vertex";
    for (const Vec4f& t : tangents.values) EXPECT_EQ(t, Vec4f(1, 0, 0, 1));
}

/// Any linear map from the plane to texture coordinates: the tangent follows u, w says on which side v falls.
TEST(Tangents, OfLinearMaps) {
    test::Draw draw(1);
    for (int round = 0; round < 200; ++round) {
        const Vec2 a(draw(-2, 2), draw(-2, 2)), b(draw(-2, 2), draw(-2, 2));   // u = a.p, v = b.p
        const double area = a.x * b.y - a.y * b.x;
        if (std::abs(area) < 0.1) continue;
        const Transform turn = Transform::rotate(draw.direction(), draw(-3, 3));
        const Mesh mesh = grid(2, turn, [&](const Vec2& p) { return Vec2(dot(a, p), dot(b, p)); });
        // dP/du and dP/dv: the columns of the inverse.
        const Vec3 along_u = turn.vector(normalized(Vec3(b.y, -b.x, 0) / area)), along_v = turn.vector(Vec3(-a.y, a.x, 0) / area);
        for (const Vec4f& value : make_tangents(mesh, 0).values) {
            const Vec4 t(value);
            ASSERT_LT(length(direction(t) - along_u), 1e-5);
            ASSERT_LT(dot(cross(turn.vector({0, 0, 1}), direction(t)) * t.w, along_v), 0) << "the bitangent points to falling v";
        }
    }
}

/// A picture mirrored at x = 1/2: the two halves do not share tangents along the seam, though position, normal and coordinates are equal there.
TEST(Tangents, SplitWhereThePictureIsMirrored) {
    const Mesh mesh = grid(2, Transform(), [](const Vec2& p) { return Vec2(std::abs(p.x - 0.5), 1 - p.y); });
    const Attribute<Vec4f> tangents = make_tangents(mesh, 0);
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
        const bool left = t / 2 % 2 == 0;
        for (int corner = 0; corner < 3; ++corner) EXPECT_EQ(tangent_at(tangents, mesh, t, corner), left ? Vec4(-1, 0, 0, -1) : Vec4(1, 0, 0, 1)) << t;
    }
}

/// Two triangles share an edge, with different directions of u: the shared corners take the average weighted by the angles there (45 and 90 degrees at
/// one end, 45 and 45 at the other).
TEST(Tangents, AreWeightedByTheAngle) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 1, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    mesh.normals.values.assign(4, Vec3f(0, 0, 1));
    mesh.uvs.resize(1);
    mesh.uvs[0].values = {{0, 1}, {1, 1}, {0, 0}, {-2, -1}};
    const Attribute<Vec4f> tangents = make_tangents(mesh, 0);
    // Triangle 1 has d(uv) = (0,-1) along (0,1) and (-2,-2) along (-1,1): dP/du = (0.5, 0.5).
    const Vec3 first(1, 0, 0), second = normalized(Vec3(1, 1, 0));
    const double right = kPi / 2, half = kPi / 4;
    EXPECT_LT(length(direction(tangent_at(tangents, mesh, 0, 0)) - normalized(first * right + second * half)), 1e-6);
    EXPECT_LT(length(direction(tangent_at(tangents, mesh, 1, 1)) - normalized(first * half + second * right)), 1e-6);
    EXPECT_LT(length(direction(tangent_at(tangents, mesh, 0, 1)) - first), 1e-6);
    EXPECT_LT(length(direction(tangent_at(tangents, mesh, 1, 2)) - second), 1e-6);
}

/// A wavy sheet with random texture coordinates, in the order of `order` and with each corner a vertex of its own if `apart`.
Mesh wavy(const std::vector<size_t>& order, bool apart) {
    test::Draw draw(5);
    Mesh mesh = grid(8, Transform::scale({3, 2, 1}), [&](const Vec2& p) { return Vec2(p.x + draw(-0.1, 0.1), p.y + draw(-0.1, 0.1)); });
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
        mesh.positions[i].z = float(draw(0, 0.3));
        mesh.normals.values[i] = Vec3f(normalized(Vec3(draw(-0.3, 0.3), draw(-0.3, 0.3), 1)));
    }
    Mesh out = mesh;
    for (size_t t = 0; t < order.size(); ++t) out.triangles[t] = mesh.triangles[order[t]];
    if (!apart) return out;
    Mesh loose;
    loose.uvs.resize(1);
    for (const Index3& t : out.triangles) {
        const auto first = uint32_t(loose.positions.size());
        for (int corner = 0; corner < 3; ++corner) {
            loose.positions.push_back(out.positions[t[corner]]);
            loose.normals.values.push_back(out.normals.values[t[corner]]);
            loose.uvs[0].values.push_back(out.uvs[0].values[t[corner]]);
        }
        loose.triangles.emplace_back(first, first + 1, first + 2);
    }
    return loose;
}

/// The order of triangles and whether vertices are shared do not count: what makes the tangents that were baked the tangents that are rendered.
TEST(Tangents, DoNotDependOnOrderOrIndexing) {
    std::vector<size_t> order(128), reversed(128);
    for (size_t i = 0; i < 128; ++i) order[i] = i, reversed[i] = 127 - i;
    const Mesh mesh = wavy(order, false);
    const Attribute<Vec4f> want = make_tangents(mesh, 0);
    EXPECT_GT(want.values.size(), 80u);
    for (const bool apart : {false, true}) {
        const Mesh other = wavy(reversed, apart);
        const Attribute<Vec4f> got = make_tangents(other, 0);
        for (size_t t = 0; t < 128; ++t)
            for (int corner = 0; corner < 3; ++corner) {
                const Vec4 a = tangent_at(want, mesh, t, corner), b = tangent_at(got, other, 127 - t, corner);
                ASSERT_LT(length(direction(a) - direction(b)), 1e-6) << t << ' ' << corner;
                ASSERT_EQ(a.w, b.w);
            }
    }
}

TEST(Tangents, AreUnitAndPerpendicular) {
    std::vector<size_t> order(128);
    for (size_t i = 0; i < 128; ++i) order[i] = i;
    const Mesh mesh = wavy(order, false);
    const Attribute<Vec4f> tangents = make_tangents(mesh, 0);
    for (size_t t = 0; t < mesh.triangles.size(); ++t)
        for (int corner = 0; corner < 3; ++corner) {
            const Vec3 d = direction(tangent_at(tangents, mesh, t, corner));
            EXPECT_NEAR(length(d), 1, 1e-6);
            EXPECT_NEAR(dot(d, Vec3(mesh.normals.values[mesh.triangles[t][corner]])), 0, 1e-6);
        }
}

/// Triangles without length or without area in the picture take the tangent of their neighbours, on either side of a mirror; alone, any.
TEST(Tangents, OfDegenerateTriangles) {
    Mesh mesh = grid(1, Transform(), [](const Vec2& p) { return Vec2(p.x, 1 - p.y); });
    mesh.triangles.emplace_back(0, 1, 1);   // no area
    mesh.positions.emplace_back(0.5f, -1, 0);
    mesh.normals.values.emplace_back(0, 0, 1);
    mesh.uvs[0].values.emplace_back(0.5f, 1);   // in line with vertices 0 and 1: no area in the picture
    mesh.triangles.emplace_back(1, 0, 4);
    const Attribute<Vec4f> tangents = make_tangents(mesh, 0);
    for (const size_t triangle : {2, 3})
        for (int corner = 0; corner < 2; ++corner) EXPECT_EQ(tangent_at(tangents, mesh, triangle, corner), Vec4(1, 0, 0, 1)) << triangle;
    EXPECT_NEAR(length(direction(tangent_at(tangents, mesh, 3, 2))), 1, 1e-6);
    mesh.uvs[0].values.assign(5, Vec2f(0.5f));
    for (const Vec4f& t : make_tangents(mesh, 0).values) {
        EXPECT_NEAR(length(direction(Vec4(t))), 1, 1e-6);
        EXPECT_NEAR(t.z, 0, 1e-6) << "perpendicular to the normal";
    }
    mesh.positions[2].x = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(make_tangents(mesh, 0).corners.size(), 12u) << "no crash";
    mesh.triangles.clear();
    EXPECT_TRUE(make_tangents(mesh, 0).values.empty());
}

/// Without normals each triangle has its own; those in one plane share them.
TEST(Tangents, OfAFlatMesh) {
    Mesh mesh = grid(1, Transform(), [](const Vec2& p) { return Vec2(p.x, 1 - p.y); });
    mesh.normals = {};
    EXPECT_EQ(make_tangents(mesh, 0).values.size(), 4u);
    mesh.positions[2].z = 1;   // folded along the diagonal
    const Attribute<Vec4f> tangents = make_tangents(mesh, 0);
    EXPECT_EQ(tangents.values.size(), 6u);
    for (const Vec4f& t : tangents.values) EXPECT_NEAR(length(direction(Vec4(t))), 1, 1e-6);
}

}  // namespace
}  // namespace alidade
