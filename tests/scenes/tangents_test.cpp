// SPDX-License-Identifier: Apache-2.0
/// Tangents beside those that Blender, which has Mikkelsen's own code, wrote into the files that it exported.
#include "eval/tangents.h"
#include "importers/importer.h"

#include <array>
#include <filesystem>
#include <gtest/gtest.h>

namespace alidade {
namespace {

const std::filesystem::path kData = ALIDADE_SHARED_DATA;

struct Comparison {
    size_t corners = 0, within_degree = 0, other_sign = 0, without = 0;
    double worst = 0;
};

/// The file stores each value rounded; normals and positions of its vertices are what Blender made the tangents from.
Comparison compare(const Mesh& mesh) {
    Comparison out;
    const Attribute<Vec4f> ours = make_tangents(mesh, 0);
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (int corner = 0; corner < 3; ++corner) {
            const Vec4 theirs(mesh.tangents.values[mesh.tangents.index(t, corner, mesh.triangles[t])]);
            const Vec4 mine(ours.values[ours.index(t, corner, mesh.triangles[t])]);
            const Vec3 a = normalized(Vec3(theirs)), b(mine);
            const double degrees = std::atan2(length(cross(a, b)), dot(a, b)) * 180 / kPi;
            ++out.corners;
            out.within_degree += degrees < 1;
            out.other_sign += mine.w != theirs.w;
            out.worst = std::max(out.worst, degrees);
        }
    }
    return out;
}

TEST(Tangents, AreBlenders) {
    if (!std::filesystem::exists(kData / "blender/textured.glb")) GTEST_SKIP() << "the reference scenes are not there";
    const auto imported = import_scene((kData / "blender/textured.glb").string());
    ASSERT_TRUE(imported) << imported.error().text();
    Comparison all;
    for (const ShapeEntry& shape : imported->scene.shapes) {
        const Mesh& mesh = std::get<Mesh>(shape.geometry);
        ASSERT_TRUE(mesh.tangents.present()) << shape.name;
        const Comparison c = compare(mesh);
        std::printf("%-12s %5zu corners, %zu within a degree, worst %.3f degrees, %zu of other sign\n", shape.name.c_str(), c.corners, c.within_degree, c.worst, c.other_sign);
        all.corners += c.corners, all.within_degree += c.within_degree, all.other_sign += c.other_sign;
    }
    EXPECT_GT(all.corners, 10'000u);
    EXPECT_GT(double(all.within_degree), 0.99 * double(all.corners));
    EXPECT_EQ(all.other_sign, 0u);
}

}  // namespace
}  // namespace alidade
