// SPDX-License-Identifier: Apache-2.0
/// KHR_materials_clearcoat against closed forms: a coat takes c F(cos) of the light, F being Schlick's term for an index of 1.5.
#include "tests/tracer/scene_builder.h"
#include "tracer/shade.h"

namespace alidade::test {
namespace {

/// A coat of `factor` and `roughness` over `base`.
GltfPbr coated(SceneBuilder& b, GltfPbr base, double factor, double roughness) {
    base.clearcoat = b.constant(Vec4(factor));
    base.clearcoat_roughness = b.constant(Vec4(roughness));
    return base;
}

double schlick(double cosine) { return 0.04 + 0.96 * std::pow(1 - cosine, 5); }

/// The square, seen from `angle` off its normal in a sky of radiance 1.
double furnace(const SceneBuilder& materials, const GltfPbr& m, double angle) {
    SceneBuilder b = materials;
    b.object(square(), b.material(m));
    b.scene.atmosphere.environment = Color(1);
    b.scene.settings.adc_bailout = 0;
    b.camera({3 * std::sin(angle), 0, 3 * std::cos(angle)}, {0, 0, 0}, 0.01);
    return value(rendered(b.scene, centre_rays(1)).picture, 0, 0, "G");
}

/// A white diffuse base, under a sky that is 1 everywhere: what the coat takes comes back as far as its mirror ray stands for it, and no more than arrives.
TEST(Clearcoat, InAFurnace) {
    for (const double factor : {0.0, 0.3, 1.0})
        for (const double roughness : {0.0, 0.25, 1.0})
            for (const double angle : {0.0, 0.8, 1.3, 1.5}) {
                SceneBuilder b;
                const double taken = factor * schlick(std::cos(angle)), mirror = (1 - roughness) * (1 - roughness);
                GltfPbr white = b.pbr(Color(1), 0, 1);
                const double got = furnace(b, coated(b, white, factor, roughness), angle);
                EXPECT_NEAR(got, 1 - taken + taken * mirror, 1e-6) << factor << ' ' << roughness << ' ' << angle;
                EXPECT_LE(got, 1 + 1e-6);
            }
}

/// Over black, only the coat is there; over a mirror of gold, the coat is whiter at the rim.
TEST(Clearcoat, OverBlackAndOverMetal) {
    for (const double angle : {0.0, 1.0, 1.4}) {
        SceneBuilder b;
        GltfPbr black = b.pbr(Color(0), 0, 1);
        black.ior = 1;
        EXPECT_NEAR(furnace(b, coated(b, black, 0.5, 0), angle), 0.5 * schlick(std::cos(angle)), 1e-6);
        const double f = schlick(std::cos(angle)), base = 0.7 + 0.3 * std::pow(1 - std::cos(angle), 5);
        EXPECT_NEAR(furnace(b, coated(b, b.pbr(Color(0.7), 1, 0), 1, 0), angle), f + (1 - f) * base, 1e-6);
    }
}

/// Light and eye on the normal: the lobe is 1 / (4 pi alpha^2), so the coat returns E c 0.04 / (4 pi alpha^2), and the base under it (1 - 0.04 c) a / pi E.
TEST(Clearcoat, DirectionalLightAtNormalIncidence) {
    for (const double factor : {0.0, 0.5, 1.0})
        for (const double roughness : {0.2, 0.5, 1.0}) {
            SceneBuilder b;
            const double alpha = roughness * roughness;
            b.object(square(), b.material(coated(b, b.lambert(Color(0.5)), factor, roughness)));
            b.light(DirectionalLight(), Color(3));
            b.camera({0, 0, 3}, {0, 0, 0}, 0.01);
            const double want = 3 * (factor * 0.04 / (4 * kPi * alpha * alpha) + (1 - 0.04 * factor) * 0.5 / kPi);
            EXPECT_NEAR(value(rendered(b.scene, centre_rays(1)).picture, 0, 0, "R"), want, 1e-5 * want) << factor << ' ' << roughness;
        }
}

/// A coat dims what glows under it.
TEST(Clearcoat, CoversEmission) {
    SceneBuilder b;
    GltfPbr lamp = coated(b, b.lambert(Color(0)), 1, 1);
    lamp.emissive = b.constant({2, 2, 2, 1});
    b.object(square(), b.material(lamp));
    b.camera({0, 0, 3}, {0, 0, 0}, 0.01);
    EXPECT_NEAR(value(rendered(b.scene, centre_rays(1)).picture, 0, 0, "B"), 2 * 0.96, 1e-6);
}

/// A factor of 0 changes no byte, over any kind of surface.
TEST(Clearcoat, FactorZeroIsNoCoat) {
    SceneBuilder b;
    for (const GltfPbr& base : {b.pbr(Color(0.8, 0.4, 0.2), 0, 0.4), b.pbr(Color(0.9), 1, 0), b.glass(1.5), b.lambert(Color(1))}) {
        Film films[2];
        for (const bool coat : {false, true}) {
            SceneBuilder one = b;
            one.object(Sphere{}, one.material(coat ? coated(one, base, 0, 0) : base));
            one.object(Plane{{0, 1, 0}, -1}, one.material(one.lambert(Color(0.5))));
            one.light(PointLight(), Color(20), Transform::translate({2, 3, 2}));
            one.scene.atmosphere.environment = Color(0.2, 0.3, 0.4);
            one.camera({0, 1, 4}, {0, 0, 0}, 45);
            films[coat] = rendered(one.scene, centre_rays(24));
        }
        EXPECT_EQ(films[0].picture.values, films[1].picture.values);
    }
}

/// The whole hemisphere of light on a coated white base comes back at most once.
TEST(Clearcoat, ReflectsNoMoreThanArrives) {
    for (const double roughness : {0.2, 0.5, 1.0}) {
        SceneBuilder b;
        b.object(square(), b.material(coated(b, b.pbr(Color(1), 0, 1), 1, roughness)));
        const auto scene = compiled(b.scene);
        Ray ray;
        ray.origin = {0.3, 0.1, 1};
        ray.dir = normalized(Vec3(0.6, 0.2, -1));
        Hit hit;
        WorkCounters work;
        ASSERT_TRUE(scene->top->intersect(ray, hit, work));
        const ShadePoint p = shade_point(*scene, ray, hit);
        const Surface s = shade<kAllFeatures>(*scene, p, ray.dir);
        double sum = 0;
        constexpr int kSteps = 400;
        for (int i = 0; i < kSteps; ++i)
            for (int j = 0; j < kSteps; ++j) {
                const double z = (i + 0.5) / kSteps, phi = 2 * kPi * (j + 0.5) / kSteps, r = std::sqrt(1 - z * z);
                sum += s.scatter({r * std::cos(phi), r * std::sin(phi), z}).x * 2 * kPi / (kSteps * kSteps);
            }
        EXPECT_LT(sum, 1.02) << roughness;
        EXPECT_GT(sum, 0.8) << roughness;
    }
}

/// The coat's own normal map bends its mirror ray, the base's does not: two rays, each in its direction.
TEST(Clearcoat, HasItsOwnNormal) {
    SceneBuilder b;
    GltfPbr m = coated(b, b.pbr(Color(1), 1, 0), 1, 0);
    m.clearcoat_normal = b.constant({0.5 + 0.5 * 0.6, 0.5, 0.5 + 0.5 * 0.8, 1});   // (0.6, 0, 0.8)
    b.object(square(), b.material(m));
    const auto scene = compiled(b.scene);
    Ray ray;
    ray.origin = {0.2, 0.1, 1};
    ray.dir = {0, 0, -1};
    Hit hit;
    WorkCounters work;
    ASSERT_TRUE(scene->top->intersect(ray, hit, work));
    const ShadePoint p = shade_point(*scene, ray, hit);
    Secondaries rays;
    shade<kAllFeatures>(*scene, p, ray.dir).secondary(*scene, {}, rays);
    ASSERT_EQ(rays.size(), 2u);
    EXPECT_LT(length(rays[0].dir - Vec3(0, 0, 1)), 1e-12);
    EXPECT_LT(length(rays[1].dir - Vec3(2 * 0.8 * 0.6, 0, 2 * 0.8 * 0.8 - 1)), 1e-9);
    EXPECT_NEAR(rays[1].weight.x, schlick(0.8), 1e-9);
}

/// Seen from behind, glTF turns normals round, a coat's own as well.
TEST(Clearcoat, HasItsOwnNormalOnTheBack) {
    SceneBuilder b;
    GltfPbr m = coated(b, b.pbr(Color(1), 1, 0), 1, 0);
    m.clearcoat_normal = b.constant({0.5 + 0.5 * 0.6, 0.5, 0.5 + 0.5 * 0.8, 1});   // (0.6, 0, 0.8)
    m.double_sided = true;
    b.object(square(), b.material(m));
    const auto scene = compiled(b.scene);
    Ray ray;
    ray.origin = {0.2, 0.1, -1};
    ray.dir = {0, 0, 1};
    Hit hit;
    WorkCounters work;
    ASSERT_TRUE(scene->top->intersect(ray, hit, work));
    const ShadePoint p = shade_point(*scene, ray, hit);
    ASSERT_FALSE(p.front);
    Secondaries rays;
    shade<kAllFeatures>(*scene, p, ray.dir).secondary(*scene, {}, rays);
    ASSERT_EQ(rays.size(), 2u);
    EXPECT_LT(length(rays[0].dir - Vec3(0, 0, -1)), 1e-12);
    EXPECT_LT(length(rays[1].dir - Vec3(-2 * 0.8 * 0.6, 0, 1 - 2 * 0.8 * 0.8)), 1e-9);
}

}  // namespace
}  // namespace alidade::test
