// SPDX-License-Identifier: Apache-2.0
/// Lights and surfaces against closed forms.
#include "core/draws.h"
#include "tests/tracer/scene_builder.h"
#include "tracer/lights.h"
#include "tracer/segment.h"
#include "tracer/shade.h"

namespace alidade::test {
namespace {

PlacedLight placed_light(decltype(Light::kind) kind, double range = kInf) {
    Light l;
    l.kind = kind;
    l.range = range;
    l.intensity = Color(8, 4, 2);
    return {l, Transform()};
}

TEST(Lights, PointFallsWithTheSquareOfTheDistance) {
    const PlacedLight light = placed_light(PointLight());
    for (double d : {1e-6, 0.5, 2.0, 1e6}) {
        const Illumination i = illuminate(light, Vec3(0, d, 0), {});
        EXPECT_DOUBLE_EQ(i.distance, d);
        EXPECT_DOUBLE_EQ(i.irradiance.x, 8 / (d * d));
        EXPECT_DOUBLE_EQ(i.irradiance.z, 2 / (d * d));
        EXPECT_EQ(i.direction, Vec3(0, -1, 0));
    }
    EXPECT_TRUE(is_black(illuminate(light, Vec3(0), {}).irradiance)) << "a point on the light itself";
}

TEST(Lights, RangeWindowOfKhrLightsPunctual) {
    const PlacedLight light = placed_light(PointLight(), 10);
    EXPECT_DOUBLE_EQ(illuminate(light, Vec3(5, 0, 0), {}).irradiance.x, 8 / 25.0 * (1 - 1 / 16.0));
    EXPECT_EQ(illuminate(light, Vec3(10, 0, 0), {}).irradiance.x, 0);
    EXPECT_EQ(illuminate(light, Vec3(11, 0, 0), {}).irradiance.x, 0);
}

TEST(Lights, SpotConeOfKhrLightsPunctual) {
    const PlacedLight light = placed_light(SpotLight{0.3, 0.6});
    auto at = [&](double angle) { return illuminate(light, Vec3(std::sin(angle), 0, -std::cos(angle)), {}).irradiance.x; };
    EXPECT_NEAR(at(0), 8, 1e-12);
    EXPECT_NEAR(at(0.29), 8, 1e-12);
    EXPECT_EQ(at(0.61), 0);
    const double x = (std::cos(0.5) - std::cos(0.6)) / (std::cos(0.3) - std::cos(0.6));
    EXPECT_NEAR(at(0.5), 8 * x * x, 1e-9);
}

TEST(Fresnel, ClosedForms) {
    EXPECT_NEAR(fresnel_dielectric(1, 1.5), 0.04, 1e-15) << "normal incidence: ((n-1)/(n+1))^2";
    EXPECT_NEAR(fresnel_dielectric(1, 1 / 1.5), 0.04, 1e-15);
    EXPECT_EQ(fresnel_dielectric(0, 1.5), 1) << "grazing";
    EXPECT_EQ(fresnel_dielectric(0.1, 1 / 1.5), 1) << "beyond the critical angle";
    EXPECT_NEAR(fresnel_dielectric(0.3, 1), 0, 1e-30) << "no boundary";
    const double brewster = std::atan(1.5), t = std::asin(std::sin(brewster) / 1.5);
    const double s = std::sin(brewster - t) / std::sin(brewster + t);
    EXPECT_NEAR(fresnel_dielectric(std::cos(brewster), 1.5), s * s / 2, 1e-15) << "at Brewster's angle only s-polarised light is reflected";
}

/// Radiance of a Lambert plane under a point light: albedo / pi * I cos / d^2.
TEST(Surface, PointLitLambertPlane) {
    SceneBuilder b;
    b.object(Plane{{0, 1, 0}, 0}, b.material(b.lambert(Color(0.8, 0.5, 0.2))));
    b.light(PointLight(), Color(10), Transform::translate({0, 2, 0}));
    b.camera({0, 2, 0}, {0, 0, 0}, 40, {0, 0, -1});   // at the light: the half vector is the eye's own direction
    const Film film = rendered(b.scene, centre_rays(33));
    for (int x = 0; x < 33; ++x) {
        const double tx = 2 * std::tan(20 * kPi / 180) * (x + 0.5 - 16.5) / 33, distance2 = 4 * (1 + tx * tx), cosine = 1 / std::sqrt(1 + tx * tx);
        EXPECT_NEAR(value(film.picture, x, 16, "R"), 0.8 / kPi * 10 / distance2 * cosine, 1e-6) << x;
        EXPECT_NEAR(value(film.picture, x, 16, "B"), 0.2 / kPi * 10 / distance2 * cosine, 1e-6) << x;
    }
}

/// Lights that are left out unasked, because they stand behind a surface of POV-Ray's, bring nothing: by illuminate() and scatter(), wherever they stand.
TEST(Surface, OfPovRayIsBlackForLightsThatItFacesAway) {
    SceneBuilder b;
    PovFinish finish;
    finish.pigment = b.constant(Vec4(1)), finish.phong = 0.5, finish.specular = 0.5, finish.diffuse = 0.7;
    b.scene.materials.push_back({"plain", {finish}, {}});
    b.object(square(), MaterialId{uint32_t(b.scene.materials.size() - 1)});
    const auto scene = compiled(b.scene);
    Ray ray;
    ray.origin = {0.3, 0.1, 1}, ray.dir = normalized(Vec3(0.3, 0.2, -1));
    Hit hit;
    WorkCounters work;
    ASSERT_TRUE(scene->top->intersect(ray, hit, work));
    const ShadePoint p = shade_point(*scene, ray, hit);
    const Surface s = shade<kAllFeatures>(*scene, p, ray.dir);
    Draws draws(RandomKey(7, 0, 0));
    int away = 0, lit = 0;
    for (const decltype(Light::kind)& kind : {decltype(Light::kind)(PointLight()), {SpotLight()}, {ConeLight()}, {CylinderLight()}, {DirectionalLight()}, {AreaLight()}})
        for (const bool parallel : {false, true})
            for (int i = 0; i < 200; ++i) {
                Light light;
                light.kind = kind, light.parallel = parallel;
                const Vec3 place = draws.in_box(Vec3(-3), Vec3(3)), axis = draws.direction();
                const PlacedLight placed(light, Transform::translate(place) * Transform::rotate(axis, draws.uniform(0, 2 * kPi)));
                const Illumination arrives = illuminate(placed, p.position, {0.5, 0.5});
                const bool black = is_black(arrives.irradiance) || is_black(s.scatter(arrives.direction));
                const bool left_out = placed.from_its_place && s.faces_away(placed.position - p.position);
                EXPECT_TRUE(black || !left_out) << light.kind.index() << ' ' << parallel << ' ' << i;
                away += left_out, lit += !black;
            }
    EXPECT_GT(away, 200);
    EXPECT_GT(lit, 200);
}

/// The whole hemisphere of a white surface sends back at most what arrives, at any roughness: the integral of scatter over wi.
TEST(Surface, ReflectsNoMoreThanArrives) {
    SceneBuilder b;
    for (double roughness : {0.2, 0.5, 1.0}) {
        for (double metallic : {0.0, 1.0}) {
            SceneBuilder one = b;
            one.object(square(), one.material(one.pbr(Color(1), metallic, roughness)));
            const auto scene = compiled(one.scene);
            Ray ray;
            ray.origin = {0.3, 0.1, 1};
            ray.dir = normalized(Vec3(0.3, 0.2, -1));
            Hit hit;
            WorkCounters work;
            ASSERT_TRUE(scene->top->intersect(ray, hit, work));
            const ShadePoint p = shade_point(*scene, ray, hit);
            const Surface s = shade<kAllFeatures>(*scene, p, ray.dir);
            double sum = 0;
            constexpr int kSteps = 400;
            for (int i = 0; i < kSteps; ++i)
                for (int j = 0; j < kSteps; ++j) {   // uniform in cos(theta) and phi
                    const double z = (i + 0.5) / kSteps, phi = 2 * kPi * (j + 0.5) / kSteps, r = std::sqrt(1 - z * z);
                    sum += s.scatter({r * std::cos(phi), r * std::sin(phi), z}).x * 2 * kPi / (kSteps * kSteps);
                }
            EXPECT_LT(sum, 1.02) << roughness << ' ' << metallic;
            EXPECT_GT(sum, 0.3) << roughness << ' ' << metallic;
            const double v = -ray.dir.z;   // at alpha 1 the microfacet integral is elementary
            if (roughness == 1 && metallic == 1) { EXPECT_NEAR(sum, 1 - v * std::log((1 + v) / v), 1e-4); }
        }
    }
}

/// POV-Ray's manual, "Interior": light fades by 1 / (1 + (x / d)^power) towards the colour, and from a power of 1000 on by Beer's law.
TEST(Interior, FadesByPowersAndByBeersLaw) {
    Interior in;
    in.fade_distance = 2, in.fade_power = 1.5, in.fade_color = {0.5, 0.2, 0};
    EXPECT_NEAR(pov_fade(in, 3).x, 0.5 + 0.5 / (1 + std::pow(1.5, 1.5)), 1e-15);
    EXPECT_EQ(pov_fade(in, 0), Color(1));
    in.fade_power = 999;
    EXPECT_NEAR(pov_fade(in, 3).y, 0.2, 1e-15);
    for (const double power : {1000.0, 1001.0, 1e6}) {
        in.fade_power = power;
        EXPECT_NEAR(pov_fade(in, 3).x, std::exp(-0.5 * 1.5), 1e-15) << power;
        EXPECT_NEAR(pov_fade(in, 3).z, std::exp(-1.5), 1e-15) << power;
    }
    in.fade_distance = 0;
    EXPECT_EQ(pov_fade(in, 3), Color(1));
    in.fade_distance = 1e-12;   // of a scene that is as small
    EXPECT_NEAR(pov_fade(in, 1e-12).z, std::exp(-1), 1e-15);
}

/// KHR_materials_transmission: metal lets nothing through, and of a mixture the dielectric part does.
TEST(Surface, WhatIsMetalIsNotTransparent) {
    const auto through = [](double metallic) {
        SceneBuilder b;
        GltfPbr m = b.pbr(Color(1), metallic, 0);
        m.transmission = b.constant(Vec4(1));
        b.object(square(), b.material(m));
        const auto scene = compiled(b.scene);
        Ray ray;
        ray.origin = {0.3, 0.1, 1}, ray.dir = {0, 0, -1};
        Hit hit;
        WorkCounters work;
        EXPECT_TRUE(scene->top->intersect(ray, hit, work));
        Secondaries rays;
        shade<kAllFeatures>(*scene, shade_point(*scene, ray, hit), ray.dir).secondary(*scene, {}, rays);
        double weight = 0;
        for (const Secondary& next : rays)
            if (next.dir.z < 0) weight += next.weight.x;
        return weight;
    };
    EXPECT_NEAR(through(0), 0.96, 1e-12) << "all but what is mirrored";
    EXPECT_NEAR(through(0.5), 0.96 * 0.5, 1e-12);
    EXPECT_EQ(through(1), 0);
}

/// KHR_materials_specular scales and colours what a dielectric mirrors: at normal incidence ((n-1)/(n+1))^2 times both.
TEST(Surface, SpecularStrengthAndColour) {
    SceneBuilder b;
    GltfPbr m = b.pbr(Color(0), 0, 0);
    m.specular = b.constant(Vec4(0.5));
    m.specular_color = b.constant({1, 0.5, 0, 1});
    b.object(square(), b.material(m));
    b.scene.atmosphere.environment = Color(1);
    b.scene.settings.adc_bailout = 0;
    b.camera({0, 0, 3}, {0, 0, 0}, 1);
    const Film film = rendered(b.scene, centre_rays(1));
    EXPECT_NEAR(value(film.picture, 0, 0, "R"), 0.04 * 0.5, 1e-6);
    EXPECT_NEAR(value(film.picture, 0, 0, "G"), 0.04 * 0.25, 1e-6);
    EXPECT_EQ(value(film.picture, 0, 0, "B"), 0);
}

/// Any index of refraction that a file may hold, and normal maps that bend the normal away from the eye: numbers, and never more light than there is.
TEST(Surface, GlassStaysFiniteAtTheExtremes) {
    for (double ior : {0.0, 1e-12, 1e12})
        for (double tilt : {-1.0, 0.0, 1.0}) {
            SceneBuilder b;
            GltfPbr m = b.glass(ior);
            m.normal = b.constant({tilt, 0.5, 0.51, 1});
            b.object(square(), b.material(m));
            b.scene.atmosphere.environment = Color(1);
            b.camera({0, 0, 3}, {0, 0, 0}, 50);
            const Film film = rendered(b.scene, centre_rays(9));
            for (const float v : film.picture.values) EXPECT_TRUE(v >= 0 && v < 1.0001f) << ior << ' ' << tilt << ' ' << v;
        }
}

/// However a map bends the normal: what is mirrored stays on the ray's side of the true surface, what is refracted goes beyond it.
TEST(Surface, BentNormalsOfGlassKeepTheSidesApart) {
    size_t refracted = 0;
    for (double tilt : {-1.0, -0.5, 0.5, 1.0})
        for (double ior : {1.1, 1.5, 3.0}) {
            SceneBuilder b;
            GltfPbr m = b.glass(ior);
            m.normal = b.constant({0.5 + 0.5 * tilt, 0.5, 0.55, 1});
            b.object(square(), b.material(m));
            const auto scene = compiled(b.scene);
            for (uint64_t number = 0; number < 200; ++number) {
                Draws draws(RandomKey(6, 0, number));
                const double side = draws.coin() ? 1 : -1;
                Ray ray;
                ray.origin = {draws.uniform(-0.9, 0.9), draws.uniform(-0.9, 0.9), side * 1e-3};
                ray.dir = normalized(Vec3(draws.uniform(-1, 1), draws.uniform(-1, 1), -side * draws.uniform(0.05, 1)));
                Hit hit;
                WorkCounters work;
                scene->top->intersect(ray, hit, work);
                if (!hit.valid()) continue;
                Secondaries rays;
                const ShadePoint point = shade_point(*scene, ray, hit);
                shade<kAllFeatures>(*scene, point, ray.dir).secondary(*scene, {}, rays);
                for (const Secondary& next : rays) {
                    const bool through = next.kind == RayKind::refraction;
                    refracted += through;
                    EXPECT_GT((through ? -side : side) * next.dir.z, 0) << tilt << ' ' << ior << ' ' << number;
                }
            }
        }
    EXPECT_GT(refracted, 1000u);
}

/// A constant sky of radiance 1 around clear glass: every pixel is 1, whatever is refracted or reflected.
TEST(Surface, GlassInAConstantSkyIsInvisible) {
    for (double ior : {1.0, 1.1, 1.5, 2.4}) {
        SceneBuilder b;
        b.object(Sphere{}, b.material(b.glass(ior)));
        b.camera({0, 0, 4}, {0, 0, 0});
        b.scene.atmosphere.environment = Color(1);
        b.scene.settings.adc_bailout = 1e-6;
        RenderOptions o = centre_rays(24);
        o.max_depth = 40;
        const Film film = rendered(b.scene, o);
        EXPECT_GT(film.stats.secondary_rays, 200u);
        for (int y = 0; y < 24; ++y)
            for (int x = 0; x < 24; ++x) EXPECT_NEAR(value(film.picture, x, y, "R"), 1, 2e-5) << ior << ' ' << x << ' ' << y;
    }
}

/// Through a slab of coloured glass at right angles: internal reflections make a geometric series.
TEST(Surface, AbsorbingSlab) {
    SceneBuilder b;
    const NodeId slab = b.object(Box{{-5, -5, -0.5}, {5, 5, 0.5}}, b.material(b.glass(1.5)));
    Interior interior;
    interior.attenuation_color = Color(0.5, 0.25, 1);
    interior.attenuation_distance = 2;
    b.scene.interiors.push_back(interior);
    b.scene.nodes[slab.index].interior = InteriorId{0};
    b.object(Sphere{{0, 0, -100}, 90}, b.material([&] {
        GltfPbr light = b.pbr(Color(0));
        light.emissive = b.constant(Vec4(1));
        light.unlit = false;
        return light;
    }()));
    b.camera({0, 0, 4}, {0, 0, 0}, 1);
    b.scene.settings.adc_bailout = 0;
    RenderOptions o = centre_rays(1);
    o.max_depth = 60;
    const Film film = rendered(b.scene, o);
    const double r = 0.04;
    for (const auto& [channel, a] : {std::pair{"R", std::pow(0.5, 0.5)}, {"G", std::pow(0.25, 0.5)}, {"B", 1.0}})
        EXPECT_NEAR(value(film.picture, 0, 0, channel), (1 - r) * (1 - r) * a / (1 - r * r * a * a), 1e-6) << channel;
}

/// A mirror shows what a mirrored camera would see.
TEST(Surface, MirrorIsAMirroredCamera) {
    auto make = [](bool mirrored) {
        SceneBuilder b;
        GltfPbr mirror = b.pbr(Color(1), 1, 0);
        if (!mirrored) b.object(Plane{{0, 1, 0}, 0}, b.material(mirror));
        b.object(Sphere{{0, 1, 0}, 0.5}, b.material(b.lambert(Color(0.9, 0.3, 0.1))));
        b.light(DirectionalLight(), Color(3), Transform::rotate({1, 0, 0}, -0.3));
        const double side = mirrored ? -1 : 1;
        b.camera({0, 1 * side, 5}, {0, -1 * side, 0}, 20, {0, side, 0});
        b.scene.settings.adc_bailout = 0;
        return b.scene;
    };
    const Film seen = rendered(make(false), centre_rays(32)), direct = rendered(make(true), centre_rays(32));
    int lit = 0;
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) {
            // The mirrored camera's picture is turned left to right: its `right` is the mirror image's left.
            const double a = value(seen.picture, x, y, "R"), c = value(direct.picture, 31 - x, y, "R");
            lit += c > 0.05;
            EXPECT_NEAR(a, c, 1e-5) << x << ' ' << y;
        }
    EXPECT_GT(lit, 20);
}

/// Two mirrors face each other: the number of reflections is the depth limit.
TEST(Surface, RecursionEndsAtTheDepthLimit) {
    SceneBuilder b;
    const MaterialId mirror = b.material(b.pbr(Color(1), 1, 0));
    b.object(Plane{{0, 0, 1}, -1}, mirror);
    b.object(Plane{{0, 0, -1}, -1}, mirror);
    b.camera({0, 0, 0}, {0, 0, -1});
    for (int depth : {0, 1, 5, 30, 1000, 20000}) {   // no depth may need more of a call stack
        RenderOptions o = centre_rays(8);
        o.max_depth = depth;
        o.tile = 1;
        o.threads = 2;
        EXPECT_EQ(rendered(b.scene, o).stats.secondary_rays, uint64_t(depth) * 64);
    }
}

}  // namespace
}  // namespace alidade::test
