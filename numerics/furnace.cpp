// SPDX-License-Identifier: Apache-2.0
/// Surfaces under light from everywhere: what comes back, against the integral of what the surface is said to be.
#include "core/draws.h"
#include "numerics/rows.h"
#include "numerics/scene_maker.h"
#include "tracer/render.h"

#include <fmt/format.h>

#include <limits>
#include <variant>

namespace alidade::numerics {

namespace {

/// glTF 2.0, appendix B, with KHR_materials_ior, _specular, _transmission and _clearcoat.
struct MetalRough {
    Color albedo{1};
    double metallic = 0, roughness = 1, ior = 1.5, specular = 1, coat = 0, coat_roughness = 0, transmission = 0;
};

/// POV-Ray 3.7 reference, 3.4.3 "Finish".
struct Finish {
    Color albedo{1};
    double diffuse = 1, brilliance = 1, phong = 0, phong_size = 1, specular = 0, roughness = 1;
    double reflection_min = 0, reflection_max = 0, falloff = 1;
};

double power5(double x) { return x * x * x * x * x; }

/// Trowbridge and Reitz's facets, by slopes; times what both directions see of them, divided by 4 cos: for light from `l`, seen from `v`, halfway `h`, all from the normal.
double facets(double alpha, double l, double v, double h) {
    const auto tan2 = [](double c) { return (1 - c * c) / (c * c); };
    const auto hidden = [&](double c) { return (std::sqrt(1 + alpha * alpha * tan2(c)) - 1) / 2; };
    const double slopes = 1 + tan2(h) / (alpha * alpha);
    return 1 / (kPi * alpha * alpha * h * h * h * h * slopes * slopes) / (4 * v * (1 + hidden(l) + hidden(v)));
}

/// A smooth face between vacuum and glass, by the angles on both sides (Fresnel's own form).
double mirrored_by_glass(double cosine, double ior) {
    const double i = std::acos(cosine), t = std::asin(std::sin(i) / ior);
    if (i < 1e-6) return std::pow((ior - 1) / (ior + 1), 2);
    return (std::pow(std::sin(i - t) / std::sin(i + t), 2) + std::pow(std::tan(i - t) / std::tan(i + t), 2)) / 2;
}

/// A metal-rough surface, seen from an angle off its normal, which is z.
struct Glossy {
    MetalRough m;
    Vec3 v;
    Color f0;
    Color under_facets{0};
    double f90, alpha, coat;

    Glossy(const MetalRough& of, const Vec3& to_eye) : m(of), v(to_eye) {
        f0 = Color(std::pow((m.ior - 1) / (m.ior + 1), 2) * m.specular * (1 - m.metallic)) + m.albedo * m.metallic;
        f90 = m.specular * (1 - m.metallic) + m.metallic;
        alpha = m.roughness * m.roughness;
        coat = m.coat * (0.04 + 0.96 * power5(1 - v.z));
        under_facets = diffuse(from_facets());
    }
    Color schlick(double cosine) const { return f0 + (Color(f90) - f0) * power5(1 - cosine); }
    /// What diffuse light gets where `reflected` is sent back otherwise.
    Color diffuse(double reflected) const {
        if (m.transmission > 0) reflected = std::max(reflected, mirrored_by_glass(v.z, m.ior));
        const Color plain = m.albedo * (1 - m.metallic);
        return plain * (std::min(1.0, (1 - reflected) / std::max(max_component(plain), 1e-300)) * (1 - m.transmission));
    }
    /// The bound of what facets send back that tracer/shade.h documents.
    double from_facets() const {
        const double share = 1 / (1 / power5(1 - v.z) + (14 * alpha + 6.5 * alpha * alpha) / (1 + 0.45 * v.z / std::max(alpha, 1e-12))) + 0.003;
        return std::min(1.0, max_component(f0) + (f90 - max_component(f0)) * share);
    }

    /// Of the light from the unit direction `l`.
    Color scattered(const Vec3& l) const {
        if (l.z <= 0) return Color(0);
        const Vec3 h = normalized(v + l);
        const Color facet = schlick(dot(v, h));
        Color sum = (Color(1) - facet) * under_facets * (l.z / kPi);
        if (alpha > 0) sum += facet * facets(alpha, l.z, v.z, h.z);
        sum *= 1 - coat;
        if (m.coat_roughness > 0) sum += Color(coat * facets(m.coat_roughness * m.coat_roughness, l.z, v.z, h.z));
        return sum;
    }
    /// Of a sky of 1: one mirror ray for the lobe, the clearer the smoother, and all of the diffuse lobe.
    Color from_sky() const {
        const auto clear = [](double roughness) { return (1 - roughness) * (1 - roughness); };
        const Color over_coat(coat * clear(m.coat_roughness));
        const double mirrored = max_component(schlick(v.z)) * clear(m.roughness);
        if (m.transmission > 0) {
            const double r = mirrored_by_glass(v.z, m.ior);
            return (Color(r) + m.albedo * m.transmission * (1 - r) + diffuse(mirrored)) * (1 - coat) + over_coat;
        }
        return (diffuse(mirrored) + schlick(v.z) * clear(m.roughness)) * (1 - coat) + over_coat;
    }
};

Color scattered(const Finish& f, const Vec3& v, const Vec3& l) {
    if (l.z <= 0) return Color(0);
    Color sum = f.albedo * (f.diffuse * std::pow(l.z, f.brilliance));
    sum += Color(f.phong * std::pow(std::max(0.0, 2 * v.z * l.z - dot(v, l)), f.phong_size));   // the eye's direction mirrored: 2 (v.n) n - v
    sum += Color(f.specular * std::pow(normalized(v + l).z, 1 / f.roughness));
    return sum / kPi;   // a light of 1 is one of pi to POV-Ray: a diffuse of 1 sends all of it back
}

/// All but a hemisphere: from there on, the light would touch the face.
constexpr double kWidest = 1.57;

/// A cap of the sky: directions within an angle of an axis.
struct Cap {
    Vec3 axis{0, 0, 1};
    double angle = kWidest;

};

/// A circle of directions around an axis, and how far it is above the face on both sides of its highest point.
struct Ring {
    Vec3 middle, up, side;
    double above;   ///< radians, at most pi

    /// So far from the axis, in radians.
    Ring(const Cap& cap, double angle) {
        const double z = std::cos(angle), r = std::sin(angle), lean = std::hypot(cap.axis.x, cap.axis.y);
        const Vec3 s = lean > 1e-9 ? normalized(Vec3(0, 0, 1) - cap.axis * cap.axis.z) : Vec3(1, 0, 0);
        middle = cap.axis * z, up = s * r, side = cross(cap.axis, s) * r;
        above = std::acos(std::clamp(-middle.z / std::max(up.z, 1e-300), -1.0, 1.0));
    }
    Vec3 at(double phi) const { return middle + up * std::cos(phi) + side * std::sin(phi); }
};

/// Of what is 0 below the face, by the midpoint rule. Rings are evenly spaced, as lobes may be narrow, and end at the horizon, where there is a bend.
template <class F> Color integral(const Cap& cap, int steps, const F& f) {
    Color sum(0);
    for (int i = 0; i < steps; ++i) {
        const double angle = cap.angle * (i + 0.5) / steps;
        const Ring ring(cap, angle);
        Color part(0);
        for (int j = 0; j < steps; ++j) part += f(ring.at(ring.above * ((2 * j + 1.0) / steps - 1)));
        sum += part * (ring.above * std::sin(angle));
    }
    return sum * (2 * cap.angle / (double(steps) * steps));
}

/// A face of one surface, and what is known of it.
struct FurnaceCase {
    std::variant<MetalRough, Finish> stuff;
    Vec3 to_eye{0, 0, 1};
    Cap cap;
    Color expected(int steps) const {
        if (const auto* m = std::get_if<MetalRough>(&stuff)) {
            const Glossy glossy(*m, to_eye);
            return integral(cap, steps, [&](const Vec3& l) { return glossy.scattered(l); });
        }
        return integral(cap, steps, [&](const Vec3& l) { return scattered(std::get<Finish>(stuff), to_eye, l); });
    }
    Color expected_of_sky() const {
        if (const auto* m = std::get_if<MetalRough>(&stuff)) return Glossy(*m, to_eye).from_sky();
        const Finish& f = std::get<Finish>(stuff);
        return Color(f.reflection_min + (f.reflection_max - f.reflection_min) * std::pow(1 - to_eye.z, f.falloff));
    }
    /// The most that may come back of lights. POV-Ray adds its highlights to all the rest, whatever there is.
    double most() const {
        const Finish* f = std::get_if<Finish>(&stuff);
        return f && (f->phong > 0 || f->specular > 0) ? kInf : 1;
    }
    std::string text() const {
        const std::string seen = fmt::format("seen {:.4g} off the normal, light from within {:.4g} of <{:.4g}, {:.4g}, {:.4g}>", std::acos(to_eye.z), cap.angle, cap.axis.x, cap.axis.y, cap.axis.z);
        if (const auto* m = std::get_if<MetalRough>(&stuff))
            return fmt::format("metal-rough {:.4g}: metallic {:.4g}, roughness {:.4g}, ior {:.4g}, specular {:.4g}, coat {:.4g} of roughness {:.4g}, transmission {:.4g}; {}", m->albedo.x, m->metallic, m->roughness, m->ior,
                               m->specular, m->coat, m->coat_roughness, m->transmission, seen);
        const Finish& f = std::get<Finish>(stuff);
        return fmt::format("finish {:.4g}: diffuse {:.4g}, brilliance {:.4g}, phong {:.4g} {:.4g}, specular {:.4g} {:.4g}, reflection {:.4g} to {:.4g}; {}", f.albedo.x, f.diffuse, f.brilliance, f.phong, f.phong_size, f.specular,
                           f.roughness, f.reflection_min, f.reflection_max, seen);
    }
};

/// Of 0, 1 and what is between.
double extreme(Draws& draws) { return std::clamp(draws.uniform(-0.5, 1.5), 0.0, 1.0); }
/// Lobes that are narrower are images of the light: a mirror, of which lights have none.
double roughness(Draws& draws) { return draws.below(4) == 0 ? 0 : draws.uniform(0.15, 1); }

MetalRough metal_rough(Draws& draws) {
    MetalRough m;
    m.albedo = Color(extreme(draws), 1, 0);
    m.metallic = extreme(draws), m.roughness = roughness(draws), m.ior = draws.coin() ? 1.5 : draws.uniform(1, 3), m.specular = draws.coin() ? 1 : draws.uniform();
    if (draws.coin()) m.coat = extreme(draws), m.coat_roughness = roughness(draws);
    if (draws.below(3) == 0) m.transmission = draws.uniform(), m.metallic = 0, m.specular = 1;
    return m;
}

Finish finish(Draws& draws) {
    Finish f;
    f.albedo = Color(extreme(draws), 1, 0);
    f.diffuse = extreme(draws), f.brilliance = draws.coin() ? 1 : draws.uniform(1, 5);
    f.reflection_max = (1 - f.diffuse) * draws.uniform(), f.reflection_min = f.reflection_max * draws.uniform(), f.falloff = draws.uniform(0.5, 6);
    if (draws.coin()) f.phong = draws.uniform(), f.phong_size = std::pow(10, draws.uniform(0, 1.5));
    if (draws.coin()) f.specular = draws.uniform(), f.roughness = std::pow(10, draws.uniform(-1.5, 0));
    return f;
}

FurnaceCase furnace_case(uint64_t number) {
    Draws draws(RandomKey(24, 0, number));
    FurnaceCase c;
    const double cosine = draws.coin() ? draws.uniform(0.02, 1) : std::cos(draws.uniform(0, 0.5));
    c.to_eye = Vec3(std::sqrt(1 - cosine * cosine), 0, cosine);
    if (number % 3 == 0) {
        c.stuff = finish(draws);
        return c;
    }
    const MetalRough m = metal_rough(draws);
    const double lobe = std::min(m.roughness > 0 ? m.roughness : 1, m.coat > 0 && m.coat_roughness > 0 ? m.coat_roughness : 1);
    if (lobe < 0.6) c.cap = {Vec3(-c.to_eye.x, 0, cosine), std::min(kWidest, 10 * lobe * lobe)};   // of a narrow lobe only what is about the mirrored direction can be sampled well
    c.stuff = m;
    return c;
}

MaterialId add(SceneMaker& scene, const MetalRough& m) {
    GltfPbr pbr;
    const auto number = [&](double x) { return scene.constant(Vec4(x)); };
    pbr.base_color = scene.constant(Vec4(m.albedo, 1)), pbr.metallic = number(m.metallic), pbr.roughness = number(m.roughness);
    pbr.ior = m.ior, pbr.specular = number(m.specular);
    if (m.coat > 0) pbr.clearcoat = number(m.coat), pbr.clearcoat_roughness = number(m.coat_roughness);
    if (m.transmission > 0) pbr.transmission = number(m.transmission);
    return scene.material(pbr);
}

MaterialId add(SceneMaker& scene, const Finish& f) {
    PovFinish pov;
    pov.pigment = scene.constant(Vec4(f.albedo, 1)), pov.ambient = Color(0);
    pov.diffuse = f.diffuse, pov.brilliance = f.brilliance, pov.phong = f.phong, pov.phong_size = f.phong_size, pov.specular = f.specular, pov.roughness = f.roughness;
    pov.reflection_min = Color(f.reflection_min), pov.reflection_max = Color(f.reflection_max), pov.reflection_falloff = f.falloff;
    return scene.material(pov);
}

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr int kSide = 8;   // pixels, of which each is an estimate of its own: they see one face from one direction

/// The face, lit from the cap, or by the whole sky. A sphere as large as it is far away is a cap of any angle.
Scene lit(const FurnaceCase& c, bool sky) {
    SceneMaker maker;
    Mesh face;
    face.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, face.triangles = {{0, 1, 2}, {0, 2, 3}};
    const MaterialId material = std::visit([&](const auto& stuff) { return add(maker, stuff); }, c.stuff);
    maker.object(face, material);
    maker.camera(c.to_eye, -c.to_eye, 1e-4);
    maker.scene.settings.adc_bailout = 0;
    const bool pov = std::holds_alternative<Finish>(c.stuff);
    if (sky && pov) maker.scene.atmosphere.background = Color(1);
    if (sky && !pov) maker.scene.atmosphere.environment = Color(1);
    Light light;
    constexpr double kFar = 1e6;
    light.kind = AreaLight{AreaLight::Form::sphere, 1, 1, kFar * std::sin(c.cap.angle)};
    light.intensity = Color(sky ? 0 : pov ? 1 / kPi : 1);
    maker.light(light, Transform::translate(c.cap.axis * kFar));
    return std::move(maker.scene);
}

/// The mean over pixels, and its standard error.
struct Estimate {
    Color mean{0}, error{0};
};

Estimate estimate(const Picture& picture) {
    Estimate e;
    Color square(0);
    const int count = picture.width * picture.height;
    for (int i = 0; i < count; ++i) {
        const float* p = picture.at(i % picture.width, i / picture.width);
        const Color c(p[0], p[1], p[2]);
        e.mean += c / double(count), square += c * c / double(count);
    }
    e.error = glm::sqrt(glm::max(square - e.mean * e.mean, Color(0)) / double(count - 1));
    return e;
}

Estimate measured(const Scene& scene, int samples, uint64_t seed) {
    Diagnostics said;
    CompileOptions options;
    options.precision = Precision::double_, options.threads = 1;
    const auto compiled = compile(scene, options, said);
    RenderOptions render_options;
    render_options.width = render_options.height = kSide, render_options.spp = 1, render_options.light_samples = samples, render_options.seed = seed, render_options.threads = 1;
    const auto film = compiled ? render(*compiled, render_options) : tl::unexpected(said.text());
    return film ? estimate(film->picture) : Estimate{Color(kUnknown), Color(kUnknown)};
}

constexpr double kRounding = 2e-6;        // of float pictures, and of light from 1e6 away
constexpr uint64_t kQuickCases = 60;     // until then, a standard error of 2e-3 is enough; after that, 1e-4

/// What should come back, and how far that may be from the integral.
struct Albedo {
    Color value{0};
    double error = 0;
};

Albedo albedo(const FurnaceCase& c, double enough) {
    Albedo known{c.expected(50), kInf};
    for (int steps = 100; known.error > enough / 4 && steps <= 3200; steps *= 2) {
        const Color finer = c.expected(steps);
        known = {finer, length(finer - known.value) / 2};   // the error falls fourfold: this is more than a third
    }
    return known;
}

/// As many samples as it takes. What is beyond 3.5 standard errors by chance is so once in 2000 times: it must be so again, with 16 times the samples.
double deviation(const FurnaceCase& c, uint64_t number, const Albedo& want, double enough, double& brightest, double& error) {
    const Scene scene = lit(c, false);
    Estimate e;
    double worst = kInf;
    int samples = 64;
    for (int again = 0; again < 2 && !(worst <= 3.5); ++again, samples = std::min(16 * samples, 1 << 22)) {
        while (e = measured(scene, samples, number + (uint64_t(again) << 32)), max_component(e.error) > enough && samples < 1 << 22) samples *= 4;
        worst = 0;
        for (int k = 0; k < 3; ++k) {
            const double off = std::abs(e.mean[k] - want.value[k]) / (e.error[k] + want.error + kRounding);
            worst = off <= worst ? worst : off;
        }
    }
    brightest = max_component(e.mean - 3.5 * e.error), error = max_component(e.error);
    return max_component(e.error) <= enough && want.error <= enough / 4 ? worst : kUnknown;   // unknown is wrong
}

}  // namespace

Check white_furnace() {
    return [](uint64_t number, NumericsTally& tally) {
        const FurnaceCase c = furnace_case(number);
        const double enough = number < kQuickCases ? 2e-3 : 1e-4;
        const Albedo want = albedo(c, enough);
        double brightest = 0, error = 0;
        const double off = deviation(c, number, want, enough, brightest, error);
        tally.measure(off, 3.5, [&] { return fmt::format("{}: not {:.6g}, {:.6g}, {:.6g}, which is known to {:.2g}; a standard error of {:.2g}", c.text(), want.value.x, want.value.y, want.value.z, want.error, error); });
        const Color sky = measured(lit(c, true), 1, number).mean, sky_want = c.expected_of_sky();
        const double sky_off = length(sky - sky_want);
        tally.decide(sky_off <= 1e-5, [&] { return fmt::format("{}, in a sky of 1: {:.6g}, {:.6g}, {:.6g}, not {:.6g}, {:.6g}, {:.6g}", c.text(), sky.x, sky.y, sky.z, sky_want.x, sky_want.y, sky_want.z); });
        tally.decide(brightest <= c.most() + kRounding && max_component(sky) <= 1 + kRounding, [&] { return fmt::format("{}: {:.6g} of the light comes back, {:.6g} of the sky", c.text(), brightest, max_component(sky)); });
    };
}

}  // namespace alidade::numerics
