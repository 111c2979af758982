// SPDX-License-Identifier: Apache-2.0
/// The pictures that are made for POV-Ray: where they are looked up, and how many bits they keep.
#include "core/deep_png.h"
#include "core/image.h"
#include "exporters/pov/picture_edges.h"
#include "tests/exporters/pov_file.h"
#include "tests/exporters/samples.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <gmock/gmock.h>

namespace alidade::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

/// Two triangles with texture coordinates -1 .. 2 and 0 .. 1, one a slot, which show the same picture so and turned.
Scene pictured_scene(const Image& file, bool srgb, Wrap wrap) {
    Scene scene = triangle_scene();
    Mesh& mesh = std::get<Mesh>(scene.shapes[0].geometry);
    mesh.uvs = {{{{-1, -1}, {2, 0}, {0, 2}, {0, 0}, {1, 0}, {0, 1}}, {0, 1, 2, 3, 4, 5}}};
    mesh.triangles = {mesh.triangles[0], mesh.triangles[0]}, mesh.slots = {0, 1};
    scene.images = {file};
    for (const Mat3& turned : {Mat3(1.0), Mat3(0, 1, 0, -1, 0, 0, 0, 0, 1)}) {
        ImageSignal image;
        image.image = {0}, image.srgb = srgb, image.wrap_u = image.wrap_v = wrap, image.uv_transform = turned;
        scene.signals.push_back({image, {}});
        GltfPbr pbr;
        pbr.base_color = {uint32_t(scene.signals.size() - 1)};
        scene.materials.push_back({"shown", {pbr}, {}});
    }
    scene.nodes[0].materials = {MaterialId{0}, MaterialId{1}};
    return scene;
}

/// Each material's triangles say where its picture is looked up; what others inherit from a node is not known.
TEST(PovPictureEdges, RangesAreThoseOfTheSlot) {
    const Scene scene = pictured_scene({}, true, Wrap::clamp);
    const auto range = [&](const Scene& of, uint32_t material) {
        const auto signal = pov_export::shown_signals(of, {material}).at(0);
        return pov_export::ranges_of_clamped(of).at(pov_export::Lookup(std::get<ImageSignal>(of.signals[signal.index].what)));
    };
    EXPECT_EQ(range(scene, 0).min, Vec2(-1));
    EXPECT_EQ(range(scene, 0).max, Vec2(2));
    EXPECT_EQ(range(scene, 1).min, Vec2(-1, 0));
    EXPECT_EQ(range(scene, 1).max, Vec2(0, 1));
    EXPECT_TRUE(range(scene, 0).known);
    Scene inherited = scene;
    Node above;
    above.materials = {MaterialId{1}}, above.children = {NodeId{0}};
    inherited.nodes.push_back(above);
    EXPECT_TRUE(range(inherited, 0).known);
    EXPECT_FALSE(range(inherited, 1).known);
    EXPECT_TRUE(pov_export::ranges_of_clamped(pictured_scene({}, true, Wrap::mirror)).empty());
}

/// 64 x 4 pixels of 16 bits, two steps apart: 8 bits would leave one value.
Image fine_picture() {
    Picture ramp(64, 4, {"R", "G", "B"});
    for (size_t i = 0; i < ramp.values.size(); ++i) ramp.values[i] = float((30000 + 2 * (i / 3 % 64)) / 65535.0);
    return {"fine", {}, encode_linear_png(ramp).value(), {}};
}

/// What is made of a picture of 16 bits because it is clamped or mirrored keeps them; POV-Ray is told that they are linear.
TEST_F(PovFile, PicturesOf16BitsKeepThem) {
    for (const Wrap wrap : {Wrap::clamp, Wrap::mirror})
        for (const bool srgb : {true, false}) {
            const Image source = fine_picture();
            const Picture wanted = decode_picture(source.bytes, srgb ? Encoding::srgb : Encoding::linear).value();
            fs::remove_all(folder_), fs::create_directories(folder_);
            const std::string written = exported(pictured_scene(source, srgb, wrap));
            EXPECT_THAT(written, HasSubstr("gamma 1"));
            EXPECT_THAT(written, Not(HasSubstr("gamma srgb")));
            size_t files = 0;
            for (const auto& entry : fs::directory_iterator(folder_)) {
                if (entry.path().extension() != ".png") continue;
                const StoredPicture stored = read_stored_picture(entry.path().string()).value();
                EXPECT_EQ(stored.levels, 65535u);
                const int left = wrap == Wrap::clamp ? stored.picture.width - 64 : 0;
                double off = 0;   // wherever the edges are, each pixel's value is there
                for (int x = 0; x < 64; ++x) {
                    double nearest = 1;
                    for (int at = 0; at <= left + 63; ++at) nearest = std::min(nearest, double(std::abs(stored.picture.at(at, 0)[0] - wanted.at(x, 0)[0])));
                    off = std::max(off, nearest);
                }
                EXPECT_LE(off, 0.51 / 65535) << srgb;
                ++files;
            }
            EXPECT_GE(files, 1u);
        }
}

/// Of 8 bits they have 8 again, but where their values are no sRGB: what is written holds the values that POV-Ray is to see.
TEST_F(PovFile, PicturesOf8BitsAreTheirValues) {
    Picture ramp(64, 4, {"R", "G", "B"});
    for (size_t i = 0; i < ramp.values.size(); ++i) ramp.values[i] = float(srgb_to_linear(double(i / 3 % 64) / 255));
    const Image source{"coarse", {}, encode_picture(ramp, ".png").value(), {}};
    for (const bool srgb : {true, false}) {
        fs::remove_all(folder_), fs::create_directories(folder_);
        EXPECT_THAT(exported(pictured_scene(source, srgb, Wrap::mirror)), HasSubstr(srgb ? "gamma srgb" : "gamma 1"));
        for (const auto& entry : fs::directory_iterator(folder_)) {
            if (entry.path().extension() != ".png") continue;
            const StoredPicture stored = read_stored_picture(entry.path().string()).value();
            EXPECT_EQ(stored.levels, srgb ? 255u : 65535u);
            for (int x = 0; x < 64; ++x) EXPECT_NEAR(stored.picture.at(x, 0)[0], x / 255.0, 1e-5) << srgb;
        }
    }
}

}  // namespace
}  // namespace alidade::test
