// SPDX-License-Identifier: Apache-2.0
/// Skinned and morphed meshes as they are rendered: beside the same shapes placed by nodes.
#include "tests/core/draw.h"
#include "tests/tracer/scene_builder.h"

namespace alidade::test {
namespace {

/// A square with room for a light and a camera, seen at an angle.
struct Stage : SceneBuilder {
    Stage() {
        light(DirectionalLight(), Color(2), Transform::rotate({1, 0, 0}, -0.6));
        camera({0.3, 0.4, 6}, {0, 0, 0}, 40);
    }
};

Mesh with_normals(Mesh mesh) {
    mesh.normals.values.assign(mesh.positions.size(), Vec3f(0, 0, 1));
    return mesh;
}

/// The greatest difference of any channel of any pixel.
double difference(const Picture& a, const Picture& b) {
    double most = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x)
            for (int c = 0; c < a.channels; ++c) most = std::max(most, double(std::abs(a.at(x, y)[c] - b.at(x, y)[c])));
    return most;
}

double covered(const Picture& p) {
    double sum = 0;
    for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x) sum += value(p, x, y, "coverage.Y");
    return sum;
}

TEST(Deformation, ARigidSkinRendersAsItsNodeWould) {
    Draw draw(9);
    for (int round = 0; round < 8; ++round) {
        const Transform place = Transform::translate(draw.vector(0.5)) * Transform::rotate(draw.direction(), draw(-0.9, 0.9)) *
                                Transform::scale({round % 2 ? 0.8 : -0.8, draw(0.5, 1.2), 1});
        Stage moved;
        moved.object(with_normals(square()), moved.material(moved.lambert(Color(0.8, 0.5, 0.2))), place);
        Stage skinned;
        Mesh mesh = with_normals(square());
        mesh.joint_sets.push_back({std::vector<Joints4>(4, Joints4(0, 0, 0, 0)), std::vector<Vec4f>(4, Vec4f(1, 0, 0, 0))});
        const NodeId body = skinned.object(std::move(mesh), skinned.material(skinned.lambert(Color(0.8, 0.5, 0.2))), Transform::translate({50, 0, 0}));
        Node joint;
        joint.to_parent = place;
        skinned.scene.skins.push_back({"s", {skinned.node(joint)}, {}});
        skinned.scene.nodes[body.index].skin = SkinId{0};
        const RenderOptions options = centre_rays(48, {"coverage", "normal"});
        const Film a = rendered(moved.scene, options), b = rendered(skinned.scene, options);
        EXPECT_GT(covered(a.picture), 100);
        EXPECT_LT(difference(a.picture, b.picture), 1e-5) << round;
    }
}

/// The tangents that a normal map needs are made of the deformed mesh: a map that leans to +u does so after a joint has turned the square.
TEST(Deformation, NormalMapsFollowTheDeformedMesh) {
    for (const bool skinned : {false, true}) {
        Stage b;
        GltfPbr bumpy = b.lambert(Color(1));
        bumpy.normal = b.constant({0.75, 0.5, 1, 1});
        const Transform turn = Transform::rotate({0, 0, 1}, 2);
        Mesh mesh = with_normals(square());
        if (skinned) mesh.joint_sets.push_back({std::vector<Joints4>(4, Joints4(0, 0, 0, 0)), std::vector<Vec4f>(4, Vec4f(1, 0, 0, 0))});
        const NodeId body = b.object(std::move(mesh), b.material(bumpy), skinned ? Transform() : turn);
        if (skinned) {
            Node joint;
            joint.to_parent = turn;
            b.scene.skins.push_back({"s", {b.node(joint)}, {}});
            b.scene.nodes[body.index].skin = SkinId{0};
        }
        const Film film = rendered(b.scene, centre_rays(3));
        // The light comes from (0, sin 0.6, cos 0.6); the normal leans by (0.5, 0, 1) towards the turned u.
        const Vec3 normal = normalized(turn.vector({0.5, 0, 1}));
        EXPECT_NEAR(value(film.picture, 1, 1, "R"), 2 / kPi * dot(normal, Vec3(0, std::sin(0.6), std::cos(0.6))), 1e-5) << skinned;
    }
}

}  // namespace
}  // namespace alidade::test
