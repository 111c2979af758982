// SPDX-License-Identifier: Apache-2.0
/// The contract of render(): the same pixels however they are computed; layers; regions; early ends; usage errors.
#include "tests/tracer/scene_builder.h"
#include "core/random.h"
#include "tracer/shade_point.h"
#include "tracer/tiles.h"

#include <cstring>
#include <mutex>
#include <thread>

namespace alidade::test {
namespace {

/// A mesh sphere of `n` x 2n quads, wavy so that shading has something to do.
Mesh wavy_sphere(int n) {
    Mesh m;
    for (int i = 0; i <= n; ++i)
        for (int j = 0; j < 2 * n; ++j) {
            const double theta = kPi * i / n, phi = kPi * j / n, r = 1 + 0.1 * std::sin(5 * theta) * std::cos(7 * phi);
            m.positions.push_back(Vec3f(Vec3(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)) * r));
        }
    auto at = [&](int i, int j) { return uint32_t(i * 2 * n + j % (2 * n)); };
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < 2 * n; ++j) {
            if (i) m.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j)});
            if (i < n - 1) m.triangles.push_back({at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)});
        }
    return m;
}

/// Meshes, closed forms, an unbounded one, mirrors, glass, alpha, three kinds of light: everything that the tracer has.
Scene everything() {
    SceneBuilder b;
    b.object(Plane{{0, 1, 0}, -1}, b.material(b.pbr(Color(0.7, 0.7, 0.6), 0, 0.4)));
    const MaterialId metal = b.material(b.pbr(Color(0.9, 0.6, 0.3), 1, 0.1));
    const NodeId first = b.object(wavy_sphere(16), metal, Transform::translate({-1.2, 0, 0}));
    Node copy = b.scene.nodes[first.index];
    copy.to_parent = Transform::translate({1.2, 0, -1}) * Transform::rotate({0, 0, 1}, 1) * Transform::scale({-0.8, 0.6, 0.8});
    b.node(copy);
    b.object(Sphere{{0, 0.2, 1}, 0.6}, b.material(b.glass(1.5)));
    GltfPbr pane = b.pbr(Color(0.2, 0.4, 0.9));
    pane.base_color = b.constant({0.2, 0.4, 0.9, 0.5});
    pane.alpha_mode = AlphaMode::blend;
    b.object(square(), b.material(pane), Transform::translate({0.6, 0.3, 1.8}) * Transform::scale(Vec3(0.5)));
    b.object(Box{{-0.3, -1, -0.3}, {0.3, 1.4, 0.3}}, b.material(b.lambert(Color(0.8, 0.2, 0.2))));
    b.light(PointLight(), Color(20), Transform::translate({2, 4, 3}));
    b.light(SpotLight{0.2, 0.5}, Color(30), Transform::translate({-3, 4, 3}) * Transform::rotate({1, 0, 0}, -0.8));
    b.light(DirectionalLight(), Color(0.5), Transform::rotate({1, 0, 0}, -1));
    b.scene.atmosphere.environment = Color(0.1, 0.12, 0.15);
    b.camera({0.5, 1.2, 6}, {0, 0, 0}, 45);
    return b.scene;
}

RenderOptions small_render() {
    RenderOptions o;
    o.width = 61;   // no multiple of any tile
    o.height = 47;
    o.spp = 4;
    o.aovs = {"depth", "normal", "albedo", "id", "uv", "coverage"};
    return o;
}

bool same_bytes(const Picture& a, const Picture& b) {
    return a.names == b.names && a.values.size() == b.values.size() && std::memcmp(a.values.data(), b.values.data(), a.values.size() * sizeof(float)) == 0;
}

TEST(Determinism, ThreadsTilesAndOrderDoNotShow) {
    const auto scene = compiled(everything());
    const Film reference = *render(*scene, small_render());
    double brightest = 0;
    for (const float v : reference.picture.values) brightest = std::isfinite(v) ? std::max(brightest, double(v)) : brightest;
    EXPECT_GT(brightest, 0.5);
    for (int threads : {1, 2, 3})
        for (int tile : {8, 16, 64}) {
            RenderOptions o = small_render();
            o.threads = threads;
            o.tile = tile;
            EXPECT_TRUE(same_bytes(render(*scene, o)->picture, reference.picture)) << threads << " threads, tiles of " << tile;
        }
}

TEST(Determinism, EveryAcceleratorAndInstructionSetMakesTheSamePixels) {
    for (const Precision precision : {Precision::float_, Precision::double_}) {
        std::optional<Film> reference;
        for (const AcceleratorEntry& accel : accelerators())
            for (const Isa isa : available_isas()) {
                CompileOptions c;
                c.accel = accel.name;
                c.isa = isa;
                c.precision = precision;
                const Film film = rendered(everything(), small_render(), c);
                if (!reference) reference = film;
                EXPECT_TRUE(same_bytes(film.picture, reference->picture)) << accel.name << ' ' << name(isa);
                EXPECT_EQ(film.stats.shadow_rays, reference->stats.shadow_rays);
            }
    }
}

TEST(Determinism, TheFullKernelMakesTheSamePixels) {
    SceneBuilder plain;
    plain.object(wavy_sphere(12), plain.material(plain.lambert(Color(0.8))));
    plain.light(PointLight(), Color(30), Transform::translate({2, 4, 3}));
    plain.camera({0, 0, 4}, {0, 0, 0}, 45);
    CompileOptions full;
    full.full_kernel = true;
    EXPECT_EQ(compiled(plain.scene)->features, 0u);
    EXPECT_EQ(compiled(plain.scene, full)->features, unsigned(kAllFeatures));
    EXPECT_TRUE(same_bytes(rendered(plain.scene, small_render()).picture, rendered(plain.scene, small_render(), full).picture));
}

TEST(Regions, AreCutsOfTheWholePicture) {
    const auto scene = compiled(everything());
    RenderOptions o = small_render();
    const Film whole = *render(*scene, o);
    o.region = Region{13, 7, 40, 31};
    const Film part = *render(*scene, o);
    ASSERT_EQ(part.picture.width, whole.picture.width);
    for (int y = 0; y < 47; ++y)
        for (int x = 0; x < 61; ++x)
            for (int c = 0; c < whole.picture.channels; ++c) {
                const bool inside = x >= 13 && x < 40 && y >= 7 && y < 31;
                ASSERT_EQ(part.picture.at(x, y)[c], inside ? whole.picture.at(x, y)[c] : 0) << x << ' ' << y << ' ' << c;
            }
}

/// POV-Ray's antialiasing compares pixels with their neighbours: those beyond a part's border count as they do in the whole.
TEST(Regions, AreCutsOfTheWholePictureUnderAntialiasingToo) {
    const auto scene = compiled(everything());
    for (const int method : {1, 2}) {
        RenderOptions o = small_render();
        o.supersampling = Supersampling{.method = method, .threshold = 0.1, .jitter = 1};   // some pixels differ from the next alone
        const Film whole = *render(*scene, o);
        for (const Region part : {Region{13, 7, 40, 31}, Region{20, 20, 21, 21}, Region{17, 0, 18, 47}, Region{0, 25, 61, 26}, Region{32, 32, 61, 47}, Region{31, 31, 33, 33}}) {
            o.region = part;
            const Film cut = *render(*scene, o);
            for (int y = part.y0; y < part.y1; ++y)
                for (int x = part.x0; x < part.x1; ++x)
                    for (int c = 0; c < 3; ++c) ASSERT_EQ(cut.picture.at(x, y)[c], whole.picture.at(x, y)[c]) << method << ": " << x << ' ' << y;
            EXPECT_LT(cut.stats.camera_rays, whole.stats.camera_rays);
            EXPECT_EQ(cut.stats.pixels, uint64_t(part.x1 - part.x0) * uint64_t(part.y1 - part.y0));
        }
    }
}

/// Tiles that are known are not rendered; each of the others is kept once, with its pixels.
TEST(Monitors, RecallSparesTilesAndKeepHasTheOthers) {
    const auto scene = compiled(everything());
    RenderOptions o = small_render();
    o.region = Region{13, 7, 40, 31};
    const TileGrid grid = *tile_grid(o);
    ASSERT_EQ(grid.count(), 6u);
    const Film whole = *render(*scene, o);
    const auto copy = [&](size_t tile, const Picture& from, Picture& to) {
        const Region r = grid.tile(tile);
        for (int y = r.y0; y < r.y1; ++y) std::copy(from.at(r.x0, y), from.at(r.x0, y) + size_t(r.x1 - r.x0) * size_t(from.channels), to.at(r.x0, y));
    };
    Picture kept(o.width, o.height, whole.picture.names);
    std::vector<int> times(grid.count());
    std::mutex mutex;
    size_t last = 0;
    Monitor monitor{[&](size_t done, size_t) { last = done; }};
    monitor.recall = [&](size_t tile, Picture& picture) { return tile % 3 == 1 && (copy(tile, whole.picture, picture), true); };
    monitor.keep = [&](size_t tile, const Picture& picture) {
        const std::lock_guard lock(mutex);
        copy(tile, picture, kept);
        ++times[tile];
    };
    const Film film = *render(*scene, o, monitor);
    EXPECT_TRUE(film.complete);
    EXPECT_EQ(last, 6u);
    EXPECT_TRUE(same_bytes(film.picture, whole.picture));
    EXPECT_EQ(times, (std::vector<int>{1, 0, 1, 1, 0, 1}));
    for (const size_t tile : {1, 4}) copy(tile, whole.picture, kept);
    EXPECT_TRUE(same_bytes(kept, whole.picture));
    uint64_t recalled = 0;
    for (const size_t tile : {1, 4}) recalled += uint64_t(grid.tile(tile).x1 - grid.tile(tile).x0) * uint64_t(grid.tile(tile).y1 - grid.tile(tile).y0);
    EXPECT_EQ(film.stats.pixels, whole.stats.pixels - recalled);
}

TEST(Monitors, StopLeavesTheDoneTilesAndSaysSo) {
    const auto scene = compiled(everything());
    std::atomic<bool> stop = false;
    size_t last = 0;
    Monitor monitor{[&](size_t done, size_t tiles) {
                        EXPECT_EQ(done, last + 1);
                        EXPECT_EQ(tiles, 12u);
                        last = done;
                        if (done == 5) stop = true;
                    },
                    &stop};
    RenderOptions o = small_render();
    o.threads = 1;
    const Film film = *render(*scene, o, monitor);
    EXPECT_FALSE(film.complete);
    EXPECT_EQ(film.stats.tiles_done, 5u);
    const Film whole = *render(*scene, o);
    EXPECT_TRUE(whole.complete);
    EXPECT_EQ(film.picture.at(3, 3)[2], whole.picture.at(3, 3)[2]);
    EXPECT_EQ(film.picture.at(60, 46)[2], 0);
}

/// A stop is heard within a pixel, not only between tiles: this one would take hours.
TEST(Monitors, StopIsHeardWithinAPixel) {
    const auto scene = compiled(everything());
    std::atomic<bool> stop = false;
    RenderOptions o = small_render();
    o.spp = 1 << 20;
    o.tile = 4096;
    std::thread late([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        stop = true;
    });
    const Film film = *render(*scene, o, Monitor{{}, &stop});
    late.join();
    EXPECT_FALSE(film.complete);
    EXPECT_LT(film.stats.seconds, 20);
}

/// Nor only between samples: each face of 40 panes of glass mirrors a ray and passes it on, so that one sample is some 2^60 rays.
TEST(Monitors, StopIsHeardWithinASample) {
    SceneBuilder b;
    const MaterialId glass = b.material(b.glass(1.5));
    for (int i = 0; i < 40; ++i) b.object(Box{{-1, -1, -2.0 * i}, {1, 1, 1 - 2.0 * i}}, glass);
    b.camera({0.1, 0.2, 5}, {0, 0, 0}, 20);
    b.scene.settings.adc_bailout = 0;
    RenderOptions o = small_render();
    o.spp = 1, o.max_depth = 60;
    std::atomic<bool> stop = false;
    std::thread late([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        stop = true;
    });
    const Film film = *render(*compiled(b.scene), o, Monitor{{}, &stop});
    late.join();
    EXPECT_FALSE(film.complete);
    EXPECT_LT(film.stats.seconds, 20);
}

TEST(Usage, ErrorsAreSentencesThatName) {
    const auto scene = compiled(everything());
    auto error_of = [&](auto change) {
        RenderOptions o = small_render();
        change(o);
        const auto film = render(*scene, o);
        return film ? std::string("none") : film.error();
    };
    EXPECT_NE(error_of([](RenderOptions& o) { o.camera = "nobody"; }).find("'nobody'"), std::string::npos);
    EXPECT_NE(error_of([](RenderOptions& o) { o.camera = "7"; }).find("there is no camera '7': the scene has 1, named or numbered 0"), std::string::npos);
    EXPECT_NE(error_of([](RenderOptions& o) { o.integrator = "photon"; }).find("'photon'"), std::string::npos);
    EXPECT_NE(error_of([](RenderOptions& o) { o.aovs = {"depht"}; }).find("'depht'"), std::string::npos);
    EXPECT_NE(error_of([](RenderOptions& o) { o.spp = o.light_samples = 65536; }).find("65536"), std::string::npos);
    EXPECT_NE(error_of([](RenderOptions& o) { o.width = 0; }).find("0x47"), std::string::npos);
    EXPECT_NE(error_of([](RenderOptions& o) { o.region = Region{5, 5, 5, 9}; }).find("5,5,5,9"), std::string::npos);
    EXPECT_EQ(error_of([](RenderOptions& o) { o.camera = "0"; }), "none");
}

TEST(Compile, SaysWhatItAddsAndLeavesOut) {
    SceneBuilder b;
    b.object(Sphere{}, b.material(b.lambert(Color(1))));
    b.object(Sphere{}, {0}, Transform::scale({1, 0, 1}));
    Diagnostics said;
    const auto scene = compile(b.scene, {}, said);
    ASSERT_TRUE(scene);
    EXPECT_NE(said.text().find("no light"), std::string::npos);
    EXPECT_NE(said.text().find("no camera"), std::string::npos);
    EXPECT_NE(said.text().find("no inverse"), std::string::npos);
    EXPECT_EQ(scene->instances.size(), 1u);
    const Film film = *render(*scene, small_render());
    double covered = 0;
    for (int y = 0; y < 47; ++y)
        for (int x = 0; x < 61; ++x) covered += value(film.picture, x, y, "coverage.Y");
    EXPECT_GT(covered, 300);
}

TEST(Compile, BuildsAndReadsOnlyWhatCanBeSeen) {
    SceneBuilder b;
    b.object(Sphere{}, b.material(b.lambert(Color(1))));
    b.scene.images.push_back({"missing", "/nonexistent.png", {}, {}});
    GltfPbr unread = b.lambert(Color(1));
    b.scene.signals.push_back({ImageSignal{}, {}});
    unread.base_color = {uint32_t(b.scene.signals.size() - 1)};
    const MaterialId m = b.material(unread, "unread");
    const ShapeId unseen = b.shape(wavy_sphere(8));
    EXPECT_EQ(summary(*compiled(b.scene)).geometries, 1u);
    EXPECT_EQ(summary(*compiled(b.scene)).images, 0u);
    Node n;
    n.what = unseen;
    n.materials = {m};
    b.node(n);
    Diagnostics said;
    EXPECT_FALSE(compile(b.scene, {}, said));
    EXPECT_NE(said.text().find("/nonexistent.png"), std::string::npos) << said.text();
}

TEST(Compile, SaysWhatItDoesNotRender) {
    SceneBuilder b;
    const MaterialId white = b.material(b.lambert(Color(1)));
    b.object(Sphere{}, white);
    b.scene.atmosphere.media.emplace_back();
    Diagnostics said;
    const auto scene = compile(b.scene, {}, said);
    ASSERT_TRUE(scene) << said.text();
    EXPECT_NE(said.text().find("media"), std::string::npos) << said.text();
}

TEST(Compile, RefusesFunctionsThatItDoesNotKnow) {
    SceneBuilder b;
    PatternSignal formula;
    formula.pattern = kFunctionPattern, formula.function = FunctionId{0};
    b.scene.functions.resize(1);
    b.scene.functions[0].steps = {{FunctionOp::argument, 0}, {FunctionOp::argument, 1}, {FunctionOp::argument, 2}, {FunctionOp::internal, 12, 3}};
    GltfPbr surface = b.lambert(Color(1));
    b.scene.signals.emplace_back().what = formula;
    surface.base_color = {uint32_t(b.scene.signals.size() - 1)};
    b.object(Sphere{}, b.material(surface));
    Diagnostics said;
    EXPECT_FALSE(compile(b.scene, {}, said));
    EXPECT_NE(said.text().find("internal(12)"), std::string::npos) << said.text();
    b.scene.functions[0].steps.back().a = 76;
    Diagnostics none;
    EXPECT_TRUE(compile(b.scene, {}, none)) << none.text();
}

/// A graph of 40 levels with two references each has 2^40 paths: refused in seconds, not walked.
TEST(Compile, RefusesGraphsThatUnfoldBeyondMemory) {
    Scene scene;
    for (uint32_t i = 0; i < 40; ++i) {
        scene.nodes.emplace_back();
        if (i) scene.nodes.back().children = {{i - 1}, {i - 1}};
    }
    scene.roots = {{39}};
    Diagnostics said;
    EXPECT_FALSE(compile(scene, {}, said));
    EXPECT_NE(said.text().find("paths"), std::string::npos) << said.text();
}

TEST(Compile, EmptySceneRendersItsBackground) {
    Scene scene;
    scene.atmosphere.environment = Color(0.25, 0.5, 1);
    const Film film = rendered(scene, centre_rays(3, {"coverage"}));
    EXPECT_EQ(value(film.picture, 1, 1, "G"), 0.5);
    EXPECT_EQ(value(film.picture, 1, 1, "coverage.Y"), 0);
}

}  // namespace
}  // namespace alidade::test
