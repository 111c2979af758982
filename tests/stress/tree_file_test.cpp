// SPDX-License-Identifier: Apache-2.0
/// Trees as JSON, read by somebody else's parser: they hold every triangle, box by box, and their counts are those of the build.
#include "stress/tree_file.h"
#include "tests/core/folder_test.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <map>

namespace alidade::test {
namespace {

using nlohmann::json;

struct WhatIsInTree {
    size_t nodes = 0, leaves = 0, depth = 0, references = 0;
    double cost = 0;
    std::vector<int> seen;   // leaves that each triangle is in
};

Bounds box_of(const json& node) {
    const auto b = node.at("box").get<std::vector<double>>();
    return {{b.at(0), b.at(1), b.at(2)}, {b.at(3), b.at(4), b.at(5)}};
}

bool holds(const Bounds& outer, const Bounds& inner) { return outer.contains(inner.min) && outer.contains(inner.max); }

Bounds bounds_of(const StressMesh& mesh, uint32_t triangle, bool exact) {
    Bounds box;
    for (int k = 0; k < 3; ++k) {
        const uint32_t v = mesh.triangles.at(triangle)[k];
        box.extend(exact && !mesh.exact_positions.empty() ? mesh.exact_positions[v] : Vec3(mesh.positions[v]));
    }
    return box;
}

/// Each node comes after its parent, in its box, among its children, one deeper. Areas are those of boxes, and the cost follows from them.
WhatIsInTree walked(const json& tree, const StressMesh& mesh, bool exact, bool holds_vertices) {
    WhatIsInTree in;
    in.seen.resize(mesh.triangles.size());
    std::map<uint32_t, const json*> known;
    for (const json& node : tree) {
        const Bounds box = box_of(node);
        EXPECT_NEAR(node.at("area").get<double>(), 2 * box.half_area(), 1e-9 * box.half_area());
        if (node.at("parent").is_null()) {
            EXPECT_TRUE(known.empty());
            EXPECT_EQ(node.at("depth"), 0);
        } else {
            const json& parent = *known.at(node.at("parent").get<uint32_t>());
            EXPECT_TRUE(holds(box_of(parent), box));
            EXPECT_EQ(node.at("depth").get<int>(), parent.at("depth").get<int>() + 1);
            EXPECT_THAT(parent.at("children").get<std::vector<uint32_t>>(), testing::Contains(node.at("node").get<uint32_t>()));
        }
        EXPECT_TRUE(known.emplace(node.at("node").get<uint32_t>(), &node).second) << "numbers are there once";
        const bool leaf = node.contains("primitives");
        const double share = node.at("area").get<double>() / tree.at(0).at("area").get<double>();
        in.cost += share * double(leaf ? node.at("primitives").size() : node.at("children").size());
        (leaf ? in.leaves : in.nodes) += 1;
        if (!leaf) {
            in.depth = std::max(in.depth, node.at("depth").get<size_t>());
            continue;
        }
        for (const uint32_t id : node.at("primitives").get<std::vector<uint32_t>>()) {
            ++in.seen.at(id), ++in.references;
            EXPECT_TRUE(!holds_vertices || holds(box, bounds_of(mesh, id, exact))) << id;
        }
    }
    return in;
}

StressScene scene_of(const char* kind, size_t triangles) {
    StressScene scene = find_stress_kind(kind)->make(triangles, 1);
    auto& mesh = scene.mesh();
    mesh.triangles.push_back(Index3(0, 0, 0)), mesh.triangles.push_back(Index3(0, 1, 4000000000u));   // removed
    if (mesh.exact_positions.empty())
        for (const Vec3f& p : mesh.positions) mesh.exact_positions.push_back(Vec3(p) * (1 + 1e-12));
    return scene;
}

TEST(TreeFile, HoldsEveryTriangleBoxByBox) {
    size_t splits = 0;
    for (const char* kind : {"scan", "architecture", "stadium", "needle"})
        for (const char* name : {"bvh", "hlbvh", "octree"})
            for (const Precision precision : {Precision::float_, Precision::double_}) {
                SCOPED_TRACE(std::string(kind) + " " + name);
                const StressScene scene = scene_of(kind, 1500);
                const auto built = find_accelerator(name)->over_triangles(scene.mesh().view(), {precision});
                std::string text;
                ASSERT_TRUE(tree_json(*built, scene.mesh().triangles.size(), [&](std::string_view piece) { text += piece; }));
                const json tree = json::parse(text);
                const BuildStats& stats = built->stats();
                const bool octree = std::string_view(name) == "octree";
                const WhatIsInTree in = walked(tree.at("tree"), scene.mesh(), precision == Precision::double_, !octree && stats.splits == 0);
                splits += stats.splits;
                EXPECT_EQ(tree.at("triangles"), scene.mesh().triangles.size());
                EXPECT_EQ(tree.at("primitives"), stats.primitives);
                EXPECT_EQ(tree.at("leaves"), in.leaves);
                EXPECT_EQ(tree.at("references"), in.references);
                EXPECT_EQ(tree.at("removed").get<std::vector<uint32_t>>(), stats.removed);
                EXPECT_EQ(tree.at("sah_cost").get<double>(), stats.sah_cost) << "read back exactly";
                EXPECT_EQ(size_t(std::count(in.seen.begin(), in.seen.end(), 0)), stats.removed.size());
                if (octree) continue;
                EXPECT_EQ(tree.at("nodes"), in.nodes);
                EXPECT_EQ(tree.at("depth"), in.depth);
                EXPECT_NEAR(in.cost, stats.sah_cost, 1e-6 * stats.sah_cost);
                EXPECT_LE(*std::max_element(in.seen.begin(), in.seen.end()), stats.splits ? 1500 : 1);
            }
    EXPECT_GT(splits, 0u) << "some trees must be split in space";
}

/// The binary tree over instances, too: each primitive in one leaf.
class Points final : public PrimitiveSet {
  public:
    size_t size() const override { return 100; }
    Bounds bounds(uint32_t id) const override { return {Vec3(id), Vec3(id + 0.5)}; }
    bool intersect(std::span<const uint32_t>, const Ray&, Hit&, WorkCounters&) const override { return false; }
    bool occluded(std::span<const uint32_t>, const Ray&, WorkCounters&) const override { return false; }
    void all_hits(std::span<const uint32_t>, const Ray&, std::vector<Hit>&, WorkCounters&) const override {}
};

TEST(TreeFile, SetsHaveTreesAndListsHaveNone) {
    for (const AcceleratorEntry& entry : accelerators()) {
        const auto built = entry.over_set(std::make_shared<Points>(), {});
        std::vector<int> seen(100);
        size_t nodes = 0;
        const bool tree = built->visit_nodes([&](const TreeNode& node) {
            ++nodes;
            for (const uint32_t id : node.primitives) {
                ++seen.at(id);
                EXPECT_TRUE(node.leaf);
                EXPECT_TRUE(node.box.overlaps(Points().bounds(id)));
            }
        });
        const std::string_view name = entry.name;
        EXPECT_EQ(tree, name != "brute" && name != "grid") << name;
        EXPECT_TRUE(tree || nodes == 0) << name;
        EXPECT_TRUE(!name.ends_with("bvh") || nodes == built->stats().nodes + built->stats().leaves) << name;   // inner nodes, and leaves behind them
        EXPECT_TRUE(!tree || name == "octree" || std::count(seen.begin(), seen.end(), 1) == 100) << name;
    }
}

class TreeFiles : public FolderTest {};

TEST_F(TreeFiles, AreWrittenWholeOrNotAtAll) {
    StressScene scene = scene_of("scan", 300);
    scene.meshes.push_back(find_stress_kind("soup")->make(40, 2).mesh());
    const std::string path = at("tree.json");
    ASSERT_EQ(write_trees(path, *find_accelerator("bvh"), {}, scene), true);
    std::ifstream in(path);
    const json document = json::parse(in);
    EXPECT_EQ(document.at("schema"), 1);
    EXPECT_EQ(document.at("accelerator"), "bvh");
    EXPECT_EQ(document.at("precision"), "float");
    ASSERT_EQ(document.at("trees").size(), 2u);
    EXPECT_EQ(document.at("trees").at(1).at("mesh"), 1);
    EXPECT_EQ(document.at("trees").at(1).at("triangles"), scene.meshes[1].triangles.size());

    EXPECT_EQ(write_trees(at("grid.json"), *find_accelerator("grid"), {}, scene), false);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1) << "no file, no part of one";
    const auto nowhere = write_trees(at("no/tree.json"), *find_accelerator("bvh"), {}, scene);
    ASSERT_FALSE(nowhere);
    EXPECT_THAT(nowhere.error(), testing::HasSubstr("cannot write"));
}

/// Nothing to hold is a tree without nodes, and no broken file.
TEST(TreeFile, OfNothingIsEmpty) {
    std::string text;
    ASSERT_TRUE(tree_json(*find_accelerator("bvh")->over_triangles({}, {}), 0, [&](std::string_view piece) { text += piece; }));
    EXPECT_TRUE(json::parse(text).at("tree").empty());
}

}  // namespace
}  // namespace alidade::test
