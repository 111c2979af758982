// SPDX-License-Identifier: Apache-2.0
/// assets/scenes/motion.glb, whose bar is skinned, whose ball is morphed and whose box is animated: beside what Blender makes of the same file.
#include "core/image.h"
#include "importers/importer.h"
#include "scene/queries.h"
#include "tests/core/run_size.h"
#include "tracer/render.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace alidade {
namespace {

const std::string kRoot = ALIDADE_ROOT;

Scene motion() {
    auto imported = import_scene(kRoot + "/assets/scenes/motion.glb");
    EXPECT_TRUE(imported) << imported.error().text();
    EXPECT_TRUE(imported->diagnostics.list().empty()) << imported->diagnostics.text();
    return imported ? std::move(imported->scene) : Scene();
}

Film rendered(Scene scene, int spp) {
    Diagnostics said;
    const auto compiled = compile(std::move(scene), {}, said);
    EXPECT_TRUE(compiled) << said.text();
    EXPECT_EQ(said.text(), "") << "nothing is left out";
    if (!compiled) return {};
    RenderOptions options;
    options.width = 320;
    options.height = 240;
    options.spp = spp;
    options.aovs = {"coverage"};
    auto film = render(*compiled, options);
    EXPECT_TRUE(film) << film.error();
    return film ? std::move(*film) : Film{};
}

class Motion : public testing::TestWithParam<double> {};

/// Coverage against Cycles': where Cycles' pixel is wholly in or out, so is ours, but for the rim; on the rim the shares of the pixel agree.
TEST_P(Motion, CoversWhatBlenderCovers) {
    if (test::run_scale() < 1) GTEST_SKIP() << "so many samples are taken in the ordinary run";
    const auto mask = read_picture(fmt::format("{}/tests/scenes/motion/mask_{:.2f}.png", kRoot, GetParam()), Encoding::linear);
    ASSERT_TRUE(mask) << mask.error();
    const Film film = rendered(pose(motion(), GetParam()), 64);
    ASSERT_EQ(film.picture.names.back(), "coverage.Y");
    int covered = 0, opposite = 0;
    double difference = 0, rim = 0;
    for (int y = 0; y < mask->height; ++y) {
        for (int x = 0; x < mask->width; ++x) {
            const double theirs = mask->at(x, y)[0], ours = film.picture.at(x, y)[film.picture.channels - 1];
            covered += theirs > 0.5;
            opposite += std::abs(theirs - ours) > 0.5;
            if (theirs > 0 && theirs < 1) difference += std::abs(theirs - ours), ++rim;
        }
    }
    std::printf("time %.2f: %d pixels covered, %d opposite; on the %.0f of the rim the mean difference is %.4f\n", GetParam(), covered, opposite, rim, difference / rim);
    EXPECT_GT(covered, 6000);
    EXPECT_EQ(opposite, 0);
    EXPECT_LT(difference / rim, 0.04) << "64 samples each: a pixel's share is known to 0.03";
}

INSTANTIATE_TEST_SUITE_P(AtThreeTimes, Motion, testing::Values(0.4, 1.1, 1.8), [](const auto& info) { return fmt::format("t{:.0f}", 100 * info.param); });

/// Without a time the scene is shown as the file's nodes and weights stand: joints and targets count all the same.
TEST(MotionAtRest, IsWhatTheFileSays) {
    const Film film = rendered(motion(), 1), first = rendered(pose(motion(), 0), 1);
    size_t differ = 0, covered = 0;
    for (int y = 0; y < film.picture.height; ++y)
        for (int x = 0; x < film.picture.width; ++x) {
            const int last = film.picture.channels - 1;
            covered += film.picture.at(x, y)[last] > 0;
            // The box is elsewhere in its first key; bar and ball start where they rest.
            differ += x < 200 && film.picture.at(x, y)[last] != first.picture.at(x, y)[last];
        }
    EXPECT_GT(covered, 5000u);
    EXPECT_EQ(differ, 0u);
}

}  // namespace
}  // namespace alidade
