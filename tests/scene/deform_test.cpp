// SPDX-License-Identifier: Apache-2.0
/// Morph targets and skins against closed forms and against what a node's transform does.
#include "scene/queries.h"
#include "tests/core/draw.h"
#include "tests/scene/sample_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alidade {
namespace {

using testing::HasSubstr;

/// Random triangles with normals and tangents.
Mesh soup(test::Draw& draw, int triangles = 20) {
    Mesh mesh;
    for (uint32_t i = 0; i < uint32_t(triangles); ++i) {
        Vec3 corner[3];
        for (Vec3& c : corner) mesh.positions.emplace_back(c = Vec3(Vec3f(draw.vector(2))));
        const Vec3 n = normalized(cross(corner[1] - corner[0], corner[2] - corner[0])), t = normalized(corner[1] - corner[0]);
        for (int k = 0; k < 3; ++k) mesh.normals.values.emplace_back(n), mesh.tangents.values.emplace_back(Vec3f(t), 1.0f);
        mesh.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    return mesh;
}

/// Every vertex goes wholly with joint 0.
void bind_to_first(Mesh& mesh) {
    mesh.joint_sets.resize(1);
    mesh.joint_sets[0].joints.assign(mesh.positions.size(), Joints4(0, 0, 0, 0));
    mesh.joint_sets[0].weights.assign(mesh.positions.size(), Vec4f(1, 0, 0, 0));
}

/// Node 0 shows `mesh` with a skin of the other nodes, all of them roots.
Scene skinned(Mesh mesh, const std::vector<Transform>& joints, std::vector<Transform> inverse_bind = {}) {
    Scene s;
    s.shapes.push_back({"skinned", std::move(mesh), {}});
    s.nodes.push_back(test::node_with(ShapeId{0}));
    s.nodes[0].skin = SkinId{0};
    s.roots = {NodeId{0}};
    s.skins.resize(1);
    s.skins[0].inverse_bind = std::move(inverse_bind);
    for (const Transform& joint : joints) {
        const NodeId id{uint32_t(s.nodes.size())};
        s.nodes.emplace_back();
        s.nodes.back().to_parent = joint;
        s.roots.push_back(id);
        s.skins[0].joints.push_back(id);
    }
    return s;
}

const Mesh& mesh_of(const Scene& s, NodeId node) { return std::get<Mesh>(s.shapes.at(std::get<ShapeId>(s.nodes.at(node.index).what).index).geometry); }
/// The mesh that deform() added last.
const Mesh& deformed_mesh(const Scene& s) { return mesh_of(s, s.roots.back()); }
Vec3 position(const Mesh& mesh, size_t i) { return Vec3(mesh.positions.at(i)) + mesh.origin; }

Transform random_affine(test::Draw& draw) {
    for (;;) {
        const Transform t = {Mat3(draw.vector(), draw.vector(), draw.vector()), draw.vector(5)};
        if (std::abs(t.determinant()) > 0.1) return t;
    }
}

TEST(Deform, ASceneWithoutMotionStaysAsItIs) {
    Scene s = test::sample_scene();
    s.skins.clear(), s.animations.clear();
    s.nodes[1].skin.reset(), s.nodes[1].morph_weights.clear();
    Mesh& mesh = std::get<Mesh>(s.shapes[3].geometry);
    mesh.morphs.clear(), mesh.morph_weights.clear(), mesh.joint_sets.clear();
    EXPECT_EQ(dump(deform(s)), dump(s));
}

TEST(Deform, LeavesAStill) {
    const Scene still = deform(test::sample_scene());
    EXPECT_FALSE(validate(still).has_errors()) << validate(still).text();
    EXPECT_EQ(dump(deform(still)), dump(still));
    EXPECT_TRUE(still.animations.empty() && still.skins.empty());
    for (const RequiredBy& r : requirements(still)) EXPECT_TRUE(r.what != Requirement::skins && r.what != Requirement::morphs) << name(r.what);
}

TEST(Morph, IsTheLinearCombination) {
    test::Draw draw(1);
    Mesh mesh = soup(draw);
    mesh.morphs.resize(3);
    for (MorphTarget& target : mesh.morphs) {
        for (size_t i = 0; i < mesh.positions.size(); ++i) {
            target.positions.emplace_back(draw.vector());
            target.normals.emplace_back(draw.vector(0.3));
            target.tangents.emplace_back(draw.vector(0.3));
        }
    }
    mesh.morphs[1].normals.clear(), mesh.morphs[1].tangents.clear();
    const std::vector<double> w = {0.5, -2, 1.25};
    Scene s = test::scene_of({test::node_with(ShapeId{0})});
    s.shapes[0].geometry = mesh;
    s.nodes[0].morph_weights = w;
    const Scene posed = deform(s);
    const Mesh& got = mesh_of(posed, NodeId{0});
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
        Vec3 p(mesh.positions[i]), n(mesh.normals.values[i]), t = Vec3(Vec4(mesh.tangents.values[i]));
        for (size_t k = 0; k < 3; ++k) {
            const MorphTarget& target = mesh.morphs[k];
            p += w[k] * Vec3(target.positions[i]);
            if (k != 1) n += w[k] * Vec3(target.normals[i]), t += w[k] * Vec3(target.tangents[i]);
        }
        ASSERT_LT(length(position(got, i) - p), 1e-6);
        ASSERT_LT(length(Vec3(got.normals.values[i]) - normalized(n)), 1e-6);
        ASSERT_LT(length(Vec3(Vec4(got.tangents.values[i])) - normalized(t)), 1e-6);
        ASSERT_EQ(got.tangents.values[i].w, 1);
    }
    EXPECT_EQ(mesh_of(s, NodeId{0}).positions, mesh.positions) << "the scene itself stays";
}

/// One mesh, shown at rest, with its own weights, with a node's weights twice, and with others: four shapes in the end.
TEST(Morph, OneCopyForEachSetOfWeights) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}};
    mesh.morphs.resize(1);
    mesh.morphs[0].positions.assign(3, Vec3f(0, 0, 1));
    mesh.morph_weights = {0.5};
    Scene s = test::scene_of(std::vector<Node>(6, test::node_with(ShapeId{0})));
    s.shapes[0].geometry = mesh;
    for (uint32_t i = 1; i < 6; ++i) s.nodes[0].children.push_back(NodeId{i});
    s.nodes[1].morph_weights = {0};
    s.nodes[2].morph_weights = s.nodes[3].morph_weights = {2};
    s.nodes[4].morph_weights = {3};
    s.nodes[5].morph_weights = {4};
    s.nodes[5].flags.visible = false;
    const Scene posed = deform(s);
    const double want[] = {0.5, 0, 2, 2, 3};
    for (uint32_t i = 0; i < 5; ++i) EXPECT_EQ(mesh_of(posed, NodeId{i}).positions[1], Vec3f(1, 0, float(want[i]))) << i;
    EXPECT_EQ(posed.shapes.size(), 4u);
    EXPECT_EQ(std::get<ShapeId>(posed.nodes[1].what), ShapeId{0});
    EXPECT_EQ(std::get<ShapeId>(posed.nodes[2].what), std::get<ShapeId>(posed.nodes[3].what));
}

/// Two bones along x, each one long, the second turned by an angle about z. Half of each bone is the rotation by half the angle times its cosine.
TEST(Skin, TwoBonesAtClosedFormAngles) {
    Mesh mesh;
    mesh.positions = {{2, 0, 0}, {1, 0, 0}, {1.5f, 0.25f, 0.5f}};
    mesh.triangles = {{0, 1, 2}};
    mesh.normals.values.assign(3, Vec3f(0, 1, 0));
    mesh.joint_sets.resize(1);
    mesh.joint_sets[0].joints.assign(3, Joints4(0, 1, 0, 0));
    mesh.joint_sets[0].weights = {Vec4f(0, 1, 0, 0), Vec4f(0.5f, 0.5f, 0, 0), Vec4f(0.5f, 0.5f, 0, 0)};
    for (double degrees = -170; degrees <= 170; degrees += 17) {
        const double a = degrees * kPi / 180;
        Scene s = skinned(mesh, {Transform(), Transform::translate({1, 0, 0}) * Transform::rotate({0, 0, 1}, a)},
                          {Transform(), Transform::translate({-1, 0, 0})});
        s.roots.pop_back();
        s.nodes[1].children = {NodeId{2}};
        s.nodes[0].to_parent = Transform::scale({0, 7, 7});   // the mesh's own node does not count, even where it is flat
        const Scene posed = deform(s);
        const Mesh& got = deformed_mesh(posed);
        EXPECT_TRUE(posed.nodes[posed.roots.back().index].to_parent.is_identity());
        EXPECT_LT(length(position(got, 0) - Vec3(1 + std::cos(a), std::sin(a), 0)), 2e-7) << degrees;
        EXPECT_LT(length(position(got, 1) - Vec3(1, 0, 0)), 2e-7) << degrees;
        const Vec3 half = std::cos(a / 2) * Transform::rotate({0, 0, 1}, a / 2).vector({0.5, 0.25, 0});
        EXPECT_LT(length(position(got, 2) - Vec3(1 + half.x, half.y, 0.5)), 2e-7) << degrees;
        EXPECT_LT(length(Vec3(got.normals.values[0]) - Vec3(-std::sin(a), std::cos(a), 0)), 2e-7);
        EXPECT_LT(length(Vec3(got.normals.values[2]) - Vec3(-std::sin(a / 2), std::cos(a / 2), 0)), 2e-7);
    }
}

TEST(Skin, IdentityIsTheRestShape) {
    test::Draw draw(2);
    Mesh mesh = soup(draw);
    mesh.joint_sets.resize(2);
    for (JointSet& set : mesh.joint_sets) {
        for (size_t i = 0; i < mesh.positions.size(); ++i) {
            set.joints.emplace_back(uint16_t(draw.below(3)), uint16_t(draw.below(3)), uint16_t(draw.below(3)), uint16_t(draw.below(3)));
            set.weights.emplace_back(float(draw(0, 1)), float(draw(0, 1)), float(draw(0, 1)), float(draw(0, 1)));   // their sum is not 1
        }
    }
    const Transform place = random_affine(draw);
    for (const bool placed : {false, true}) {
        const Transform joint = placed ? place : Transform();
        const Scene posed = deform(skinned(mesh, {joint, joint, joint}, std::vector<Transform>(3, placed ? *inverse(place) : Transform())));
        const Mesh& got = deformed_mesh(posed);
        for (size_t i = 0; i < mesh.positions.size(); ++i) {
            ASSERT_LT(length(position(got, i) - Vec3(mesh.positions[i])), placed ? 1e-6 : 1e-300);
            ASSERT_LT(length(Vec3(got.normals.values[i]) - Vec3(mesh.normals.values[i])), 1e-6);
            ASSERT_LT(length(Vec3(Vec4(got.tangents.values[i])) - Vec3(Vec4(mesh.tangents.values[i]))), 1e-6);
        }
    }
}

/// All weights on one joint: the vertices go where that node would carry them, normals by the transpose of its inverse, mirrored or not.
TEST(Skin, RigidlyBoundIsANodesTransform) {
    test::Draw draw(3);
    int mirrored = 0;
    for (int round = 0; round < 20; ++round) {
        Mesh mesh = soup(draw);
        mesh.origin = draw.vector();
        bind_to_first(mesh);
        const Transform joint = random_affine(draw), bind = random_affine(draw), all = joint * bind;
        mirrored += all.determinant() < 0;
        const Mesh got = deformed_mesh(deform(skinned(mesh, {joint}, {bind})));
        for (size_t i = 0; i < mesh.positions.size(); ++i) {
            const Vec3 want = all.point(position(mesh, i));
            ASSERT_LT(length(position(got, i) - want), 1e-6 * (1 + length(want)));
            ASSERT_LT(length(Vec3(got.normals.values[i]) - normalized(inverse(all)->transposed(Vec3(mesh.normals.values[i])))), 1e-6);
            ASSERT_LT(length(Vec3(Vec4(got.tangents.values[i])) - normalized(all.vector(Vec3(Vec4(mesh.tangents.values[i]))))), 1e-6);
            ASSERT_EQ(got.tangents.values[i].w, all.determinant() < 0 ? -1 : 1);
        }
        for (const Index3& t : got.triangles) {
            const Vec3 front = cross(position(got, t.y) - position(got, t.x), position(got, t.z) - position(got, t.x));
            ASSERT_GT(dot(front, Vec3(got.normals.values[t.x])), 0) << "counter-clockwise in front, mirrored or not";
        }
    }
    EXPECT_GT(mirrored, 3);
}

TEST(Skin, WeightsOfSeveralSetsCountAlike) {
    Mesh mesh;
    mesh.positions = {{1, 0, 0}, {0, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}};
    mesh.joint_sets.resize(2);
    mesh.joint_sets[0].joints.assign(3, Joints4(0, 1, 2, 3));
    mesh.joint_sets[1].joints.assign(3, Joints4(4, 5, 6, 7));
    // An eighth each; weights that add up to 4 and have to be scaled; and none at all.
    for (JointSet& set : mesh.joint_sets) set.weights = {Vec4f(0.125f), Vec4f(0.5f), Vec4f(0)};
    std::vector<Transform> joints;
    for (int i = 0; i < 8; ++i) joints.push_back(Transform::translate({0, 0, double(i)}));
    const Mesh got = deformed_mesh(deform(skinned(mesh, joints)));
    EXPECT_EQ(position(got, 0), Vec3(1, 0, 3.5));
    EXPECT_EQ(position(got, 1), Vec3(0, 0, 3.5));
    EXPECT_EQ(position(got, 2), Vec3(0, 1, 0)) << "a vertex without weights stays";
}

/// A value that corners share is split where its vertices turn differently.
TEST(Skin, NormalsThatCornersShare) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}};
    mesh.normals.values = {Vec3f(0, 1, 0)};
    mesh.normals.corners = {0, 0, 0};
    bind_to_first(mesh);
    mesh.joint_sets[0].joints[1] = Joints4(1, 0, 0, 0);
    const Mesh got = deformed_mesh(deform(skinned(mesh, {Transform(), Transform::rotate({0, 0, 1}, kPi / 2)})));
    for (int corner = 0; corner < 3; ++corner) {
        const Vec3 n(got.normals.values[got.normals.index(0, corner, got.triangles[0])]);
        EXPECT_LT(length(n - (corner == 1 ? Vec3(-1, 0, 0) : Vec3(0, 1, 0))), 1e-7) << corner;
    }
}

TEST(Skin, FarFromTheOriginVerticesKeepTheirDigits) {
    test::Draw draw(4);
    Mesh mesh = soup(draw);
    bind_to_first(mesh);
    const Transform far = Transform::translate({4e6, 0, -7e5}) * Transform::rotate({0, 1, 0}, 1);
    const Mesh got = deformed_mesh(deform(skinned(mesh, {far})));
    for (size_t i = 0; i < mesh.positions.size(); ++i) ASSERT_LT(length(position(got, i) - far.point(Vec3(mesh.positions[i]))), 1e-6);
}

TEST(Skin, HiddenJointsMoveAndHiddenMeshesStayHidden) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}};
    bind_to_first(mesh);
    Scene s = skinned(mesh, {Transform::translate({0, 0, 5})});
    s.nodes[1].flags.visible = false;
    EXPECT_EQ(position(deformed_mesh(deform(s)), 0), Vec3(0, 0, 5));
    s.nodes[0].flags.visible = false;
    const Scene hidden = deform(s);
    EXPECT_EQ(hidden.shapes.size(), 1u);
    EXPECT_EQ(hidden.roots.size(), s.roots.size());
}

/// Morphed first, then skinned, as the specification orders them; children of the skinned node and its materials stay.
TEST(Skin, AfterMorphing) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}};
    mesh.morphs.resize(1);
    mesh.morphs[0].positions.assign(3, Vec3f(1, 0, 0));
    bind_to_first(mesh);
    Scene s = skinned(mesh, {Transform::rotate({0, 0, 1}, kPi / 2)});
    s.nodes[0].morph_weights = {2};
    s.nodes[0].materials = {MaterialId{0}};
    s.nodes[0].children = {NodeId{2}};
    s.nodes.push_back(test::node_with(ShapeId{0}));
    const Scene posed = deform(s);
    EXPECT_LT(length(position(deformed_mesh(posed), 0) - Vec3(0, 2, 0)), 1e-7);
    EXPECT_EQ(posed.nodes[posed.roots.back().index].materials.size(), 1u);
    EXPECT_TRUE(posed.nodes[posed.roots.back().index].children.empty());
    EXPECT_EQ(posed.nodes[0].children.size(), 1u);
    EXPECT_EQ(mesh_of(posed, NodeId{2}).positions, mesh.positions) << "the same mesh without a skin is at rest";
}

/// A small file must not ask for gigabytes: many nodes with weights of their own over one mesh.
TEST(Deform, HowMuchMayBeMade) {
    Mesh mesh;
    mesh.positions.assign(50'000, Vec3f(0));
    mesh.triangles = {{0, 1, 2}};
    mesh.morphs.resize(1);
    Scene s = test::scene_of(std::vector<Node>(1000, test::node_with(ShapeId{0})));
    s.shapes[0].geometry = std::move(mesh);
    for (uint32_t i = 1; i < 1000; ++i) s.nodes[0].children.push_back(NodeId{i});
    for (Node& node : s.nodes) node.morph_weights = {0.5};
    EXPECT_FALSE(validate(s).has_errors()) << "one copy";
    for (uint32_t i = 0; i < 1000; ++i) s.nodes[i].morph_weights = {double(i)};
    EXPECT_THAT(validate(s).text(), HasSubstr("deformed copies of meshes with more than"));
}

}  // namespace
}  // namespace alidade
