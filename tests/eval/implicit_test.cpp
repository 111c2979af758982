// SPDX-License-Identifier: Apache-2.0
/// Quadrics and polynomials, and the roots of polynomials of one variable.
#include "eval/shapes/polynomial_roots.h"
#include "tests/eval/crossings.h"
#include "tests/eval/shape_samples.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

using test::crossings;
using test::expect_at;

/// (x - a) (x - b) ... as coefficients by rising powers.
std::vector<double> product(const std::vector<double>& roots) {
    std::vector<double> c{1};
    for (const double r : roots) {
        c.push_back(0);
        for (size_t i = c.size() - 1; i > 0; --i) c[i] = c[i - 1] - r * c[i];
        c[0] *= -r;
    }
    return c;
}

TEST(PolynomialRoots, OfKnownRoots) {
    const std::vector<double> cases[] = {{3}, {-1, 2}, {0, 1e-6, 5}, {-7, -1, 0.5, 8}, {1, 2, 3, 4, 5, 6}, {-1e5, -1, 1, 1e5}, {0, 0, 0}};
    for (const auto& want : cases) {
        double got[kMostRoots];
        ASSERT_EQ(real_roots(product(want), got), int(want.size()));
        for (size_t i = 0; i < want.size(); ++i) EXPECT_NEAR(got[i], want[i], 1e-11 * std::max(1e-6, std::abs(want[i])));
    }
}

/// x^m (x - a) (x - b) ...: 0 is told exactly, once where the sign changes there, and twice where the polynomial is positive on both sides.
TEST(PolynomialRoots, AtZeroAreExact) {
    struct Case {
        int zeros;
        std::vector<double> others, want;
    };
    const Case cases[] = {{1, {-2, 3}, {-2, 0, 3}}, {2, {1, 2}, {0, 0, 1, 2}}, {2, {-1, 2}, {-1, 2}}, {3, {-2, -1}, {-2, -1, 0}}, {11, {-329024.5, -131072, 1048576, 2097152}, {-329024.5, -131072, 0, 1048576, 2097152}}};
    for (const auto& [zeros, others, want] : cases) {
        std::vector<double> c = product(others);
        c.insert(c.begin(), size_t(zeros), 0);
        double got[kMostRoots];
        RootRange range;
        ASSERT_EQ(real_roots_in(c, range, got), int(want.size())) << zeros;
        for (size_t i = 0; i < want.size(); ++i) {
            EXPECT_NEAR(got[i], want[i], 1e-11 * std::abs(want[i])) << zeros;
        }
        EXPECT_EQ(range.sign, c.size() % 2 == 1 ? 1 : -1) << "before the first root";
    }
    double got[kMostRoots];
    RootRange range;
    EXPECT_EQ(real_roots_in(std::vector<double>{0, 1, 0, 1}, range, got), 1) << "x (1 + x^2)";
    EXPECT_EQ(got[0], 0);
    EXPECT_EQ(range.sign, -1);
}

TEST(PolynomialRoots, NoneNorEndless) {
    double got[kMostRoots];
    EXPECT_EQ(real_roots(std::vector<double>{1, 0, 1}, got), 0);
    EXPECT_EQ(real_roots(std::vector<double>{5}, got), 0);
    EXPECT_EQ(real_roots(std::vector<double>{}, got), 0);
    EXPECT_EQ(real_roots(std::vector<double>{0, 0, 0}, got), 0);
    EXPECT_EQ(real_roots(std::vector<double>{1, kInf}, got), 0);
    EXPECT_EQ(real_roots(std::vector<double>{1, std::nan(""), 1}, got), 0);
}

/// Random roots of degree 2 to 15, some of them complex pairs: as many are found as are real.
TEST(PolynomialRoots, AreAllFound) {
    test::Draw draw(70);
    for (int i = 0; i < 20000; ++i) {
        const int degree = 2 + int(draw.below(14));
        std::vector<double> c{draw.sign() * draw.decades(-3, 3)};
        int real = 0;
        const auto times = [&](double b, double k) {   // (x^2 + b x + k)
            std::vector<double> out(c.size() + 2, 0.0);
            for (size_t j = 0; j < c.size(); ++j) out[j] += k * c[j], out[j + 1] += b * c[j], out[j + 2] += c[j];
            c = out;
        };
        int at = 0;
        for (; at + 1 < degree; at += 2) {
            const double middle = -1 + 2 * (at + draw(0.3, 0.7)) / degree, apart = draw(0.1, 0.25) * 2 / degree * (draw.sign());
            times(-2 * middle, middle * middle - apart * std::abs(apart));
            if (apart > 0) real += 2;
        }
        if (at < degree) {
            const double root = 1 + draw(0.1, 0.5);
            c.insert(c.begin(), 0.0);
            for (size_t j = 0; j + 1 < c.size(); ++j) c[j] -= root * c[j + 1];
            ++real;
        }
        double got[kMostRoots];
        ASSERT_EQ(real_roots(c, got), real) << i << " degree " << degree;
        ASSERT_TRUE(std::is_sorted(got, got + real));
    }
}

TEST(Quadric, ThoseOfTheBooks) {
    const Quadric hyperboloid{{1, -1, 1}, Vec3(0), Vec3(0), -1}, paraboloid{{1, 0, 1}, Vec3(0), {0, -1, 0}, 0}, cone{{1, -1, 1}, Vec3(0), Vec3(0), 0}, saddle{Vec3(0), {0, 1, 0}, {0, -1, 0}, 0};
    expect_at(crossings(hyperboloid, Vec3(-5, 0, 0), Vec3(1, 0, 0)), {4, 6});
    expect_at(crossings(hyperboloid, Vec3(-5, 1, 0), Vec3(2, 0, 0)), {2.5 - std::sqrt(0.5), 2.5 + std::sqrt(0.5)});
    expect_at(crossings(hyperboloid, Vec3(0, -5, 0), Vec3(0, 1, 0)), {});
    expect_at(crossings(paraboloid, Vec3(0, 5, 0), Vec3(0, -1, 0)), {5});
    expect_at(crossings(paraboloid, Vec3(-5, 4, 0), Vec3(1, 0, 0)), {3, 7});
    expect_at(crossings(cone, Vec3(-5, 1, 0), Vec3(1, 0, 0)), {4, 6});
    expect_at(crossings(saddle, Vec3(0.5, 5, 0.5), Vec3(0, -1, 0)), {4.75});
    EXPECT_TRUE(find_shape(cone)->inside(cone, Vec3(0, 5, 1)));
    EXPECT_FALSE(find_shape(cone)->inside(cone, Vec3(2, 1, 0)));
}

TEST(Quadric, EllipsoidsAndCylindersHaveBounds) {
    const Bounds ellipsoid = bounds(Quadric{{1, 4, 0.25}, Vec3(0), {-2, 0, 0}, 0}), cylinder = bounds(Quadric{{1, 0, 1}, Vec3(0), Vec3(0), -4});
    const Vec3 low(0, -0.5, -2), high(2, 0.5, 2);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(ellipsoid.min[i], low[i], 1e-14);
        EXPECT_NEAR(ellipsoid.max[i], high[i], 1e-14);
    }
    EXPECT_NEAR(cylinder.max.x, 2, 1e-14);
    EXPECT_EQ(cylinder.max.y, kInf);
    EXPECT_EQ(bounds(Quadric{{-1, -1, -1}, Vec3(0), Vec3(0), 1}).max.x, kInf) << "the outside of a sphere";
    EXPECT_EQ(bounds(Quadric{{1, 0, 1}, Vec3(0), {0, -1, 0}, 0}).max.x, kInf) << "a paraboloid";
}

/// x^4 + ... = (x^2 + y^2 + z^2 + R^2 - r^2)^2 - 4 R^2 (x^2 + z^2): a torus, whose closed form has other means.
Polynomial quartic_torus(double major, double minor) {
    Polynomial f;
    f.order = 4, f.coefficients.assign(Polynomial::terms(4), 0.0);
    const auto c = [&](int i, int j, int k) -> double& { return f.coefficients[test::power_index(4, i, j, k)]; };
    const double k = major * major - minor * minor;
    c(4, 0, 0) = c(0, 4, 0) = c(0, 0, 4) = 1, c(2, 2, 0) = c(2, 0, 2) = c(0, 2, 2) = 2;
    c(2, 0, 0) = c(0, 0, 2) = 2 * k - 4 * major * major, c(0, 2, 0) = 2 * k, c(0, 0, 0) = k * k;
    return f;
}

/// From near and far: the quartic has the crossings of the torus.
TEST(Polynomial, AQuarticTorusIsATorus) {
    test::Draw draw(71);
    for (const double distance : {4.0, 1e4, 1e8}) {
        int hits = 0;
        for (int i = 0; i < 2000; ++i) {
            const Torus torus{Vec3(0), draw(0.9, 2), draw(0.2, 0.8)};
            const Ray ray = test::ray_from(distance, draw);
            const Crossings want = find_shape(torus)->crossings(torus, ray);
            const Polynomial f = quartic_torus(torus.major, torus.minor);
            const Crossings got = find_shape(f)->crossings(f, ray);
            if (want.count != got.count) {   // a tangent: the crossings are together within a root of the rounding
                const Crossings& more = want.count > got.count ? want : got;
                ASSERT_LT((more.at[1].t - more.at[0].t) * length(ray.dir), 1e-6 * (1 + distance * 1e-8));
                continue;
            }
            for (int k = 0; k < got.count; ++k, ++hits) {
                const double cosine = std::abs(dot(find_shape(torus)->surface(torus, ray.at(want.at[k].t), 0).normal, normalized(ray.dir)));
                ASSERT_NEAR(got.at[k].t * length(ray.dir), want.at[k].t * length(ray.dir), (1e-13 + 1e-15 * distance) / std::max(cosine, 1e-7)) << i;
            }
        }
        EXPECT_GT(hits, 1000);
    }
}

/// The tube of a spindle goes on within: so does its quartic, which is negative in the tube once and positive where that overlaps itself.
TEST(Polynomial, ASpindleHasTheCrossingsOfItsQuartic) {
    test::Draw draw(72);
    for (const double distance : {4.0, 1e4}) {
        int inner = 0, undecided = 0;
        for (int i = 0; i < 4000; ++i) {
            const double major = draw(0.3, 2);
            const Torus torus{Vec3(0), major, major * draw(1.05, 3)};
            const Ray ray = test::ray_from(distance, draw);
            const Polynomial f = quartic_torus(torus.major, torus.minor);
            const Crossings want = find_shape(f)->crossings(f, ray), got = find_shape(torus)->crossings(torus, ray);
            double gap = kInf;
            for (const Crossings* one : {&want, &got})
                for (int k = 1; k < one->count; ++k) gap = std::min(gap, (one->at[k].t - one->at[k - 1].t) * length(ray.dir));
            if (gap < 1e-5) {   // a tangent, or near the axis: the crossings are together within a root of the rounding
                ++undecided;
                continue;
            }
            ASSERT_EQ(got.count, want.count) << i;
            inner += got.count == 4;
            for (int k = 0; k < got.count; ++k) {
                const double cosine = std::abs(dot(find_shape(f)->surface(f, ray.at(want.at[k].t), 0).normal, normalized(ray.dir)));
                ASSERT_NEAR(got.at[k].t * length(ray.dir), want.at[k].t * length(ray.dir), (1e-12 + 1e-15 * distance) / std::max(cosine, 1e-6)) << i;
            }
        }
        EXPECT_GT(inner, 300) << distance;
        EXPECT_LT(undecided, 20) << distance;
    }
}

/// A highest power that is only rounding makes no crossing at the end of the world.
TEST(Polynomial, DegreesThatVanishAlongALine) {
    Polynomial f;   // x^3 - y, along y and across
    f.order = 3, f.coefficients.assign(Polynomial::terms(3), 0.0);
    f.coefficients[test::power_index(3, 3, 0, 0)] = 1, f.coefficients[test::power_index(3, 0, 1, 0)] = -1;
    expect_at(crossings(f, Vec3(0.5, 5, 0), Vec3(0, -1, 0)), {4.875});
    expect_at(crossings(f, Vec3(2, 8, -1), Vec3(0, 0, 1)), {});
    expect_at(crossings(f, Vec3(-3, 0.125, 1), Vec3(1, 0, 0)), {3.5});
}

#ifdef ALIDADE_HAS_QUAD

using test::Quad;
using test::QuadVec;

/// Order 15, many crossings, in 113 bits: each crossing found is a root, and their number is that of the changes of sign.
TEST(Polynomial, CrossingsAgainst113Bits) {
    test::Draw draw(72);
    for (const int order : {2, 3, 4, 6, 9, 15}) {
        double worst = 0;
        int hits = 0;
        for (int i = 0; i < 60; ++i) {
            Polynomial f;
            f.order = order, f.coefficients.resize(Polynomial::terms(order));
            for (double& c : f.coefficients) c = draw(-1, 1);
            Ray ray = test::ray_from(draw.decades(0, 6), draw);
            const Crossings got = find_shape(f)->crossings(f, ray);
            const auto value = [&](Quad t) { return test::quad_value(f, QuadVec(ray.origin) + t * QuadVec(ray.dir)); };
            for (int k = 0; k < got.count; ++k, ++hits) {
                const test::QuadJet at = value(got.at[k].t);
                const double slope = double(fabsq(dot(at.gradient, QuadVec(ray.dir))));
                const Vec3 p = glm::abs(ray.at(got.at[k].t));
                Polynomial size = f;
                for (double& c : size.coefficients) c = std::abs(c);
                const double magnitude = double(test::quad_value(size, QuadVec(p)).value);
                if (slope * got.at[k].t == 0) continue;
                worst = std::max(worst, double(fabsq(at.value)) / slope / (std::numeric_limits<double>::epsilon() * (std::abs(got.at[k].t) + magnitude / slope)));
            }
            int changes = 0;
            const double speed = length(ray.dir), middle = -dot(ray.origin, ray.dir) / (speed * speed);
            Quad last = value(Quad(middle) - Quad(1e4) / speed).value;
            int inside = 0;
            for (int k = 0; k < got.count; ++k) inside += std::abs(got.at[k].t - middle) * speed < 1e4;
            for (int k = -80; k <= 80; ++k) {   // denser in the middle, where the crossings are
                const double x = 1e4 * std::pow(std::abs(k) / 80.0, 5) * (k < 0 ? -1 : 1);
                const Quad next = value(Quad(middle) + Quad(x) / speed).value;
                changes += (next > 0) != (last > 0), last = next;
            }
            ASSERT_GE(inside, changes) << "order " << order << ", ray " << i;
            ASSERT_EQ((inside - changes) % 2, 0);
        }
        EXPECT_GT(hits, 50);
        std::printf("[          ] order %d: %.2f eps (|t| + M / |f'|), %d crossings\n", order, worst, hits);
        EXPECT_LT(worst, 4);
    }
}

/// T09: an ellipsoid a million times as long as it is thick, and a paraboloid from far away.
TEST(Quadric, CrossingsAgainst113Bits) {
    test::Draw draw(73);
    const Quadric needle{{1, 1e-12, 1}, Vec3(0), Vec3(0), -1};
    double worst = 0;
    int hits = 0;
    for (int i = 0; i < 20000; ++i) {
        Quadric q;
        if (i % 4 == 0) q = needle;
        else if (i % 4 == 1) q = {{1, 0, 1}, Vec3(0), {0, -1, 0}, draw(-1, 1)};
        else test::randomize(q, draw);
        const Ray ray = test::ray_from(draw.decades(0, 8), draw);
        const Crossings got = find_shape(q)->crossings(q, ray);
        for (int k = 0; k < got.count; ++k, ++hits) {
            const double t = got.at[k].t;
            const QuadVec p = QuadVec(ray.origin) + Quad(t) * QuadVec(ray.dir);
            const Vec3 &s = q.squares, &m = q.products, &l = q.linear, a = glm::abs(ray.at(t));
            const QuadVec gradient(2 * Quad(s.x) * p.x + m.x * p.y + m.y * p.z + l.x, 2 * Quad(s.y) * p.y + m.x * p.x + m.z * p.z + l.y, 2 * Quad(s.z) * p.z + m.y * p.x + m.z * p.y + l.z);
            const double value = double(fabsq(dot(gradient + QuadVec(l), p) / 2 + q.constant)), slope = double(fabsq(dot(gradient, QuadVec(ray.dir))));
            const double magnitude = dot(glm::abs(s), a * a) + std::abs(m.x) * a.x * a.y + std::abs(m.y) * a.x * a.z + std::abs(m.z) * a.y * a.z + dot(glm::abs(l), a) + std::abs(q.constant);
            worst = std::max(worst, value / (std::numeric_limits<double>::epsilon() * (std::abs(t) * slope + magnitude)));
        }
    }
    EXPECT_GT(hits, 10000);
    std::printf("[          ] %.2f eps (|t| + M / |f'|)\n", worst);
    EXPECT_LT(worst, 4);
}
#endif

}  // namespace
}  // namespace alidade
