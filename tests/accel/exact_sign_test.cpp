// SPDX-License-Identifier: Apache-2.0
/// The exact predicates against rational arithmetic, where rounding would decide wrongly: on edges, within an ulp of them, over all magnitudes.
#include "accel/triangles/exact_sign.h"

#include "core/draws.h"
#include "numerics/triangles/rational.h"
#include "tests/core/run_size.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace alidade::test {

using namespace numerics;

namespace {

struct EdgeCase {
    Vec3 d, o, a, b;
};

/// o, a, b such that the line through o along d meets the line through a and b, as well as double can say it, and then moved by a few ulps.
EdgeCase near_edge(Draws& draws, double size) {
    EdgeCase c;
    c.a = size * draws.in_box(Vec3(-1), Vec3(1)), c.b = size * draws.in_box(Vec3(-1), Vec3(1)), c.o = size * draws.in_box(Vec3(-1), Vec3(1));
    const Vec3 on_edge = c.a + (draws.coin() ? draws.below(5) / 4.0 : draws.uniform()) * (c.b - c.a);
    c.d = (on_edge - c.o) / size;
    for (int ulps = int(draws.below(3)); ulps > 0; --ulps) {
        double& component = c.d[int(draws.below(3))];
        component = std::nextafter(component, draws.sign() * kInf);
    }
    return c;
}

/// Small integers times a power of two: every sixth one lies on the edge.
EdgeCase on_lattice(Draws& draws, double size) {
    const auto point = [&] { return Vec3(draws.below(4), draws.below(4), draws.below(4)); };
    EdgeCase c;
    c.d = point() - point(), c.o = size * point(), c.a = size * point(), c.b = size * point();
    return c;
}

/// Near an edge, each axis with a size of its own; some of them flat, as floats are, or far from the origin.
EdgeCase stretched(Draws& draws, double size) {
    EdgeCase c = near_edge(draws, 1);
    for (int axis = 0; axis < 3; ++axis) {
        const double own = draws.coin() ? 1 : std::exp2(int(draws.below(61)) - 30), far = draws.below(4) == 0 ? std::floor(draws.uniform(0, 1e6)) : 0;
        const uint32_t kind = draws.below(4);
        for (Vec3* point : {&c.o, &c.a, &c.b}) {
            double& x = (*point)[axis];
            if (kind == 0) x = 0;
            if (kind == 1 && point != &c.o) x = double(float(x));
            if (kind > 1) x += far;
            x *= own * size;
        }
        c.d[axis] *= own;
    }
    return c;
}

/// Coordinates of any magnitude between 2^-150 and 2^150, each for itself.
EdgeCase any_magnitude(Draws& draws, double) {
    const auto coordinate = [&] { return draws.below(4) == 0 ? 0.0 : draws.uniform(-1, 1) * std::exp2(draws.uniform(-150, 150)); };
    const auto point = [&] {
        const double x = coordinate(), y = coordinate(), z = coordinate();
        return Vec3(x, y, z);
    };
    EdgeCase c;
    c.o = point(), c.a = point(), c.b = point(), c.d = draws.in_box(Vec3(-1), Vec3(1));
    return c;
}

Rational exact_value(const EdgeCase& c) {
    const RationalVec o = rational(c.o);
    return dot(rational(c.d), cross(rational(c.a) - o, rational(c.b) - o));
}

int sign(double x) { return (x > 0) - (x < 0); }

struct EdgeClass {
    const char* name;
    EdgeCase (*make)(Draws&, double size);
    double least_zeros;  ///< share of exact zeros, so that the test cannot miss them
};

TEST(ExactEdge, HasTheSignOfRationalArithmetic) {
    for (const EdgeClass& kind : {EdgeClass{"near an edge", near_edge, 0.05}, {"lattice", on_lattice, 0.1}, {"stretched", stretched, 0.02}, {"any magnitude", any_magnitude, 0}}) {
        const size_t count = run_size(20000, 2000000);
        size_t zeros = 0;
        double worst = 0;
        for (size_t i = 0; i < count; ++i) {
            Draws draws(RandomKey(101, 0, i, 0));
            const double size = std::exp2(int(draws.below(201)) - 100);
            const EdgeCase c = kind.make(draws, size);
            const Rational exact = exact_value(c);
            const double got = exact_edge(c.d, c.o, c.a, c.b);
            ASSERT_EQ(sign(got), sgn(exact)) << kind.name << ", seed 101, case " << i << fmt::format(": {:a}", got);
            ASSERT_EQ(exact_edge(c.d, c.o, c.b, c.a), -got) << kind.name << ", seed 101, case " << i << ": swapped ends";
            zeros += exact == 0;
            worst = std::max(worst, relative_error(got, exact));
        }
        fmt::print("{}: {} cases, {} zeros, worst relative error {:.2g}\n", kind.name, count, zeros, worst);
        EXPECT_LE(worst, 0x1p-50) << kind.name << ": the value is good to a few ulps";
        EXPECT_GE(double(zeros), kind.least_zeros * double(count)) << kind.name;
    }
}

TEST(Collinear, IsDecidedExactly) {
    size_t yes = 0;
    const size_t count = run_size(20000, 2000000);
    for (size_t i = 0; i < count; ++i) {
        Draws draws(RandomKey(103, 0, i, 0));
        const double size = std::exp2(int(draws.below(201)) - 100);
        const EdgeCase edge = draws.coin() ? near_edge(draws, size) : on_lattice(draws, size);
        const Vec3 middle = edge.a + draws.below(5) / 4.0 * (edge.b - edge.a);
        const RationalVec a = rational(edge.a), n = cross(rational(edge.b) - a, rational(middle) - a);
        const bool want = n[0] == 0 && n[1] == 0 && n[2] == 0;
        ASSERT_EQ(collinear(edge.a, edge.b, middle), want) << "seed 103, case " << i;
        ASSERT_EQ(collinear(middle, edge.a, edge.b), want) << "seed 103, case " << i;
        yes += want;
    }
    EXPECT_GT(yes, count / 10);
    EXPECT_LT(yes, count - count / 10);
}

}  // namespace
}  // namespace alidade::test
