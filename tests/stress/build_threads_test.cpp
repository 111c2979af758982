// SPDX-License-Identifier: Apache-2.0
/// The tree of any number of threads, byte by byte.
#include "accel/bvh/bvh.h"
#include "core/fingerprint.h"
#include "stress/rays.h"
#include "tests/core/run_size.h"

#include <algorithm>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <tuple>

namespace alidade::test {
namespace {

template <class T> uint64_t bytes_of(const T& array, uint64_t before) { return fingerprint(std::as_bytes(std::span(array)), before); }

auto numbers(const BuildStats& s) { return std::tuple(s.primitives, s.references, s.splits, s.split_candidates, s.nodes, s.leaves, s.depth, s.sah_cost); }

struct Tree {
    uint64_t binary, wide;
    BuildStats stats;
};

/// A negative growth stands for the fast builder.
template <class R> Tree tree_of(const StressMesh& mesh, double growth, int threads) {
    const TriangleSource<R> source(mesh.view());
    std::vector<uint32_t> order{1, 2, 3}, ids;   // as if there were unbounded ones
    for (uint32_t id = 0; id < source.size(); ++id)
        if (source.kind(id) == PrimitiveKind::bounded) ids.push_back(id);
    BuildInput<TriangleSource<R>> input{source, std::move(ids), {}, order};
    Tree out;
    const BvhLimits limits{kLanes, kLanes, Isa::best, growth, threads};
    auto references = bvh_references<R>(input, threads, std::max(0.0, growth));
    const auto nodes = growth < 0 ? build_bvh_fast(std::move(references), limits, order, out.stats) : build_bvh(std::move(references), limits, order, out.stats, growth > 0 ? &source : nullptr);
    EXPECT_EQ(out.stats.nodes, nodes.size());
    out.binary = bytes_of(nodes, bytes_of(order, kFingerprintOfNothing));
    out.wide = bytes_of(widened(nodes, out.stats, threads), kFingerprintOfNothing);
    return out;
}

class Threads : public testing::TestWithParam<const StressKind*> {};

/// With as many references as in some tens of subtrees, and more than one pass takes on one thread.
TEST_P(Threads, MakeTheSameTree) {
    const StressScene scene = GetParam()->make(std::max(run_size(60000), size_t(6000)), 2);
    size_t splits = 0;
    for (const double growth : {-1.0, 0.0, 0.1, kSplitGrowth}) {
        for (const StressMesh& mesh : scene.meshes) {
            const Tree one = tree_of<float>(mesh, growth, 1), one_in_double = tree_of<double>(mesh, growth, 1);
            for (const int threads : {2, 3, 8}) {
                const Tree many = tree_of<float>(mesh, growth, threads), many_in_double = tree_of<double>(mesh, growth, threads);
                EXPECT_EQ(many.binary, one.binary) << threads << " threads, growth " << growth;
                EXPECT_EQ(many.wide, one.wide) << threads << " threads, growth " << growth;
                EXPECT_EQ(numbers(many.stats), numbers(one.stats)) << threads << " threads, growth " << growth;
                EXPECT_EQ(std::tuple(many_in_double.binary, many_in_double.wide), std::tuple(one_in_double.binary, one_in_double.wide)) << threads << " threads in double, growth " << growth;
            }
            splits += one.stats.splits;
        }
    }
    EXPECT_TRUE(splits > run_size(100) || std::string_view(GetParam()->name) != "architecture") << "the test must exercise splits in space";
}

/// All of an accelerator: which triangles are left out, the bounds, and the packed leaves, seen by rays' hits and work.
TEST_P(Threads, MakeTheSameAccelerator) {
    const StressScene scene = GetParam()->make(std::max(run_size(40000), size_t(6000)), 3);
    for (const AcceleratorEntry& entry : accelerators().subspan(1)) {
        const auto one = entry.over_triangles(scene.mesh().view(), {Precision::float_, Isa::best, 1}), many = entry.over_triangles(scene.mesh().view(), {Precision::float_, Isa::best, 3});
        EXPECT_EQ(numbers(many->stats()), numbers(one->stats())) << entry.name;
        EXPECT_EQ(many->stats().removed, one->stats().removed) << entry.name;
        EXPECT_EQ(many->stats().bytes, one->stats().bytes) << entry.name;
        EXPECT_EQ(many->bounds().min, one->bounds().min) << entry.name;
        EXPECT_EQ(many->bounds().max, one->bounds().max) << entry.name;
        WorkCounters work_one, work_many;
        for (const StressRay& ray : camera_rays(scene, 24)) {
            Hit a, b;
            one->intersect(ray.ray(), a, work_one), many->intersect(ray.ray(), b, work_many);
            ASSERT_EQ(std::tuple(b.t, b.primitive, b.u, b.v), std::tuple(a.t, a.primitive, a.u, a.v)) << entry.name;
        }
        EXPECT_EQ(std::tuple(work_many.boxes, work_many.filtered, work_many.primitives), std::tuple(work_one.boxes, work_one.filtered, work_one.primitives)) << entry.name;
    }
}

std::vector<const StressKind*> kinds() {
    std::vector<const StressKind*> rows;
    for (const StressKind& kind : stress_kinds()) rows.push_back(&kind);
    return rows;
}

INSTANTIATE_TEST_SUITE_P(Kinds, Threads, testing::ValuesIn(kinds()), [](const auto& info) { return std::string(info.param->name); });

}  // namespace
}  // namespace alidade::test
