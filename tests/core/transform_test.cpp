// SPDX-License-Identifier: Apache-2.0
#include "core/transform.h"
#include "tests/core/draw.h"
#include "tests/core/quad.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// Random columns with a volume of at least 0.1: their inverse is no larger than about 30.
Mat3 well_conditioned(test::Draw& draw) {
    for (;;) {
        const Mat3 m(draw.vector(), draw.vector(), draw.vector());
        if (std::abs(dot(m[0], cross(m[1], m[2]))) > 0.1) return m;
    }
}

/// On every machine the same bits as point() and vector(), and all else of a ray stays.
TEST(Transform, OfARayIsThatOfItsPointAndItsDirection) {
    test::Draw draw(5);
    for (int number = 0; number < 10000; ++number) {
        const Transform t{Mat3(draw.vector(), draw.vector(), draw.vector()), draw.vector()};
        Ray ray;
        ray.origin = draw.vector(), ray.dir = draw.vector(), ray.tmin = draw.vector().x, ray.tmax = draw.vector().y, ray.time = 0.25f, ray.mask = kMaskShadow;
        const Ray mapped = t.ray(ray);
        ASSERT_EQ(mapped.origin, t.point(ray.origin));
        ASSERT_EQ(mapped.dir, t.vector(ray.dir));
        ASSERT_TRUE(mapped.tmin == ray.tmin && mapped.tmax == ray.tmax && mapped.time == ray.time && mapped.mask == ray.mask);
    }
}

TEST(Transform, InverseOfPowersOfTwoIsExact) {
    const Transform t = Transform::translate({3, -4, 5}) * Transform::scale({0x1p-40, -1, 0x1p40});
    const auto back = inverse(t);
    ASSERT_TRUE(back);
    EXPECT_EQ(back->linear, Transform::scale({0x1p40, -1, 0x1p-40}).linear);
    EXPECT_EQ(back->translation, Vec3(-3 * 0x1p40, -4, -5 * 0x1p-40));
}

TEST(Transform, InverseOfAShearIsExact) {
    Transform shear;
    shear.linear[1][0] = 1e6;   // x += 1e6 y
    const auto back = inverse(shear);
    ASSERT_TRUE(back);
    EXPECT_EQ(back->linear[1][0], -1e6);
    EXPECT_EQ((*back * shear).linear, Mat3(1.0));
}

#ifdef ALIDADE_HAS_QUAD
/// Rows and columns of a good matrix stretched by 1e-12 .. 1e12: each element of the inverse keeps its own digits.
TEST(Transform, InverseAgainst113BitsAtExtremeScales) {
    test::Draw draw(10);
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
        Transform t{well_conditioned(draw), draw.vector()};
        const Vec3 in(draw.decades(-12, 12), draw.decades(-12, 12), draw.decades(-12, 12));
        const Vec3 out(draw.decades(-12, 12), draw.decades(-12, 12), draw.decades(-12, 12));
        for (int c = 0; c < 3; ++c) t.linear[c] *= in[c] * out;
        const auto got = inverse(t);
        ASSERT_TRUE(got) << i;
        const test::QuadVec m[] = {test::QuadVec(t.linear[0]), test::QuadVec(t.linear[1]), test::QuadVec(t.linear[2])};
        const test::Quad det = test::dot(m[0], test::cross(m[1], m[2]));
        for (int r = 0; r < 3; ++r) {
            const test::QuadVec row = (1 / det) * test::cross(m[(r + 1) % 3], m[(r + 2) % 3]);
            const test::Quad exact[] = {row.x, row.y, row.z};
            for (int c = 0; c < 3; ++c)
                worst = std::max(worst, double(fabsq(test::Quad(got->linear[c][r]) - exact[c]) * test::Quad(in[r]) * test::Quad(out[c])));
        }
    }
    EXPECT_LT(worst, 3e-13);   // of elements up to 30: the volume of 0.1 costs one digit twice
}

/// Every point of a box maps into the mapped box, in exact arithmetic.
TEST(Transform, BoundsHoldTheMappedPoints) {
    test::Draw draw(11);
    for (int i = 0; i < 20000; ++i) {
        const Transform t{Mat3(draw.vector(), draw.vector() * draw.decades(-8, 8), draw.vector()), draw.vector(draw.decades(-3, 6))};
        Bounds b;
        b.extend(draw.vector(draw.decades(-3, 8)));
        b.extend(draw.vector(draw.decades(-3, 8)));
        const Bounds mapped = t.bounds(b);
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 p(corner & 1 ? b.max.x : b.min.x, corner & 2 ? b.max.y : b.min.y, corner & 4 ? b.max.z : b.min.z);
            test::QuadVec q(t.translation);
            for (int c = 0; c < 3; ++c) q = q + test::Quad(p[c]) * test::QuadVec(t.linear[c]);
            ASSERT_TRUE(mapped.min.x <= q.x && q.x <= mapped.max.x) << i;
            ASSERT_TRUE(mapped.min.y <= q.y && q.y <= mapped.max.y) << i;
            ASSERT_TRUE(mapped.min.z <= q.z && q.z <= mapped.max.z) << i;
        }
    }
}
#endif

TEST(Transform, BoundsOfEmptyAndUnboundedBoxes) {
    EXPECT_TRUE(Transform::translate({1, 2, 3}).bounds(Bounds()).empty());
    const Bounds half{Vec3(-kInf, 0, -kInf), Vec3(kInf, 1, kInf)};
    const Bounds mapped = (Transform::translate({0, 5, 0}) * Transform::scale({2, -3, 1})).bounds(half);
    EXPECT_EQ(mapped.min.x, -kInf);
    EXPECT_EQ(mapped.max.z, kInf);
    EXPECT_NEAR(mapped.min.y, 2, 1e-14);
    EXPECT_NEAR(mapped.max.y, 5, 1e-14);
}

/// Four lanes at once, where the machine has them: the same bits as row by row, whatever the numbers are.
TEST(Transform, BoundsAreTheSameRowByRow) {
    test::Draw draw(13);
    const auto odd = [&](const Vec3& v) {   // zeros of both signs, and what is no number
        Vec3 out = v;
        for (int k = 0; k < 3; ++k)
            if (draw.below(4) == 0) out[k] = draw.below(2) ? 0.0 : draw.below(2) ? -0.0 : draw.below(8) ? kInf : std::numeric_limits<double>::quiet_NaN();
        return out;
    };
    for (int i = 0; i < 20000; ++i) {
        const Transform t{Mat3(odd(draw.vector()), odd(draw.vector()), odd(draw.vector())), odd(draw.vector())};
        Bounds b;
        b.extend(draw.vector()), b.extend(draw.vector());
        for (int k = 0; k < 3; ++k) {
            if (draw.below(8) == 0) b.min[k] = -kInf;
            if (draw.below(8) == 0) b.max[k] = kInf;
        }
        const Bounds got = t.bounds(b);
        for (int row = 0; row < 3; ++row) {
            double low = t.translation[row], high = low, size = std::abs(low);
            for (int column = 0; column < 3; ++column) {
                const double k = t.linear[column][row], p = k * b.min[column], q = k * b.max[column];
                if (k == 0) continue;
                low += std::min(p, q), high += std::max(p, q), size += std::abs(k) * std::max(std::abs(b.min[column]), std::abs(b.max[column]));
            }
            if (std::isfinite(size)) low -= gamma_bound(6) * size, high += gamma_bound(6) * size;
            const auto same = [](double x, double y) { return (std::isnan(x) && std::isnan(y)) || (x == y && std::signbit(x) == std::signbit(y)); };
            ASSERT_TRUE(same(got.min[row], low)) << i << " " << got.min[row] << " " << low;
            ASSERT_TRUE(same(got.max[row], high)) << i << " " << got.max[row] << " " << high;
        }
    }
}

TEST(Transform, SingularAndBrokenMapsAreRefused) {
    EXPECT_FALSE(inverse(Transform::scale({1, 0, 1})));
    EXPECT_FALSE(inverse(Transform::scale({1, std::numeric_limits<double>::quiet_NaN(), 1})));
    EXPECT_FALSE(inverse(Transform::scale({1, kInf, 1})));
    EXPECT_FALSE(inverse(Transform::translate({kInf, 0, 0})));
    EXPECT_FALSE(inverse(Transform::scale({1, 1e-320, 1}))) << "its inverse is infinite";
    test::Draw draw(12);
    for (int i = 0; i < 10000; ++i) {   // flat but for rounding
        const Vec3 a = draw.vector(), b = draw.vector();
        const Transform flat{Mat3(a, b, draw(-1, 1) * a + draw(-1, 1) * b), Vec3(0)};
        ASSERT_FALSE(inverse(flat)) << i;
    }
}

/// The reason why normals need the inverse transpose: they stay perpendicular to what lies in the surface.
TEST(Transform, NormalsStayPerpendicularToTangents) {
    test::Draw draw(13);
    for (int i = 0; i < 20000; ++i) {
        const Transform t{well_conditioned(draw), draw.vector()};
        const Vec3 n = draw.direction();
        Vec3 s, unused;
        orthonormal_basis(n, s, unused);
        const Vec3 normal = inverse(t)->transposed(n), tangent = t.vector(s);
        ASSERT_NEAR(dot(normal, tangent) / (length(normal) * length(tangent)), 0, 200 * kEpsilon);
    }
    const Vec3 stretched = inverse(Transform::scale({4, 1, 1}))->transposed(normalized(Vec3(1, 1, 0)));
    EXPECT_NEAR(stretched.y / stretched.x, 4, 4 * kEpsilon) << "the normal of x + y = 0, stretched along x, leans towards y";
}

TEST(Transform, QuaternionIsRodriguesRotation) {
    test::Draw draw(14);
    for (int i = 0; i < 10000; ++i) {
        const Vec3 axis = draw.direction(), v = draw.vector();
        const double angle = draw(-7, 7);
        const Vec3 want = std::cos(angle) * v + std::sin(angle) * cross(axis, v) + (1 - std::cos(angle)) * dot(axis, v) * axis;
        ASSERT_LT(length(Transform::rotate(axis, angle).vector(v) - want), 16 * kEpsilon);
    }
    EXPECT_LT(length(Transform::rotate({0, 0, 1}, kPi / 2).vector({1, 0, 0}) - Vec3(0, 1, 0)), 2 * kEpsilon) << "right-handed";
}

TEST(Transform, ARayMapsWithItsParameter) {
    test::Draw draw(15);
    for (int i = 0; i < 10000; ++i) {
        const Transform t{well_conditioned(draw), draw.vector()};
        Ray ray;
        ray.origin = draw.vector(), ray.dir = draw.vector(), ray.tmin = 1, ray.tmax = 9, ray.mask = 5;
        const Ray mapped = t.ray(ray);
        const double at = draw(-10, 10);
        ASSERT_LT(length(mapped.at(at) - t.point(ray.at(at))), 200 * kEpsilon);
        ASSERT_EQ(mapped.tmin, 1);
        ASSERT_EQ(mapped.tmax, 9);
        ASSERT_EQ(mapped.mask, 5u);
    }
}

TEST(Transform, ProductsDeterminantAndNorm) {
    test::Draw draw(16);
    EXPECT_TRUE(Transform().is_identity());
    EXPECT_FALSE(Transform::translate({1, 0, 0}).is_identity());
    EXPECT_EQ(Transform::scale({2, 3, -4}).determinant(), -24);
    for (int i = 0; i < 10000; ++i) {
        const Transform a{well_conditioned(draw), draw.vector()}, b{well_conditioned(draw), draw.vector()};
        const Vec3 p = draw.vector();
        ASSERT_LT(length((a * b).point(p) - a.point(b.point(p))), 32 * kEpsilon);
        ASSERT_LE(length(a.vector(p)), a.norm() * length(p) * (1 + 8 * kEpsilon));
    }
}

}  // namespace
}  // namespace alidade
