// SPDX-License-Identifier: Apache-2.0
/// What is seen of surfaces in one place: of POV scenes that of the object whose box the ray enters first, of others that of the first instance.
#include "tests/tracer/scene_builder.h"

#include "accel/accelerator.h"
#include "tracer/compiled_scene.h"

namespace alidade::test {
namespace {

/// The square of the front, and a triangle beside it that comes nearer by `depth`.
Mesh front_and_ear(float depth) {
    Mesh m = square();
    m.uvs.clear();
    m.positions.insert(m.positions.end(), {{2, 2, -depth}, {3, 2, -depth}, {2, 3, -depth}});
    m.triangles.push_back({4, 5, 6});
    return m;
}

/// All have their front in the plane z = 0. By when a ray along z comes to their boxes, the last one first: a plane has none.
std::vector<ShapeGeometry> things() { return {Box{{-1, -1, 0}, {1, 1, 1}}, front_and_ear(1), front_and_ear(2), Plane{{0, 0, -1}, 0}}; }

size_t seen(const SceneBuilder& b, const AcceleratorEntry& accel) {
    CompileOptions options;
    options.accel = accel.name;
    const auto scene = compiled(b.scene, options);
    Hit hit;
    WorkCounters work;
    EXPECT_TRUE(scene->top->intersect(Ray{Vec3(0.3, 0.2, -5), Vec3(0, 0, 1)}, hit, work)) << accel.name;
    return hit.instance;
}

SceneBuilder pair(const ShapeGeometry& first, const ShapeGeometry& second, bool by_boxes) {
    SceneBuilder b;
    const MaterialId grey = b.material(b.lambert(Color(0.5)));
    b.object(first, grey), b.object(second, grey);
    b.camera({0, 0, -5}, Vec3(0));
    b.light(PointLight(), Color(1));   // the third that POV-Ray wants for a hierarchy of boxes
    b.scene.settings.first_box_shows = by_boxes;
    return b;
}

TEST(Coincidence, ThatOfTheFirstBoxIsSeenWhateverTheOrderOfObjects) {
    for (const AcceleratorEntry& accel : accelerators())
        for (size_t later = 0; later < things().size(); ++later)
            for (size_t sooner = later + 1; sooner < things().size(); ++sooner) {
                EXPECT_EQ(seen(pair(things()[later], things()[sooner], true), accel), 1u) << accel.name << ' ' << later << ' ' << sooner;
                EXPECT_EQ(seen(pair(things()[sooner], things()[later], true), accel), 0u) << accel.name << ' ' << later << ' ' << sooner;
                EXPECT_EQ(seen(pair(things()[later], things()[sooner], false), accel), 0u) << accel.name << ' ' << later << ' ' << sooner;
            }
}

/// Of boxes that are entered at one place; rounding pads of their sizes say nothing.
TEST(Coincidence, OfBoxesInOnePlaceTheFirstObjectIsSeen) {
    const Box small{{-1, -1, 0}, {1, 1, 1}}, large{{-70, -20, 0}, {90, 80, 30}}, tenth{{-1, -1, 0.1}, {1, 1, 1}}, large_tenth{{-70, -20, 0.1}, {90, 80, 30}};
    for (const AcceleratorEntry& accel : accelerators())
        for (const auto& [a, b] : {std::pair(small, large), std::pair(large, small), std::pair(tenth, large_tenth), std::pair(large_tenth, tenth)}) EXPECT_EQ(seen(pair(a, b, true), accel), 0u) << accel.name;
}

}  // namespace
}  // namespace alidade::test
