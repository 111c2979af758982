// SPDX-License-Identifier: Apache-2.0
/// Pigments with maps against POV-Ray's pigment functions, and the space that patterns are looked up in.
#include "tests/povray/povray.h"
#include "tests/tracer/on_plane.h"
#include "tests/tracer/scene_builder.h"
#include "tracer/surface.h"
#include "tracer/textures.h"

#include <fmt/format.h>
#include <random>

namespace alidade::test {
namespace {

/// A pigment in POV-Ray's words and as a signal of `scene`.
struct PigmentCase {
    std::string text;
    SignalId signal;
};

/// Signals, one call each.
struct Pigments {
    Scene scene;
    std::vector<PigmentCase> cases;

    SignalId color(const Color& c, double filter = 0, double transmit = 0) { return add(ConstantSignal{Vec4(c, 1), filter, transmit}); }
    template <class S> SignalId add(const S& what) {
        scene.signals.emplace_back();
        scene.signals.back().what = what;
        return {uint32_t(scene.signals.size() - 1)};
    }
    SignalId pattern(const char* name, std::vector<MapEntry> map, std::vector<double> parameters = {}, std::vector<Warp> warps = {}, double turbulence = 0) {
        PatternSignal s;
        s.pattern = name, s.map = std::move(map), s.parameters = std::move(parameters), s.warps = std::move(warps);
        s.turbulence.amount = Vec3(turbulence);
        return add(s);
    }
    void expect(std::string text, SignalId signal) { cases.push_back({std::move(text), signal}); }
};

Pigments pigments() {
    Pigments p;
    const auto red = p.color({1, 0, 0}), blue = p.color({0, 0, 1}), glass = p.color({.9, .8, .25}, .3, .6), gray = p.color(Color(.5)), dark = p.color({.1, .2, .3}, .7, .1);
    const Warp half{WarpKind::transform, Transform::scale(Vec3(.5)), {}}, moved{WarpKind::transform, Transform::translate({.2, .1, -.4}), {}};
    p.expect("bozo color_map { [.2 rgb x] [.6 rgbft <.9,.8,.25,.3,.6>] [.8 rgbft <.1,.2,.3,.7,.1>] }", p.pattern("bozo", {{.2, red}, {.6, glass}, {.8, dark}}));
    p.expect("gradient x color_map { [.25 rgb x] [.25 rgb z] [.5 rgb .5] [.5 rgb x] }", p.pattern("gradient", {{.25, red}, {.25, blue}, {.5, gray}, {.5, red}}, {1, 0, 0}));
    p.expect("gradient x color_map { [0 rgb x] [.7 rgb z] [.3 rgb .5] [.9 rgbft <.1,.2,.3,.7,.1>] }", p.pattern("gradient", {{0, red}, {.7, blue}, {.3, gray}, {.9, dark}}, {1, 0, 0}));
    p.expect("onion color_map { [.9 rgb x] [.2 rgb z] }", p.pattern("onion", {{.9, red}, {.2, blue}}));
    p.expect("checker rgb x, rgb z scale .5", p.pattern("checker", {{0, red}, {1, blue}}, {}, {half}));
    p.expect("hexagon rgb x, rgb z, rgb .5", p.pattern("hexagon", {{0, red}, {1, blue}, {2, gray}}));
    p.expect("brick rgb x, rgb z brick_size <.5,.3,.4> mortar .05", p.pattern("brick", {{0, red}, {1, blue}}, {.5, .3, .4, .05}));
    const SignalId inner = p.pattern("agate", {{0, gray}, {1, glass}}, {}, {half});
    const SignalId checks = p.pattern("checker", {{0, blue}, {1, dark}}, {}, {half});
    p.expect("leopard pigment_map { [.1 agate color_map { [0 rgb .5] [1 rgbft <.9,.8,.25,.3,.6>] } scale .5] [.9 checker rgb z, rgbft <.1,.2,.3,.7,.1> scale .5] } turbulence .3 translate <.2,.1,-.4>",
             p.pattern("leopard", {{.1, inner}, {.9, checks}}, {}, {moved}, .3));
    p.expect("average pigment_map { [1 agate color_map { [0 rgb .5] [1 rgbft <.9,.8,.25,.3,.6>] } scale .5] [2.5 rgb x] [.5 checker rgb z, rgbft <.1,.2,.3,.7,.1> scale .5] } translate <.2,.1,-.4>",
             p.pattern("average", {{1, inner}, {2.5, red}, {.5, checks}}, {}, {moved}));
    return p;
}

constexpr const char* kChannels[] = {"red", "green", "blue", "filter", "transmit"};

double channel(const PigmentColor& c, size_t i) { return i < 3 ? c.color[int(i)] : i == 3 ? c.filter : c.transmit; }

}  // namespace

TEST(Pigments, MapsArePovRays) {
    if (!povray_is_installed()) GTEST_SKIP() << "povray is not installed";
    const Pigments p = pigments();
    std::mt19937_64 engine(3);
    std::uniform_real_distribution<double> uniform(-2, 2);
    std::vector<Vec3> points = {Vec3(0.25, 0, 0), Vec3(0.5, 0, 0), Vec3(0), Vec3(1, 0, 0)};
    while (points.size() < 120) points.emplace_back(uniform(engine), uniform(engine), uniform(engine));
    std::string prelude;
    std::vector<std::string> asked;
    for (size_t i = 0; i < p.cases.size(); ++i) {
        prelude += fmt::format("#declare F{} = function {{ pigment {{ {} }} }}\n", i, p.cases[i].text);
        for (const Vec3& at : points)
            for (const char* c : kChannels) asked.push_back(fmt::format("F{}({:.17g}, {:.17g}, {:.17g}).{}", i, at.x, at.y, at.z, c));
    }
    const std::vector<double> theirs = povray_values(prelude, asked);
    ASSERT_EQ(theirs.size(), asked.size());
    Diagnostics said;
    std::vector<SignalId> all;
    for (uint32_t i = 0; i < p.scene.signals.size(); ++i) all.push_back({i});
    const Textures textures(p.scene, all, 1, said);
    ASSERT_FALSE(said.has_errors()) << said.text();
    for (size_t k = 0; k < theirs.size(); ++k) {
        ShadePoint point;
        point.position = points[k / 5 % points.size()];
        const PigmentCase& c = p.cases[k / 5 / points.size()];
        // POV-Ray's colours have single precision.
        EXPECT_NEAR(channel(textures.pigment(c.signal, point, point.pattern_point()), k % 5), theirs[k], 3e-7) << c.text << " at " << pov_text(point.position) << ' ' << kChannels[k % 5];
    }
}

/// A pattern stands still in the node that carries the material, whatever is between that node and the shape.
TEST(Pigments, PatternsAreInTheSpaceOfTheNodeThatCarriesThem) {
    SceneBuilder b;
    PatternSignal bozo;
    bozo.pattern = "bozo";
    b.scene.signals.emplace_back();
    b.scene.signals.back().what = bozo;
    GltfPbr m = b.lambert(Color(1));
    m.base_color = {0};
    const MaterialId material = b.material(m);
    Node shape;
    shape.what = b.shape(Sphere{Vec3(0), 1});
    shape.to_parent = Transform::rotate({0, 1, 0}, 0.7) * Transform::scale({1, 2, 1});
    const NodeId child = b.node(shape, false);
    Node carrier;
    carrier.materials = {material};
    carrier.to_parent = Transform::translate({3, 1, 0}) * Transform::scale(Vec3(1.5));
    carrier.children = {child};
    b.node(carrier);
    b.camera({3, 1, 10}, {3, 1, 0});
    const auto scene = compiled(b.scene);
    ASSERT_TRUE(scene);
    Ray ray;
    ray.origin = {3.2, 1.3, 10};
    ray.dir = {0, 0, -1};
    Hit hit;
    WorkCounters work;
    ASSERT_TRUE(scene->top->intersect(ray, hit, work));
    const ShadePoint point = shade_point(*scene, ray, hit);
    const Vec3 local = (point.position - Vec3(3, 1, 0)) / 1.5;
    EXPECT_NEAR(scene->textures->evaluate({0}, point).x, Pattern::make(bozo)->value(local), 1e-12);
    EXPECT_GT(std::fabs(Pattern::make(bozo)->value(local) - Pattern::make(bozo)->value(point.position)), 1e-3);
}

/// What a shadow ray passes is known without the point where that is the same everywhere, and is what the point would say, bit for bit.
TEST(Pigments, FiltersOfOneColourAreKnownAhead) {
    SceneBuilder b;
    const auto finish = [](SignalId pigment) {
        PovFinish f;
        f.pigment = pigment;
        return f;
    };
    const auto add = [&](std::vector<PovFinish> layers) {
        Material m;
        for (const PovFinish& f : layers) m.layers.push_back(f);
        b.scene.materials.push_back(m);
        Node ball;
        ball.what = b.shape(Sphere{Vec3(0), 1});
        ball.materials = {MaterialId{uint32_t(b.scene.materials.size() - 1)}};
        ball.to_parent = Transform::translate({3.0 * double(b.scene.nodes.size()), 0, 0});
        b.node(ball);
    };
    b.scene.signals = {{ConstantSignal{Vec4(.9, .3, .7, 1), .6, .1}, {}}, {ConstantSignal{Vec4(.2, .8, .4, 1), .3, .5}, {}}, {PatternSignal(), {}}};
    auto& checks = std::get<PatternSignal>(b.scene.signals[2].what);
    checks.pattern = "checker", checks.map = {{0, {0}}, {1, {1}}};
    add({finish({0})}), add({finish({0}), finish({1})}), add({finish({0}), finish({2})});
    b.camera({3, 1, 10}, {3, 1, 0});
    const auto scene = compiled(b.scene);
    ASSERT_TRUE(scene);
    WorkCounters work;
    for (uint32_t i = 0; i < 3; ++i) {
        const Ray ray{{3.0 * i + .3, .2, 10}, {0, 0, -1}};
        Hit hit;
        ASSERT_TRUE(scene->top->intersect(ray, hit, work));
        const uint32_t slot = plain_slot(*scene, hit);
        const ShadePoint point = passed_point(*scene, ray, hit);
        ASSERT_EQ(slot, point.slot);
        ASSERT_EQ(scene->uniform_filters[slot].has_value(), i < 2);
        if (i < 2) { ASSERT_TRUE(*scene->uniform_filters[slot] == transmitted(*scene, point, ray.dir)); }
    }
}

/// Two balls in an air of their own, one before the other, of the layers that `change` makes, in the light of two lamps; their lowest pigment is `lowest`.
Scene plain_or_not(const Signal& lowest, const std::function<void(PovFinish&, PovFinish&)>& change) {
    SceneBuilder b;
    b.scene.signals = {{ConstantSignal{Vec4(.9, .3, .7, 1), 0, 0}, {}}, {ConstantSignal{Vec4(.2, .8, .4, 1), .3, .4}, {}}, lowest};
    PovFinish below, above;
    below.pigment = {2}, above.pigment = {1};
    change(below, above);
    Material m;
    m.layers = {below, above};
    b.scene.materials.push_back(m);
    for (const Vec3& at : {Vec3(-1, 0, 0), Vec3(.5, .2, -1)}) b.object(Sphere{Vec3(0), 1}, {0}, Transform::translate(at));
    for (const Vec3& at : {Vec3(5, 8, 10), Vec3(-9, 1, 3)}) b.light(PointLight(), Color(1), Transform::translate(at));
    b.camera({0, 1, 8}, {0, 0, 0});
    return b.scene;
}

/// What is known of a surface ahead of its points is what its points would say, bit for bit: here those of a pattern of two colours that are the same.
TEST(Pigments, SurfacesOfOneColourAreKnownAhead) {
    PatternSignal checks;
    checks.pattern = "checker", checks.map = {{0, {0}}, {1, {0}}};
    const std::function<void(PovFinish&, PovFinish&)> changes[] = {
        [](PovFinish& below, PovFinish& above) { below.phong = 1, above.specular = .7, above.metallic = 1; },
        [](PovFinish& below, PovFinish& above) { below.reflection_min = below.reflection_max = Color(.4), above.reflection_fresnel = true, above.reflection_max = Color(.8); },
        [](PovFinish& below, PovFinish& above) { below.emission = Color(.3), above.irid = .5, above.irid_thickness = .6, above.diffuse_back = .4; },
        [](PovFinish&, PovFinish& above) { above.conserve_energy = true, above.reflection_max = Color(.6); },
    };
    RenderOptions options;
    options.width = options.height = 48;
    for (const auto& change : changes) {
        const Scene plain = plain_or_not({ConstantSignal{Vec4(.9, .3, .7, 1), 0, 0}, {}}, change), patterned = plain_or_not({checks, {}}, change);
        const auto a = compiled(plain), b = compiled(patterned);
        ASSERT_TRUE(a && b);
        EXPECT_EQ(a->plain_surfaces.empty(), &change == &changes[3]) << "energy that is conserved depends on the direction";
        EXPECT_TRUE(b->plain_surfaces.empty());
        const Film of_plain = rendered(plain, options), of_patterned = rendered(patterned, options);
        EXPECT_EQ(of_plain.picture.values, of_patterned.picture.values) << &change - changes;
    }
}

TEST(Pigments, UvMappedPatternsAreLookedUpAtTextureCoordinates) {
    const PatternSpace space{Transform(), Transform::scale(Vec3(7))};
    ShadePoint point;
    point.position = {5, 6, 7};
    point.on_shape = test::on_plane(0.25, 0.75);
    point.space = &space;
    EXPECT_EQ(point.pattern_point(), Vec3(35, 42, 49));
    EXPECT_EQ(point.uv_place(), Vec3(5, 6, 0)) << "POV-Ray knows no (u, v) of planes";
    const ShapeGeometry box = Box{};
    point.on_shape = {find_shape(box), &box, Vec3(1, 0.5, 0.25), 0};
    const Vec2 on_box = find_shape(box)->surface(box, point.on_shape.point, 0).uv;
    EXPECT_EQ(point.uv_place(), Vec3(on_box, 0));
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, mesh.triangles = {Index3(0u, 1u, 2u)};
    mesh.uvs.resize(1), mesh.uvs[0].values = {{0.5f, 0.25f}, {0.5f, 0.25f}, {0.5f, 0.25f}};
    point.mesh = &mesh;
    EXPECT_EQ(point.uv_place(), Vec3(0.5, 0.75, 0)) << "v upwards";
}

TEST(Pigments, APatternThatDoesNotExistIsAnErrorWithItsPlace) {
    SceneBuilder b;
    PatternSignal zork;
    zork.pattern = "zork";
    b.scene.files = {{"scene.pov"}};
    b.scene.signals.emplace_back();
    b.scene.signals.back() = {zork, {0, 3, 4, ""}};
    Diagnostics said;
    const Textures textures(b.scene, {{0}}, 1, said);
    EXPECT_TRUE(said.has_errors());
    EXPECT_NE(said.text().find("there is no pattern 'zork'"), std::string::npos) << said.text();
}

}  // namespace alidade::test
