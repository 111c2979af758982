// SPDX-License-Identifier: Apache-2.0
/// The shapes of POV-Ray scenes against what POV-Ray's trace() said once: pov-object-vectors.csv, the rows of the shapes that are modelled.
#include "importers/importer.h"
#include "tests/povray/povray.h"
#include "tracer/compiled_scene.h"
#include "tracer/render.h"

#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <random>

namespace alidade {
namespace {

/// The scene with the object, or nothing if some of it is not modelled.
std::shared_ptr<const CompiledScene> scene_of(const PovObjectVector& row, const std::filesystem::path& folder) {
    const std::string name = row.declaration.substr(9, row.declaration.find('=') - 9), path = (folder / "s.pov").string();
    std::ofstream(path) << "#version 3.7; global_settings { assumed_gamma 1 }\n" << row.declaration << "\nobject { " << name << " }\n";
    auto imported = import_scene(path, {});
    if (!imported) return nullptr;
    const auto modelled = [](const Diagnostics& said) { return said.text().find(" yet") == std::string::npos; };
    if (!modelled(imported->diagnostics)) return nullptr;
    Diagnostics said;
    const auto compiled = compile(std::move(imported->scene), {}, said);
    return modelled(said) ? compiled : nullptr;
}

/// A ray that starts nearer than POV-Ray's least depth to a surface does not see it there.
bool is_left_to_povray(const PovObjectVector& row) { return row.label.find("min depth") != std::string::npos; }

TEST(PovObjects, AreHitWherePovRayHitsThem) {
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / fmt::format("alidade_pov_objects_{}", std::random_device{}());
    std::filesystem::create_directories(folder);
    const auto all = pov_object_vectors();
    if (all.empty()) GTEST_SKIP() << "the shared research is not at hand";
    int asked = 0;
    for (const PovObjectVector& row : all) {
        if (is_left_to_povray(row)) continue;
        const auto scene = scene_of(row, folder);
        if (!scene) continue;
        ++asked;
        Ray ray;
        ray.origin = row.origin, ray.dir = row.dir;
        Hit hit;
        WorkCounters work;
        const bool found = scene->top->intersect(ray, hit, work);
        EXPECT_EQ(found, row.normal != Vec3(0)) << row.label;
        // POV-Ray turns a text by 0.001 degrees about its axes.
        const double tolerance = row.declaration.find("=text{") != std::string::npos ? 5e-5 : 1e-9;
        if (found && row.normal != Vec3(0)) {
            EXPECT_LT(length(ray.at(hit.t) - row.hit), tolerance) << row.label;
        }
    }
    std::filesystem::remove_all(folder);
    std::printf("[          ] %d rows of %zu\n", asked, all.size());
    EXPECT_GE(asked, 20);
}

}  // namespace
}  // namespace alidade
