// SPDX-License-Identifier: Apache-2.0
/// Every structure shares one triangle kernel; this test shares nothing with it. Moeller-Trumbore in long double, as a textbook has it, is right
/// where a ray stays clear of edges and does not graze: there the hits must be the same.
#include "numerics/triangles/compare.h"
#include "numerics/triangles/rays.h"
#include "tests/core/run_size.h"

#include <gtest/gtest.h>

namespace alidade::test {

using namespace numerics;

namespace {

using Real = long double;
using RealVec = Vec3T<Real>;

struct NaiveHit {
    Real t = std::numeric_limits<Real>::infinity();
    uint32_t primitive = kNoId;
    bool clear = true;  ///< no triangle was met near an edge, at a grazing angle, or at nearly the same t
};

NaiveHit naive_first_hit(const TriangleMesh& mesh, const Ray& ray) {
    constexpr Real margin = 1e-6L;
    NaiveHit first;
    const RealVec dir(ray.dir), origin(ray.origin);
    for (uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const RealVec p0(mesh.corner(i, 0)), e1 = RealVec(mesh.corner(i, 1)) - p0, e2 = RealVec(mesh.corner(i, 2)) - p0;
        const RealVec p = glm::cross(dir, e2), from = origin - p0, q = glm::cross(from, e1);
        const Real det = glm::dot(e1, p), u = glm::dot(from, p) / det, v = glm::dot(dir, q) / det, t = glm::dot(e2, q) / det;
        const Real nearest_edge = std::min({u, v, 1 - u - v});
        const bool grazing = std::abs(det) < margin * glm::length(dir) * glm::length(e1) * glm::length(e2);
        if (grazing || (std::abs(nearest_edge) < margin && t > -margin) || (nearest_edge > 0 && std::abs(t) < margin)) first.clear = false;
        if (!(nearest_edge > 0) || !(t >= 0)) continue;
        if (std::abs(t - first.t) < margin) first.clear = false;
        if (t < first.t) first.t = t, first.primitive = i;
    }
    return first;
}

TEST(Naive, MoellerTrumboreInLongDoubleAgreesAwayFromEdges) {
    const size_t count = run_size(4000, 200000);
    for (const TriangleMesh& source :
         {geodesic_sphere(4), torus(16, 10), soup(300, 0.3, 2), cube(5), moved(torus(16, 10), Vec3(2, 0.5, 1), Vec3(3, -5, 1), "moved torus")}) {
        for (const Precision precision : {Precision::float_, Precision::double_}) {
            const TriangleMesh mesh = source.read_at(precision);
            const auto brute = brute_force(mesh, precision);
            size_t clear_hits = 0;
            for (size_t i = 0; i < count; ++i) {
                const Ray ray = ray_classes().front().make(mesh, RandomKey(81, 0, i, 0));
                const NaiveHit want = naive_first_hit(mesh, ray);
                if (!want.clear) continue;
                const Hit got = first_hit(*brute, ray);
                ASSERT_EQ(got.primitive, want.primitive) << mesh.name << ", " << name(precision) << ", seed 81, ray " << i << ": " << describe(ray);
                if (!got.valid()) continue;
                ++clear_hits;
                ASSERT_NEAR(got.t, double(want.t), 1e-9) << mesh.name << ", " << name(precision) << ", seed 81, ray " << i << ": " << describe(ray);
                const Vec3 a = mesh.corner(got.primitive, 0), b = mesh.corner(got.primitive, 1), c = mesh.corner(got.primitive, 2);
                const Vec3 point = (1.0 - got.u - got.v) * a + double(got.u) * b + double(got.v) * c;
                ASSERT_LE(max_abs(point - ray.at(got.t)), 1e-5)
                    << mesh.name << ", " << name(precision) << ", seed 81, ray " << i << ": " << describe(ray);
            }
            EXPECT_GT(clear_hits, count / 2) << mesh.name << ": the test must exercise hits";
        }
    }
}

}  // namespace
}  // namespace alidade::test
