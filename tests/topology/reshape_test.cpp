// SPDX-License-Identifier: Apache-2.0
/// What is done to a whole scene, and what is said about it.
#include "tests/topology/surfaces.h"
#include "topology/normals.h"
#include "topology/reshape.h"

#include <gmock/gmock.h>

namespace alidade {
namespace {

using testing::HasSubstr;

Scene scene_of(const std::vector<Mesh>& meshes) {
    Scene scene;
    for (const Mesh& mesh : meshes) scene.shapes.push_back({"shape " + std::to_string(scene.shapes.size()), mesh, {}});
    scene.shapes.push_back({"ball", Sphere{}, {}});
    return scene;
}
const Mesh& mesh_at(const Scene& scene, size_t i) { return std::get<Mesh>(scene.shapes[i].geometry); }

Diagnostics reshaped(Scene& scene, const ReshapeOptions& options) {
    Diagnostics said;
    reshape(scene, options, said);
    EXPECT_FALSE(validate(scene).has_errors()) << validate(scene).text();
    return said;
}

TEST(Reshape, NothingAskedNothingDone) {
    Scene scene = scene_of({cube(), moebius(9)});
    const std::string before = dump(scene);
    EXPECT_TRUE(reshaped(scene, {}).list().empty());
    EXPECT_EQ(dump(scene), before);
}

TEST(Reshape, WhatCannotBeTreatedStaysAsItIs) {
    Scene scene = scene_of({cube(), together(cube(), cube(Vec3(1))), octahedron()});
    const std::string before = dump(scene_of({mesh_at(scene, 1)}));
    const Diagnostics said = reshaped(scene, {2, 0.5, {}});
    EXPECT_EQ(mesh_at(scene, 0).triangles.size(), 96u);
    EXPECT_EQ(mesh_at(scene, 2).triangles.size(), 64u);
    EXPECT_EQ(dump(scene_of({mesh_at(scene, 1)})), before);
    EXPECT_EQ(said.warnings(), 2u) << said.text();
    EXPECT_THAT(said.text(), HasSubstr("\"shape 1\" is not subdivided: its surface is not manifold"));
    EXPECT_THAT(said.text(), HasSubstr("\"shape 1\" is not decimated: its surface is not manifold"));
}

TEST(Reshape, NormalsThatAreLostAreMadeAnewAndSo) {
    Mesh smooth = octahedron();
    topology::set_crease_normals(smooth, 180);
    Mesh with_tangents = smooth;
    with_tangents.tangents.values.assign(6, Vec4f(1, 0, 0, 1));
    Scene scene = scene_of({octahedron(), smooth, with_tangents});
    const Diagnostics said = reshaped(scene, {1, 1, {}});
    for (size_t i = 0; i < 3; ++i) EXPECT_TRUE(mesh_at(scene, i).normals.present()) << "a subdivided surface is smooth";
    EXPECT_THAT(said.text(), HasSubstr("lost the file's normals, and were given new ones: 2"));
    EXPECT_THAT(said.text(), HasSubstr("lost the file's tangents, which are now made from texture coordinates: 1"));

    Mesh smooth_ball = sphere(16, 8);
    topology::set_crease_normals(smooth_ball, 180);
    Scene coarse = scene_of({sphere(16, 8), smooth_ball});
    reshaped(coarse, {0, 0.5, {}});
    EXPECT_FALSE(mesh_at(coarse, 0).normals.present()) << "flat it was, flat it stays";
    EXPECT_TRUE(mesh_at(coarse, 1).normals.present());
}

TEST(Reshape, TheCreaseAngleIsForMeshesWithoutNormals) {
    Mesh with_normals = cube();
    topology::set_crease_normals(with_normals, 180);
    Scene scene = scene_of({cube(), with_normals});
    const Diagnostics said = reshaped(scene, {0, 1, 30});
    EXPECT_EQ(mesh_at(scene, 0).normals.values.size(), 24u);
    EXPECT_EQ(mesh_at(scene, 1).normals.values.size(), 8u);
    EXPECT_TRUE(said.list().empty());
}

TEST(Reshape, TooManyTrianglesAreRefusedBeforeTheyAreMade) {
    Scene scene = scene_of({cube(), octahedron()});
    const std::string before = dump(scene);
    Diagnostics said;
    reshape(scene, {8, 1, {}, 20 * 65536 - 1}, said);
    EXPECT_TRUE(said.has_errors());
    EXPECT_THAT(said.text(), HasSubstr("--subdivide 8 would make 1310720 triangles"));
    EXPECT_EQ(dump(scene), before);
}

TEST(Reshape, MixedTexturesStay) {
    Mesh mixed = cube();
    mixed.corner_slots.assign(3 * mixed.triangles.size(), 0);
    Scene scene = scene_of({mixed});
    const std::string before = dump(scene);
    for (const ReshapeOptions& options : {ReshapeOptions{1, 1, {}}, ReshapeOptions{0, 0.5, {}}}) {
        const Diagnostics said = reshaped(scene, options);
        EXPECT_THAT(said.text(), HasSubstr("mixes textures over its triangles"));
        EXPECT_EQ(dump(scene), before);
    }
}

TEST(Reshape, WhatDecimationCannotReachIsSaid) {
    Scene scene = scene_of({octahedron()});
    const Diagnostics said = reshaped(scene, {0, 1e-3, {}});
    EXPECT_EQ(mesh_at(scene, 0).triangles.size(), 8u) << "with any less it were no octahedron";
    EXPECT_THAT(said.text(), HasSubstr("still has 8 triangles, not 1"));
}

}  // namespace
}  // namespace alidade
