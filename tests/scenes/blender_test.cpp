// SPDX-License-Identifier: Apache-2.0
/// Scenes exported from Blender, beside what Cycles saw of the same files.
#include "core/image.h"
#include "importers/importer.h"
#include "tests/core/run_size.h"
#include "tracer/render.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <sys/resource.h>

namespace alidade {
namespace {

const std::filesystem::path kData = ALIDADE_SHARED_DATA;

Film rendered(const std::string& name, const RenderOptions& options) {
    auto imported = import_scene((kData / "blender" / name).string());
    EXPECT_TRUE(imported) << imported.error().text();
    if (!imported) return {};
    Diagnostics said;
    const auto scene = compile(std::move(imported->scene), {}, said);
    EXPECT_TRUE(scene) << said.text();
    if (!scene) return {};
    auto film = render(*scene, options);
    EXPECT_TRUE(film) << film.error();
    return film ? std::move(*film) : Film{};
}

/// Which pixels show an object, row by row.
struct MaskPicture {
    int width, height;
    std::vector<bool> object;

    bool at(int x, int y) const { return object[size_t(y) * size_t(width) + size_t(x)]; }
    /// Does the 3 x 3 neighbourhood hold both kinds?
    bool edge(int x, int y) const {
        for (int j = std::max(y - 1, 0); j <= std::min(y + 1, height - 1); ++j)
            for (int i = std::max(x - 1, 0); i <= std::min(x + 1, width - 1); ++i)
                if (at(i, j) != at(x, y)) return true;
        return false;
    }
};

template <class IsObject> MaskPicture mask_of(const Picture& p, IsObject is_object) {
    MaskPicture m{p.width, p.height, {}};
    for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x) m.object.push_back(is_object(p.at(x, y)));
    return m;
}

/// The least sum of channels that is not 0.
float faintest_pixel(const Picture& p) {
    float least = std::numeric_limits<float>::infinity();
    for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x) {
            const float sum = p.at(x, y)[0] + p.at(x, y)[1] + p.at(x, y)[2];
            if (sum > 0) least = std::min(least, sum);
        }
    return least;
}

class BlenderScene : public testing::TestWithParam<const char*> {};

/// Cycles drew the exported file under a black sky: a pixel that is exactly 0 saw nothing in 64 samples, or a mirror that shows nothing. The picture
/// cannot tell the two apart; ours can, so an object of ours that sends less light than the faintest pixel of Cycles' is left undecided.
/// Everywhere else, away from edges, both see the same objects.
TEST_P(BlenderScene, CoversWhatCyclesSees) {
    if (test::run_scale() < 1) GTEST_SKIP() << "so many samples are taken in the ordinary run";
    const std::string name = GetParam();
    if (!std::filesystem::exists(kData / "blender" / (name + ".glb"))) GTEST_SKIP() << "the reference scenes are not there";
    const auto reference = read_picture((kData / "blender" / (name + "_roundtrip_cycles.exr")).string(), Encoding::linear);
    ASSERT_TRUE(reference) << reference.error();
    RenderOptions options;
    options.width = reference->width;
    options.height = reference->height;
    options.spp = 16;
    options.aovs = {"coverage"};
    const Film film = rendered(name + ".glb", options);
    ASSERT_EQ(film.picture.names.back(), "coverage.Y");
    const MaskPicture cycles = mask_of(*reference, [](const float* p) { return p[0] != 0 || p[1] != 0 || p[2] != 0; });
    const float faintest = faintest_pixel(*reference);
    const MaskPicture dark = mask_of(film.picture, [&](const float* p) { return p[film.picture.channels - 1] > 0 && p[0] + p[1] + p[2] < faintest; });
    const MaskPicture ours = mask_of(film.picture, [&](const float* p) { return p[film.picture.channels - 1] > 0; });
    int objects = 0, judged = 0, differ = 0, undecided = 0;
    for (int y = 0; y < cycles.height; ++y)
        for (int x = 0; x < cycles.width; ++x) {
            if (cycles.edge(x, y)) continue;
            if (!cycles.at(x, y) && dark.at(x, y)) {
                ++undecided;
                continue;
            }
            ++judged;
            objects += cycles.at(x, y);
            differ += cycles.at(x, y) != ours.at(x, y);
        }
    std::printf("%s: %d of %d pixels away from edges differ, %d show objects, %d undecided\n", name.c_str(), differ, judged, objects, undecided);
    EXPECT_GT(objects, judged / 10);
    EXPECT_LE(differ, judged * 5e-4);
    EXPECT_LE(undecided, judged / 100);
}

INSTANTIATE_TEST_SUITE_P(RoundTrips, BlenderScene, testing::Values("prims", "textured"), [](const auto& info) { return std::string(info.param); });

TEST(BlenderInstances, ShareTheirMeshes) {
    if (!std::filesystem::exists(kData / "blender/instances.glb")) GTEST_SKIP() << "the reference scenes are not there";
    auto imported = import_scene((kData / "blender/instances.glb").string());
    ASSERT_TRUE(imported) << imported.error().text();
    Diagnostics said;
    const auto scene = compile(std::move(imported->scene), {}, said);
    ASSERT_TRUE(scene) << said.text();
    const CompiledSummary s = summary(*scene);
    EXPECT_EQ(s.triangles, 78'734u);
    EXPECT_GT(s.instanced_triangles, 3'700'000u);
    EXPECT_LT(s.bytes, 30u << 20) << "each mesh once";
    RenderOptions options;
    options.width = 320;
    options.height = 240;
    options.spp = 1;
    ASSERT_TRUE(render(*scene, options));
#if !defined(__SANITIZE_ADDRESS__)
    rusage usage{};
    ASSERT_EQ(getrusage(RUSAGE_SELF, &usage), 0);
    std::printf("peak memory of this process: %ld MB\n", usage.ru_maxrss / 1024);
    EXPECT_LT(usage.ru_maxrss, 300 * 1024) << "3.8 million instanced triangles";
#endif
}

}  // namespace
}  // namespace alidade
