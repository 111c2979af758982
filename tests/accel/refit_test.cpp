// SPDX-License-Identifier: Apache-2.0
/// Refitted structures: the answers of brute force over the new positions, bit for bit, whatever moved; and what cannot be refitted is left as it was.
#include "accel/load.h"
#include "core/draws.h"
#include "numerics/triangles/compare.h"
#include "numerics/triangles/rays.h"
#include "tests/core/run_size.h"
#include "tests/core/folder_test.h"

#include <gtest/gtest.h>

#include <map>

namespace alidade::test {

using namespace numerics;

namespace {

TriangleMesh with_vertices(const TriangleMesh& mesh, std::vector<Vec3> vertices, Precision precision) { return TriangleMesh(mesh.name, std::move(vertices), mesh.triangles).read_at(precision); }

struct Pose {
    const char* name;
    Vec3 (*of)(const Vec3& v, uint32_t vertex);
};

/// From a turn that keeps every bit to a crumpling that leaves nothing where it was.
const Pose kPoses[] = {
    {"axes exchanged", [](const Vec3& v, uint32_t) { return Vec3(v.y, v.z, -v.x); }},
    {"twisted", [](const Vec3& v, uint32_t) { return Vec3(v.x * std::cos(2 * v.z) - v.y * std::sin(2 * v.z), v.x * std::sin(2 * v.z) + v.y * std::cos(2 * v.z), v.z); }},
    {"crumpled", [](const Vec3& v, uint32_t i) { Draws draws(RandomKey(141, 0, i, 0)); return v * draws.uniform(0.2, 2); }},
    {"torn apart", [](const Vec3& v, uint32_t i) { Draws draws(RandomKey(142, 0, i, 0)); return v + draws.in_box(Vec3(-3), Vec3(3)); }},
    {"far away and small", [](const Vec3& v, uint32_t) { return v * 1e-3 + Vec3(100, -50, 7); }},
};

TriangleMesh posed(const TriangleMesh& mesh, const Pose& pose, Precision precision) {
    std::vector<Vec3> vertices = mesh.vertices;
    for (uint32_t i = 0; i < vertices.size(); ++i) vertices[i] = pose.of(vertices[i], i);
    return with_vertices(mesh, std::move(vertices), precision);
}

std::vector<TriangleMesh> meshes() {
    std::vector<TriangleMesh> all = small_meshes();
    all.push_back(battens(60)), all.push_back(geodesic_sphere(8, 0.2));
    return all;
}

class Refit : public testing::TestWithParam<std::tuple<const char*, Precision>> {
  protected:
    const AcceleratorEntry& entry() const { return *find_accelerator(std::get<0>(GetParam())); }
    Precision precision() const { return std::get<1>(GetParam()); }
};

/// One structure goes from pose to pose. It refuses where, and only where, other triangles than before cannot be hit; a new one goes on then.
TEST_P(Refit, AnswersAsBruteForceOverTheNewPositions) {
    size_t refits = 0, refused = 0, hits = 0, asked = 0, splits = 0;
    for (const TriangleMesh& source : meshes()) {
        const TriangleMesh rest = source.read_at(precision());
        auto structure = build(entry(), rest, {precision()});
        splits += structure->stats().splits;
        for (const Pose& pose : kPoses) {
            const TriangleMesh mesh = posed(rest, pose, precision());
            const auto brute = brute_force(mesh, precision());
            const bool same = brute->stats().removed == structure->stats().removed;
            ASSERT_EQ(structure->refit(mesh.view(), 1 + int(refits % 3)), same) << mesh.name << ' ' << pose.name;
            ++(same ? refits : refused);
            if (!same) structure = build(entry(), mesh, {precision()});
            EXPECT_EQ(structure->bounds().min, brute->bounds().min);
            EXPECT_EQ(structure->bounds().max, brute->bounds().max);
            for (const RayClass& rays : ray_classes()) {
                for (size_t i = 0; i < run_size(8, 200); ++i) {
                    const Ray ray = rays.make(mesh, RandomKey(143, 0, i, 0));
                    const Answers want = answers(*brute, ray);
                    hits += want.occluded, ++asked;
                    ASSERT_EQ(difference(answers(*structure, ray), want), "") << entry().name << ", " << mesh.name << ' ' << pose.name << ", " << rays.name << ": " << describe(ray);
                }
            }
        }
    }
    EXPECT_GT(refits, 10 * refused);
    EXPECT_GT(hits, asked / 4);
    EXPECT_TRUE(splits > 0 || std::string_view(entry().name) != "bvh") << "some trees must be split in space";
}

/// With `robust` and `fast` any tree differs from another where a ray is within the rounding of an edge: a refitted one from a new one no more often than two new ones, of different kinds, do.
TEST_P(Refit, OtherTestsOfTrianglesAnswerAsANewStructure) {
    for (const Intersect how : {Intersect::robust, Intersect::fast}) {
        size_t unlike = 0, usual = 0;
        for (const TriangleMesh& source : {geodesic_sphere(8, 0.2), torus(16, 10), soup(300, 0.3, 2), battens(40)}) {
            const AccelOptions options{precision(), Isa::best, 1, how};
            const auto structure = build(entry(), source.read_at(precision()), options);
            for (const Pose& pose : kPoses) {
                const TriangleMesh mesh = posed(source, pose, precision());
                ASSERT_TRUE(structure->refit(mesh.view()));
                const auto fresh = build(entry(), mesh, options), other = build(*find_accelerator(std::string_view(entry().name) == "bvh" ? "hlbvh" : "bvh"), mesh, options);
                for (const RayClass& of : ray_classes()) {
                    for (size_t i = 0; i < 20; ++i) {
                        const Ray ray = of.make(mesh, RandomKey(144, 0, i, 0));
                        const Answers want = answers(*fresh, ray);
                        unlike += !difference(answers(*structure, ray), want).empty(), usual += !difference(answers(*other, ray), want).empty();
                    }
                }
            }
        }
        EXPECT_LE(unlike, usual) << name(how);
    }
}

/// Boxes that tests of triangles need wider than they are, are so after a refit: nothing is lost at edges and vertices. From the origin, where only the boxes are widened, and from anywhere.
TEST_P(Refit, ClosedMeshesDoNotLeak) {
    const TriangleMesh& rest = closed_meshes().front();
    for (const Intersect how : {Intersect::exact, Intersect::robust}) {
        const auto structure = build(entry(), rest.read_at(precision()), {precision(), Isa::best, 1, how});
        size_t poses = 0;
        for (const TriangleMesh& closed : closed_meshes()) {
            if (closed.triangles != rest.triangles) continue;   // of another form
            const TriangleMesh mesh = closed.read_at(precision());
            if (!structure->refit(mesh.view())) continue;   // so far away, floats leave some without area
            ++poses;
            const bool around_origin = mesh.inside.contains(Vec3(0));
            for (size_t i = 0; i < run_size(4000, 100000); ++i) {
                Ray ray = (i % 4 < 3 ? edge_aimed_from_inside : vertex_aimed_from_inside)(mesh, RandomKey(148, 0, i, 0));
                if (around_origin && i % 2) ray.dir = ray.origin + ray.dir, ray.origin = Vec3(0);
                ASSERT_TRUE(first_hit(*structure, ray).valid()) << name(how) << ", " << mesh.name << ": " << describe(ray);
            }
        }
        EXPECT_GE(poses, 7u);
    }
}

struct Shown {
    std::map<uint32_t, TreeNode> nodes;                     // spans are those of the call: not to be used
    std::map<uint32_t, std::vector<uint32_t>> children, primitives;
};

Shown shown(const Accelerator& structure) {
    Shown out;
    structure.visit_nodes([&](const TreeNode& node) {
        out.nodes[node.number] = node;
        out.children[node.number].assign(node.children.begin(), node.children.end());
        out.primitives[node.number].assign(node.primitives.begin(), node.primitives.end());
    });
    return out;
}

/// Every box is the smallest one around what is below it, also where planes had cut triangles; and the cost is that of these boxes.
TEST_P(Refit, BoxesAreTight) {
    for (const TriangleMesh& source : {geodesic_sphere(12, 0.2), battens(60)}) {
        const auto structure = build(entry(), source.read_at(precision()), {precision()});
        const TriangleMesh mesh = posed(source, kPoses[1], precision());
        ASSERT_TRUE(structure->refit(mesh.view()));
        const Shown tree = shown(*structure);
        double cost = 0;
        for (const auto& [number, node] : tree.nodes) {
            Bounds box;
            for (const uint32_t child : tree.children.at(number)) box.extend(tree.nodes.at(child).box);
            for (const uint32_t id : tree.primitives.at(number))
                for (int k = 0; k < 3; ++k) box.extend(mesh.corner(id, k));
            EXPECT_EQ(node.box.min, box.min) << number;
            EXPECT_EQ(node.box.max, box.max) << number;
            cost += box.half_area() / tree.nodes.at(0).box.half_area() * double(tree.children.at(number).size() + tree.primitives.at(number).size());
        }
        EXPECT_NEAR(structure->stats().sah_cost, cost, 1e-6 * cost);
    }
}

/// The way there and back changes nothing, where no plane had cut a triangle; and the cost tells when to build anew.
TEST_P(Refit, CostTellsWhenToBuildAnew) {
    const TriangleMesh rest = soup(3000, 0.05, 3).read_at(precision());
    std::vector<Vec3> vertices = rest.vertices;
    for (uint32_t i = 0; i < vertices.size(); ++i) {
        Draws draws(RandomKey(147, 0, i / 3, 0));   // a triangle's corners go together
        vertices[i] = vertices[i] * 0.2 + draws.in_box(Vec3(-1), Vec3(1));
    }
    const TriangleMesh torn = with_vertices(rest, std::move(vertices), precision());
    const auto structure = build(entry(), rest, {precision()});
    ASSERT_EQ(structure->stats().splits, 0u);
    const double built = structure->stats().sah_cost;
    ASSERT_TRUE(structure->refit(posed(rest, kPoses[0], precision()).view()));
    EXPECT_NEAR(structure->stats().sah_cost, built, 1e-6 * built) << "a turn by a right angle";
    ASSERT_TRUE(structure->refit(torn.view()));
    EXPECT_GT(structure->stats().sah_cost, 2 * build(entry(), torn, {precision()})->stats().sah_cost);
    EXPECT_EQ(structure->stats().phases.back().name, std::string("refit"));
    ASSERT_TRUE(structure->refit(rest.view()));
    EXPECT_NEAR(structure->stats().sah_cost, built, 1e-6 * built);
}

/// Nothing is changed by what is refused.
TEST_P(Refit, RefusesOtherTriangles) {
    TriangleMesh mesh = geodesic_sphere(4);
    mesh.triangles.push_back(Index3(5, 5, 5));   // removed
    mesh = mesh.read_at(precision());
    const auto structure = build(entry(), mesh, {precision()}), untouched = build(entry(), mesh, {precision()});
    ASSERT_EQ(structure->stats().removed.size(), 1u);
    const auto refused = [&](const char* what, const TriangleMesh& other) {
        EXPECT_FALSE(structure->refit(other.view())) << what;
        EXPECT_EQ(structure->stats().sah_cost, untouched->stats().sah_cost) << what;
        for (size_t i = 0; i < 100; ++i) {
            const Ray ray = ray_classes().front().make(mesh, RandomKey(145, 0, i, 0));
            ASSERT_EQ(difference(answers(*structure, ray), answers(*untouched, ray)), "") << what;
        }
    };
    const auto changed = [&](uint32_t vertex, const Vec3& to) {
        std::vector<Vec3> vertices = mesh.vertices;
        vertices[vertex] = to;
        return with_vertices(mesh, vertices, precision());
    };
    const Index3 t = mesh.triangles[7];
    refused("without area", changed(t.x, mesh.vertices[t.y]));
    refused("not finite", changed(t.x, Vec3(std::nan(""), 0, 0)));
    refused("too large", changed(t.x, Vec3(0x1p500, 0, 0)));
    TriangleMesh more = mesh, fewer = mesh, good = mesh;
    more.triangles.push_back(t), fewer.triangles.pop_back(), good.triangles.back() = Index3(1, 2, 3);
    refused("one more", more);
    refused("one fewer", fewer);
    refused("the removed one has come back", good);
    EXPECT_TRUE(structure->refit(mesh.view()));
}

class RefitFiles : public FolderTest {};

/// Large enough that every thread has a part.
TEST_F(RefitFiles, BitsDoNotDependOnThreads) {
    const TriangleMesh mesh = soup(40000, 0.05, 3), moved = posed(mesh, kPoses[2], Precision::float_);
    for (const int threads : {1, 2, 5}) {
        const auto structure = build(*find_accelerator("bvh"), mesh.read_at(Precision::float_), {});
        ASSERT_TRUE(structure->refit(moved.view(), threads));
        ASSERT_TRUE(structure->save(at(std::to_string(threads)), moved.view()));
    }
    EXPECT_TRUE(text("1") == text("2") && text("1") == text("5"));
}

/// A mapped structure is moved in memory, never in its file.
TEST_F(RefitFiles, AMappedStructureBecomesACopy) {
    const TriangleMesh mesh = torus(16, 10).read_at(Precision::float_), moved = posed(mesh, kPoses[1], Precision::float_);
    ASSERT_TRUE(build(*find_accelerator("bvh"), mesh, {})->save(at("a"), mesh.view()));
    const std::string before = text("a");
    const auto loaded = load_accelerator(at("a"), mesh.view(), {});
    ASSERT_TRUE(loaded) << loaded.error();
    ASSERT_TRUE((*loaded)->refit(moved.view()));
    EXPECT_TRUE(text("a") == before);
    const auto brute = brute_force(moved, Precision::float_);
    for (size_t i = 0; i < 200; ++i) {
        const Ray ray = ray_classes()[i % ray_classes().size()].make(moved, RandomKey(146, 0, i, 0));
        ASSERT_EQ(difference(answers(**loaded, ray), answers(*brute, ray)), "");
    }
}

TEST(RefitTable, OnlyBvhsOverTrianglesCan) {
    const TriangleMesh mesh = cube(2).read_at(Precision::float_);
    for (const AcceleratorEntry& entry : accelerators()) {
        const std::string_view name = entry.name;
        EXPECT_EQ(build(entry, mesh, {})->refit(mesh.view()), name == "bvh" || name == "hlbvh") << name;
    }
    const auto none = find_accelerator("bvh")->over_triangles({}, {});
    EXPECT_TRUE(none->refit({}));
    EXPECT_FALSE(none->refit(mesh.view()));
}

INSTANTIATE_TEST_SUITE_P(Bvhs, Refit, testing::Combine(testing::Values("bvh", "hlbvh"), testing::Values(Precision::float_, Precision::double_)),
                         [](const auto& info) { return std::string(std::get<0>(info.param)) + "_" + name(std::get<1>(info.param)); });

}  // namespace
}  // namespace alidade::test
