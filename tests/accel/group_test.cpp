// SPDX-License-Identifier: Apache-2.0
/// Rays that are asked together: the hits of each by itself, and less work where they go the same way.
#include "accel/bvh/wide_group.h"
#include "accel/lazy.h"
#include "core/draws.h"
#include "numerics/triangles/compare.h"
#include "numerics/triangles/rays.h"
#include "tests/core/run_size.h"

#include <gtest/gtest.h>

namespace alidade::test {

using namespace numerics;

namespace {

constexpr uint64_t kSeed = 41;

Vec3 random_point(Draws& draws, double size) { return {draws.uniform(-size, size), draws.uniform(-size, size), draws.uniform(-size, size)}; }

/// As many rays as a group has, of one octant: from one point or from several, more or less apart.
std::array<LocalRay, kGroup> similar_rays(Draws& draws) {
    const double scale = std::ldexp(1.0, int(draws.below(100)) - 50), apart = std::ldexp(1.0, -int(draws.below(24))), moved = draws.coin() ? 0 : scale * std::ldexp(1.0, -int(draws.below(24)));
    const Vec3 origin = draws.below(8) ? random_point(draws, scale) : Vec3(0);
    Vec3 dir(draws.sign() * draws.uniform(0.1, 1), draws.sign() * draws.uniform(0.1, 1), draws.sign() * draws.uniform(0.1, 1));
    const uint32_t flat = draws.below(8);   // an axis along which some, or all, hardly go
    std::array<LocalRay, kGroup> rays;
    for (LocalRay& ray : rays) {
        ray.origin = origin + random_point(draws, moved), ray.dir = dir * (Vec3(1) + random_point(draws, 0.9 * apart));
        if (flat < 3 && draws.coin()) ray.dir[int(flat)] *= std::ldexp(1.0, -int(draws.below(60)));
        if (flat == 3) ray.dir.x = 0;
        ray.inverse = Vec3(1.0) / ray.dir, ray.tmin = draws.coin() ? 0 : scale / 16, ray.reach = 64 * scale;
    }
    return rays;
}

/// Boxes around points of the rays, tight or not, and some of anywhere.
template <class R> WideNode<R> node_on(const std::array<LocalRay, kGroup>& rays, Draws& draws) {
    WideNode<R> node{};
    for (uint32_t i = 0; i < kWide; ++i) {
        const LocalRay& ray = rays[draws.below(kGroup)];
        const double scale = max_abs(ray.origin) + 1e-30, size = draws.coin() ? 0 : scale * std::ldexp(1.0, -int(draws.below(30)));
        const Vec3 at = ray.origin + draws.uniform(0, 4) * scale * ray.dir + (draws.below(4) ? Vec3(0) : random_point(draws, scale));
        BoundsT<R> box;
        for (int a = 0; a < 3; ++a) box.min[a] = R(at[a] - size * draws.uniform(0, 1)), box.max[a] = std::max(box.min[a], R(at[a] + size * draws.uniform(0, 1)));
        node.set_box(i, box);
    }
    return node;
}

template <class R> class GroupBoxes : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(GroupBoxes, Reals);

/// Bit for bit: no rounding may take a box from the group that one of its rays enters, and of each box the rays are those that enter it.
TYPED_TEST(GroupBoxes, AreThoseOfTheRaysAndFewMore) {
    using R = TypeParam;
    size_t entered = 0, in_vain = 0, groups = 0;
    const size_t count = run_size(100000, 10000000);
    for (const Isa isa : available_isas()) {
        const GroupBoxTest<R> test = group_box_test<R>(isa);
        ASSERT_EQ(test != nullptr, fuses(isa)) << name(isa);
        for (size_t n = 0; test && n < count; ++n) {
            Draws draws(RandomKey(kSeed, 0, n, 0));
            const auto rays = similar_rays(draws);
            const WideNode<R> node = node_on<R>(rays, draws);
            const R limit = draws.coin() ? std::numeric_limits<R>::max() : R(draws.uniform(0, 4) * max_abs(rays[0].origin));
            GroupBoxBits bits{};
            if (!test(node, rays, 4, limit, bits)) continue;
            ++groups;
            for (uint32_t i = 0; i < kWide; ++i) {
                uint32_t alone = 0;
                for (uint32_t k = 0; k < kGroup; ++k) alone |= (bits.alone[k] >> i & 1) << k;
                ASSERT_EQ(bits.rays[i], alone) << name(isa) << ", seed 41, node " << n << ", box " << i;
                if (alone) { ASSERT_TRUE(bits.together >> i & 1) << name(isa) << ", seed 41, node " << n << ", box " << i; }
                entered += alone != 0, in_vain += !alone && (bits.together >> i & 1);
            }
        }
        if (!test) continue;
        EXPECT_GT(groups, count * 9 / 10);
        EXPECT_GT(entered, groups);
        EXPECT_LT(in_vain, entered / 2) << "a group must not enter everything";
        groups = entered = in_vain = 0;
    }
}

/// What a camera near the mesh, or far away, sends through 4 x 4 pixels, coarse or fine, and sometimes rays that have nothing in common.
std::vector<Ray> square_of_rays(const TriangleMesh& mesh, Draws& draws) {
    const Bounds box = mesh.bounds();
    const Vec3 middle = box.center(), half = (box.max - box.min) * 0.5;
    const double far = draws.below(4) == 0 ? 1e5 : draws.coin() ? 3 : 0.7, pixel = std::ldexp(1.0, -int(draws.below(16))), jitter = draws.coin() ? 0.5 : 0;
    const Vec3 eye = middle + far * half * Vec3(draws.uniform(-1, 1), draws.uniform(-1, 1), draws.uniform(-1, 1)), at = middle + half * random_point(draws, 1);
    std::vector<Ray> rays;
    for (uint32_t k = 0; k < kGroup; ++k) {
        Ray ray;
        ray.origin = eye;
        ray.dir = at + half * pixel * Vec3(k % 4 + draws.uniform(0, jitter), k / 4 + draws.uniform(0, jitter), 0) - eye;
        if (draws.below(100) == 0) ray = ray_classes()[draws.below(uint32_t(ray_classes().size()))].make(mesh, RandomKey(kSeed, 3, draws.below(1000), k));
        if (draws.below(10) == 0) ray.tmin = draws.uniform(0, 2), ray.tmax = draws.uniform(0, 4);
        rays.push_back(ray);
    }
    return rays;
}

class Together : public testing::TestWithParam<const AcceleratorEntry*> {};

/// All structures, precisions and instructions; groups that are not full, too.
TEST_P(Together, GiveTheHitsOfEachByItself) {
    size_t hits = 0, asked = 0, squares = 0, shared = 0, parted = 0;
    for (const Precision precision : {Precision::float_, Precision::double_})
        for (const Isa isa : available_isas()) {
            for (const TriangleMesh& given : {torus(40, 30), geodesic_sphere(12), soup(3000, 0.05, 6), soup(20000, 0.01, 6)}) {
                const TriangleMesh mesh = given.read_at(precision);
                AccelOptions options;
                options.precision = precision, options.isa = isa;
                const auto accelerator = build(*GetParam(), mesh, options);
                for (size_t n = 0; n < std::max(run_size(200, 20000), size_t(40)); ++n) {
                    Draws draws(RandomKey(kSeed, 1, n, 0));
                    auto rays = square_of_rays(mesh, draws);
                    if (n % 7 == 0) rays.resize(kGroup - draws.below(kGroup));
                    std::vector<Hit> found(rays.size(), Hit{-1, 0, 0, 0, 0, 0, {}});
                    WorkCounters together, alone;
                    accelerator->intersect_many(rays, found, together);
                    for (size_t i = 0; i < rays.size(); ++i, ++asked) {
                        Hit want;
                        accelerator->intersect(rays[i], want, alone);
                        ASSERT_EQ(difference(found[i], want), "") << mesh.name << ", " << name(isa) << ", square " << n << ", ray " << i << ": " << describe(rays[i]);
                        hits += found[i].valid();
                    }
                    shared += together.boxes < alone.boxes, parted += together.boxes > alone.boxes, ++squares;
                }
            }
        }
    EXPECT_GT(hits, asked / 5);
    EXPECT_LT(hits, asked);
    const std::string_view who = GetParam()->name;
    if (who != "bvh" && who != "hlbvh" && who != "compact") {   // which in double is bvh
        EXPECT_EQ(shared + parted, 0u);
    } else if (GroupOf<WideNode<float>, TriangleLeaf<float>>::traversal(Isa::best)) {
        EXPECT_GT(shared, squares / 20) << "squares must go together";
        EXPECT_GT(parted, squares / 100) << "and some must part on the way";
    }
}

INSTANTIATE_TEST_SUITE_P(Registry, Together, testing::ValuesIn(accelerators_under_test()), [](const auto& info) { return std::string(info.param->name); });

/// A mesh, seen through all pixels, in squares.
std::vector<Ray> picture(const TriangleMesh& mesh, size_t side) {
    const Bounds box = mesh.bounds();
    const Vec3 middle = box.center(), half = (box.max - box.min) * 0.5, eye = middle + Vec3(1.7, 2.3, 3.1) * half, right = normalized(cross(Vec3(0, 1, 0), middle - eye)), up = cross(middle - eye, right);
    std::vector<Ray> rays;
    for (size_t y = 0; y < side; y += 4)
        for (size_t x = 0; x < side; x += 4)
            for (size_t k = 0; k < kGroup; ++k) {
                const double u = double(x + k % 4) / double(side) - 0.5, v = double(y + k / 4) / double(side) - 0.5;
                Ray ray;
                ray.origin = eye, ray.dir = middle - eye + u * 2 * length(half) * right + v * 2 * length(half) * normalized(up);
                rays.push_back(ray);
            }
    return rays;
}

/// Boxes tested for all rays: together, and one by one.
std::pair<uint64_t, uint64_t> boxes_tested(const TriangleMesh& mesh, size_t side) {
    const auto accelerator = build(*find_accelerator("bvh"), mesh, {});
    const std::vector<Ray> rays = picture(mesh, side);
    std::vector<Hit> hits(rays.size());
    WorkCounters together, alone;
    accelerator->intersect_many(rays, hits, together);
    for (size_t i = 0; i < rays.size(); ++i) {
        Hit hit;
        accelerator->intersect(rays[i], hit, alone);
        EXPECT_EQ(difference(hits[i], hit), "") << mesh.name << ", ray " << i;
    }
    EXPECT_EQ(together.rays, alone.rays);
    EXPECT_LT(double(together.filtered), 1.15 * double(alone.filtered));
    return {together.boxes, alone.boxes};
}

TEST(GroupWork, IsLessWhereRaysGoTheSameWay) {
    if (!GroupOf<WideNode<float>, TriangleLeaf<float>>::traversal(Isa::best)) GTEST_SKIP() << "no groups without fused products";
    const auto [together, alone] = boxes_tested(torus(40, 30), 128);
    EXPECT_LT(together, alone * 2 / 5);
}

/// Triangles smaller than pixels: a group that parts has done some work for nothing, but those after it are not tried for a while.
TEST(GroupWork, IsHardlyMoreWhereTheyDoNot) {
    if (!GroupOf<WideNode<float>, TriangleLeaf<float>>::traversal(Isa::best)) GTEST_SKIP() << "no groups without fused products";
    for (const auto& [side, most] : {std::pair(16, 1.1), {32, 1.1}, {64, 1.35}}) {   // of the last, some go together
        const auto [together, alone] = boxes_tested(soup(100000, 0.01, 6), size_t(side));
        EXPECT_LT(double(together), most * double(alone)) << side;
    }
}

/// One that is built late answers, too, by itself and when it is there.
TEST(GroupWork, OfALazyStructure) {
    const TriangleMesh mesh = torus(40, 30).read_at(Precision::float_);
    const auto lazy = over_triangles_lazily(*find_accelerator("bvh"), mesh.view(), {});
    const std::vector<Ray> rays = picture(mesh, 128);
    WorkCounters alone;
    for (int again = 0; again < 2; ++again) {
        std::vector<Hit> hits(rays.size());
        WorkCounters work;
        lazy->intersect_many(rays, hits, work);
        alone = {};
        for (size_t i = 0; i < rays.size(); ++i) {
            Hit hit;
            lazy->intersect(rays[i], hit, alone);
            EXPECT_EQ(difference(hits[i], hit), "");
        }
        if (GroupOf<WideNode<float>, TriangleLeaf<float>>::traversal(Isa::best)) { EXPECT_LT(work.boxes, alone.boxes * 9 / 10) << again; }
    }
}

}  // namespace
}  // namespace alidade::test
