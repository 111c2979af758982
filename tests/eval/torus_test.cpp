// SPDX-License-Identifier: Apache-2.0
#include "tests/eval/crossings.h"
#include "tests/eval/shape_samples.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

using test::crossings;
using test::expect_at;

TEST(Torus, ThroughTheTubeAlongAndAcross) {
    const Torus t{Vec3(0), 2, 0.5};
    expect_at(crossings(t, Vec3(-5, 0, 0), Vec3(1, 0, 0)), {2.5, 3.5, 6.5, 7.5});
    expect_at(crossings(t, Vec3(2, 3, 0), Vec3(0, -2, 0)), {1.25, 1.75});
    expect_at(crossings(t, Vec3(0, 3, 0), Vec3(0, -1, 0)), {});
    expect_at(crossings(Torus{Vec3(1, 2, 3), -2, -0.5}, Vec3(-4, 2, 3), Vec3(1, 0, 0)), {2.5, 3.5, 6.5, 7.5});
}

/// With a minor radius larger than the major one the tube overlaps itself: its inner sheets are met, but the middle is filled. Crossings and normals are those
/// of POV-Ray's trace().
TEST(Torus, ASpindleIsMetWithinToo) {
    const Torus t{Vec3(0), 0.5, 1};
    const ShapeOps& ops = *find_shape(t);
    expect_at(crossings(t, Vec3(-5, 0, 0), Vec3(1, 0, 0)), {3.5, 4.5, 5.5, 6.5});
    expect_at(crossings(t, Vec3(0.1, 5, 0), Vec3(0, -1, 0)), {5 - std::sqrt(0.84), 4.2, 5.8, 5 + std::sqrt(0.84)});
    const Vec3 at(std::sqrt(0.91) - 0.5, 0.3, 0), within = ops.shading_normal(t, at);
    EXPECT_LT(length(ops.normal_at(t, at, 0) - Vec3(std::sqrt(0.91), 0.3, 0)), 1e-15);
    EXPECT_NEAR(within.x, -0.151758, 1e-6);
    EXPECT_NEAR(within.y, 0.988418, 1e-6);
    Ray ray;
    ray.origin = Vec3(-5, 0.3, 0), ray.dir = Vec3(1, 0, 0);
    const Crossings all = ops.crossings(t, ray);
    for (int i = 0; i < all.count; ++i) EXPECT_LT(ops.error(t, ray, all.at[i].t, 0).along_normal, 1e-13) << "the sheet that is met, not the other";
    EXPECT_TRUE(ops.inside(t, Vec3(0)));
    EXPECT_FALSE(ops.solid(t)) << "to POV-Ray, what is within is inside";
    EXPECT_TRUE(ops.solid(Torus{Vec3(0), 1, -1}));
}

TEST(Torus, WithoutAMajorRadiusItIsASphere) {
    expect_at(crossings(Torus{Vec3(0), 0, 1}, Vec3(-5, 0, 0), Vec3(1, 0, 0)), {4, 6});
    expect_at(crossings(Torus{Vec3(0), 1, 0}, Vec3(-5, 0, 0), Vec3(1, 0, 0)), {});
}

/// A line across the top of the tube, in closed form: it meets the circle's plane distance R +- sqrt(r^2 - y^2).
TEST(Torus, TangentsAreSharp) {
    for (const double distance : {4.0, 1e4, 1e8})
        for (const double depth : {1e-3, 1e-6, 1e-9}) {
            const Torus t{Vec3(0), 1, 0.25};
            const Crossings in = crossings(t, Vec3(-distance, 0.25 - depth, 0), Vec3(1, 0, 0));
            ASSERT_EQ(in.count, 4) << distance << " " << depth;
            const double half = std::sqrt((0.5 - depth) * depth);
            for (int i = 0; i < 4; ++i)
                EXPECT_NEAR(in.at[i].t - distance, (i < 2 ? -1 : 1) + (i % 2 ? half : -half), 1e-15 / half + 4e-16 * distance);
            EXPECT_EQ(crossings(t, Vec3(-distance, 0.25 + depth, 0), Vec3(1, 0, 0)).count, 0) << distance << " " << depth;
        }
}

/// As POV-Ray 3.7 maps it.
TEST(Torus, TextureCoordinates) {
    const Torus t{Vec3(0), 1, 0.25};
    const ShapeOps& ops = *find_shape(t);
    EXPECT_EQ(ops.surface(t, Vec3(1.25, 0, 0), 0).uv, Vec2(0.5, 0.5));
    EXPECT_EQ(ops.surface(t, Vec3(0, 0, 1.25), 0).uv, Vec2(0.25, 0.5));
    EXPECT_EQ(ops.surface(t, Vec3(1, 0.25, 0), 0).uv, Vec2(0.5, 0.75));
}

#ifdef ALIDADE_HAS_QUAD

using test::Quad;
using test::QuadVec;

/// The implicit function along a ray, in 113 bits: roots by bisection between samples that are far nearer to each other than the torus is thick.
class ExactTorus {
  public:
    ExactTorus(const Torus& torus, const Ray& ray) : torus_(torus), ray_(ray) {}

    Quad operator()(Quad t) const {
        const QuadVec p = QuadVec(ray_.origin) + t * QuadVec(ray_.dir) - QuadVec(torus_.center);
        const Quad around = sqrtq(p.x * p.x + p.z * p.z), major = fabsq(torus_.major), minor = fabsq(torus_.minor);
        const auto from = [&](Quad off) { return sqrtq(off * off + p.y * p.y) - minor; };
        const Quad here = from(around - major), across = from(around + major);
        return here >= 0 || major >= minor ? here : fmaxq(here, -fabsq(across)) * (across < 0 ? -1 : 1);
    }

    /// False if the line comes so near to a tangent that samples could miss two roots.
    bool roots(std::vector<Quad>& out) const {
        constexpr int kSamples = 400;
        const Quad speed = length(QuadVec(ray_.dir)), middle = dot(QuadVec(torus_.center) - QuadVec(ray_.origin), QuadVec(ray_.dir)) / (speed * speed);
        const Quad reach = Quad(1.5) * (fabsq(torus_.major) + fabsq(torus_.minor)) / speed;
        std::vector<Quad> f(kSamples + 1);
        const auto at = [&](int i) { return middle + reach * (2 * Quad(i) / kSamples - 1); };
        for (int i = 0; i <= kSamples; ++i) f[size_t(i)] = (*this)(at(i));
        for (int i = 1; i < kSamples; ++i) {
            const Quad a = f[size_t(i - 1)], b = f[size_t(i)], c = f[size_t(i + 1)];
            if (fabsq(b) < Quad(1e-3) && ((b <= a && b <= c) || (b >= a && b >= c))) return false;
        }
        for (int i = 0; i < kSamples; ++i)
            if ((f[size_t(i)] > 0) != (f[size_t(i + 1)] > 0)) out.push_back(bisected(at(i), at(i + 1)));
        return true;
    }

  private:
    Quad bisected(Quad low, Quad high) const {
        const bool positive = (*this)(low) > 0;
        for (int i = 0; i < 110; ++i) {
            const Quad middle = (low + high) / 2;
            (((*this)(middle) > 0) == positive ? low : high) = middle;
        }
        return low;
    }

    const Torus& torus_;
    const Ray& ray_;
};

/// No crossing is missed or invented, from any distance; and t is right.
TEST(Torus, CrossingsAgainst113Bits) {
    test::Draw draw(62);
    for (const double distance : {4.0, 1e4, 1e8}) {
        double worst = 0;
        int hits = 0;
        for (int i = 0; i < 700; ++i) {
            Torus torus;
            test::randomize(torus, draw);
            const Ray ray = test::ray_from(distance, draw);
            std::vector<Quad> want;
            if (!ExactTorus(torus, ray).roots(want)) continue;
            const Crossings got = find_shape(torus)->crossings(torus, ray);
            ASSERT_EQ(size_t(got.count), want.size()) << "from " << distance << ", ray " << i;
            for (int k = 0; k < got.count; ++k, ++hits) {
                const double cosine = std::abs(dot(find_shape(torus)->surface(torus, ray.at(got.at[k].t), 0).normal, normalized(ray.dir)));
                const double unit = std::numeric_limits<double>::epsilon() * (std::abs(got.at[k].t) + (std::abs(torus.major) + std::abs(torus.minor)) / length(ray.dir));
                worst = std::max(worst, double(fabsq(Quad(got.at[k].t) - want[size_t(k)])) / unit * cosine);
            }
        }
        EXPECT_GT(hits, 700);
        std::printf("[          ] from %g: %.2f eps (|t| + (R + r) / |d|) / cosine\n", distance, worst);
        EXPECT_LT(worst, 4);
    }
}
#endif

}  // namespace
}  // namespace alidade
