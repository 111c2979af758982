// SPDX-License-Identifier: Apache-2.0
#include "scene/queries.h"

#include "core/random.h"
#include "tests/scene/sample_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alidade {
namespace {

using testing::ElementsAre;

std::vector<std::vector<uint32_t>> paths(const Scene& scene) {
    std::vector<std::vector<uint32_t>> out;
    visit_paths(scene, [&](const Visit& v) {
        EXPECT_EQ(v.node, v.path.back());
        out.emplace_back();
        for (const NodeId id : v.path) out.back().push_back(id.index);
        return true;
    });
    return out;
}

//   0 ─┬─ 1 ─┬─ 3
//      │     └─ 3
//      └─ 2 ─── 3        4 is a root of its own
TEST(VisitPaths, EveryPathInDocumentOrder) {
    std::vector<Node> nodes(5);
    nodes[0].children = {NodeId{1}, NodeId{2}};
    nodes[1].children = {NodeId{3}, NodeId{3}};
    nodes[2].children = {NodeId{3}};
    Scene scene = test::scene_of(nodes);
    scene.roots = {NodeId{0}, NodeId{4}};
    EXPECT_THAT(paths(scene), ElementsAre(ElementsAre(0), ElementsAre(0, 1), ElementsAre(0, 1, 3), ElementsAre(0, 1, 3), ElementsAre(0, 2),
                                          ElementsAre(0, 2, 3), ElementsAre(4)));
}

/// Below a whole, and that alone, the last sibling comes first where that is asked for.
TEST(VisitPaths, WhatIsSeenFirst) {
    std::vector<Node> nodes(7);
    nodes[0].children = {NodeId{1}, NodeId{4}};
    nodes[1].children = {NodeId{2}, NodeId{3}};
    nodes[4].children = {NodeId{5}, NodeId{6}};
    nodes[4].whole = true;
    const auto order = [&](SiblingOrder how) {
        Scene scene = test::scene_of(nodes);
        scene.roots = {NodeId{0}};
        std::vector<uint32_t> out;
        visit_paths(scene, [&](const Visit& v) { return out.push_back(v.node.index), true; }, how);
        return out;
    };
    EXPECT_THAT(order(SiblingOrder::document), ElementsAre(0, 1, 2, 3, 4, 5, 6));
    EXPECT_THAT(order(SiblingOrder::seen_first), ElementsAre(0, 1, 2, 3, 4, 6, 5));
    nodes[0].whole = true;
    EXPECT_THAT(order(SiblingOrder::seen_first), ElementsAre(0, 4, 6, 5, 1, 3, 2));
}

TEST(VisitPaths, HiddenSubtreesAreLeftOut) {
    std::vector<Node> nodes(4);
    nodes[0].children = {NodeId{1}, NodeId{2}};
    nodes[1].children = {NodeId{3}};
    nodes[1].flags.visible = false;
    Scene scene = test::scene_of(nodes);
    EXPECT_THAT(paths(scene), ElementsAre(ElementsAre(0), ElementsAre(0, 2)));
    scene.nodes[0].flags.visible = false;
    EXPECT_TRUE(paths(scene).empty());
}

/// Two instances of one sphere: parent transforms come after those of the children.
TEST(VisitPaths, TransformsMultiplyAlongThePath) {
    std::vector<Node> nodes(4);
    nodes[0].children = {NodeId{1}, NodeId{2}};
    nodes[0].to_parent = Transform::scale(Vec3(2));
    nodes[1].to_parent = Transform::translate({1, 0, 0});
    nodes[2].to_parent = Transform::translate({0, 1, 0}) * Transform::rotate({0, 0, 1}, kPi / 2);
    nodes[1].children = nodes[2].children = {NodeId{3}};
    nodes[3].to_parent = Transform::translate({10, 0, 0});
    std::vector<Vec3> origins;
    visit_paths(test::scene_of(nodes), [&](const Visit& v) {
        if (v.node.index == 3) origins.push_back(v.to_world.point(Vec3(0)));
        return true;
    });
    ASSERT_EQ(origins.size(), 2u);
    EXPECT_EQ(origins[0], Vec3(22, 0, 0));
    EXPECT_LT(length(origins[1] - Vec3(0, 22, 0)), 1e-13);
}

TEST(VisitPaths, AChainOfAMillionNodes) {
    std::vector<Node> nodes(1000000);
    for (uint32_t i = 0; i + 1 < nodes.size(); ++i) nodes[i].children = {NodeId{i + 1}}, nodes[i].to_parent.translation.x = 1;
    size_t count = 0;
    double last = 0;
    visit_paths(test::scene_of(std::move(nodes)), [&](const Visit& v) {
        ++count;
        last = v.to_world.translation.x;
        return v.path.size() == count;
    });
    EXPECT_EQ(count, 1000000u);
    EXPECT_EQ(last, 999999);
}

/// Thirty diamonds in a row: 2^30 paths to the last node. Nobody has to walk them all.
TEST(VisitPaths, TheVisitorEndsTheWalk) {
    std::vector<Node> nodes(31);
    for (uint32_t i = 0; i < 30; ++i) nodes[i].children = {NodeId{i + 1}, NodeId{i + 1}};
    Scene scene = test::scene_of(nodes);
    scene.roots = {NodeId{0}, NodeId{0}};
    size_t calls = 0;
    visit_paths(scene, [&](const Visit&) { return ++calls < 100000; });
    EXPECT_EQ(calls, 100000u);
    calls = 0;
    visit_paths(scene, [&](const Visit&) { return ++calls < 1; });
    EXPECT_EQ(calls, 1u);
    EXPECT_EQ(path_count(scene), 0x1p32 - 2);
}

/// Random graphs, hidden nodes among them.
TEST(VisitPaths, AreAsManyAsCounted) {
    for (uint64_t seed = 0; seed < 200; ++seed) {
        const RandomKey key(seed, 0, 0, 0);
        std::vector<Node> nodes(12);
        for (uint32_t i = 0; i < 12; ++i) {
            nodes[i].flags.visible = key.uniform(100 * i) < 0.9;
            for (uint32_t child = i + 1; child < 12; ++child)
                if (key.uniform(100 * i + child) < 0.3) nodes[i].children.push_back(NodeId{child});
        }
        Scene scene = test::scene_of(std::move(nodes));
        scene.roots = {NodeId{0}, NodeId{2}};
        size_t calls = 0;
        visit_paths(scene, [&](const Visit&) { return ++calls, true; });
        EXPECT_EQ(path_count(scene), double(calls)) << seed;
    }
}

}  // namespace
}  // namespace alidade
