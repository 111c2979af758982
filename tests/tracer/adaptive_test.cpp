// SPDX-License-Identifier: Apache-2.0
/// Adaptive sampling: what it estimates, what it saves, and what it may not depend on.
#include "core/random.h"
#include "tests/core/run_size.h"
#include "tests/tracer/scene_builder.h"
#include "tracer/sample_stop.h"

#include <random>

namespace alidade::test {
namespace {

/// A wall without any features, and over a quarter of it confetti much smaller than a pixel.
Scene confetti() {
    SceneBuilder b;
    GltfPbr wall = b.pbr(Color(0.3, 0.4, 0.5));
    wall.unlit = true;
    b.object(square(), b.material(wall), Transform::scale(Vec3(4)));
    std::mt19937 random(3);
    std::uniform_real_distribution<float> unit(0, 1);
    for (int color = 0; color < 3; ++color) {
        Mesh mesh;
        for (uint32_t i = 0; i < 3000; i += 3) {
            const Vec3f at(unit(random) - 1, 2 * unit(random) - 1, 0.01f + 0.01f * unit(random));
            for (int c = 0; c < 3; ++c) mesh.positions.push_back(Vec3f(0.5f, 1, 1) * at + 0.06f * Vec3f(unit(random), unit(random), 0));
            mesh.triangles.emplace_back(i, i + 1, i + 2);
        }
        GltfPbr paint = b.pbr(Color(color == 0, color == 1, 1));
        paint.unlit = true;
        b.object(mesh, b.material(paint), Transform::translate(Vec3(-0.5, 0, 0)));
    }
    b.light(PointLight{}, Color(1));
    b.camera(Vec3(0, 0, 2.7), Vec3(0));
    return b.scene;
}

RenderOptions options(int spp, double adaptive) {
    RenderOptions o = centre_rays(24);
    o.spp = spp;
    o.adaptive = adaptive;
    return o;
}

/// Root of the mean square of the difference, as displayed.
double error(const Picture& a, const Picture& b) {
    double sum = 0;
    for (size_t i = 0; i < a.values.size(); ++i) {
        const double d = linear_to_srgb(double(a.values[i])) - linear_to_srgb(double(b.values[i]));
        sum += d * d;
    }
    return std::sqrt(sum / double(a.values.size()));
}

TEST(Noise, EstimatesTheStandardErrorOfIndependentSamples) {
    const RandomKey key(1, 2, 3, 4);
    for (const int count : {16, 64, 256}) {
        double estimated = 0, measured = 0;
        constexpr int kRuns = 2000;
        for (int run = 0; run < kRuns; ++run) {
            NoiseEstimate noise;
            double mean = 0;
            for (int i = 0; i < count; ++i) {
                const double x = key.uniform(uint64_t(run) * 1000 + uint64_t(i));
                noise.add(Color(x, 0.5, 0.5));
                mean += x / count;
            }
            estimated += noise.displayed_error(1) / kRuns;
            measured += (linear_to_srgb(mean) - linear_to_srgb(0.5)) * (linear_to_srgb(mean) - linear_to_srgb(0.5)) / kRuns;
        }
        EXPECT_NEAR(estimated / std::sqrt(measured), 1, 0.06) << count;
    }
}

TEST(Noise, FlatIsKnownAndBrokenNeverIs) {
    NoiseEstimate flat, broken, alone;
    for (int i = 0; i < 20; ++i) flat.add(Color(0.1, 0.7, 3)), broken.add(Color(0.1, i == 7 ? std::nan("") : 0.5, 1));
    alone.add(Color(1));
    EXPECT_LT(flat.displayed_error(1), 1e-15);
    EXPECT_FALSE(broken.displayed_error(1) < 1e9);
    EXPECT_EQ(alone.displayed_error(1), kInf);
}

/// A pixel that does not end early is the plain one, bit for bit.
TEST(Adaptive, WithoutALimitItIsPlain) {
    const Scene scene = confetti();
    const Film plain = rendered(scene, options(40, 0)), strict = rendered(scene, options(40, 1e-30));
    EXPECT_EQ(plain.stats.camera_rays, uint64_t(24 * 24 * 40));
    EXPECT_EQ(plain.stats.pixels, uint64_t(24 * 24));
    EXPECT_EQ(plain.stats.pixels_ended_early, 0u);
    EXPECT_LT(strict.stats.pixels_ended_early, 24u * 24u * 9 / 10) << "the test must exercise pixels that do not end early";
    size_t differing = 0;
    for (int i = 0; i < 24 * 24; ++i) differing += !std::equal(plain.picture.at(i % 24, i / 24), plain.picture.at(i % 24, i / 24) + 3, strict.picture.at(i % 24, i / 24));
    EXPECT_LE(differing, strict.stats.pixels_ended_early);
}

TEST(Adaptive, FewerThanTheLeastIsAllOfThem) {
    const Film film = rendered(confetti(), options(kLeastSamples, 10));
    EXPECT_EQ(film.stats.camera_rays, uint64_t(24 * 24 * kLeastSamples));
    EXPECT_EQ(rendered(confetti(), options(100, 10)).stats.camera_rays, uint64_t(24 * 24 * kLeastSamples)) << "everything is known well enough at once";
}

TEST(Adaptive, DependsOnNoThreadTileOrRegion) {
    const Scene scene = confetti();
    const Film first = rendered(scene, options(128, 0.02));
    EXPECT_GT(first.stats.pixels_ended_early, 24u * 24u / 2);
    for (const int threads : {1, 2, 5})
        for (const int tile : {1, 7, 64}) {
            RenderOptions o = options(128, 0.02);
            o.threads = threads, o.tile = tile;
            const Film other = rendered(scene, o);
            ASSERT_EQ(other.picture.values, first.picture.values) << threads << " threads, tiles of " << tile;
            ASSERT_EQ(other.stats.camera_rays, first.stats.camera_rays);
        }
    RenderOptions o = options(128, 0.02);
    o.region = Region{3, 5, 9, 20};
    const Film part = rendered(scene, o);
    for (int y = 5; y < 20; ++y)
        for (int x = 3; x < 9; ++x)
            for (int c = 0; c < 3; ++c) ASSERT_EQ(part.picture.at(x, y)[c], first.picture.at(x, y)[c]);
}

/// The plain picture that is as good took far more samples.
TEST(Adaptive, ReachesTheSameErrorWithFarFewerSamples) {
    if (run_scale() < 1) GTEST_SKIP() << "work is counted in the ordinary run";
    const Scene scene = confetti();
    RenderOptions reference = options(4096, 0);
    reference.seed = 77;
    const Picture truth = rendered(scene, reference).picture;
    const Film adaptive = rendered(scene, options(1024, 0.02));
    const double reached = error(adaptive.picture, truth), spent = double(adaptive.stats.camera_rays) / (24 * 24);
    EXPECT_LT(reached, 0.02);
    int needed = 16;
    while (needed < 1024 && error(rendered(scene, options(needed, 0)).picture, truth) > reached) needed += 16;
    std::printf("[          ] error %.5f: %.1f samples a pixel, plain %d\n", reached, spent, needed);
    EXPECT_LT(spent, 0.6 * needed);
}

/// Black before black: where pictures have alpha, its edge is not known before that is.
TEST(Adaptive, LooksAtAlpha) {
    SceneBuilder b;
    b.object(square(), b.material(b.lambert(Color(0))), Transform::rotate({0, 0, 1}, 0.3));
    b.light(PointLight{}, Color(1));   // else a sky lights, which is opaque
    b.camera(Vec3(0, 0, 6), Vec3(0));
    RenderOptions o = options(256, 0.01);
    const Film plain = rendered(b.scene, o);
    EXPECT_EQ(plain.stats.camera_rays, 24u * 24 * kLeastSamples);
    o.alpha = Alpha::straight;
    const Film film = rendered(b.scene, o);
    EXPECT_GT(film.stats.camera_rays, plain.stats.camera_rays * 2);
    EXPECT_EQ(film.picture.at(0, 0)[3], 0);
    EXPECT_EQ(film.picture.at(12, 12)[3], 1);
    double covered = 0;
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 24; ++x) covered += double(film.picture.at(x, y)[3]);
    const double half_window = 6 * std::tan(20 * kPi / 180);
    EXPECT_NEAR(covered / (24 * 24), 1 / (half_window * half_window), 0.002);
}

/// Beside the part that is rendered a picture is opaque, as in POV-Ray.
TEST(Alpha, OfWhatIsNotRendered) {
    SceneBuilder b;
    b.light(PointLight{}, Color(1));
    b.camera(Vec3(0, 0, 6), Vec3(0));
    RenderOptions o = options(1, 0);
    o.alpha = Alpha::associated, o.region = Region{0, 0, 10, 24};
    const Film film = rendered(b.scene, o);
    EXPECT_EQ(film.picture.at(9, 0)[3], 0);
    EXPECT_EQ(film.picture.at(10, 0)[3], 1);
}

TEST(Adaptive, ALimitThatIsNoNumberIsRefused) {
    const auto scene = compiled(confetti());
    for (const double bad : {-1.0, std::nan("")}) EXPECT_FALSE(render(*scene, options(4, bad)));
}

}  // namespace
}  // namespace alidade::test
