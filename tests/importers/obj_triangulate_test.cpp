// SPDX-License-Identifier: Apache-2.0
/// Polygons cut into triangles. The oracle: the triangles' areas are positive and sum to the polygon's, so that they neither overlap nor leave the polygon;
/// and every random point is in as many triangles as the polygon winds around it.
#include "importers/mesh/triangulate.h"

#include <gtest/gtest.h>

#include <random>

namespace alidade::mesh {
namespace {

double signed_area(const Vec2& a, const Vec2& b, const Vec2& c) { return 0.5 * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)); }

/// By the crossing rule, for points on no edge.
bool is_inside(const std::vector<Vec2>& polygon, const Vec2& p) {
    bool inside = false;
    for (size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++)
        if ((polygon[i].y > p.y) != (polygon[j].y > p.y) &&
            p.x < (polygon[j].x - polygon[i].x) * (p.y - polygon[i].y) / (polygon[j].y - polygon[i].y) + polygon[i].x)
            inside = !inside;
    return inside;
}

/// Lays the polygon into a tilted plane, cuts it, and checks the cut in the plane again.
void expect_exact_cut(const std::vector<Vec2>& polygon, const char* what) {
    SCOPED_TRACE(what);
    const Vec3 frames[][2] = {{Vec3(1, 0, 0), Vec3(0, 1, 0)}, {Vec3(0, 1, 0), Vec3(1, 0, 0)}, {Vec3(0, 0.6, 0.8), Vec3(1, 0, 0)}, {Vec3(0.6, 0, -0.8), Vec3(0, 1, 0)}};
    for (const auto& frame : frames) {
        std::vector<Vec3> points;
        for (const Vec2& p : polygon) points.push_back(p.x * frame[0] + p.y * frame[1] + Vec3(3, -5, 7));
        std::vector<Index3> triangles;
        ASSERT_TRUE(Triangulator().triangulate(points, triangles));
        ASSERT_EQ(triangles.size(), polygon.size() - 2);

        double want = 0, got = 0;
        for (size_t i = 1; i + 1 < polygon.size(); ++i) want += signed_area(polygon[0], polygon[i], polygon[i + 1]);
        for (const Index3& t : triangles) {
            const double area = signed_area(polygon[t.x], polygon[t.y], polygon[t.z]);
            ASSERT_GT(area * want, 0) << "a triangle is turned over or flat";
            got += area;
        }
        ASSERT_NEAR(got, want, 1e-9 * std::abs(want));

        std::mt19937 random(7);
        std::uniform_real_distribution<double> anywhere(-2.1, 2.1);
        for (int i = 0; i < 200; ++i) {
            const Vec2 p(anywhere(random), anywhere(random));
            int covers = 0;
            for (const Index3& t : triangles) covers += is_inside({polygon[t.x], polygon[t.y], polygon[t.z]}, p);
            ASSERT_EQ(covers, int(is_inside(polygon, p))) << p.x << " " << p.y;
        }
    }
}

TEST(Triangulation, OfShapesThatAFanGetsWrong) {
    expect_exact_cut({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, "square");
    expect_exact_cut({{0, 0}, {2, 0}, {2, 2}, {1, 0.5}, {0, 2}}, "the pentagon whose fan has a negative area");
    expect_exact_cut({{0, 0}, {1, 0}, {0.2, 0.2}, {0, 1}}, "arrow head, by the diagonal from its notch");
    expect_exact_cut({{0.2, 0.2}, {0, 1}, {0, 0}, {1, 0}}, "the same from its notch");
    expect_exact_cut({{0, 0}, {2, 0}, {2, 2}, {1.5, 2}, {1.5, 0.5}, {0.5, 0.5}, {0.5, 2}, {0, 2}}, "U");
    expect_exact_cut({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}, "square with a corner in the middle of each side");
    expect_exact_cut({{0, 0}, {1, 0}, {1, 0.4}, {0.5, 0.4}, {0.5, 0.6}, {1, 0.6}, {1, 1}, {0, 1}}, "C");
    // A hole, joined by a bridge that is walked both ways: some corners stand at the same place.
    expect_exact_cut({{-2, -2}, {2, -2}, {2, 2}, {-2, 2}, {-2, -2}, {-1, -1}, {-1, 1}, {1, 1}, {1, -1}, {-1, -1}}, "frame");
}

/// Any set of radii around a centre makes a simple polygon.
TEST(Triangulation, OfRandomStars) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> radius(0.05, 2);
    for (int n : {4, 5, 6, 9, 17, 64}) {
        for (int round = 0; round < 25; ++round) {
            std::vector<Vec2> polygon;
            for (int i = 0; i < n; ++i) {
                const double r = radius(random), angle = 2 * kPi * i / n;
                polygon.emplace_back(r * std::cos(angle), r * std::sin(angle));
            }
            std::rotate(polygon.begin(), polygon.begin() + round % n, polygon.end());
            expect_exact_cut(polygon, "star");
        }
    }
}

/// A comb has teeth that no fan from anywhere covers; a spiral hides its ears.
TEST(Triangulation, OfCombsAndSpirals) {
    std::vector<Vec2> comb = {{2, -1}, {2, -0.9}};
    for (int i = 0; i < 20; ++i) comb.emplace_back(1.9 - 0.2 * i, 1), comb.emplace_back(1.8 - 0.2 * i, -0.9);
    comb.emplace_back(-2, -1);
    expect_exact_cut(comb, "comb");
    std::vector<Vec2> spiral;
    for (int i = 0; i <= 60; ++i) spiral.emplace_back((0.2 + 0.03 * i) * std::cos(0.3 * i), (0.2 + 0.03 * i) * std::sin(0.3 * i));
    for (int i = 60; i >= 0; --i) spiral.emplace_back((0.1 + 0.03 * i) * std::cos(0.3 * i), (0.1 + 0.03 * i) * std::sin(0.3 * i));
    expect_exact_cut(spiral, "spiral");
    std::reverse(spiral.begin(), spiral.end());
    expect_exact_cut(spiral, "spiral, clockwise");
}

TEST(Triangulation, OfWhatIsNotSimpleEndsAndSaysSo) {
    const std::vector<std::vector<Vec3>> polygons = {
        {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}},                              // bow tie
        {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}},                   // a point
        {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}},                              // a line
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},   // twice around
    };
    for (size_t i = 0; i < polygons.size(); ++i) {
        std::vector<Index3> triangles;
        EXPECT_FALSE(Triangulator().triangulate(polygons[i], triangles)) << i;
        EXPECT_EQ(triangles.size(), polygons[i].size() - 2) << i;
        for (const Index3& t : triangles) EXPECT_LT(std::max({t.x, t.y, t.z}), polygons[i].size()) << i;
    }
}

/// A convex polygon of any size is a fan: no quadratic time.
TEST(Triangulation, OfConvexPolygonsIsAFan) {
    std::vector<Vec3> circle;
    for (int i = 0; i < 100000; ++i) circle.emplace_back(1000 * std::cos(2 * kPi * i / 100000), 1000 * std::sin(2 * kPi * i / 100000), 5);
    std::vector<Index3> triangles;
    EXPECT_TRUE(Triangulator().triangulate(circle, triangles));
    for (const Index3& t : triangles) ASSERT_EQ(t.x, 0u);
}

}  // namespace
}  // namespace alidade::mesh
