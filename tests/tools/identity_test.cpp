// SPDX-License-Identifier: Apache-2.0
#include "tools/identity.h"

#include "core/image.h"
#include "tests/core/folder_test.h"
#include "tracer/compiled_scene.h"

#include <filesystem>
#include <functional>
#include <gtest/gtest.h>
#include <set>

namespace alidade {
namespace {

std::string line(const Identity& all, const std::string& name) {
    for (const auto& [key, value] : all)
        if (key == name) return value;
    return "none";
}

/// Whatever decides pixels is in it; the number of threads is not.
TEST(Identity, ChangesWithEveryOptionThatDecidesPixels) {
    const CompiledScene scene;
    const RenderOptions usual;
    const std::function<void(RenderOptions&)> changes[] = {
        [](RenderOptions& o) { ++o.width; }, [](RenderOptions& o) { ++o.height; }, [](RenderOptions& o) { o.region = Region{0, 0, 5, 5}; }, [](RenderOptions& o) { o.camera = "b"; },
        [](RenderOptions& o) { o.integrator = "cast"; }, [](RenderOptions& o) { o.spp = 3; }, [](RenderOptions& o) { o.supersampling.emplace(); }, [](RenderOptions& o) { o.adaptive = 0.1; }, [](RenderOptions& o) { o.lens_noise.emplace(); },
        [](RenderOptions& o) { o.supersampling = Supersampling{.threshold = 0.30000000000000004}; }, [](RenderOptions& o) { o.supersampling = Supersampling{.method = 2}; },
        [](RenderOptions& o) { o.supersampling = Supersampling{.gamma = 2}; }, [](RenderOptions& o) { o.supersampling = Supersampling{.jitter = 1}; }, [](RenderOptions& o) { o.supersampling = Supersampling{.depth = 2}; },
        [](RenderOptions& o) { o.sampler = "random"; }, [](RenderOptions& o) { o.light_samples = 2; }, [](RenderOptions& o) { o.aperture = 0; }, [](RenderOptions& o) { o.focus = 1; },
        [](RenderOptions& o) { o.seed = 1; }, [](RenderOptions& o) { o.frame = 1; }, [](RenderOptions& o) { o.max_depth = 2; }, [](RenderOptions& o) { o.exposure = 1; },
        [](RenderOptions& o) { o.aovs = {"depth"}; }, [](RenderOptions& o) { o.alpha = Alpha::associated; }, [](RenderOptions& o) { o.alpha = Alpha::straight; }, [](RenderOptions& o) { o.tile = 8; }, [](RenderOptions& o) { o.time = 1; }};
    std::vector<Identity> seen{identity(scene, usual)};
    for (const auto& change : changes) {
        RenderOptions o = usual;
        change(o);
        const Identity now = identity(scene, o);
        for (size_t i = 0; i < seen.size(); ++i) EXPECT_NE(now, seen[i]) << "change " << seen.size() << " looks like " << i;
        seen.push_back(now);
    }
    RenderOptions o = usual;
    o.threads = 7;
    EXPECT_EQ(identity(scene, o), seen[0]);
}

TEST(Identity, ChangesWithTheSceneAndItsPictures) {
    const test::TempFolder folder;
    const std::string path = folder.path() / "identity.ppm";
    CompiledScene scene;
    const RenderOptions o;
    const auto now = [&] { return line(identity(scene, o), "scene"); };
    std::set<std::string> seen{now()};
    scene.scene.shapes.push_back({"", Mesh{}, {}});
    EXPECT_TRUE(seen.insert(now()).second);
    Mesh& mesh = std::get<Mesh>(scene.scene.shapes[0].geometry);
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}};
    EXPECT_TRUE(seen.insert(now()).second);
    mesh.positions[1].x = std::nextafter(1.0f, 2.0f);
    EXPECT_TRUE(seen.insert(now()).second);
    Image image;
    image.path = path;
    scene.scene.images.push_back(image);
    EXPECT_TRUE(seen.insert(now()).second);
    for (const std::string text : {"P6 1 1 255 abc", "P6 1 1 255 abd"}) {
        ASSERT_TRUE(write_file(path, std::as_bytes(std::span(text))));
        EXPECT_TRUE(seen.insert(now()).second) << text;
        EXPECT_FALSE(seen.insert(now()).second);
    }
}

}  // namespace
}  // namespace alidade
