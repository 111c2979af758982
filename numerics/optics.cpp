// SPDX-License-Identifier: Apache-2.0
/// Refraction and Fresnel's equations, to the last digits: at the critical angle, at grazing angles, for indices close to 1 and far from it.
#include "core/draws.h"
#include "numerics/exact.h"
#include "numerics/rows.h"
#include "numerics/scene_maker.h"
#include "tracer/shade.h"

#include <fmt/format.h>

#include <array>

namespace alidade::numerics {

namespace {

/// Of what lies behind a surface, over that in front.
double relative_index(Draws& draws) {
    static constexpr std::array kIndices{1.0, 1 + 1e-12, 1 + 1e-15, 1.0003, 1.33, 1.5, 2.4, 100.0, 1e6};
    const double n = draws.coin() ? kIndices[draws.below(kIndices.size())] : draws.uniform(1, 3);
    return draws.coin() ? n : 1 / n;
}

/// Anywhere from 0 to 1, near both, or at the critical angle, at most a few units away.
double cosine(Draws& draws, double eta) {
    switch (draws.below(5)) {
        case 0: return std::pow(10, draws.uniform(-300, 0));
        case 1: return draws.coin() ? 0 : std::ldexp(1.0, -int(draws.below(60)));
        case 2: return 1 - std::pow(10, draws.uniform(-16, 0));
        case 3:
            if (eta < 1) return std::clamp(std::sqrt((1 - eta) * (1 + eta)) + (int(draws.below(5)) - 2) * 0x1p-54, 0.0, 1.0);
            [[fallthrough]];
        default: return draws.uniform();
    }
}

/// The square of the cosine beyond, of the numbers as they are; negative where all is mirrored.
Exact square_beyond(const Exact& c, double eta) { return Exact((exact(eta) * exact(eta) - 1) + c * c) / (exact(eta) * exact(eta)); }

/// What is let through, as energy.
Exact through(double c, double eta) {
    const Exact square = square_beyond(exact(c), eta);
    if (eta == 1) return exact(1);
    if (square <= 0 || c == 0) return exact(0);
    const Exact beyond = sqrt(square), n = exact(eta), in = exact(c), s = 2 * in / (in + n * beyond), p = 2 * in / (n * in + beyond);
    return n * beyond / in * (s * s + p * p) / 2;
}

struct Path {
    Vec3 in, normal;
    double eta;
};

/// The angle of `cosine` from a normal that points anywhere.
Path path(Draws& draws) {
    Path p;
    p.eta = relative_index(draws), p.normal = draws.direction();
    const double c = cosine(draws, p.eta);
    Vec3 s, t;
    orthonormal_basis(p.normal, s, t);
    const double phi = draws.uniform(0, 2 * kPi);
    p.in = normalized((s * std::cos(phi) + t * std::sin(phi)) * std::sqrt((1 - c) * (1 + c)) - p.normal * c);
    return p;
}

std::string text(const Path& p) { return fmt::format("<{}, {}, {}> on <{}, {}, {}>, index {}", p.in.x, p.in.y, p.in.z, p.normal.x, p.normal.y, p.normal.z, p.eta); }

ExactVec exact_unit(const Vec3& v) { return ExactVec(v) * (1 / length(ExactVec(v))); }

/// Snell's law by vectors.
std::optional<ExactVec> exact_refraction(const Path& p) {
    const ExactVec d = exact_unit(p.in), n = exact_unit(p.normal);
    const Exact c = -dot(d, n), square = square_beyond(c, p.eta);
    if (square <= 0) return std::nullopt;
    const ExactVec out = d * (1 / exact(p.eta)) + n * (c / exact(p.eta) - sqrt(square));
    return out * (1 / length(out));
}

double off_by(const Vec3& got, const ExactVec& want) {
    const ExactVec off = ExactVec(got) - want;
    return std::max({to_double(abs(off.x)), to_double(abs(off.y)), to_double(abs(off.z))});
}

void one_face(Draws& draws, NumericsTally& tally) {
    const Path p = path(draws);
    const Exact cosine = -dot(exact_unit(p.in), exact_unit(p.normal)), square = square_beyond(cosine, p.eta);
    if (cosine < 0) return;   // one of 0, on the other side
    const auto want = exact_refraction(p);
    Vec3 out(0);
    const bool passes = refract(p.in, p.normal, p.eta, out);
    const bool undecided = abs(square) < 1e-30;
    tally.decide(undecided || passes == want.has_value(), [&] { return text(p) + (passes ? ": refracted" : ": mirrored"); });
    if (!passes || !want) return;
    tally.measure(off_by(out, *want) / ulp(0.75), 2, [&] { return text(p); });
    // And back, unless the rounding of what is between grows more than a thousandfold on the way: from grazing angles, or out of what is very dense.
    Vec3 back(0);
    const bool returns = refract(-out, -p.normal, 1 / p.eta, back);
    if (std::max(p.eta, 1 / p.eta) > 1e3 * std::min(-dot(p.in, p.normal), -dot(out, p.normal))) return;
    tally.decide(returns && length(back + p.in) <= 1e-12, [&] { return fmt::format("{}: comes back {} off", text(p), length(back + p.in)); });
}

/// Boxes in boxes, each of another index, in a scene: a ray that goes through all of them leaves as it came.
void nested(Draws& draws, NumericsTally& tally) {
    SceneMaker maker;
    const int depth = 1 + int(draws.below(64));
    for (int i = 0; i < depth; ++i) {
        GltfPbr glass;
        glass.base_color = maker.constant(Vec4(1)), glass.metallic = glass.roughness = maker.constant(Vec4(0)), glass.transmission = maker.constant(Vec4(1));
        Interior inside;
        inside.ior = glass.ior = draws.below(8) == 0 ? 1 + 1e-12 : draws.uniform(1, 3);
        maker.scene.interiors.push_back(inside);
        const double half = 65 - i;
        const uint32_t at = maker.object(Box{Vec3(-1e4, -half, -1e4), Vec3(1e4, half, 1e4)}, maker.material(glass));
        maker.scene.nodes[at].interior = InteriorId{uint32_t(i)};
    }
    CompileOptions options;
    options.threads = 1;
    Diagnostics said;
    const auto scene = compile(maker.scene, options, said);
    if (!scene) return tally.decide(false, [&] { return said.text(); });
    Ray ray;
    ray.dir = normalized(Vec3(draws.uniform(-1, 1), -draws.uniform(0.1, 1), draws.uniform(-1, 1))), ray.origin = ray.dir * 80.0 / ray.dir.y;
    const Vec3 first = ray.dir;
    RayState state;
    int faces = 0;
    WorkCounters work;
    for (Hit hit; hit = Hit(), scene->top->intersect(ray, hit, work); ++faces) {
        const ShadePoint point = shade_point(*scene, ray, hit);
        Secondaries rays;
        shade<kAllFeatures>(*scene, point, ray.dir).secondary(*scene, state, rays);
        if (rays.empty() || rays.back().kind != RayKind::refraction) break;
        ray = spawn_ray(point, rays.back().dir), state.inside = rays.back().inside;
    }
    tally.decide(faces == 2 * depth && state.inside.empty() && length(ray.dir - first) <= 1e-12,
                 [&] { return fmt::format("{} boxes, <{}, {}, {}>: {} faces, {} off", depth, first.x, first.y, first.z, faces, length(ray.dir - first)); });
}

}  // namespace

Check refraction() {
    return [](uint64_t number, NumericsTally& tally) {
        Draws draws(RandomKey(22, 0, number));
        if (number % 64 == 0) nested(draws, tally);
        else one_face(draws, tally);
    };
}

Check fresnel_energy() {
    return [](uint64_t number, NumericsTally& tally) {
        Draws draws(RandomKey(23, 0, number));
        const double eta = relative_index(draws), c = cosine(draws, eta), mirrored = fresnel_dielectric(c, eta);
        const auto what = [&] { return fmt::format("cosine {}, index {}: {} is mirrored", c, eta, mirrored); };
        tally.decide(mirrored >= 0 && mirrored <= 1, what);
        tally.measure(to_double(abs(exact(mirrored) + through(c, eta) - 1)) / ulp(1), 2, what);
    };
}

}  // namespace alidade::numerics
