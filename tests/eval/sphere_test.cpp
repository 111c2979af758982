// SPDX-License-Identifier: Apache-2.0
#include "tests/eval/shape_samples.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

Crossings crossings(const Sphere& s, const Ray& ray) { return find_shape(s)->crossings(s, ray); }

Ray ray(const Vec3& origin, const Vec3& dir) {
    Ray r;
    r.origin = origin, r.dir = dir;
    return r;
}

TEST(Sphere, OfTheLecture) {
    const Crossings c = crossings({Vec3(0, 0, 5), 2}, ray(Vec3(0), Vec3(0, 0, 0.5)));
    ASSERT_EQ(c.count, 2);
    EXPECT_EQ(c.at[0].t, 6);
    EXPECT_EQ(c.at[1].t, 14);
}

TEST(Sphere, ANegativeRadiusDrawsAsAPositiveOne) {
    const Crossings c = crossings({Vec3(0, 0, 5), -2}, ray(Vec3(0), Vec3(0, 0, 1)));
    ASSERT_EQ(c.count, 2);
    EXPECT_EQ(c.at[0].t, 3);
    EXPECT_TRUE(find_shape(Sphere())->inside(Sphere{Vec3(0), -1}, Vec3(0.5)));
}

/// A tangent is met twice at one t, whichever way it is approached: entries and exits pair.
TEST(Sphere, TangentsAreTwiceOrNotAtAll) {
    const Crossings c = crossings({Vec3(0), 1}, ray(Vec3(1, 0, -5), Vec3(0, 0, 1)));
    ASSERT_EQ(c.count, 2);
    EXPECT_EQ(c.at[0].t, c.at[1].t);
    EXPECT_EQ(crossings({Vec3(0), 1}, ray(Vec3(std::nextafter(1.0, 2.0), 0, -5), Vec3(0, 0, 1))).count, 0);
    test::Draw draw(50);
    for (int i = 0; i < 10000; ++i) {
        const Vec3 dir = draw.direction();
        Vec3 side, up;
        orthonormal_basis(dir, side, up);
        ASSERT_NE(crossings({Vec3(0), 1}, ray(side - 5.0 * dir, dir)).count, 1);
    }
}

/// From 1e12 radii away the first shift is rounded by 1e-4 radii: only the second one lets a silhouette be decided.
TEST(Sphere, TheSilhouetteIsSharpFromTrillionsOfRadii) {
    test::Draw draw(54);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 dir(0, 0, draw(0.1, 10));   // parallel to an axis: the distance of the line from the centre is exact
        for (const double depth : {1e-14, 1e-12, 1e-9}) {
            ASSERT_EQ(crossings({Vec3(0), 1}, ray(Vec3(1 - depth, 0, -1e12), dir)).count, 2) << depth;
            ASSERT_EQ(crossings({Vec3(0), 1}, ray(Vec3(1 + depth, 0, -1e12), dir)).count, 0) << depth;
        }
    }
}

/// As pixels of POV-Ray 3.7.0.10 renders of sphere { 0, 1 } with uv_mapping show them.
TEST(Sphere, TextureCoordinatesAroundTheEquatorAndAtThePoles) {
    const ShapeOps& ops = *find_shape(Sphere());
    const Sphere s{Vec3(1, 2, 3), 2};
    const auto uv = [&](const Vec3& dir) { return ops.surface(s, s.center + 2.0 * dir, 0).uv; };
    EXPECT_EQ(uv({1, 0, 0}), Vec2(0, 0.5));
    EXPECT_EQ(uv({0, 0, 1}), Vec2(0.25, 0.5));
    EXPECT_EQ(uv({-1, 0, 0}), Vec2(0.5, 0.5));
    EXPECT_EQ(uv({0, 0, -1}), Vec2(0.75, 0.5));
    EXPECT_EQ(uv({0, 1, 0}), Vec2(0, 1));
    EXPECT_EQ(uv({0, -1, 0}), Vec2(0, 0));
    EXPECT_GT(length(ops.surface(s, s.center + Vec3(0, 2, 0), 0).dpdu), 1) << "a pole has tangents too";
}

#ifdef ALIDADE_HAS_QUAD

using test::Quad;
using test::QuadVec;

/// The crossings in 113 bits; false if the ray misses.
bool exact_crossings(const Sphere& s, const Ray& r, Quad (&t)[2]) {
    const QuadVec origin = QuadVec(r.origin) - QuadVec(s.center), dir(r.dir);
    const Quad a = dot(dir, dir), shift = -dot(origin, dir) / a;
    const QuadVec nearest = origin + shift * dir;
    const Quad square = Quad(s.radius) * Quad(s.radius) - dot(nearest, nearest);
    if (square < 0) return false;
    const Quad half = sqrtq(square / a);
    t[0] = shift - half, t[1] = shift + half;
    return true;
}

/// A ray from `distance` radii away whose line passes the centre at `impact` radii.
Ray aimed(const Sphere& s, double distance, double impact, test::Draw& draw) {
    const Vec3 dir = draw.direction();
    Vec3 side, up;
    orthonormal_basis(dir, side, up);
    const double angle = draw(0, 2 * kPi);
    const Vec3 beside = std::cos(angle) * side + std::sin(angle) * up;
    return ray(s.center + std::abs(s.radius) * (impact * beside - distance * dir), dir * draw(0.1, 10));
}

/// The larger error of the two crossings: in ulp of t, in radii, and in what half a chord this short leaves of it.
struct TError {
    double ulp = 0, radii = 0, of_bound = 0;
    bool missed = false;
};

/// The square root turns an error of 4 roundings of the radius into 4 epsilon / half chord; t itself is rounded at the distance.
TError t_error(const Sphere& s, const Ray& r) {
    TError e;
    Quad want[2];
    const bool hit = exact_crossings(s, r, want);
    const Crossings got = crossings(s, r);
    e.missed = hit != (got.count == 2);
    if (!hit || e.missed) return e;
    const double to_radii = length(r.dir) / std::abs(s.radius), half = 0.5 * double(want[1] - want[0]) * to_radii;
    for (int i = 0; i < 2; ++i) {
        const double radii = double(fabsq(Quad(got.at[i].t) - want[i])) * to_radii;
        const double bound = std::numeric_limits<double>::epsilon() * (std::abs(got.at[i].t) * to_radii + 4 / half);
        e.ulp = std::max(e.ulp, test::ulps(got.at[i].t, want[i]));
        e.radii = std::max(e.radii, radii);
        e.of_bound = std::max(e.of_bound, radii / bound);
    }
    return e;
}

/// Rays that pass within 0.99 radii of the centre, which may itself be far from 0.
TEST(Sphere, CrossingsFromFarAgainst113Bits) {
    test::Draw draw(51);
    for (const double distance : {4.0, 1e2, 1e4, 1e6, 1e8}) {
        double worst = 0;
        int wrong = 0;
        for (int i = 0; i < 50000; ++i) {
            const Sphere s{draw.vector(draw.decades(-3, 8)), draw.decades(-3, 3)};
            const TError e = t_error(s, aimed(s, distance, 0.99 * std::sqrt(draw(0, 1)), draw));
            wrong += e.missed;
            worst = std::max(worst, e.ulp);
        }
        std::printf("[          ] %g radii away: t within %.2f ulp\n", distance, worst);
        EXPECT_LE(worst, 4) << distance;
        EXPECT_EQ(wrong, 0) << distance;
    }
}

/// Rays that pass about `depth` radii inside the silhouette: from far away their own rounding moves them by more than that, so the bound is taken from
/// the chord that they really have.
TEST(Sphere, TangentsAgainst113Bits) {
    test::Draw draw(52);
    for (const double distance : {4.0, 1e4, 1e6}) {
        for (const double depth : {1e-3, 1e-6, 1e-9, 1e-12}) {
            TError worst;
            int wrong = 0;
            for (int i = 0; i < 20000; ++i) {
                const Sphere s{Vec3(0), draw.decades(-3, 3)};
                const TError e = t_error(s, aimed(s, distance, 1 - depth, draw));
                wrong += e.missed;
                worst.radii = std::max(worst.radii, e.radii);
                worst.of_bound = std::max(worst.of_bound, e.of_bound);
            }
            std::printf("[          ] depth %g from %g radii: t within %.2g radii, %.2f of the bound\n", depth, distance, worst.radii, worst.of_bound);
            EXPECT_LE(worst.of_bound, 1) << depth << " from " << distance;
            EXPECT_EQ(wrong, 0) << depth << " from " << distance;
        }
    }
}

/// Hit or miss is decided as in exact arithmetic, but for rays within a few roundings of the silhouette.
TEST(Sphere, HitOrMissIsExactOutsideARoundingOfTheSilhouette) {
    test::Draw draw(53);
    const double epsilon = std::numeric_limits<double>::epsilon();
    for (const double distance : {4.0, 1e4, 1e8}) {
        for (int i = 0; i < 20000; ++i) {
            const Sphere s{draw.vector(), draw.decades(-3, 3)};
            const Ray r = aimed(s, distance, 1 + draw.sign() * epsilon * draw.decades(0, 4), draw);
            const QuadVec origin = QuadVec(r.origin) - QuadVec(s.center), dir(r.dir);
            const Quad pass = length(cross(origin, dir)) / length(dir) / Quad(s.radius);   // where the rounded ray really passes, in radii
            if (fabsq(pass - 1) < 4 * epsilon) continue;
            ASSERT_EQ(crossings(s, r).count > 0, pass < 1) << double(pass - 1) << " from " << distance;
        }
    }
}

#endif

}  // namespace
}  // namespace alidade
