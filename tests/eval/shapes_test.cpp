// SPDX-License-Identifier: Apache-2.0
/// What holds for every row of the table of shapes.
#include "core/clamp.h"
#include "eval/csg.h"
#include "tests/eval/shape_samples.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace alidade {

void PrintTo(const ShapeOps& row, std::ostream* out) { *out << row.name; }

namespace {

constexpr int kSamples = 3000;

class EveryShape : public testing::TestWithParam<ShapeOps> {
  protected:
    const ShapeOps& row = GetParam();

    /// Calls body(shape, ray, crossings) for random shapes and rays from `distance`; at least a quarter of the rays has to hit.
    template <class Body> void for_samples(double distance, uint64_t seed, const Body& body) {
        test::Draw draw(seed);
        int hits = 0;
        for (int i = 0; i < kSamples; ++i) {
            const ShapeGeometry shape = test::sample_shape(row, i, draw);
            const Ray ray = test::ray_from(distance, draw);
            const Crossings crossings = row.crossings(shape, ray);
            hits += crossings.count > 0;
            body(shape, ray, crossings);
            if (testing::Test::HasFatalFailure()) FAIL() << row.name << " sample " << i << " from " << distance;
        }
        EXPECT_GT(hits, kSamples / 4) << "the test must exercise hits";
    }
};

/// Sorted, inside the box as computed in double, and within their error of it.
TEST_P(EveryShape, BoundsHoldTheHits) {
    for (const double distance : {0.5, 4.0, 1e4, 1e8}) {
        for_samples(distance, 40, [&](const ShapeGeometry& shape, const Ray& ray, const Crossings& crossings) {
            Bounds box = row.bounds(shape);
            for (int i = 0; i < crossings.count; ++i) {
                const Crossing& c = crossings.at[i];
                ASSERT_TRUE(std::isfinite(c.t));
                ASSERT_GE(row.error(shape, ray, c.t, c.part).along_normal, 0);
                ASSERT_TRUE(i == 0 || crossings.at[i - 1].t <= c.t);
                ASSERT_EQ(clamp_to_bounds(c.t, ray, box), c.t);
                const double slack = 4 * std::numeric_limits<double>::epsilon() * (max_abs(ray.origin) + std::abs(c.t) * max_abs(ray.dir));
                const Vec3 p = ray.at(c.t);
                ASSERT_TRUE((Bounds{box.min - slack, box.max + slack}.contains(p)));
            }
        });
    }
}

/// The crossings in the interval of a ray, in order.
std::vector<Crossing> in_interval(const Crossings& crossings, const Ray& ray) {
    std::vector<Crossing> out;
    for (int i = 0; i < crossings.count; ++i)
        if (crossings.at[i].t >= ray.tmin && crossings.at[i].t <= ray.tmax) out.push_back(crossings.at[i]);
    return out;
}
int before_interval(const Crossings& crossings, const Ray& ray) {
    int count = 0;
    while (count < crossings.count && crossings.at[count].t < ray.tmin) ++count;
    return count;
}

/// What is wanted is found bit for bit; what is not stays on its side of the interval, or is told of by the side on which the line begins.
TEST_P(EveryShape, WhatIsWantedIsFoundExactly) {
    std::mt19937_64 random(44);
    std::uniform_real_distribution<double> number(-1, 1);
    int inner = 0, left_out = 0;
    for (const double distance : {0.5, 4.0, 1e4}) {
        for_samples(distance, 44, [&](const ShapeGeometry& shape, const Ray& ray, const Crossings& all) {
            const auto end = [&](double sign) {
                const double at = all.count > 0 && random() % 4 ? all.at[random() % size_t(all.count)].t : distance * number(random);
                const double away[] = {0, 1e-12, 1e-7, 1e-3, 1, kInf};
                return at + sign * std::abs(number(random)) * away[random() % 6];
            };
            Ray asked = ray;
            asked.tmin = end(random() % 2 ? 1 : -1), asked.tmax = end(random() % 4 ? 1 : -1);
            if (!(asked.tmin <= asked.tmax)) std::swap(asked.tmin, asked.tmax);
            if (std::isnan(asked.tmin) || std::isnan(asked.tmax)) return;
            const Bounds own = row.bounds(shape);
            const std::vector<Crossing> expected = in_interval(all, asked);
            const Crossings got = row.crossings_wanted(shape, own, asked, Wanted::all);
            const std::vector<Crossing> found = in_interval(got, asked), first = in_interval(row.crossings_wanted(shape, own, asked, Wanted::first), asked), any = in_interval(row.crossings_wanted(shape, own, asked, Wanted::any), asked);
            ASSERT_EQ(found.size(), expected.size());
            for (size_t i = 0; i < found.size(); ++i) ASSERT_TRUE(found[i].t == expected[i].t && found[i].part == expected[i].part) << found[i].t << " " << expected[i].t;
            ASSERT_EQ(first.empty(), expected.empty());
            ASSERT_TRUE(expected.empty() || (first[0].t == expected[0].t && first[0].part == expected[0].part));
            ASSERT_EQ(any.empty(), expected.empty());
            if (got.begins_inside) {
                ASSERT_EQ(*got.begins_inside != (before_interval(got, asked) % 2 == 1), begins_inside(row, shape, ray, all) != (before_interval(all, asked) % 2 == 1));
                ++left_out;
            } else {
                ASSERT_EQ(before_interval(got, asked), before_interval(all, asked));
            }
            inner += !expected.empty() && int(expected.size()) < all.count;
        });
    }
    if (!row.wanted) return;   // all are found at once
    EXPECT_GT(inner, kSamples / 8) << "the test must exercise ends between crossings";
    EXPECT_GT(left_out, std::string(row.name) == "polynomial" ? kSamples / 8 : -1);
}

/// The length of a direction only says in what t is counted: by a power of two the crossings are the same bits, where squares of it overflow and where they are lost, too.
TEST_P(EveryShape, DirectionsMayHaveAnyLength) {
    for_samples(4, 46, [&](const ShapeGeometry& shape, const Ray& ray, const Crossings& crossings) {
        for (const int power : {-900, -600, -100, 100, 634, 900}) {
            Ray scaled = ray;
            for (int axis = 0; axis < 3; ++axis) scaled.dir[axis] = std::ldexp(ray.dir[axis], power);
            scaled.tmin = -kInf, scaled.tmax = kInf;
            const Crossings got = row.crossings_wanted(shape, row.bounds(shape), scaled, Wanted::all);
            ASSERT_EQ(got.count, crossings.count) << power;
            for (int i = 0; i < got.count; ++i) {
                ASSERT_EQ(std::ldexp(got.at[size_t(i)].t, power), crossings.at[size_t(i)].t) << power;
                ASSERT_EQ(got.at[size_t(i)].part, crossings.at[size_t(i)].part) << power;
            }
        }
    });
}

/// A ray from a hit point meets the surface there again: within the errors of both, along the normal.
TEST_P(EveryShape, IsMetAgainFromItsHitPoints) {
    for (const double distance : {4.0, 1e4, 1e8}) {
        for_samples(distance, 41, [&](const ShapeGeometry& shape, const Ray& ray, const Crossings& crossings) {
            for (int i = 0; i < crossings.count; ++i) {
                Ray again = ray;
                again.origin = ray.at(crossings.at[i].t);
                const Vec3 normal = row.surface(shape, again.origin, crossings.at[i].part).normal;
                const double speed = std::abs(dot(normal, ray.dir));
                if (speed < 0.05 * length(ray.dir)) continue;   // grazing: the way along the ray is much longer than along the normal
                const Crossings second = row.crossings(shape, again);
                double nearest = kInf, error = 0;
                for (int k = 0; k < second.count; ++k)
                    if (std::abs(second.at[k].t) < nearest) nearest = std::abs(second.at[k].t), error = row.error(shape, again, second.at[k].t, second.at[k].part).along_normal;
                ASSERT_LE(nearest * speed, 1.5 * (row.error(shape, ray, crossings.at[i].t, crossings.at[i].part).along_normal + error));
            }
        });
    }
}

/// Powers of two change no digit: neither of the scene nor of the ray's direction.
TEST_P(EveryShape, ScaleByPowersOfTwoIsExact) {
    for_samples(4, 42, [&](const ShapeGeometry& shape, const Ray& ray, const Crossings& crossings) {
        for (const double k : {0x1p-40, 0x1p-3, 2.0, 0x1p40}) {
            Ray scaled = ray, longer = ray;
            scaled.origin *= k;
            longer.dir *= k;
            const Crossings of_scene = row.crossings(test::placed(shape, k, Vec3(0)), scaled), of_dir = row.crossings(shape, longer);
            ASSERT_EQ(of_dir.count, crossings.count);
            ASSERT_EQ(of_scene.count, crossings.count);
            for (int i = 0; i < crossings.count; ++i) {
                ASSERT_EQ(of_dir.at[i].t, crossings.at[i].t / k);
                ASSERT_EQ(of_scene.at[i].t, crossings.at[i].t * k);
                ASSERT_EQ(of_scene.at[i].part, crossings.at[i].part);
            }
        }
    });
}

/// Shape and ray moved together: the same hits, within their errors.
TEST_P(EveryShape, TranslationMovesTheHits) {
    for_samples(4, 43, [&](const ShapeGeometry& shape, const Ray& ray, const Crossings& crossings) {
        const Vec3 offset = test::mobility(shape) * Vec3(1000, -500, 0.25);
        Ray moved = ray;
        moved.origin += offset;
        const Crossings there = row.crossings(test::placed(shape, 1, offset), moved);
        for (int i = 0; i < crossings.count; ++i) {
            const Vec3 normal = row.surface(shape, ray.at(crossings.at[i].t), crossings.at[i].part).normal;
            const double cosine = std::abs(dot(normal, normalized(ray.dir)));
            if (cosine < 0.05) continue;
            ASSERT_EQ(there.count, crossings.count);
            ASSERT_NEAR(there.at[i].t * length(ray.dir), crossings.at[i].t * length(ray.dir), 2e-11);   // the numbers of the shape are rounded at 1000
        }
    });
}

/// The line is in and out of the solid by turns, and out of a bounded one at both ends.
TEST_P(EveryShape, InsideAgreesWithTheCrossings) {
    for (const double distance : {0.5, 4.0, 1e4}) {
        for_samples(distance, 44, [&](const ShapeGeometry& shape, const Ray& ray, const Crossings& crossings) {
            if (!row.solid(shape)) return;
            std::vector<double> cuts;
            for (int i = 0; i < crossings.count; ++i) cuts.push_back(crossings.at[i].t);
            cuts.insert(cuts.begin(), cuts.empty() ? -1e6 : std::min(-1e6, 2 * cuts.front()));
            cuts.push_back(std::max(1e6, 2 * cuts.back()));
            bool expected = row.inside(shape, ray.at(cuts.front()));
            ASSERT_FALSE(expected && row.bounds(shape).finite());
            for (size_t i = 0; i + 1 < cuts.size(); ++i, expected = !expected) {
                if ((cuts[i + 1] - cuts[i]) * length(ray.dir) < 1e-9 * (1 + distance)) continue;   // too thin to have an inside
                ASSERT_EQ(row.inside(shape, ray.at(0.5 * (cuts[i] + cuts[i + 1]))), expected) << "interval " << i;
            }
        });
    }
}

TEST_P(EveryShape, NormalsAreUnitAndPointOutwards) {
    for_samples(4, 45, [&](const ShapeGeometry& shape, const Ray& ray, const Crossings& crossings) {
        for (int i = 0; i < crossings.count; ++i) {
            const Vec3 p = ray.at(crossings.at[i].t);
            const SurfacePoint s = row.surface(shape, p, crossings.at[i].part);
            ASSERT_NEAR(length(s.normal), 1, 1e-15);
            ASSERT_EQ(row.normal_at(shape, p, crossings.at[i].part), s.normal);
            if (row.shading_normal && !row.solid(shape)) continue;   // sheets within have no outside
            ASSERT_FALSE(row.inside(shape, p + 1e-9 * s.normal));
            if (!test::has_inside(shape)) continue;
            if (crossings.count < 2 || (crossings.at[1].t - crossings.at[0].t) * length(ray.dir) > 1e-3) {
                ASSERT_TRUE(row.inside(shape, p - 1e-9 * s.normal));
            }
        }
    });
}

/// Against the plane through three hits of neighbouring rays.
TEST_P(EveryShape, NormalsAgreeWithNeighbouringHits) {
    for_samples(4, 46, [&](const ShapeGeometry& shape, const Ray& ray, const Crossings& crossings) {
        if (crossings.count == 0) return;
        Vec3 side, up, p[3];
        orthonormal_basis(normalized(ray.dir), side, up);
        for (int k = 0; k < 3; ++k) {
            Ray neighbour = ray;
            neighbour.origin += 1e-6 * (k == 1 ? side : k == 2 ? up : Vec3(0));
            const Crossings hits = row.crossings(shape, neighbour);
            if (hits.count == 0 || hits.at[0].part != crossings.at[0].part) return;
            p[k] = neighbour.at(hits.at[0].t);
        }
        const Vec3 normal = row.surface(shape, p[0], crossings.at[0].part).normal;
        if (std::abs(dot(normal, normalized(ray.dir))) < 0.05) return;
        ASSERT_LT(length(cross(normal, normalized(cross(p[1] - p[0], p[2] - p[0])))), 1e-3);
    });
}

/// A step along dpdu changes u and not v, a step along dpdv the other way round; both lie in the surface.
TEST_P(EveryShape, TangentsAreDerivativesOfTheTextureCoordinates) {
    for_samples(4, 47, [&](const ShapeGeometry& shape, const Ray& ray, const Crossings& crossings) {
        if (crossings.count == 0) return;
        const Vec3 p = ray.at(crossings.at[0].t);
        const uint32_t part = crossings.at[0].part;
        const SurfacePoint s = row.surface(shape, p, part);
        ASSERT_LT(std::abs(dot(s.normal, normalized(s.dpdu))), 1e-12);
        ASSERT_LT(std::abs(dot(s.normal, normalized(s.dpdv))), 1e-12);
        const double h = 1e-6;
        if (std::holds_alternative<Extrusion>(shape) && s.normal.z == 0) return;   // mapped by x and y, as POV-Ray does: constant along z
        if (length(s.dpdu) < 0.1 || length(s.dpdv) < 0.1) return;   // next to a pole the coordinates bend too much for differences
        const Vec2 du = (row.surface(shape, p + h * s.dpdu, part).uv - row.surface(shape, p - h * s.dpdu, part).uv) / (2 * h);
        const Vec2 dv = (row.surface(shape, p + h * s.dpdv, part).uv - row.surface(shape, p - h * s.dpdv, part).uv) / (2 * h);
        if (std::abs(du.x) > 1000) return;   // across the seam
        ASSERT_NEAR(du.x, 1, 1e-4);
        ASSERT_NEAR(du.y, 0, 1e-4);
        ASSERT_NEAR(dv.y, 1, 1e-4);
        ASSERT_NEAR(dv.x, 0, 1e-4);
    });
}

TEST_P(EveryShape, BrokenRaysHitNothing) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const ShapeGeometry shape = test::default_shape(row.kind);
    for (int axis = 0; axis < 3; ++axis) {
        for (const double bad : {nan, kInf, -kInf}) {
            Ray ray;
            ray.origin = Vec3(0.25, 0.5, -7), ray.dir = Vec3(0, -0.1, 1);
            ray.dir[axis] = bad;
            EXPECT_EQ(row.crossings(shape, ray).count, 0) << "direction " << axis << " " << bad;
            ray.dir = Vec3(0, -0.1, 1);
            ray.origin[axis] = bad;
            EXPECT_EQ(row.crossings(shape, ray).count, 0) << "origin " << axis << " " << bad;
        }
    }
    Ray still;
    still.dir = Vec3(0);
    EXPECT_EQ(row.crossings(shape, still).count, 0);
    still.origin = Vec3(0.25, 0, -1);
    EXPECT_EQ(row.crossings(shape, still).count, 0);
}

#ifdef ALIDADE_HAS_QUAD
/// The promise that shadow rays are built on: the true surface is within the error, along the normal, of ray.at(t) as computed and as it is exactly.
TEST_P(EveryShape, ErrorBoundsHoldAgainst113Bits) {
    test::Draw draw(48);
    double tightest = 0;   // the largest part of a bound that was needed
    int hits = 0;
    for (int i = 0; hits < 100000; ++i) {
        ASSERT_LT(i, 1000000);
        const double scale = draw.decades(-6, 6);
        const ShapeGeometry shape = [&] {
            const ShapeGeometry sample = test::sample_shape(row, i, draw);
            return test::placed(sample, scale, test::mobility(sample) * scale * draw.vector(draw.decades(-1, 4)));
        }();
        Ray ray = test::ray_from(draw.decades(-2, 8), draw);
        ray.origin *= scale;
        const Bounds box = row.bounds(shape);
        if (box.finite()) ray.origin += box.center();
        const Crossings crossings = row.crossings(shape, ray);
        for (int k = 0; k < crossings.count; ++k, ++hits) {
            const Crossing& c = crossings.at[k];
            const double bound = row.error(shape, ray, c.t, c.part).along_normal;
            const test::QuadVec exact = test::QuadVec(ray.origin) + test::Quad(c.t) * test::QuadVec(ray.dir), computed(ray.at(c.t));
            for (const test::QuadVec& p : {exact, computed}) {
                const double distance = double(std::visit([&](const auto& s) { return test::distance(s, p, c.part); }, shape));
                ASSERT_LE(distance, bound) << row.name << " " << i;
                tightest = std::max(tightest, distance / bound);
            }
        }
    }
    std::printf("[          ] %s: at most %.2f of an error bound is needed\n", row.name, tightest);
    EXPECT_GT(tightest, 0.05) << "a bound that is far too large costs contact shadows";
}
#endif

INSTANTIATE_TEST_SUITE_P(Shapes, EveryShape, testing::ValuesIn(shapes().begin(), shapes().end()),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(Shapes, EachRowHasItsKindNameAndText) {
    std::set<std::string> names;
    std::set<size_t> kinds;
    for (const ShapeOps& row : shapes()) {
        EXPECT_TRUE(names.insert(row.name).second);
        EXPECT_TRUE(kinds.insert(row.kind).second);
        EXPECT_GT(std::string(row.doc).size(), 5u);
        EXPECT_EQ(find_shape(test::default_shape(row.kind)), &row);
    }
    EXPECT_EQ(find_shape(Mesh()), nullptr);
    EXPECT_EQ(kinds.size() + 1, std::variant_size_v<ShapeGeometry>) << "every shape but the mesh has a row";
}

}  // namespace
}  // namespace alidade
