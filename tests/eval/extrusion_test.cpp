// SPDX-License-Identifier: Apache-2.0
#include "tests/eval/crossings.h"
#include "tests/eval/shape_samples.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

using test::crossings;
using test::expect_at;

/// Straight sides.
Outline box(double low, double high) {
    const Vec2 a(low, low), b(high, low), c(high, high), d(low, high);
    return {{a, a, b, b, c, c, d, d}};
}

Outline reversed(const Outline& o) {
    Outline out;
    for (size_t i = o.points.size(); i > 0; i -= 2) {
        const Vec2 from = o.points[i == o.points.size() ? 0 : i], control = o.points[i - 1], to = o.points[i - 2];
        out.points.push_back(from), out.points.push_back(control == to ? from : control);
    }
    return out;
}

TEST(Extrusion, CapsAndSides) {
    const Extrusion e{{box(0, 3), reversed(box(1, 2))}, 0, 2, false};
    expect_at(crossings(e, Vec3(0.5, 0.5, -5), Vec3(0, 0, 1)), {5, 7});
    expect_at(crossings(e, Vec3(1.5, 1.5, -5), Vec3(0, 0, 1)), {});
    expect_at(crossings(e, Vec3(-1, 1.5, 1), Vec3(1, 0, 0)), {1, 2, 3, 4});
    expect_at(crossings(e, Vec3(-1, 1.5, 2.5), Vec3(1, 0, 0)), {});
    expect_at(crossings(e, Vec3(-1, 0.5, -0.5), Vec3(1, 0, 1)), {1, 2.5});
    EXPECT_EQ(find_shape(e)->surface(e, Vec3(0, 1.5, 1), crossings(e, Vec3(-1, 1.5, 1), Vec3(1, 0, 0)).at[0].part).normal, Vec3(-1, 0, 0));
    EXPECT_EQ(find_shape(e)->surface(e, Vec3(1, 1.5, 1), crossings(e, Vec3(-1, 1.5, 1), Vec3(1, 0, 0)).at[1].part).normal, Vec3(1, 0, 0));
}

/// Two letters' parts that overlap: wound around, they are one; by turns, they leave a hole.
TEST(Extrusion, WindingAndTurns) {
    for (const bool even_odd : {false, true}) {
        const Extrusion e{{box(0, 2), box(1, 3)}, 1, -1, even_odd};
        EXPECT_EQ(find_shape(e)->inside(e, Vec3(1.5, 1.5, 0)), !even_odd);
        EXPECT_EQ(crossings(e, Vec3(-1, 1.5, 0), Vec3(1, 0, 0)).count, even_odd ? 4 : 2);
        EXPECT_EQ(crossings(e, Vec3(1.5, 1.5, -5), Vec3(0, 0, 1)).count, even_odd ? 0 : 2);
    }
}

/// A parabola from (-1, 0) over the control point (0, 2) to (1, 0), closed by a line: y = 1 - x^2.
TEST(Extrusion, ArcsAreExact) {
    const Extrusion e{{{{Vec2(-1, 0), Vec2(0, 2), Vec2(1, 0), Vec2(1, 0)}}}, 0, 1, false};
    for (int i = 1; i < 10; ++i) {
        const double y = 0.1 * i, x = std::sqrt(1 - y);
        expect_at(crossings(e, Vec3(-3, y, 0.5), Vec3(1, 0, 0)), {3 - x, 3 + x});
        const Vec3 normal = find_shape(e)->surface(e, Vec3(x, y, 0.5), crossings(e, Vec3(-3, y, 0.5), Vec3(1, 0, 0)).at[1].part).normal;
        EXPECT_LT(length(normal - normalized(Vec3(2 * x, 1, 0))), 1e-14);
    }
    expect_at(crossings(e, Vec3(-3, 1 + 1e-9, 0.5), Vec3(1, 0, 0)), {});
    expect_at(crossings(e, Vec3(0.5, 5, 0.5), Vec3(0, -1, 0)), {4.25, 5});
}

/// A star of many rays: more crossings than a list holds without memory of its own, all of them in order and in pairs.
TEST(Extrusion, CombsHaveManyCrossings) {
    std::vector<Vec2> corners{{59, 0}, {0, 0}};
    for (int i = 0; i < 30; ++i) {
        const double x = 2 * i;
        for (const Vec2& p : {Vec2(x, 1), Vec2(x, 4), Vec2(x + 1, 4), Vec2(x + 1, 1)}) corners.push_back(p);
    }
    Outline comb;
    for (const Vec2& p : corners) comb.points.push_back(p), comb.points.push_back(p);
    const Extrusion e{{comb}, 0, 1, false};
    const Crossings got = crossings(e, Vec3(-1, 2, 0.5), Vec3(1, 0, 0));
    ASSERT_EQ(got.count, 60);
    const Crossings copy = got;
    for (int i = 0; i < 60; ++i) EXPECT_NEAR(copy.at[i].t, i + 1, 1e-13);
}

/// Lines through corners neither slip in nor out.
TEST(Extrusion, CornersPair) {
    const Extrusion e{{box(0, 1)}, 0, 1, false};
    for (const Vec2& corner : {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)})
        for (int i = 0; i < 64; ++i) {
            const double angle = 2 * kPi * i / 64;
            const Vec3 dir(std::cos(angle), std::sin(angle), 0.01);
            EXPECT_EQ(crossings(e, Vec3(corner.x, corner.y, 0.5) - 3.0 * dir, dir).count % 2, 0) << i;
        }
}

TEST(Extrusion, BrokenPointsAndRaysAreHarmless) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Extrusion broken{{{{Vec2(0, 0), Vec2(nan, 1), Vec2(1, 0), Vec2(1, nan), Vec2(nan, nan), Vec2(0, 1)}}}, 0, 1, false}, none{{}, 0, 1, false};
    for (const Vec3& dir : {Vec3(0, 0, 1), Vec3(1, 0.1, 0), Vec3(1e-200, 0, 1), Vec3(1e-200, 1e-200, 1e-200), Vec3(1e150, 0, 1)}) {
        const Crossings got = crossings(broken, Vec3(0.2, 0.2, 0.3), dir);
        for (int i = 0; i < got.count; ++i) EXPECT_FALSE(std::isnan(got.at[i].t));
        EXPECT_EQ(crossings(none, Vec3(0.2, 0.2, 0.3), dir).count, 0);
    }
    expect_at(crossings(Extrusion{{box(0, 1)}, 0, 1, false}, Vec3(0.5, 0.5, -1), Vec3(1e-200, 0, 1)), {1, 2});
    EXPECT_EQ(crossings(Extrusion{{box(0, 1)}, 0, 1, false}, Vec3(-1e-30, 0.5, 0.5), Vec3(1e-30, 0, 0)).count, 2);
}

#ifdef ALIDADE_HAS_QUAD
/// t against the exact distance from the surface, which a step along the ray changes by the cosine.
TEST(Extrusion, CrossingsAgainst113Bits) {
    test::Draw draw(74);
    double worst = 0;
    int hits = 0;
    for (int i = 0; i < 3000; ++i) {
        Extrusion e;
        test::randomize(e, draw);
        const Ray ray = test::ray_from(draw.decades(0, 8), draw);
        const Crossings got = find_shape(e)->crossings(e, ray);
        for (int k = 0; k < got.count; ++k, ++hits) {
            const double off = double(test::distance(e, test::QuadVec(ray.origin) + test::Quad(got.at[k].t) * test::QuadVec(ray.dir), got.at[k].part));
            worst = std::max(worst, off / (std::numeric_limits<double>::epsilon() * (std::abs(got.at[k].t) * length(ray.dir) + 4)));
        }
    }
    EXPECT_GT(hits, 2000);
    std::printf("[          ] %.2f eps (|t| + size / |d|) / cosine\n", worst);
    EXPECT_LT(worst, 8);
}
#endif

}  // namespace
}  // namespace alidade
