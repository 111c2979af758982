// SPDX-License-Identifier: Apache-2.0
/// What the POV-Ray exporter writes of each kind of shape, of nodes, and of what is broken; read again by the importer.
#include "tests/exporters/pov_file.h"
#include "tests/exporters/samples.h"
#include "tests/scene/sample_scene.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gmock/gmock.h>

namespace alidade::test {
namespace {

using testing::HasSubstr;
using testing::Not;

Scene scene_of(ShapeGeometry geometry) {
    Scene s;
    s.shapes.push_back({"thing", std::move(geometry), {}});
    Node node;
    node.what = ShapeId{0};
    node.to_parent = Transform::translate({1.0 / 3, 2, 3}) * Transform::rotate({0, 1, 0}, 0.3);
    s.nodes.push_back(node);
    s.roots = {NodeId{0}};
    s.settings.default_light = false;
    return s;
}

std::string shapes_of(const Scene& scene) {
    Scene only;
    for (ShapeEntry shape : scene.shapes) {
        shape.name.clear(), shape.from = {};
        only.shapes.push_back(shape);
    }
    return dump(only);
}

/// One of each kind that the scene graph has, made by its defaults: a new kind is among them without a line here.
template <size_t I> void each_kind(const std::function<void(ShapeGeometry)>& f) {
    if constexpr (I < std::variant_size_v<ShapeGeometry>) {
        f(std::variant_alternative_t<I, ShapeGeometry>());
        each_kind<I + 1>(f);
    }
}

/// Placements of one another, each bounded by a sphere and turned: what is written of them grows with their number, and not with its square.
TEST_F(PovFile, ChainsOfBoundedPlacementsStayLinear) {
    const auto size_of = [&](uint32_t levels) {
        Scene s = scene_of(Box{});
        s.shapes.push_back({"bound", Sphere{Vec3(0), 4}, {}});
        Node bound;
        bound.what = ShapeId{1};
        s.nodes.push_back(bound);
        for (uint32_t i = 0; i < levels; ++i) {
            Node above;
            above.to_parent = Transform::rotate({0, 0, 1}, 0.1);
            above.bounds = {NodeId{1}};
            above.children = {s.roots[0]};
            s.roots = {NodeId{uint32_t(s.nodes.size())}};
            s.nodes.push_back(above);
        }
        return exported(s).size();
    };
    const size_t some = size_of(50);
    EXPECT_THAT(text("scene.pov"), HasSubstr("bounded_by"));
    EXPECT_LT(size_of(200), 5 * some);
}

TEST_F(PovFile, EveryKindOfShapeComesBack) {
    size_t kinds = 0;
    each_kind<0>([&](ShapeGeometry geometry) {
        ++kinds;
        if (std::holds_alternative<Mesh>(geometry)) geometry = std::get<Mesh>(triangle_scene().shapes[0].geometry);
        const Scene scene = scene_of(geometry);
        const std::string written = exported(scene);
        EXPECT_THAT(lost_, Not(HasSubstr("extent"))) << geometry.index();
        if (std::holds_alternative<Extrusion>(geometry)) {   // letters become prisms, which are not read yet
            EXPECT_THAT(written, HasSubstr("prism {"));
            return;
        }
        const Scene read = again();
        EXPECT_EQ(shapes_of(scene), shapes_of(read)) << written;
        ASSERT_EQ(read.roots.size(), 2u) << "and a camera";
        const Node& node = read.nodes[read.roots[0].index];
        EXPECT_EQ(node.to_parent.linear, scene.nodes[0].to_parent.linear);
        EXPECT_EQ(node.to_parent.translation, scene.nodes[0].to_parent.translation);
    });
    EXPECT_GE(kinds, 12u);
}

/// What only the language of POV-Ray 3.1 says is declared in it.
TEST_F(PovFile, LayersThatColourNothingAreDeclaredInAnOlderLanguage) {
    Scene scene = triangle_scene();
    scene.signals = {{ConstantSignal{Vec4(1, 0.5, 0.7, 1), 0.5, 0}, {}}};
    PovFinish finish;
    finish.pigment = SignalId{0};
    PovFinish above = finish;
    above.uncolored = true;
    scene.materials = {{"glass", {finish, above, above}, {}}};
    scene.nodes[0].materials = {MaterialId{0}};
    EXPECT_THAT(exported(scene), HasSubstr("#version 3.1;"));
    EXPECT_THAT(lost_, Not(HasSubstr("layers")));
    const Scene read = again();
    const auto marked = [](const auto& layer) { return std::get<PovFinish>(layer).uncolored; };
    for (const Material& m : read.materials) EXPECT_EQ(std::count_if(m.layers.begin(), m.layers.end(), marked), std::ptrdiff_t(m.layers.size()) - 1);
    EXPECT_EQ(read.materials.at(0).layers.size(), 3u);
    scene.materials[0].layers[1] = finish;
    exported(scene);
    EXPECT_THAT(lost_, HasSubstr("layers that colour what passes them"));
}

TEST_F(PovFile, ASceneOfEverythingIsRead) {
    EXPECT_THAT(exported(sample_scene()), HasSubstr("clipped_by"));
    for (const char* what : {"animations", "skins", "morph targets"}) EXPECT_THAT(lost_, HasSubstr(what));
    EXPECT_THAT(lost_, Not(HasSubstr("solid geometry")));
    again();
}

/// Times and components below 0 are no subtractions from what stands before them, and a spline keeps how many components it has.
TEST_F(PovFile, FunctionsAndTheirSplinesComeBack) {
    const std::string declared = "#declare S = function { spline { natural_spline -3, <-1,-2,-3>, -2, <-4,5,-6>, -1, <1,0,2>, 2, <-1,1,1> } } #declare Flat = function { spline { linear_spline -2, <1,-2>, -1, <-4,5> } } #declare G = function { pigment { bozo } }\n"
                                 "#declare T = function { transform { scale 2 } } #declare F = function(a, b) { sum(i, 1, 3, -i*a) + pow(b) - -a + S(a).t + S(b).y + Flat(a).z + G(a, b, a).hf + T(a, b, a).transmit }\n";
    put("first.pov", declared + "sphere { 0, 1 pigment { function { F(x, y) + min(-x, -1) } color_map { [0 rgb <-1,0,0>] [.5 rgb 1] } translate <-1,-2,-3> } normal { function { F(y, x) } .5 slope_map { [0 <-1,-1>] [1 <-2,1>] } } }");
    const auto first = import_scene(at("first.pov"));
    ASSERT_TRUE(first) << first.error().text();
    const std::string written = exported(first->scene);
    Scene wanted, read;
    wanted.functions = first->scene.functions, read.functions = again().functions;
    ASSERT_GE(wanted.functions.size(), 3u);
    ASSERT_EQ(wanted.functions[0].splines.size(), 3u);
    for (Scene* s : {&read, &wanted})
        for (FunctionProgram& f : s->functions)
            for (FunctionStep& step : f.steps)
                if (step.op == FunctionOp::pigment) step.a = 0;       // signals have other numbers
    EXPECT_EQ(dump(read), dump(wanted)) << written;
}

TEST_F(PovFile, WhatIsShownOftenIsWrittenOnce) {
    Scene scene = triangle_scene();
    for (uint32_t i = 1; i < 100; ++i) {
        scene.nodes.push_back(scene.nodes[0]);
        scene.nodes[i].to_parent = Transform::translate({double(i), 0, 0});
        scene.roots.push_back({i});
    }
    const std::string written = exported(scene);
    EXPECT_EQ(written.find("mesh2"), written.rfind("mesh2"));
    EXPECT_EQ(again().shapes.size(), 1u);
}

/// A billion paths, and a chain of a hundred thousand nodes.
TEST_F(PovFile, DeepAndBushyGraphsStaySmall) {
    Scene scene = triangle_scene();
    for (uint32_t i = 0; i < 30; ++i) {
        Node twice;
        twice.children = {NodeId{i}, NodeId{i}};
        scene.nodes.push_back(twice);
    }
    scene.roots = {NodeId{30}};
    EXPECT_LT(exported(scene).size(), 10'000u);
    Scene chain = triangle_scene();
    for (uint32_t i = 0; i < 100'000; ++i) {
        Node link;
        link.children = {NodeId{i}};
        chain.nodes.push_back(link);
    }
    chain.roots = {NodeId{100'000}};
    EXPECT_LT(exported(chain).size(), 20'000'000u);
}

TEST_F(PovFile, WhatIsBrokenIsLeftOutAndTold) {
    Scene scene = triangle_scene();
    Node flat = scene.nodes[0];
    flat.to_parent = Transform::scale({1, 0, 1});
    scene.nodes.push_back(flat);
    scene.roots.push_back({1});
    scene.shapes.push_back({"line", Cylinder{Vec3(0), Vec3(0), 1, false}, {}});
    Node line;
    line.what = ShapeId{1};
    scene.nodes.push_back(line);
    scene.roots.push_back({2});
    EXPECT_THAT(exported(scene), Not(HasSubstr("cylinder")));
    EXPECT_THAT(lost_, HasSubstr("flat"));
    EXPECT_THAT(lost_, HasSubstr("without extent"));
    EXPECT_EQ(again().shapes.size(), 1u);
}

TEST_F(PovFile, NamesCannotEndAComment) {
    Scene scene = triangle_scene();
    scene.nodes[0].name = "a\nsphere { 0, 1 }\r*/ \"#include";
    const std::string written = exported(scene);
    EXPECT_THAT(written, Not(HasSubstr("sphere {")));
    EXPECT_THAT(written, Not(HasSubstr("#include \"")));
    EXPECT_EQ(again().shapes.size(), 1u);
}

/// A square whose normals are all `normal`, at its four corners.
Scene square_with(const Vec3f& normal) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    mesh.normals.values.assign(4, normal);
    return scene_of(std::move(mesh));
}

/// POV-Ray draws a triangle of a mesh flat whose normals are one: one corner's is turned by nothing that shows, however long they are.
TEST_F(PovFile, NormalsThatAreNotUnitAreKept) {
    for (const float size : {0.01f, 0.5f, 1.0f, 2.0f, 100.0f}) {
        exported(square_with(Vec3f(0.6f, 0, 0.8f) * size));
        const Scene read = again();
        const Mesh& mesh = std::get<Mesh>(read.shapes.at(0).geometry);
        for (size_t t = 0; t < 2; ++t)
            for (int corner = 0; corner < 3; ++corner) EXPECT_LT(length(Vec3(mesh.normals.values[mesh.normals.index(t, corner, mesh.triangles[t])]) - Vec3(0.6, 0, 0.8)), 2e-5) << size;
    }
}

TEST_F(PovFile, NormalsWithoutDirectionTurnNothing) {
    EXPECT_THAT(exported(square_with(Vec3f(0))), Not(HasSubstr("normal_indices")));
    EXPECT_THAT(lost_, HasSubstr("normals without direction"));
    const Scene read = again();
    const Mesh& mesh = std::get<Mesh>(read.shapes.at(0).geometry);
    for (const Vec3f& n : mesh.normals.values) EXPECT_LT(std::abs(n.x), 1e-6f);
}

SignalId constant(Scene& scene, const Vec4& value) {
    scene.signals.push_back({ConstantSignal{value}, {}});
    return {uint32_t(scene.signals.size() - 1)};
}

/// A clear coat is there as much as what is under it.
TEST_F(PovFile, ClearCoatsAreThereByAlpha) {
    for (const double alpha : {0.0, 0.25, 1.0})
        for (const double rough : {0.0, 0.5}) {
            Scene scene = triangle_scene();
            GltfPbr pbr;
            pbr.alpha_mode = AlphaMode::blend, pbr.base_color = constant(scene, Vec4(1, 1, 1, alpha));
            pbr.clearcoat = constant(scene, Vec4(0.8)), pbr.clearcoat_roughness = constant(scene, Vec4(rough));
            scene.materials.push_back({"coated", {pbr}, {}});
            scene.nodes[0].materials = {MaterialId{0}};
            exported(scene);
            const Scene read = again();
            Color most(0);
            for (const Material& material : read.materials)
                for (const auto& layer : material.layers) most = glm::max(most, std::get<PovFinish>(layer).reflection_max);
            EXPECT_NEAR(most.x, 0.8 * (1 - rough) * (1 - rough) * alpha, 1e-9) << alpha << " " << rough;
        }
}

/// What is partly metal gives as diffuse light what glTF 2.0, appendix B.3, has straight on, colour by colour; the metal's own lobe of it has the base's colour.
TEST_F(PovFile, DiffuseLightOfWhatIsPartlyMetalIsWhatIsNotReflected) {
    const Color base(0.9, 0.6, 0.2);
    for (const double metallic : {0.1, 0.3, 0.5, 0.8}) {
        Scene scene = triangle_scene();
        GltfPbr pbr;
        pbr.base_color = constant(scene, Vec4(base.x, base.y, base.z, 1));
        pbr.metallic = constant(scene, Vec4(metallic)), pbr.roughness = constant(scene, Vec4(0.6));
        scene.materials.push_back({"mixed", {pbr}, {}});
        scene.nodes[0].materials = {MaterialId{0}};
        exported(scene);
        const Scene read = again();
        const auto& layers = read.materials.at(0).layers;
        Color diffuse(0);
        for (const auto& layer : layers) {
            const auto& finish = std::get<PovFinish>(layer);
            const Vec3 pigment(std::get<ConstantSignal>(read.signals.at(finish.pigment.index).what).value);
            const double covers = finish.diffuse > 1000 ? std::exp2(-20) : 1;   // a clear layer
            if (pigment != Vec3(1)) diffuse += Color(pigment) * (finish.diffuse * covers);
        }
        const auto of_metal = [&](int c) { return diffuse[c] / base[c] - (1 - metallic) * (1 - 0.04 * (1 - metallic) - base[c] * metallic); };
        EXPECT_GE(of_metal(0), 0) << metallic;
        EXPECT_LT(of_metal(0), 0.3 * metallic) << metallic;
        for (int c = 1; c < 3; ++c) EXPECT_NEAR(of_metal(c), of_metal(0), 1e-6) << metallic << " " << c;
    }
}

/// Opaque things are told from 0.02 on, what lets light through from 0.1 on; a POV-Ray texture lets through what all its layers do.
TEST_F(PovFile, SmallScenesAreToldByWhatIsInThem) {
    const auto told = [&](const std::string& texture) {
        const auto read = import_scene(put("small.pov", "camera { location <0, 0, -1> } light_source { <1, 1, -1> 1 } sphere { 0, 0.03 " + texture + " }"));
        EXPECT_TRUE(read) << (read ? "" : read.error().text());
        exported(read->scene);
        return lost_.find("misses in so small a scene") != std::string::npos;
    };
    const std::string clear = "texture { pigment { rgbt <1, 0, 0, 0.5> } }", opaque = "texture { pigment { rgb 1 } }";
    EXPECT_FALSE(told(opaque));
    EXPECT_FALSE(told(opaque + clear));
    EXPECT_FALSE(told("texture { gradient x texture_map { [0 pigment { rgb 1 }] [1 pigment { rgb 0 }] } }"));
    EXPECT_TRUE(told(clear));
    EXPECT_TRUE(told(clear + clear));
    EXPECT_TRUE(told("texture { pigment { gradient x color_map { [0 rgb 1] [1 rgbf 1] } } }"));
    EXPECT_TRUE(told("texture { gradient x texture_map { [0 pigment { rgb 1 }] [1 pigment { rgbt 1 }] } }"));
}

}  // namespace
}  // namespace alidade::test
