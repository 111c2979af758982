// SPDX-License-Identifier: Apache-2.0
#include "scene/queries.h"
#include "tests/core/draw.h"
#include "tests/scene/sample_scene.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

/// One animated node.
Scene animated(ChannelPath path, Interpolation interpolation, std::vector<float> times, std::vector<float> values) {
    Scene s = test::scene_of({test::node_with(ShapeId{0})});
    s.nodes[0].trs = Trs();
    Channel c;
    c.target = NodeId{0};
    c.path = path;
    c.interpolation = interpolation;
    c.width = path == ChannelPath::rotation ? 4 : 3;
    c.times = std::move(times);
    c.values = std::move(values);
    s.animations.resize(1);
    s.animations[0].channels = {c};
    return s;
}

Vec3 translation_at(const Scene& s, double time) { return pose(s, time).nodes[0].to_parent.translation; }

/// The rotation at `time`, as the image of x.
Vec3 x_axis_at(const Scene& s, double time) { return pose(s, time).nodes[0].to_parent.linear[0]; }

TEST(Pose, StepHoldsAKeyUntilTheNext) {
    const Scene s = animated(ChannelPath::translation, Interpolation::step, {1, 2, 4}, {1, 0, 0, 2, 0, 0, 4, 0, 0});
    EXPECT_EQ(translation_at(s, 1), Vec3(1, 0, 0));
    EXPECT_EQ(translation_at(s, 1.999), Vec3(1, 0, 0));
    EXPECT_EQ(translation_at(s, 2), Vec3(2, 0, 0));
    EXPECT_EQ(translation_at(s, 3.999), Vec3(2, 0, 0));
    EXPECT_EQ(translation_at(s, 4), Vec3(4, 0, 0));
}

TEST(Pose, LinearBetweenKeysAndExactOnThem) {
    const Scene s = animated(ChannelPath::translation, Interpolation::linear, {1, 2, 4}, {0.1f, 0, 0, 2, 8, 0, 4, 0, -6});
    EXPECT_EQ(translation_at(s, 1), Vec3(0.1f, 0, 0));
    EXPECT_EQ(translation_at(s, 2), Vec3(2, 8, 0));
    EXPECT_EQ(translation_at(s, 3), Vec3(3, 4, -3));
    EXPECT_LT(length(translation_at(s, 3.5) - Vec3(3.5, 2, -4.5)), 1e-15);
}

TEST(Pose, ClampedOutsideItsKeys) {
    for (const Interpolation i : {Interpolation::step, Interpolation::linear}) {
        const Scene s = animated(ChannelPath::scale, i, {1, 2}, {2, 2, 2, 3, 4, 5});
        EXPECT_EQ(pose(s, -7).nodes[0].trs->scale, Vec3(2));
        EXPECT_EQ(pose(s, 99).nodes[0].trs->scale, Vec3(3, 4, 5));
        EXPECT_EQ(pose(s, kInf).nodes[0].to_parent.linear[2], Vec3(0, 0, 5));
    }
    const Scene s = animated(ChannelPath::translation, Interpolation::cubic, {1, 2}, {9, 9, 9, 1, 2, 3, 9, 9, 9, 9, 9, 9, 4, 5, 6, 9, 9, 9});
    EXPECT_EQ(translation_at(s, 0), Vec3(1, 2, 3));
    EXPECT_EQ(translation_at(s, 3), Vec3(4, 5, 6));
}

TEST(Pose, OneKeyAndEqualKeys) {
    EXPECT_EQ(translation_at(animated(ChannelPath::translation, Interpolation::linear, {1}, {5, 6, 7}), 3), Vec3(5, 6, 7));
    const Scene s = animated(ChannelPath::translation, Interpolation::linear, {1, 1, 2}, {0, 0, 0, 5, 0, 0, 6, 0, 0});
    EXPECT_EQ(translation_at(s, 1), Vec3(5, 0, 0));
    EXPECT_EQ(translation_at(s, 1.5), Vec3(5.5, 0, 0));
}

const float kHalf = std::sqrt(0.5f);

TEST(Pose, RotationTurnsAtConstantSpeed) {
    const Scene s = animated(ChannelPath::rotation, Interpolation::linear, {0, 1}, {0, 0, 0, 1, 0, 0, kHalf, kHalf});   // 90 degrees about z
    for (double t = 0; t <= 1; t += 0.125) EXPECT_LT(length(x_axis_at(s, t) - Vec3(std::cos(t * kPi / 2), std::sin(t * kPi / 2), 0)), 1e-7) << t;
}

TEST(Pose, RotationTakesTheShorterArc) {
    const Scene s = animated(ChannelPath::rotation, Interpolation::linear, {0, 1}, {0, 0, 0, 1, 0, 0, -kHalf, -kHalf});   // the same rotation, negated
    EXPECT_LT(length(x_axis_at(s, 0.5) - Vec3(std::sqrt(0.5), std::sqrt(0.5), 0)), 1e-7);
}

/// Slerp against the rotation by a fraction of the angle, about random axes; angles down to 1e-9.
TEST(Pose, RotationAgainstAxisAndAngle) {
    test::Draw draw(30);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 axis = draw.direction();
        const double angle = draw.decades(-9, 0.49), t = draw(0, 1);
        const auto part = [&](int k) { return float(std::sin(angle / 2) * axis[k]); };
        const std::vector<float> end = {part(0), part(1), part(2), float(std::cos(angle / 2))};
        const Scene s = animated(ChannelPath::rotation, Interpolation::linear, {0, 1}, {0, 0, 0, 1, end[0], end[1], end[2], end[3]});
        const Vec3 sine(end[0], end[1], end[2]);
        const double exact_angle = 2 * std::atan2(length(sine), double(end[3]));   // of the floats
        const Vec3 want = Transform::rotate(normalized(sine), t * exact_angle).vector({1, 0, 0});
        ASSERT_LT(length(x_axis_at(s, t) - want), 1e-14) << angle;
    }
}

TEST(Pose, PosedRotationsAreUnit) {
    const Scene s = animated(ChannelPath::rotation, Interpolation::cubic, {0, 2}, {0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, kHalf, kHalf, 0, 0, 0, 0});
    for (double t = 0; t <= 2; t += 0.25) {
        const Vec4 q = pose(s, t).nodes[0].trs->rotation;
        EXPECT_NEAR(dot(q, q), 1, 1e-15);
        EXPECT_NEAR(pose(s, t).nodes[0].to_parent.determinant(), 1, 1e-14);
    }
    const Scene zero = animated(ChannelPath::rotation, Interpolation::linear, {0}, {0, 0, 0, 0});
    EXPECT_TRUE(pose(zero, 0).nodes[0].to_parent.is_identity()) << "a quaternion of zeros turns nothing";
}

/// A cubic polynomial is its own Hermite spline: p(t) = t^3 - 2t^2 + 3t - 1, p'(t) = 3t^2 - 4t + 3, on uneven keys.
TEST(Pose, CubicReproducesAPolynomial) {
    const auto p = [](double t) { return ((t - 2) * t + 3) * t - 1; };
    const auto slope = [](double t) { return (3 * t - 4) * t + 3; };
    const std::vector<float> times = {-1, 0.5f, 4};
    std::vector<float> values;
    for (const float t : times)
        for (const double row : {slope(t), p(t), slope(t)})
            for (int component = 1; component <= 3; ++component) values.push_back(float(component * row));
    const Scene s = animated(ChannelPath::translation, Interpolation::cubic, times, values);
    for (double t = -1; t <= 4; t += 0.0625) EXPECT_LT(length(translation_at(s, t) - p(t) * Vec3(1, 2, 3)), 1e-12) << t;
}

/// On its keys a spline is the keys' values, to the last bit, whatever the tangents.
TEST(Pose, CubicIsExactOnItsKeys) {
    test::Draw draw(31);
    std::vector<float> times, values;
    for (int key = 0; key < 20; ++key) {
        times.push_back(float(key + draw(0, 0.9)));
        for (int k = 0; k < 9; ++k) values.push_back(float(draw(-1e3, 1e3)));
    }
    const Scene s = animated(ChannelPath::translation, Interpolation::cubic, times, values);
    for (size_t key = 0; key < times.size(); ++key)
        EXPECT_EQ(translation_at(s, times[key]), Vec3(values[9 * key + 3], values[9 * key + 4], values[9 * key + 5])) << key;
}

/// Animated weights are over the node's, and those over the mesh's; the spline 3s^2 - 2s^3 from 0 to 1 has tangents of 0.
TEST(Pose, WeightsMorphTheMesh) {
    Scene s = test::sample_scene();
    s.nodes[1].skin.reset();
    const auto height = [](const Scene& posed) {
        return std::get<Mesh>(posed.shapes[std::get<ShapeId>(posed.nodes[1].what).index].geometry).positions[0].z;
    };
    EXPECT_EQ(height(pose(s, 0)), 0);
    EXPECT_FLOAT_EQ(height(pose(s, 0.25)), 0.1f * (3.0f / 16 - 2.0f / 64));
    EXPECT_FLOAT_EQ(height(pose(s, 1)), 0.1f);
    EXPECT_EQ(pose(s, 0.5).nodes[1].to_parent.translation, Vec3(0.5, 1, 1.5));
    s.animations.clear();
    EXPECT_FLOAT_EQ(height(pose(s, 0)), 0.025f) << "the node's";
    s.nodes[1].morph_weights.clear();
    EXPECT_FLOAT_EQ(height(pose(s, 0)), 0.05f) << "the mesh's";
}

/// All clips play at once, each within its own range.
TEST(Pose, ClipsPlayTogether) {
    Scene s = animated(ChannelPath::translation, Interpolation::linear, {0, 1}, {0, 0, 0, 1, 0, 0});
    s.animations.push_back(animated(ChannelPath::scale, Interpolation::linear, {1, 3}, {1, 1, 1, 3, 3, 3}).animations[0]);
    for (const auto& [time, x, scale] : {std::tuple{0.5, 0.5, 1.0}, {2.0, 1.0, 2.0}, {5.0, 1.0, 3.0}}) {
        EXPECT_EQ(translation_at(s, time), Vec3(x, 0, 0)) << time;
        EXPECT_EQ(x_axis_at(s, time), Vec3(scale, 0, 0)) << time;
    }
}

/// A skin follows its animated joints: sample_scene's mesh node is the parent of its only joint, so that the skin moves by that node's motion.
TEST(Pose, JointsCarryTheMesh) {
    const Scene posed = pose(test::sample_scene(), 0.5);
    const Node& drawn = posed.nodes[posed.roots.back().index];
    const Mesh& mesh = std::get<Mesh>(posed.shapes[std::get<ShapeId>(drawn.what).index].geometry);
    EXPECT_TRUE(drawn.to_parent.is_identity());
    EXPECT_LT(length(Vec3(mesh.positions[1]) + mesh.origin - Vec3(1.5, 1, 2.55)), 1e-6) << "joint at (0.5, 1, 2.5), morphed by 0.05";
}

TEST(Pose, PartsOfATransformCombineAsTRS) {
    Scene s = animated(ChannelPath::scale, Interpolation::step, {0}, {2, 3, 4});
    s.nodes[0].trs->translation = Vec3(1, 1, 1);
    s.nodes[0].trs->rotation = Vec4(0, 0, std::sqrt(0.5), std::sqrt(0.5));
    const Transform t = pose(s, 0).nodes[0].to_parent;
    EXPECT_LT(length(t.point({1, 0, 0}) - Vec3(1, 3, 1)), 4e-15) << "scaled, turned, moved";
    EXPECT_LT(length(t.point({0, 1, 0}) - Vec3(-2, 1, 1)), 4e-15);
}

/// Pure: the scene stays, and where nothing moves the pose is the scene.
TEST(Pose, LeavesTheSceneAndItsTopology) {
    const Scene s = test::sample_scene();
    const std::string before = dump(s);
    const Scene posed = pose(s, 0.7);
    EXPECT_EQ(dump(s), before);
    EXPECT_NE(dump(posed), before);
    EXPECT_EQ(dump(pose(posed, 0.7)), dump(posed));
    for (size_t i = 0; i < s.nodes.size(); ++i) EXPECT_EQ(posed.nodes[i].children, s.nodes[i].children);
    Scene still = s;
    still.animations.clear();
    EXPECT_EQ(dump(pose(still, 0.7)), dump(deform(still)));
}

}  // namespace
}  // namespace alidade
