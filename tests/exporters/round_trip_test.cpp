// SPDX-License-Identifier: Apache-2.0
/// What is written and read again is the same: for every exporter of the table, over every sample.
#include "eval/flat_triangle.h"
#include "exporters/exporter.h"
#include "importers/importer.h"
#include "scene/queries.h"
#include "tests/core/folder_test.h"
#include "tests/core/run_size.h"
#include "tests/exporters/canonical.h"
#include "tests/exporters/samples.h"

#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

namespace alidade::test {
namespace {

namespace fs = std::filesystem;

class RoundTrip : public FolderTest {
  protected:
    /// The sample, written and read again.
    Scene again(const Sample& sample, const std::string& ending) {
        const std::string path = (folder_ / (sample.name + ending)).string();
        const auto written = export_scene(sample.scene, path);
        EXPECT_TRUE(written) << sample.name << ending << ": " << (written ? "" : written.error());
        if (!written) return {};
        for (const std::string& file : written->files) EXPECT_TRUE(fs::exists(file)) << file;
        auto read = import_scene(path);
        EXPECT_TRUE(read) << sample.name << ending << ": " << (read ? "" : read.error().text());
        return read ? std::move(read->scene) : Scene();
    }
};

std::vector<std::string> endings(const ExporterEntry& entry) {
    std::vector<std::string> out;
    std::istringstream words(entry.extensions);
    for (std::string word; words >> word;) out.push_back(word);
    return out;
}

bool holds_materials(const std::string& ending) { return ending != ".ply" && ending != ".pov"; }   // POV-Ray's finishes are others
bool holds_missing_uvs(const std::string& ending) { return ending != ".ply" && ending != ".pov"; }   // one mesh: if one has them all do

/// In POV-Ray's scenes colours of vertices are textures.
void forget_what_pov_lacks(std::vector<WorldTriangle>& list) {
    for (WorldTriangle& t : list)
        for (Corner& c : t.corners) std::fill(c.begin() + 8, c.end(), std::numeric_limits<double>::quiet_NaN());
}

/// NaN stands for an attribute that is not there.
void expect_near(const Corner& want, const Corner& got, size_t first, size_t last, double tolerance, const std::string& where) {
    for (size_t i = first; i < last; ++i) {
        if (std::isnan(want[i])) continue;
        ASSERT_NEAR(want[i], got[i], tolerance) << where << " component " << i;
    }
}

/// By how much the normals of a triangle may differ: readers normalise, two roundings to float; where POV-Ray would take them for none, one is turned by 1.5e-5.
double normal_tolerance(const WorldTriangle& t, const std::string& ending) {
    const auto part = [&](size_t corner, size_t first) { return Vec3(t.corners[corner][first], t.corners[corner][first + 1], t.corners[corner][first + 2]); };
    return ending == ".pov" && is_drawn_flat({part(0, 0), part(1, 0), part(2, 0)}, {part(0, 3), part(1, 3), part(2, 3)}) ? 2e-5 : 3e-7;
}

void expect_same_triangles(const std::vector<WorldTriangle>& want, const std::vector<WorldTriangle>& got, const std::string& ending, const std::string& where) {
    ASSERT_EQ(want.size(), got.size()) << where;
    for (size_t t = 0; t < want.size(); ++t) {
        const std::string here = fmt::format("{} triangle {}", where, t);
        const double of_normals = normal_tolerance(want[t], ending);
        for (size_t c = 0; c < 3; ++c) {
            for (size_t i = 0; i < 3; ++i) ASSERT_EQ(float(want[t].corners[c][i]), float(got[t].corners[c][i])) << here;
            expect_near(want[t].corners[c], got[t].corners[c], 3, 6, of_normals, here + " normal");
            expect_near(want[t].corners[c], got[t].corners[c], 6, 8, 1e-15, here + " uv");
            expect_near(want[t].corners[c], got[t].corners[c], 8, 11, ending == ".obj" ? 1e-7 : 0, here + " colour");   // through sRGB's powers and back
            if (holds_missing_uvs(ending)) {
                ASSERT_EQ(std::isnan(want[t].corners[c][6]), std::isnan(got[t].corners[c][6])) << here;
            }
        }
        if (holds_materials(ending)) {
            ASSERT_EQ(want[t].material, got[t].material) << here;
        }
    }
}

/// Coincident triangles have no order among themselves; samples that have some are compared by their positions alone.
bool has_coincident(const std::vector<WorldTriangle>& list) {
    for (size_t i = 1; i < list.size(); ++i) {
        bool same = true;
        for (size_t k = 0; k < 9; ++k) same = same && float(list[i].corners[k / 3][k % 3]) == float(list[i - 1].corners[k / 3][k % 3]);
        if (same) return true;
    }
    return false;
}

TEST_F(RoundTrip, SameTriangles) {
    size_t triangles = 0;
    for (const Sample& sample : samples()) {
        for (const ExporterEntry& entry : exporters())
            for (const std::string& ending : endings(entry)) {
                const bool exact = entry.name != std::string("gltf");   // glTF has no doubles for vertices
                std::vector<WorldTriangle> want = world_triangles(ending == ".pov" ? deform(sample.scene) : sample.scene, exact);   // POV-Ray has no skins
                if (want.empty()) continue;
                if (ending == ".pov") forget_what_pov_lacks(want);
                std::vector<WorldTriangle> got = world_triangles(again(sample, ending), exact);
                triangles += got.size();
                if (has_coincident(want)) {
                    for (auto* list : {&want, &got})
                        for (WorldTriangle& t : *list) {
                            t.material.clear();
                            for (Corner& c : t.corners) std::fill(c.begin() + 3, c.end(), std::numeric_limits<double>::quiet_NaN());
                        }
                }
                expect_same_triangles(want, got, ending, sample.name + ending);
                if (HasFatalFailure()) return;
            }
    }
    EXPECT_GT(triangles, 10'000 * run_scale());
}

TEST_F(RoundTrip, SurveyedCoordinatesKeepTheirDigits) {
    for (const Sample& sample : samples()) {
        if (sample.name != "surveyed") continue;
        for (const char* ending : {".obj", ".ply", ".glb", ".pov"}) {
            const bool exact = std::string(ending) != ".glb";
            const auto want = world_triangles(sample.scene, exact), got = world_triangles(again(sample, ending), exact);
            ASSERT_EQ(want.size(), got.size());
            // Sorted by floats, which lie half a metre apart there: so each triangle is looked for.
            for (const WorldTriangle& w : want)
                EXPECT_TRUE(std::any_of(got.begin(), got.end(), [&](const WorldTriangle& g) {
                    for (size_t shift = 0; shift < 3; ++shift) {
                        bool same = true;
                        for (size_t c = 0; c < 3; ++c)
                            for (size_t i = 0; i < 3; ++i) same = same && w.corners[c][i] == g.corners[(c + shift) % 3][i];
                        if (same) return true;
                    }
                    return false;
                })) << ending;
        }
    }
}

/// Writing what was read from glTF changes nothing that glTF holds: hierarchy, instances, lights, cameras, materials, textures, skins, morphs, animations.
TEST_F(RoundTrip, GltfTwiceIsTheSameScene) {
    size_t compared = 0;
    for (const Sample& sample : samples()) {
        for (const char* ending : {".gltf", ".glb"}) {
            const Scene once = again(sample, ending);
            const Sample second{sample.name + "_again", once};
            EXPECT_EQ(first_difference(dump(canonical(once)), dump(canonical(again(second, ending)))), "") << sample.name << ending;
            if (!sample.name.ends_with(".glb") && !sample.name.ends_with(".gltf")) continue;
            EXPECT_EQ(first_difference(dump(canonical(sample.scene)), dump(canonical(once))), "") << sample.name << ending;
            ++compared;
        }
    }
    EXPECT_GE(compared, 4u);
}

TEST_F(RoundTrip, TheSameBytesTwice) {
    for (const Sample& sample : samples())
        for (const ExporterEntry& entry : exporters()) {
            if (world_triangles(sample.scene, false).empty()) continue;   // formats of meshes alone refuse it
            const auto bytes = [&](const char* name) {
                const std::string path = (folder_ / name / (sample.name + endings(entry)[0])).string();
                fs::create_directories(folder_ / name);
                EXPECT_TRUE(export_scene(sample.scene, path)) << path;
                std::ifstream in(path, std::ios::binary);
                return std::string(std::istreambuf_iterator<char>(in), {});
            };
            EXPECT_EQ(bytes("a"), bytes("b")) << sample.name << " " << entry.name;
        }
}

}  // namespace
}  // namespace alidade::test
