// SPDX-License-Identifier: Apache-2.0
/// Cylinders and cones.
#include "eval/shapes/frustum.h"
#include "tests/eval/crossings.h"
#include "tests/eval/shape_samples.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

using test::crossings;

struct Expected {
    double t;
    uint32_t part;
};
void expect_parts(const Crossings& got, std::initializer_list<Expected> want) {
    ASSERT_EQ(size_t(got.count), want.size());
    int i = 0;
    for (const Expected& e : want) {
        EXPECT_DOUBLE_EQ(got.at[i].t, e.t);
        EXPECT_EQ(got.at[i].part, e.part);
        ++i;
    }
}

TEST(Cylinder, SideAndCaps) {
    const Cylinder c{Vec3(0), Vec3(0, 4, 0), 2, false};
    expect_parts(crossings(c, Vec3(-5, 1, 0), Vec3(0.5, 0, 0)), {{6, 0}, {14, 0}});
    expect_parts(crossings(c, Vec3(1, -1, 0), Vec3(0, 1, 0)), {{1, 1}, {5, 2}});
    expect_parts(crossings(c, Vec3(1, 6, 0), Vec3(0, -1, 0)), {{2, 2}, {6, 1}});
    expect_parts(crossings(c, Vec3(0, -1, 0), Vec3(1, 1, 0)), {{1, 1}, {2, 0}});
    expect_parts(crossings(c, Vec3(3, -1, 0), Vec3(0, 1, 0)), {});
    expect_parts(crossings(c, Vec3(-5, 5, 0), Vec3(1, 0, 0)), {});
}

TEST(Cylinder, AnOpenOneHasNoCapsButTheSameInside) {
    const Cylinder c{Vec3(0), Vec3(0, 4, 0), -2, true};
    expect_parts(crossings(c, Vec3(1, -1, 0), Vec3(0, 1, 0)), {});
    expect_parts(crossings(c, Vec3(0, -1, 0), Vec3(1, 1, 0)), {{2, 0}});
    EXPECT_TRUE(find_shape(c)->inside(c, Vec3(1, 2, 1)));
    EXPECT_FALSE(find_shape(c)->inside(c, Vec3(1, 5, 1)));
    EXPECT_FALSE(find_shape(c)->solid(c));
    EXPECT_TRUE(find_shape(c)->solid(Cylinder()));
}

TEST(Cone, SideTipAndCaps) {
    const Cone c{Vec3(0), Vec3(0, 2, 0), 2, 0, false};
    expect_parts(crossings(c, Vec3(-5, 1, 0), Vec3(1, 0, 0)), {{4, 0}, {6, 0}});
    expect_parts(crossings(c, Vec3(1, 5, 0), Vec3(0, -1, 0)), {{4, 0}, {5, 1}});
    expect_parts(crossings(c, Vec3(-1, -1, 0), Vec3(1, 1, 0)), {{1, 1}, {2, 0}});   // parallel to a line of the side
    expect_parts(crossings(c, Vec3(-5, 3, 0), Vec3(1, 0, 0)), {});                  // the other half, beyond the tip
}

TEST(Cone, RadiiOfDifferentSignsMakeTwoCones) {
    const Cone c{Vec3(0, -1, 0), Vec3(0, 1, 0), -1, 1, false};
    expect_parts(crossings(c, Vec3(0.5, -2, 0), Vec3(0, 1, 0)), {{1, 1}, {1.5, 0}, {2.5, 0}, {3, 2}});
    expect_parts(crossings(c, Vec3(-5, 0.5, 0), Vec3(1, 0, 0)), {{4.5, 0}, {5.5, 0}});
    EXPECT_TRUE(find_shape(c)->inside(c, Vec3(0.4, -0.5, 0)));
    EXPECT_FALSE(find_shape(c)->inside(c, Vec3(0.4, 0.1, 0)));
}

TEST(Cone, NegativeRadiiOfBothEndsDrawAsPositiveOnes) {
    expect_parts(crossings(Cone{Vec3(0), Vec3(0, 2, 0), -2, -1, false}, Vec3(-5, 0, 0), Vec3(1, 0, 0)), {{3, 0}, {7, 0}});
}

TEST(Cone, WithoutLengthNothingIsHit) {
    expect_parts(crossings(Cone{Vec3(1), Vec3(1), 1, 1, false}, Vec3(1, 1, -5), Vec3(0, 0, 1)), {});
    expect_parts(crossings(Cylinder{Vec3(1), Vec3(1), 1, false}, Vec3(1, 1, -5), Vec3(0, 0, 1)), {});
}

#ifdef ALIDADE_HAS_QUAD

using test::Quad;
using test::QuadVec;

/// The roots of the infinite side by the schoolbook formula, in 113 bits.
std::vector<Quad> exact_side(const Cone& c, const Ray& ray) {
    const QuadVec axis = QuadVec(c.b) - QuadVec(c.a), o = QuadVec(ray.origin) - QuadVec(c.a), d(ray.dir);
    const Quad size = length(axis), slope = (Quad(c.radius_b) - Quad(c.radius_a)) / size;
    const QuadVec w = (1 / size) * axis;
    const QuadVec q0 = o - dot(o, w) * w, q1 = d - dot(d, w) * w;
    const Quad r0 = Quad(c.radius_a) + slope * dot(o, w), r1 = slope * dot(d, w);
    const Quad a = dot(q1, q1) - r1 * r1, b = dot(q0, q1) - r0 * r1, e = dot(q0, q0) - r0 * r0, disc = b * b - a * e;
    if (disc < 0) return {};
    return {(-b - sqrtq(disc)) / a, (-b + sqrtq(disc)) / a};
}

/// Every crossing of the side is one of the exact roots, as near as its angle lets it be.
TEST(Frustum, DistancesAgainst113Bits) {
    test::Draw draw(61);
    for (const double distance : {4.0, 100.0, 1e4, 1e8}) {
        double worst = 0;
        int hits = 0;
        for (int i = 0; i < 30000; ++i) {
            Cone c;
            test::randomize(c, draw);
            if (i % 2) c.radius_b = c.radius_a;   // a cylinder
            const ShapeGeometry shape = i % 2 ? ShapeGeometry(Cylinder{c.a, c.b, c.radius_a, c.open}) : ShapeGeometry(c);
            const ShapeOps& ops = *find_shape(shape);
            const Ray ray = test::ray_from(distance, draw);
            const Crossings got = ops.crossings(shape, ray);
            const std::vector<Quad> want = exact_side(c, ray);
            for (int k = 0; k < got.count; ++k) {
                if (got.at[k].part != 0) continue;
                const double cosine = std::abs(dot(ops.surface(shape, ray.at(got.at[k].t), 0).normal, normalized(ray.dir)));
                if (cosine < 0.05) continue;
                Quad nearest = 1e30;
                for (const Quad t : want) nearest = std::min(nearest, fabsq(t - Quad(got.at[k].t)));
                const double unit = std::numeric_limits<double>::epsilon() * (std::abs(got.at[k].t) + 4 / length(ray.dir));
                worst = std::max(worst, double(nearest) / unit * cosine);
                ++hits;
            }
        }
        EXPECT_GT(hits, 5000);
        std::printf("[          ] from %g: %.2f eps (|t| + 4 / |d|) / cosine\n", distance, worst);
        EXPECT_LT(worst, 4);
    }
}

/// Rays beside the infinite cylinder around a frustum, from near to far, at all scales: one that is told to pass it does, and at usual scales those that pass it clearly are told.
TEST(Frustum, WhatSurelyPassesDoesPass) {
    test::Draw draw(62);
    int told = 0, clear = 0, clear_told = 0, near = 0;
    for (int i = 0; i < 200000; ++i) {
        Cone c;
        test::randomize(c, draw);
        const double radius = std::max(std::abs(c.radius_a), std::abs(c.radius_b));
        Ray ray = test::ray_from(std::pow(10.0, 2 * (i % 9)), draw);
        const QuadVec across = cross(QuadVec(ray.dir), QuadVec(c.b) - QuadVec(c.a)), apart = (1 / length(across)) * across;
        const auto distance = [&] { return dot(QuadVec(ray.origin) - QuadVec(c.a), apart); };
        if (i % 3 == 0)   // almost a tangent
            ray.origin += double(Quad((1 + 1e-7 * (i % 7 - 3)) * radius) - distance()) * Vec3(double(apart.x), double(apart.y), double(apart.z));
        const double parts = double(fabsq(distance()) / Quad(radius)), scale = std::ldexp(1.0, i % 5 == 0 ? 150 * (i % 9 - 4) : 0);
        const bool passes = surely_passes(scale * c.a, scale * c.b, scale * radius, {scale * ray.origin, scale * ray.dir, ray.tmin, ray.tmax});
        EXPECT_TRUE(!passes || parts > 1) << i;
        told += passes, near += std::abs(parts - 1) < 1e-6;
        if (scale == 1 && parts > 1.01 && i % 9 < 4) ++clear, clear_told += passes;
    }
    EXPECT_GT(told, 20000);
    EXPECT_GT(near, 10000);
    EXPECT_EQ(clear_told, clear);
}

/// Tangents at depths down to 1e-9: two crossings, or none outside.
TEST(Frustum, TheSilhouetteIsSharp) {
    for (const double distance : {4.0, 1e4, 1e8})
        for (const double depth : {1e-3, 1e-6, 1e-9}) {
            EXPECT_EQ(crossings(Cylinder{Vec3(0), Vec3(0, 4, 0), 1, false}, Vec3(1 - depth, 2, -distance), Vec3(0, 0, 1)).count, 2);
            EXPECT_EQ(crossings(Cylinder{Vec3(0), Vec3(0, 4, 0), 1, false}, Vec3(1 + depth, 2, -distance), Vec3(0, 0, 1)).count, 0);
            EXPECT_EQ(crossings(Cone{Vec3(0), Vec3(0, 4, 0), 2, 0, false}, Vec3(1 - depth, 2, -distance), Vec3(0, 0, 1)).count, 2);
            EXPECT_EQ(crossings(Cone{Vec3(0), Vec3(0, 4, 0), 2, 0, false}, Vec3(1 + depth, 2, -distance), Vec3(0, 0, 1)).count, 0);
        }
}
#endif

}  // namespace
}  // namespace alidade
