// SPDX-License-Identifier: Apache-2.0
/// Samplers, lights with an extent, skies and lenses, against what they converge to.
#include "tests/core/run_size.h"
#include "tests/tracer/scene_builder.h"
#include "tracer/cameras.h"
#include "tracer/lights.h"
#include "tracer/sampler.h"
#include "tracer/sky.h"

#include <array>
#include <functional>
#include <set>

namespace alidade::test {
namespace {

TEST(Samplers, EveryRowIsUniformAndDeterministic) {
    for (const SamplerEntry& sampler : samplers()) {
        Vec2 mean(0), square(0);
        double product = 0;
        constexpr uint32_t kCount = 4096;
        for (uint32_t i = 0; i < kCount; ++i) {
            const Vec2 p = sampler.pair(RandomKey(1, 2, 3), i, kCount);
            ASSERT_TRUE(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1) << sampler.name;
            ASSERT_EQ(p, sampler.pair(RandomKey(1, 2, 3), i, kCount));
            mean += p / double(kCount), square += p * p / double(kCount), product += p.x * p.y / kCount;
        }
        EXPECT_NEAR(mean.x, 0.5, 0.02) << sampler.name;
        EXPECT_NEAR(mean.y, 0.5, 0.02) << sampler.name;
        EXPECT_NEAR(square.x, 1 / 3.0, 0.02) << sampler.name;
        EXPECT_NEAR(product, 0.25, 0.02) << sampler.name << ": the two dimensions do not know of each other";
    }
}

TEST(Samplers, BlocksHaveTheBitsOfPairs) {
    for (const SamplerEntry& sampler : samplers())
        for (const Coordinates which : {Coordinates::pixel, Coordinates::light, Coordinates::lens})
            for (uint64_t pixel = 0; pixel < 50; ++pixel)
                for (const uint32_t count : {2u, 7u, 120u, 70'000u}) {
                    const SampleDomain domain = SampleKey::domain(RandomKey(3, 1, pixel), which, pixel % 2);
                    const uint32_t begin = count / 11 * 8;
                    SampleBlock block;
                    sample_block(sampler, domain, begin, count, block);
                    for (uint32_t k = 0; k < std::min(kSampleBlock, count - begin); ++k)
                        ASSERT_EQ(block[k], sampler.pair(domain, begin + k, count)) << sampler.name << ", sample " << begin + k << " of " << count;
                }
}

/// Against the angle and the radius that the map is defined by.
TEST(Samplers, TheDiscIsThatOfShirleyAndChiu) {
    for (double x = 0; x <= 1; x += 1 / 64.0)
        for (double y = 0; y <= 1; y += 1 / 64.0) {
            const double a = 2 * x - 1, b = 2 * y - 1;
            const bool wide = std::abs(a) > std::abs(b);
            const double r = wide ? a : b, angle = wide ? kPi / 4 * (b / a) : b == 0 ? 0 : kPi / 2 - kPi / 4 * (a / b);
            EXPECT_LE(length(concentric_disc({x, y}) - Vec2(r * std::cos(angle), r * std::sin(angle))), 4e-16) << x << " " << y;
        }
}

/// A pixel's own samples are those that its keys draw.
TEST(Samplers, TheDomainOfAPixelIsThatOfItsKeys) {
    const SamplerEntry& sampler = samplers()[0];
    const RandomKey pixel(5, 0, 77);
    for (const Coordinates which : {Coordinates::pixel, Coordinates::lens}) {
        SampleBlock block;
        sample_block(sampler, SampleKey::domain(pixel, which, 1), 8, 30, block);
        for (uint32_t k = 0; k < kSampleBlock; ++k) EXPECT_EQ(block[k], SampleKey(sampler.pair, pixel, 8 + k, 30).pair(which, 1));
    }
}

/// Any power of two of Sobol pairs puts one sample into each elementary interval: 1 x n, 2 x n/2, ... n x 1.
TEST(Samplers, SobolPairsAreNets) {
    const SamplePair pair = find_sampler("sobol")->pair;
    for (uint64_t domain = 0; domain < 20; ++domain)
        for (uint32_t n : {1u, 4u, 16u, 64u, 256u})
            for (uint32_t columns = 1; columns <= n; columns *= 2) {
                std::set<std::pair<uint32_t, uint32_t>> cells;
                for (uint32_t i = 0; i < n; ++i) {
                    const Vec2 p = pair(RandomKey(domain, 0, 0), i, n);
                    cells.insert({uint32_t(p.x * columns), uint32_t(p.y * (n / columns))});
                }
                ASSERT_EQ(cells.size(), n) << "domain " << domain << ", " << columns << " columns";
            }
}

TEST(Samplers, StratifiedVisitsEveryCellOnce) {
    const SamplePair pair = find_sampler("stratified")->pair;
    for (const auto& [n, columns, rows] : {std::tuple{16u, 4u, 4u}, {12u, 4u, 3u}, {7u, 7u, 1u}, {100u, 10u, 10u}}) {
        std::set<std::pair<uint32_t, uint32_t>> cells;
        for (uint32_t i = 0; i < n; ++i) {
            const Vec2 p = pair(RandomKey(5, 0, 9), i, n);
            cells.insert({uint32_t(p.x * columns), uint32_t(p.y * rows)});
        }
        EXPECT_EQ(cells.size(), n);
    }
}

/// The error of the mean of a smooth function falls faster with nets than with independent samples.
TEST(Samplers, LowDiscrepancyBeatsChance) {
    auto error = [](const char* name) {
        double sum = 0;
        for (uint64_t domain = 0; domain < 200; ++domain) {
            double mean = 0;
            for (uint32_t i = 0; i < 64; ++i) {
                const Vec2 p = find_sampler(name)->pair(RandomKey(domain, 1, 1), i, 64);
                mean += p.x * p.x * p.y / 64;
            }
            sum += std::pow(mean - 1 / 6.0, 2);
        }
        return std::sqrt(sum / 200);
    };
    EXPECT_LT(error("sobol"), error("random") / 5);
    EXPECT_LT(error("stratified"), error("random") / 3);
}

/// Numbers that a sample's light depends on together, as a render asks for them: the place in the pixel, on a light, on the lens.
/// `branch`: of the path, where the light is seen behind a mirror.
std::array<double, 6> joint(const char* sampler, uint64_t pixel, uint32_t index, uint32_t count, uint64_t branch = 0) {
    const SampleKey key(find_sampler(sampler)->pair, RandomKey(pixel, 0, 0), index, count);
    const Vec2 in_pixel = key.pair(Coordinates::pixel, 0), on_light = (branch ? key.child(branch) : key).pair_of_light(1, 0, 1), on_lens = key.pair(Coordinates::lens, 2);
    return {in_pixel.x, in_pixel.y, on_light.x, on_light.y, on_lens.x, on_lens.y};
}

/// Calls `each` with every way to cut `dimensions` axes into 2^k[i] parts, `cuts` = the sum of k.
void for_all_shapes(size_t dimensions, int cuts, const std::function<void(const std::vector<int>&)>& each, std::vector<int> begun = {}) {
    if (begun.size() + 1 == dimensions) {
        begun.push_back(cuts);
        return each(begun);
    }
    for (int k = 0; k <= cuts; ++k) {
        std::vector<int> next = begun;
        next.push_back(k);
        for_all_shapes(dimensions, cuts - k, each, next);
    }
}

/// 2^m points are a (t, m, s)-net: each box of volume 2^(t - m) has 2^t of them. Each pair of coordinates alone has t = 0, for any m; of all together bench/sample_orders.py tells it.
TEST(Samplers, SobolCoordinatesAreOneNet) {
    const std::vector<size_t> pixel{0, 1}, light{2, 3}, lens{4, 5}, with_light{0, 1, 2, 3}, with_lens{0, 1, 4, 5}, all{0, 1, 2, 3, 4, 5};
    struct Net {
        std::vector<size_t> coordinates;
        int t, m;
    };
    const std::vector<Net> nets = {{pixel, 0, 4}, {light, 0, 4}, {lens, 0, 4}, {pixel, 0, 9}, {light, 0, 9}, {lens, 0, 9}, {with_light, 1, 4}, {with_light, 1, 6}, {with_light, 2, 8},
                                                                         {with_light, 3, 11}, {with_lens, 1, 3}, {with_lens, 2, 6}, {with_lens, 3, 11}, {all, 1, 2}, {all, 3, 6}, {all, 4, 10}};
    for (const Net& net : nets) {
        const auto& coordinates = net.coordinates;
        const int t = net.t, m = net.m;
        for (const uint64_t branch : {0, 5})
            for (uint32_t count : {1u << m, 3u << m}) {   // the first of more are a net, too
                std::vector<std::array<double, 6>> points;
                for (uint32_t i = 0; i < (1u << m); ++i) points.push_back(joint("sobol", 3, i, count, branch));
                for_all_shapes(coordinates.size(), m - t, [&](const std::vector<int>& cuts) {
                    std::vector<int> inside(size_t(1) << (m - t));
                    for (const auto& p : points) {
                        size_t cell = 0;
                        for (size_t d = 0; d < coordinates.size(); ++d) cell = (cell << cuts[d]) | size_t(std::ldexp(p[coordinates[d]], cuts[d]));
                        ++inside[cell];
                    }
                    for (const int n : inside) ASSERT_EQ(n, 1 << t) << "2^" << m << " points of " << count << ", coordinates " << testing::PrintToString(coordinates) << ", cut " << testing::PrintToString(cuts);
                });
            }
    }
}

/// Light that goes with the distance of two places, as of near surfaces: samples spread over each place alone are no better than chance.
TEST(Samplers, PixelLightAndLensAreSpreadTogether) {
    const auto error = [](const char* sampler, size_t other) {
        constexpr uint32_t kCount = 1024;
        double sum = 0, squares = 0;
        for (uint64_t pixel = 0; pixel < 200; ++pixel) {
            double mean = 0;
            for (uint32_t i = 0; i < kCount; ++i) {
                const auto p = joint(sampler, pixel, i, kCount);
                mean += std::exp(-8 * (std::pow(p[0] - p[other], 2) + std::pow(p[1] - p[other + 1], 2))) / kCount;
            }
            sum += mean / 200, squares += mean * mean / 200;
        }
        return std::sqrt(squares - sum * sum);
    };
    EXPECT_LT(error("sobol", 2), error("random", 2) / 3) << "a light";
    EXPECT_LT(error("sobol", 4), error("random", 4) / 1.5) << "the lens";
}

PlacedLight area_light(AreaLight area, const Transform& t, double radiance) {
    Light light;
    light.kind = area;
    light.intensity = Color(radiance);
    return {light, t};
}

/// Mean irradiance on a surface at the origin with normal +y.
double irradiance(const PlacedLight& light) {
    double sum = 0;
    constexpr uint32_t kCount = 1 << 14;
    for (uint32_t i = 0; i < kCount; ++i) {
        const Illumination e = illuminate(light, Vec3(0), samplers()[0].pair(RandomKey(3, 1, 4), i, kCount));
        sum += e.irradiance.x * std::max(0.0, e.direction.y) / kCount;
    }
    return sum;
}

const Transform kDown = Transform::rotate({1, 0, 0}, -kPi / 2);   // -z to -y

TEST(AreaLights, DiscByClosedForm) {
    AreaLight disc;
    disc.form = AreaLight::Form::disc;
    disc.radius = 0.8;
    for (double d : {0.3, 1.0, 10.0})
        EXPECT_NEAR(irradiance(area_light(disc, Transform::translate({0, d, 0}) * kDown, 2)), 2 * kPi * 0.64 / (0.64 + d * d), 2e-3);
    EXPECT_EQ(irradiance(area_light(disc, Transform::translate({0, 1, 0}) * Transform::rotate({1, 0, 0}, kPi / 2), 2)), 0) << "dark behind";
}

/// Four times the form factor of a rectangle over its corner. Source   Howell, "A Catalog of Radiation Heat Transfer Configuration Factors", B-3.
TEST(AreaLights, RectangleByClosedForm) {
    AreaLight area;
    area.width = 1.6;
    area.height = 0.6;
    for (double d : {0.5, 2.0}) {
        const double a = 0.8 / d, b = 0.3 / d, ra = std::sqrt(1 + a * a), rb = std::sqrt(1 + b * b);
        const double factor = 4 / (2 * kPi) * (a / ra * std::atan(b / ra) + b / rb * std::atan(a / rb));
        EXPECT_NEAR(irradiance(area_light(area, Transform::translate({0, d, 0}) * kDown, 3)), 3 * kPi * factor, 3e-3);
        EXPECT_NEAR(irradiance(area_light(area, Transform::translate({0, d, 0}) * kDown * Transform::scale({2, 2, 1}), 3)) > 3 * kPi * factor, true, 0)
            << "a scaled light is larger";
    }
}

/// Small beside its distance, a sphere fills r^2 / d^2 of half a sphere: 1 less the cosine of its angle would have no digits.
TEST(AreaLights, ASphereFarAwayKeepsItsDigits) {
    AreaLight sphere;
    sphere.form = AreaLight::Form::sphere;
    for (const double distance : {1e3, 1e5, 1e7, 1e9}) {
        sphere.radius = 1;
        const double got = illuminate(area_light(sphere, Transform(), 1), Vec3(0, 0, -distance), {0.5, 0.5}).irradiance.x, ratio = 1 / distance;
        EXPECT_NEAR(got / (kPi * ratio * ratio), 1, ratio * ratio + 1e-12) << distance;
    }
}

TEST(AreaLights, SphereByClosedForm) {
    AreaLight sphere;
    sphere.form = AreaLight::Form::sphere;
    sphere.radius = 0.5;
    for (double d : {0.51, 1.0, 100.0, 1e6})
        EXPECT_NEAR(irradiance(area_light(sphere, Transform::translate({0, d, 0}), 4)) / (4 * kPi * 0.25 / (d * d)), 1, 2e-3) << d;
    const Illumination e = illuminate(area_light(sphere, Transform::translate({0, 2, 0}), 1), Vec3(0), {0, 0.3});
    EXPECT_NEAR(e.distance, 1.5, 1e-9) << "the near side";
}

/// A pixel as wide as the light above it: where in the pixel a sample is must not go with where on the light it is, or near pairs count too much. The
/// closed form is that of a point and a disc (Howell, B-13), by the midpoint rule over the pixel.
TEST(AreaLights, SamplesDoNotGoWithThePlaceInThePixel) {
    SceneBuilder b;
    b.object(Plane{}, b.material(b.lambert(Color(1))));
    AreaLight disc;
    disc.form = AreaLight::Form::disc;
    disc.radius = 1;
    b.light(disc, Color(1), Transform::translate({0, 1, 0}) * kDown);
    b.camera({0, 0.5, 0}, {0, 0, 0}, 40, {0, 0, 1});
    Camera& camera = b.scene.cameras[0];
    camera.projection = Projection::orthographic, camera.right = {2, 0, 0}, camera.up = {0, 0, 2};
    double mean = 0;
    constexpr int kSteps = 200;
    for (int i = 0; i < kSteps * kSteps; ++i) {
        const double x = 2 * (i % kSteps + 0.5) / kSteps - 1, z = 2 * (i / kSteps + 0.5) / kSteps - 1, square = x * x + z * z, sum = square + 2;
        mean += 0.5 * (1 - square / std::sqrt(sum * sum - 4 * square)) / (kSteps * kSteps);
    }
    for (const char* sampler : {"sobol", "stratified", "random"}) {
        RenderOptions o = centre_rays(1);
        o.spp = 1 << 14;
        o.sampler = sampler;
        EXPECT_NEAR(value(rendered(b.scene, o).picture, 0, 0, "R"), mean, 8e-3) << sampler;   // four standard deviations of the noise; without this it is 0.47 off
    }
}

/// A convex diffuse solid in a constant sky: every point sends back albedo times the sky, without noise.
TEST(Skies, FurnaceOfAConvexSolid) {
    SceneBuilder b;
    b.object(Sphere{}, b.material(b.lambert(Color(0.5, 0.25, 1))));
    b.scene.atmosphere.environment = Color(2);
    b.camera({0, 0, 4}, {0, 0, 0}, 20);
    const Film film = rendered(b.scene, centre_rays(8));
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) {
            EXPECT_NEAR(value(film.picture, x, y, "R"), 1, 1e-6);
            EXPECT_NEAR(value(film.picture, x, y, "G"), 0.5, 1e-6);
        }
}

/// Half the sky is hidden by a black wall that is infinitely high: half the light is left on the floor beside it.
TEST(Skies, AWallHidesHalfOfIt) {
    SceneBuilder b;
    b.object(Plane{{0, 1, 0}, 0}, b.material(b.lambert(Color(1))));
    b.object(Plane{{1, 0, 0}, 0}, b.material(b.lambert(Color(0))));
    b.scene.atmosphere.environment = Color(1);
    b.camera({1e-4, 1, 0}, {1e-4, 0, 0}, 1e-3, {0, 0, 1});
    RenderOptions o = centre_rays(1);
    o.spp = 4096;
    EXPECT_NEAR(value(rendered(b.scene, o).picture, 0, 0, "R"), 0.5, 2e-3);
}

Picture gradient_sky() {
    Picture p(16, 8, {"R", "G", "B"});
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 16; ++x)
            for (int c = 0; c < 3; ++c) p.at(x, y)[c] = float((x == 11 && y == 2 ? 50 : 0.2) + 0.1 * x + c);
    return p;
}

/// The sum over samples of radiance cos / density is the irradiance that a sum over pixels gives; densities integrate to 1.
TEST(Skies, ImageSamplesConvergeToTheSumOverPixels) {
    const Sky sky(gradient_sky(), 0.5);
    const Vec3 n = normalized(Vec3(0.3, 1, -0.2));
    Color want(0);
    constexpr int kFine = 40;
    for (int y = 0; y < 8 * kFine; ++y)
        for (int x = 0; x < 16 * kFine; ++x) {
            const double theta = kPi * (y + 0.5) / (8 * kFine), phi = 2 * kPi * ((x + 0.5) / (16 * kFine) - 0.5);
            const Vec3 d(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
            want += sky.radiance(d) * (std::max(0.0, dot(d, n)) * std::sin(theta) * (kPi / (8 * kFine)) * (2 * kPi / (16 * kFine)));
        }
    Color got(0);
    double inverse = 0;
    constexpr uint32_t kCount = 1 << 16;
    for (uint32_t i = 0; i < kCount; ++i) {
        const Sky::Sample s = sky.sample(n, samplers()[0].pair(RandomKey(2, 7, 1), i, kCount));
        ASSERT_GT(s.density, 0);
        EXPECT_EQ(s.radiance, sky.radiance(s.direction)) << i;
        got += s.radiance * (std::max(0.0, dot(s.direction, n)) / s.density / kCount);
        inverse += 1 / s.density / kCount;
    }
    EXPECT_NEAR(inverse, 4 * kPi, 0.02) << "the whole sphere is reached";
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(got[c] / want[c], 1, 0.01);
}

TEST(Lenses, RaysOfAPicturePointMeetInThePlaneOfFocus) {
    Camera c;
    c.right = {1.2, 0, 0};
    c.aperture = 0.5;
    c.focal_point = {0, 0, -7};
    const CameraRays rays(c, 120, 100);
    for (double x : {0.5, 60.0, 110.0}) {
        const Ray pinhole = rays.at(x, 20);
        const Vec3 meet = pinhole.at(-7 / pinhole.dir.z);
        double widest = 0;
        for (uint32_t i = 0; i < 64; ++i) {
            const Ray ray = rays.at(x, 20, samplers()[0].pair(RandomKey(1, 1, 1), i, 64));
            EXPECT_LT(length(ray.at((meet.z - ray.origin.z) / ray.dir.z) - meet), 1e-12);
            widest = std::max(widest, length(ray.origin));
        }
        EXPECT_LE(widest, 0.25);
        EXPECT_GT(widest, 0.23);
    }
}

/// A point of light out of focus becomes a disc of the size that similar triangles give.
TEST(Lenses, CircleOfConfusion) {
    SceneBuilder b;
    GltfPbr lamp = b.pbr(Color(0));
    lamp.emissive = b.constant(Vec4(1));
    b.object(Sphere{{0, 0, -10}, 1e-3}, b.material(lamp));
    b.camera({0, 0, 0}, {0, 0, -1}, 20);
    RenderOptions o = centre_rays(64);
    o.spp = int(std::max(run_size(4096), size_t(512)));
    o.aperture = 0.4;
    o.focus = 5;
    o.sampler = "sobol";
    o.threads = 2;
    const Film film = rendered(b.scene, o);
    const double blur = 0.4 * (10 - 5) / 10 / 5, pixel = 2 * std::tan(10 * kPi / 180) / 64;   // diameter seen from the eye, and a pixel
    double far = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            if (value(film.picture, x, y, "R") > 0) far = std::max(far, std::hypot(x - 31.5, y - 31.5));
    EXPECT_NEAR(far, blur / 2 / pixel, 1.5);
}

}  // namespace
}  // namespace alidade::test
