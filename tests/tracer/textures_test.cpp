// SPDX-License-Identifier: Apache-2.0
/// Texture lookups against hand-made tables: wrap modes, filters, encodings, coordinate transforms, tangent frames.
#include "eval/patterns/picture.h"
#include "eval/texture_reads.h"
#include "tests/tracer/on_plane.h"
#include "tests/tracer/scene_builder.h"
#include "tracer/shade_point.h"
#include "tracer/sky.h"
#include "tracer/surface.h"
#include "tracer/textures.h"

#include <functional>

namespace alidade::test {
namespace {

std::vector<std::byte> pgm(int width, int height, const std::vector<int>& levels) {
    std::string text = "P2\n" + std::to_string(width) + ' ' + std::to_string(height) + "\n255\n";
    for (const int level : levels) text += std::to_string(level) + '\n';
    const auto* begin = reinterpret_cast<const std::byte*>(text.data());
    return {begin, begin + text.size()};
}

struct File {
    std::vector<std::byte> bytes;
};

/// A 2 x 1 image: 0 on the left, 1 on the right.
struct Lookup {
    SceneBuilder b;
    std::unique_ptr<Textures> textures;
    ShadePoint point;

    explicit Lookup(ImageSignal signal, std::vector<int> levels = {0, 255}) : Lookup(std::move(signal), File{pgm(int(levels.size()), 1, levels)}) {}
    Lookup(ImageSignal signal, File file) {
        b.scene.images.push_back({"step", "", std::move(file.bytes), {}});
        b.scene.signals.push_back({signal, {}});
        Diagnostics said;
        textures = std::make_unique<Textures>(b.scene, std::vector<SignalId>{{0}}, 1, said);
        EXPECT_FALSE(said.has_errors()) << said.text();
    }
    double at(double u, double v = 0.5) {
        point.on_shape = test::on_plane(u, v);
        return textures->evaluate({0}, point).x;
    }
};

TEST(Textures, LinearFilterBetweenTexelCentres) {
    ImageSignal s;
    s.wrap_u = Wrap::clamp;
    Lookup look(s);
    EXPECT_EQ(look.at(0.25), 0);
    EXPECT_EQ(look.at(0.75), 1);
    EXPECT_NEAR(look.at(0.5), 0.5, 1e-12);
    EXPECT_NEAR(look.at(0.625), 0.75, 1e-12);
    EXPECT_EQ(look.at(-3), 0);
    EXPECT_EQ(look.at(3), 1);
}

/// A depth is no alpha.
TEST(Textures, OnlyColoursOfAnExrCount) {
    Picture picture(1, 1, {"R", "G", "B", "Z"});
    picture.values = {0.25F, 0.5F, 0.75F, 100};
    Lookup look(ImageSignal(), File{*encode_picture(picture, ".exr")});
    look.at(0.5);
    EXPECT_EQ(look.textures->evaluate({0}, look.point), Vec4(0.25, 0.5, 0.75, 1));
}

TEST(Textures, WrapModes) {
    for (const auto& [wrap, u, want] : {std::tuple{Wrap::repeat, 1.25, 0.0}, {Wrap::repeat, -0.25, 1.0}, {Wrap::repeat, 0.0, 0.0}, {Wrap::clamp, -0.2, 0.0},
                                        {Wrap::clamp, 1.2, 1.0}, {Wrap::mirror, 1.25, 1.0}, {Wrap::mirror, 1.75, 0.0}, {Wrap::mirror, -0.25, 0.0},
                                        {Wrap::mirror, -0.75, 1.0}, {Wrap::once, 1.25, 0.0}, {Wrap::once, 0.75, 1.0}}) {
        ImageSignal s;
        s.wrap_u = wrap;
        s.filter = Filter::nearest;
        Lookup look(s);
        EXPECT_EQ(look.at(u), want) << int(wrap) << ' ' << u;
    }
    ImageSignal s;
    Lookup look(s);
    EXPECT_NEAR(look.at(0.0), 0.5, 1e-12) << "linear filtering wraps too";
    for (const Wrap any : {Wrap::repeat, Wrap::clamp, Wrap::mirror, Wrap::once}) {
        s.wrap_u = any;
        for (const double far : {1e300, -1e300, 16777215.5, kInf, std::numeric_limits<double>::quiet_NaN()}) EXPECT_LE(Lookup(s).at(far), 1) << "no crash";
    }
    s.wrap_u = Wrap::clamp;
    EXPECT_EQ(Lookup(s).at(16777217), 1);
}

TEST(Textures, EncodingAndTransform) {
    ImageSignal s;
    s.wrap_u = s.wrap_v = Wrap::clamp;
    EXPECT_NEAR(Lookup(s, {128}).at(0.5), 128 / 255.0, 1e-6);
    s.srgb = true;
    EXPECT_NEAR(Lookup(s, {128}).at(0.5), std::pow((128 / 255.0 + 0.055) / 1.055, 2.4), 1e-6);
    s.srgb = false;
    s.uv_transform = Mat3(-1, 0, 0, 0, 1, 0, 1, 0, 1);   // u' = 1 - u
    EXPECT_EQ(Lookup(s).at(0.25), 1);
}

uint64_t reads_of(const std::function<void()>& work) {
    const uint64_t before = texture_reads;
    work();
    return texture_reads - before;
}

/// What is counted are texels, so that a filter shows; what lies beside a picture is no texel.
TEST(TextureReads, AreTexels) {
    ImageSignal s;
    Lookup linear(s);
    EXPECT_EQ(reads_of([&] { linear.at(0.3); }), 4u);
    s.filter = Filter::nearest;
    Lookup nearest(s);
    EXPECT_EQ(reads_of([&] { nearest.at(0.3); }), 1u);
    s.wrap_u = Wrap::once;
    Lookup once(s);
    EXPECT_EQ(reads_of([&] { once.at(1.5); }), 0u);
    const Image image{"step", "", pgm(2, 2, {0, 255, 255, 0}), {}};
    for (const auto& [filter, texels] : {std::pair{PictureFilter::none, 1u}, {PictureFilter::bilinear, 4u}, {PictureFilter::bicubic, 16u}}) {
        PatternPicture how;
        how.filter = filter;
        const auto picture = SpacePicture::make(how, image, {});
        ASSERT_TRUE(picture);
        EXPECT_EQ(reads_of([&] { picture->color({0.3, 0.3, 0}); }), texels);
        EXPECT_EQ(reads_of([&] { picture->rise({0.3, 0.3, 0}); }), 3 * texels) << "three heights are a slope";
    }
    const Sky sky(Picture(2, 1, {"R", "G", "B"}), 1);
    EXPECT_EQ(reads_of([&] { sky.radiance({0, 1, 0}); }), 1u);
}

TEST(SpacePictures, NumbersAreWholeBetweenPixels) {
    const Image image{"step", "", pgm(2, 1, {10, 21}), {}};
    PatternPicture how;
    how.filter = PictureFilter::bilinear, how.value = PictureValue::number;
    const auto picture = SpacePicture::make(how, image, {});
    ASSERT_TRUE(picture);
    for (int i = 0; i <= 40; ++i) EXPECT_EQ(picture->value({0.25 + 0.0125 * i, 0.5, 0}), std::floor(10 + 11 * i / 40.0 + 1e-6)) << i;
}

/// Catmull and Rom's cubic goes beyond the values beside a step.
TEST(SpacePictures, PatternsStayWithinTheirValues) {
    const Image image{"step", "", pgm(6, 1, {0, 0, 255, 255, 0, 0}), {}};
    PatternPicture how;
    how.filter = PictureFilter::bicubic;
    const auto picture = SpacePicture::make(how, image, {});
    ASSERT_TRUE(picture);
    int beyond = 0;
    for (int i = 0; i < 100; ++i) {
        const Vec3 place(i / 100.0, 0.5, 0);
        beyond += picture->color(place).color.x < 0;
        EXPECT_GE(picture->value(place), 0);
        EXPECT_LE(picture->value(place), 1);
    }
    EXPECT_GT(beyond, 5) << "colours do go beyond";
}

/// A square before the camera: a lookup of four texels for each sample that hits it, however many threads there are. Without a texture, none.
TEST(TextureReads, OfAPictureAreThoseOfItsSamples) {
    for (const bool textured : {true, false}) {
        SceneBuilder b;
        GltfPbr m = b.lambert(Color(1));
        if (textured) {
            b.scene.images.push_back({"step", "", pgm(2, 1, {0, 255}), {}});
            b.scene.signals.push_back({ImageSignal(), {}});
            m.base_color = {uint32_t(b.scene.signals.size() - 1)};
        }
        b.object(square(), b.material(m));
        b.light(PointLight(), Color(5), Transform::translate({0, 0, 3}));
        b.camera({0, 0, 5}, {0, 0, 0}, 10);
        for (const int threads : {1, 2}) {
            RenderOptions o = centre_rays(40);
            o.spp = 3, o.threads = threads;
            const Film film = rendered(b.scene, o);
            EXPECT_EQ(film.stats.camera_rays, 4800u);
            EXPECT_EQ(film.stats.texture_reads, textured ? 4 * film.stats.camera_rays : 0);
        }
    }
}

/// The tangent frame of a square whose u grows to the right and v downwards is (right, up), mirrored or not, turned or not.
TEST(Textures, TangentFrameFollowsTheTextureCoordinates) {
    for (const Transform& t : {Transform(), Transform::rotate({0, 0, 1}, 1), Transform::scale({-1, 1, 1}), Transform::scale({2, 0.5, 3})}) {
        SceneBuilder b;
        GltfPbr bumpy = b.lambert(Color(1));
        bumpy.normal = b.constant({0.5, 0.5, 1, 1});
        b.object(square(), b.material(bumpy), t);
        const auto scene = compiled(b.scene);
        Ray ray;
        ray.origin = {0.01, 0.02, 2};
        ray.dir = {0, 0, -1};
        Hit hit;
        WorkCounters work;
        ASSERT_TRUE(scene->top->intersect(ray, hit, work));
        ShadePoint p = shade_point(*scene, ray, hit);
        tangent_frame(*scene, 0, p);
        EXPECT_LT(length(p.tangent - normalized(t.vector({1, 0, 0}))), 1e-12);
        EXPECT_LT(length(p.bitangent - normalized(t.vector({0, 1, 0}))), 1e-12);
        EXPECT_LT(length(p.geometric_normal - Vec3(0, 0, 1)), 1e-12) << "mirroring keeps the front in front";
    }
}

/// A normal map on a texture coordinate set that the mesh has no values for: some frame, and no crash.
TEST(Textures, TangentFrameWithoutTextureCoordinates) {
    SceneBuilder b;
    Mesh m = square();
    m.uvs.resize(2);
    std::swap(m.uvs[0], m.uvs[1]);
    GltfPbr bumpy = b.lambert(Color(1));
    bumpy.normal = b.constant({0.5, 0.5, 1, 1});
    b.object(m, b.material(bumpy));
    b.light(DirectionalLight(), Color(1));
    b.camera({0, 0, 3}, {0, 0, 0}, 10);
    EXPECT_GT(value(rendered(b.scene, centre_rays(1)).picture, 0, 0, "R"), 0.1);
}

}  // namespace
}  // namespace alidade::test
