// SPDX-License-Identifier: Apache-2.0
/// Spots as POV-Ray's lights, and POV-Ray's lights as spots.
#include "exporters/pov/spot_rim.h"
#include "tests/exporters/pov_file.h"
#include "tests/exporters/samples.h"
#include "tests/scene/sample_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <gmock/gmock.h>
#include <string>

namespace alidade::test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Of a spot's light, what KHR_lights_punctual has at an angle from the axis.
double gltf_cone(double inner, double outer, double angle) {
    const double x = std::clamp((std::cos(angle) - std::cos(outer)) / std::max(0.001, std::cos(inner) - std::cos(outer)), 0.0, 1.0);
    return x * x;
}

/// What POV-Ray's lights have there: the sum of theirs, in floats as its colours are.
float written_cones(const Scene& scene, double intensity, double angle) {
    float sum = 0;
    const double c = std::cos(angle);
    for (const Light& light : scene.lights) {
        const ConeLight& cone = std::get<ConeLight>(light.kind);
        const double begin = std::cos(cone.falloff), end = std::cos(cone.radius), near = light.fade.value().distance;
        const double u = begin < end ? std::clamp((c - begin) / (end - begin), 0.0, 1.0) : c >= end;
        sum += float(light.intensity.x * 2 * kPi * near * near / intensity) * float(std::pow(c, cone.tightness) * u * u * (3 - 2 * u));
    }
    return sum;
}

/// The most by which what is written differs from a spot of these angles.
double most_off(const Scene& read, const SpotLight& spot, double intensity) {
    double most = 0;
    for (int i = 0; i <= 2000; ++i) {
        const double angle = std::min(1.1 * spot.outer_angle, kPi / 2) * i / 2000;
        most = std::max(most, std::abs(double(written_cones(read, intensity, angle)) - gltf_cone(spot.inner_angle, spot.outer_angle, angle)));
    }
    return most;
}

/// Whether the ramp ends before the axis, at it (glTF's default), or, in spots of less than 2.6 degrees, not at all: what is said to be lost is what is.
TEST_F(PovFile, SpotsHaveGltfsConeAndTellByHowMuchTheyDoNot) {
    constexpr double kIntensity = 7;
    const std::array<SpotLight, 13> cones{{{0, 1.5}, {0, kPi / 2}, {0, kPi / 4}, {0, 0.3}, {0, 0.1}, {0, 0.045}, {0, 0.03}, {0.01, 0.03}, {0.015, 0.02}, {0, 0.01}, {0.1, 0.6}, {0.3, 0.6}, {0.5, 1.2}}};
    for (const SpotLight& cone : cones) {
        Scene scene = triangle_scene();
        Light light;
        light.kind = cone, light.intensity = Color(kIntensity);
        Node node;
        node.what = LightId{0};
        scene.roots.push_back({uint32_t(scene.nodes.size())});
        scene.lights = {light}, scene.nodes.push_back(node);
        exported(scene);
        const Scene read = again();
        const double said = pov_export::spot_rim(cone).off, most = most_off(read, cone, kIntensity);
        EXPECT_LT(said, 0.0311) << cone.inner_angle << " " << cone.outer_angle;
        EXPECT_LE(most, 1.01 * said + 1e-6) << cone.inner_angle << " " << cone.outer_angle;
        const double ramp = std::cos(cone.inner_angle) - std::cos(cone.outer_angle);
        EXPECT_TRUE(ramp < 0.03 || said < 5e-4) << cone.inner_angle << " " << cone.outer_angle;
        EXPECT_EQ(told_.find("of the light") == std::string::npos, said < 5e-4) << told_;
        EXPECT_TRUE(said < 5e-4 || told_.find(std::to_string(read.lights.size()) + " of POV-Ray's, off by") != std::string::npos) << told_;
    }
}

/// A spot beside a triangle.
Scene scene_with(const SpotLight& spot) {
    Scene scene = triangle_scene();
    Light light;
    light.kind = spot, light.intensity = Color(7, 3, 1);
    scene.lights = {light};
    scene.nodes.push_back(node_with(LightId{0}));
    scene.roots.push_back({uint32_t(scene.nodes.size() - 1)});
    return scene;
}

class PovLightsAsGltf : public PovFile {
  protected:
    Scene as_gltf(const Scene& scene) {
        const std::string path = (folder_ / "again.glb").string();
        const auto done = export_scene(scene, path);
        EXPECT_TRUE(done) << (done ? "" : done.error());
        lost_.clear();
        for (const Loss& loss : done->losses) lost_ += loss.what + "\n";
        auto read = import_scene(path);
        EXPECT_TRUE(read) << (read ? "" : read.error().text());
        return std::move(read->scene);
    }
    Scene read_pov(const std::string& text) {
        std::ofstream(folder_ / "scene.pov") << "camera { location <0, 0, -9> } sphere { 0, 1 }\n" << text;
        return again();
    }
    static size_t lit(const Scene& scene) {
        return size_t(std::count_if(scene.nodes.begin(), scene.nodes.end(), [](const Node& node) { return std::holds_alternative<LightId>(node.what); }));
    }
};

/// A spot that became a sum of lights in POV-Ray's file is one again in glTF's.
TEST_F(PovLightsAsGltf, SpotsComeBackFromTheirSums) {
    for (const SpotLight& cone : {SpotLight{0.3, 0.6}, SpotLight{0, kPi / 4}, SpotLight{0.5, 1.2}, SpotLight{0.59, 0.6}}) {
        exported(scene_with(cone));
        const Scene read = as_gltf(again());
        ASSERT_EQ(read.lights.size(), 1u);
        const SpotLight& spot = std::get<SpotLight>(read.lights[0].kind);
        EXPECT_NEAR(spot.inner_angle, cone.inner_angle, 1e-6);
        EXPECT_NEAR(spot.outer_angle, cone.outer_angle, 1e-6);
        EXPECT_NEAR(read.lights[0].intensity.x / read.lights[0].intensity.y, 7.0 / 3, 1e-5);
        EXPECT_NEAR(read.lights[0].intensity.x, 7, 0.07);
        EXPECT_THAT(lost_, Not(HasSubstr("negative")));
    }
}

/// Also with others in the same place, and where the whole sum stands twice.
TEST_F(PovLightsAsGltf, SumsAreFoundAmongOthers) {
    Scene scene = scene_with({0.3, 0.6});
    scene.lights.push_back(scene.lights[0]), scene.lights.push_back(scene.lights[0]);
    scene.lights[1].kind = SpotLight{0.2, 0.6}, scene.lights[2].kind = ConeLight{0.1, 0.2, 2}, scene.lights[2].inverse_square = false;
    Node lamp;
    for (uint32_t i = 0; i < 3; ++i) {
        if (i > 0) scene.nodes.push_back(node_with(LightId{i}));
        lamp.children.push_back({uint32_t(i == 0 ? 1 : scene.nodes.size() - 1)});
    }
    scene.nodes.push_back(lamp);
    Node other;
    other.to_parent = Transform::translate({1, 2, 3}), other.children = {NodeId{uint32_t(scene.nodes.size() - 1)}};
    scene.nodes.push_back(other);
    scene.roots = {NodeId{0}, NodeId{uint32_t(scene.nodes.size() - 2)}, NodeId{uint32_t(scene.nodes.size() - 1)}};
    exported(scene);
    const Scene read = as_gltf(again());
    EXPECT_THAT(lost_, Not(HasSubstr("negative")));
    EXPECT_EQ(lit(read), 6u) << read.lights.size();
    for (const double inner : {0.3, 0.2, 0.1})
        EXPECT_TRUE(std::any_of(read.lights.begin(), read.lights.end(), [&](const Light& l) { return std::abs(std::get<SpotLight>(l.kind).inner_angle - inner) < 1e-6; })) << inner;
}

/// Light that is taken from the middle of a cone leaves the cone's what it is, and is told.
TEST_F(PovLightsAsGltf, ADarkNotchTakesNoLightFromItsCone) {
    const std::string spot = "light_source { <0, 5, 0> rgb 1 spotlight point_at 0 radius 20 falloff 30 }\n";
    const Scene plain = as_gltf(read_pov(spot));
    for (const char* notch : {"radius 5 falloff 8", "radius 5 falloff 5 tightness 2", "radius 30 falloff 30"}) {
        const Scene notched = as_gltf(read_pov(spot + "light_source { <0, 5, 0> rgb -1 spotlight point_at 0 " + notch + " }"));
        EXPECT_THAT(lost_, HasSubstr("lights of negative")) << notch;
        ASSERT_EQ(notched.lights.size(), 1u) << notch;
        EXPECT_EQ(notched.lights[0].intensity, plain.lights.at(0).intensity) << notch;
        EXPECT_EQ(std::get<SpotLight>(notched.lights[0].kind).inner_angle, std::get<SpotLight>(plain.lights[0].kind).inner_angle) << notch;
    }
}

/// A light that stands in two places keeps its light in both, whatever is taken from it in one.
TEST_F(PovLightsAsGltf, NothingIsMergedThatStandsElsewhereToo) {
    exported(scene_with({0.3, 0.6}));
    Scene sum = again();
    ASSERT_EQ(sum.lights.size(), 6u);
    const auto first = std::find_if(sum.nodes.begin(), sum.nodes.end(), [](const Node& n) { return std::holds_alternative<LightId>(n.what) && std::get<LightId>(n.what) == LightId{0}; });
    ASSERT_NE(first, sum.nodes.end());
    Node twin = *first;
    twin.to_parent = Transform::translate({7, 0, 0}) * twin.to_parent;
    sum.nodes.push_back(twin);
    sum.roots.push_back({uint32_t(sum.nodes.size() - 1)});
    const Scene read = as_gltf(sum);
    EXPECT_THAT(lost_, HasSubstr("lights of negative"));
    EXPECT_EQ(lit(read), 4u) << "three add light, one of them twice";
    Scene faded = sum;
    faded.nodes.pop_back(), faded.roots.pop_back();
    EXPECT_EQ(as_gltf(faded).lights.size(), 1u);
    faded.lights[4].fade->distance *= 2;
    EXPECT_EQ(as_gltf(faded).lights.size(), 2u) << "the spot that 0 .. 2 are without the others, and what these add";
    EXPECT_THAT(lost_, HasSubstr("lights of negative"));
}

}  // namespace
}  // namespace alidade::test
