// SPDX-License-Identifier: Apache-2.0
#include "tests/tracer/scene_builder.h"

#include "tracer/compiled_scene.h"
#include "tracer/start_inside.h"

#include <random>

namespace alidade::test {
namespace {

double in_unit(std::mt19937& random) { return std::uniform_real_distribution<double>()(random); }

TEST(StartInside, SolidsThatHoldTheBeginningOfARayComeInTheOrderOfTheScene) {
    SceneBuilder b;
    std::mt19937 random(5);
    std::vector<Sphere> spheres;
    const MaterialId clear = b.material(b.glass(1.5));
    b.scene.interiors.emplace_back();
    b.scene.interiors[0].ior = 1.5;
    for (int i = 0; i < 200; ++i) {
        spheres.push_back({{4 * in_unit(random) - 2, 4 * in_unit(random) - 2, in_unit(random) - 0.5}, 0.2 + in_unit(random)});
        const NodeId node = b.object(spheres.back(), clear);
        b.scene.nodes[node.index].interior = InteriorId{0};
    }
    b.camera({0, 0, 0}, {0, 0, 1});
    b.scene.cameras[0].projection = Projection::orthographic;
    b.scene.cameras[0].right = {4, 0, 0}, b.scene.cameras[0].up = {0, 4, 0};
    const auto scene = compiled(b.scene);
    const StartInside around(*scene, scene->cameras[0].camera);
    for (int k = 0; k < 100; ++k) {
        const Vec3 origin(4 * in_unit(random) - 2, 4 * in_unit(random) - 2, 0);
        std::vector<uint32_t> wanted, got;
        for (uint32_t i = 0; i < spheres.size(); ++i)
            if (length(origin - spheres[i].center) < spheres[i].radius) wanted.push_back(scene->instances[i].carrier);
        const InteriorStack inside = around.at(origin);
        for (const InteriorStack::Entry& entry : inside.entries()) got.push_back(entry.carrier);
        EXPECT_EQ(got, wanted);
    }
}

}  // namespace
}  // namespace alidade::test
