// SPDX-License-Identifier: Apache-2.0
#include "eval/shapes/twice.h"
#include "tracer/normal_maps.h"
#include "tracer/pov_surface.h"
#include "tracer/segment.h"
#include "tracer/shade.h"

namespace alidade {
namespace {

/// Trowbridge-Reitz (GGX) times Smith's height-correlated visibility. Source   glTF 2.0, appendix B.3.2.
double microfacet(double alpha, double nh, double nl, double nv) {
    const double a2 = alpha * alpha, d = nh * nh * (a2 - 1) + 1;
    const double distribution = a2 / (kPi * d * d);
    const double visibility = 0.5 / (nl * std::sqrt(a2 + (1 - a2) * nv * nv) + nv * std::sqrt(a2 + (1 - a2) * nl * nl));
    return distribution * visibility;
}

}  // namespace

const GltfPbr* pbr(const CompiledScene& scene, const ShadePoint& p) {
    return std::get_if<GltfPbr>(&material_at(scene, p).layers[0]);
}

Surface shade_pov(const CompiledScene& scene, const ShadePoint& point, const Vec3& dir, const InteriorStack& inside) {
    Surface s;
    s.point_ = &point;
    s.wo_ = -dir;
    s.normal_ = dot(point.shading_normal, dir) > 0 ? -point.shading_normal : point.shading_normal;
    s.pov_.emplace(scene, point, dir, s.normal_, inside);
    s.mirrors_or_refracts_ = s.pov_->sends_on();
    s.normal_ = s.pov_->normal();
    s.emitted_ = s.pov_->emitted(scene.scene.settings.ambient_light);
    // A ray that passes a hole goes on as it is, so that layers tell what is seen through it; where there is glass or fog it must learn that it enters or leaves something.
    if (scene.all_air && s.pov_->is_hole()) s.coverage_ = 0, s.mirrors_or_refracts_ = false;
    return s;
}

double scalar(const CompiledScene& scene, const std::optional<SignalId>& signal, const ShadePoint& p, double absent) {
    return signal ? scene.textures->evaluate(*signal, p).x : absent;
}

double coverage(const GltfPbr& m, double alpha) {
    switch (m.alpha_mode) {
        case AlphaMode::mask: return alpha < m.alpha_cutoff ? 0 : 1;
        case AlphaMode::blend: return std::clamp(alpha, 0.0, 1.0);
        case AlphaMode::opaque: break;
    }
    return 1;
}

Vec3 bent_normal(const CompiledScene& scene, SignalId map, double scale, const ShadePoint& point) {
    ShadePoint p = point;
    tangent_frame(scene, tangent_uv_set(scene.scene, map), p);
    const Vec3 sampled = Vec3(scene.textures->evaluate(map, p)) * 2.0 - Vec3(1);
    return normalized(p.tangent * (sampled.x * scale) + p.bitangent * (sampled.y * scale) + p.shading_normal * sampled.z);
}

Coat coat_over(const CompiledScene& scene, const GltfPbr& m, const ShadePoint& point, const Vec3& wo) {
    constexpr double f0 = 0.04;   // ((1.5 - 1) / (1.5 + 1))^2
    Coat coat;
    coat.normal = m.clearcoat_normal ? bent_normal(scene, *m.clearcoat_normal, 1, point) : point.shading_normal;
    if (!point.front) coat.normal = -coat.normal;
    const double roughness = scalar(scene, m.clearcoat_roughness, point, 0), x = 1 - std::min(std::abs(dot(coat.normal, wo)), 1.0), x2 = x * x;
    coat.weight = std::clamp(scalar(scene, m.clearcoat, point, 0), 0.0, 1.0) * (f0 + (1 - f0) * (x2 * x2 * x));
    coat.alpha = roughness * roughness;
    coat.mirror = (1 - roughness) * (1 - roughness);
    return coat;
}

double reflected_bound(double f0, double f90, double alpha, double cosine) {
    const double x = std::clamp(1 - cosine, 0.0, 1.0), x2 = x * x, schlick = x2 * x2 * x;
    const double dimmed = alpha * alpha * (14 + 6.5 * alpha) / (alpha + 0.45 * cosine + 1e-300), facets = schlick / (1 + schlick * dimmed) + 0.003;
    return std::min(f0 + (f90 - f0) * facets, 1.0);
}

namespace {

/// The square of eta times the cosine beyond, of vectors whose squared lengths have the product `lengths`. Near the critical angle it is a small difference, whose root a rounding would move by half
/// of its digits.
double beyond_squared(const Twice& cos_i, const Twice& lengths, double eta) { return ((Twice::product(eta, eta) - Twice(1)) * lengths + cos_i * cos_i).value(); }

/// v / |v|, rounded once: by a step of Newton's from the rounded inverse root.
Vec3 unit(const TwiceVec& v) {
    const Twice square = dot(v, v);
    const double root = 1 / std::sqrt(square.high), rest = 0.5 * (Twice(1) - square * Twice::product(root, root)).value();
    Vec3 out(0);
    for (int k = 0; k < 3; ++k) {
        const Twice rough = v.v[k] * Twice(root);
        out[k] = (rough + Twice(rough.high * rest)).value();
    }
    return out;
}

}  // namespace

double fresnel_dielectric(double cos_i, double eta) {
    if (eta == 1) return 0;
    const double square = beyond_squared(cos_i, Twice(1), eta);
    if (!(square > 0)) return 1;
    const double beyond = std::sqrt(square), eta2_cos = eta * eta * cos_i;   // beyond: eta cos_t
    const double parallel = (eta2_cos - beyond) / (eta2_cos + beyond), perpendicular = (cos_i - beyond) / (cos_i + beyond);
    const double mirrored = (parallel * parallel + perpendicular * perpendicular) / 2;
    if (mirrored <= 0.5) return mirrored;
    // By what is let through, whose error is as small as it is.
    return 1 - 2 * beyond * (cos_i / ((cos_i + beyond) * (cos_i + beyond)) + eta2_cos / ((eta2_cos + beyond) * (eta2_cos + beyond)));
}

/// Unit vectors are so to the last digit but one, and 1 - cos^2 takes that for an angle: so lengths are measured.
bool refract(const Vec3& dir, const Vec3& n, double eta, Vec3& out) {
    if (eta == 1) return out = dir, true;
    const TwiceVec in(dir), normal(n);
    const Twice cos_i = -dot(in, normal), normal_length = dot(normal, normal);
    const double square = beyond_squared(cos_i, dot(in, in) * normal_length, eta);
    if (!(square > 0)) return false;
    const Twice along = (cos_i - Twice(std::sqrt(square))) * (Twice(2) - normal_length);   // 1 / x, close to 1
    const TwiceVec bent = in.moved(along, normal);   // eta times as long as it should be: into air from what is dense, very short
    out = unit(bent);
    return true;
}

/// Schlick's approximation, as the specification's appendix B.3.4 has it.
Color Surface::fresnel(double cos_angle) const {
    const double x = std::clamp(1 - cos_angle, 0.0, 1.0), x2 = x * x;
    return f0_ + (Color(f90_) - f0_) * (x2 * x2 * x);
}

Color Surface::diffuse() const {
    if (unlit_) return Color(0);
    return diffuse_ * (diffuse_share(most_diffuse_, std::max(max_component(fresnel(cosine_to_eye())) * mirror_, glass_)) * (1 - coat_.weight));
}

Vec3 Surface::facing_normal() const { return point_->front ? point_->geometric_normal : -point_->geometric_normal; }

Color Surface::scatter_base(const Vec3& wi) const {
    const double nl = dot(normal_, wi);
    if (nl <= 0) return Color(0);
    const double nv = std::max(dot(normal_, wo_), 1e-4);
    const Vec3 h = normalized(wi + wo_);
    const Color f = fresnel(dot(wo_, h));
    const Color diffuse = (Color(1) - f) * diffuse_ * (nl / kPi * share_of_lights_);
    if (alpha_ < kSmallestAlpha) return diffuse;
    return diffuse + f * (nl * microfacet(alpha_, std::max(dot(normal_, h), 0.0), nl, nv));
}

Color Surface::scatter(const Vec3& wi, bool highlights) const {
    if (pov_) return pov_->scatter(wi, highlights);
    if (unlit_ || dot(facing_normal(), wi) <= 0) return Color(0);   // a bent normal must not let light through from behind
    const Color base = scatter_base(wi) * (1 - coat_.weight);
    const double nl = dot(coat_.normal, wi);
    if (coat_.weight <= 0 || coat_.alpha < kSmallestAlpha || nl <= 0) return base;
    const double nv = std::max(dot(coat_.normal, wo_), 1e-4), nh = std::max(dot(coat_.normal, normalized(wi + wo_)), 0.0);
    return base + Color(coat_.weight * nl * microfacet(coat_.alpha, nh, nl, nv));
}

void Surface::secondary(const CompiledScene& scene, const RayState& state, Secondaries& out) const {
    if (pov_) return pov_->secondary(scene, *point_, state, dot(point_->shading_normal, wo_) < 0 ? -point_->shading_normal : point_->shading_normal, out);   // POV-Ray knows no other normal of a smooth triangle
    if (coverage_ <= 0 || unlit_) return;
    if (is_black(transmission_)) add_mirror(state, out);
    else add_transmission(scene, state, out);
    add_coat(state, out);
}

Vec3 Surface::mirrored(const Vec3& normal) const {
    const Vec3 facing = facing_normal(), direction = normal * (2 * dot(normal, wo_)) - wo_;
    // A bent normal can send the mirror ray below the surface: then the true normal mirrors it.
    return normalized(dot(direction, facing) > 0 ? direction : facing * (2 * dot(facing, wo_)) - wo_);
}

void Surface::add_mirror(const RayState& state, Secondaries& out) const {
    const Color weight = fresnel(std::max(dot(normal_, wo_), 0.0)) * (mirror_ * coverage_ * (1 - coat_.weight));
    if (!is_black(weight)) out.push_back({mirrored(normal_), weight, RayKind::reflection, state.inside});
}

void Surface::add_coat(const RayState& state, Secondaries& out) const {
    const Color weight(coat_.weight * coat_.mirror * coverage_);
    if (is_black(weight)) return;
    const Vec3 direction = mirrored(coat_.normal);
    if (!out.empty() && out[0].kind == RayKind::reflection && out[0].dir == direction) out[0].weight += weight;   // one ray for both
    else out.push_back({direction, weight, RayKind::reflection, state.inside});
}

/// Glass: what is not mirrored is refracted and coloured. The outside is whatever the ray was in before.
void Surface::add_transmission(const CompiledScene& scene, const RayState& state, Secondaries& out) const {
    InteriorStack beyond = state.inside;
    const uint32_t interior = slot_at(scene, *point_).interior, carrier = scene.instances[point_->instance].carrier;
    if (point_->front) beyond.enter({carrier, interior});
    else beyond.leave(carrier);
    // A camera inside the glass has no entry to leave: it is in this interior all the same.
    const double n1 = !point_->front && state.inside.empty() ? ior_ : ior_in(scene, state.inside), n2 = ior_in(scene, beyond);
    // A bent normal can face away from the eye: then the true one mirrors and refracts.
    const Vec3 facing = facing_normal(), normal = dot(normal_, wo_) > 0 ? normal_ : facing;
    const double eta = n2 / n1, cos_o = std::max(dot(normal, wo_), 0.0), reflectance = fresnel_dielectric(cos_o, eta), share = coverage_ * (1 - coat_.weight);
    Vec3 through;
    out.push_back({mirrored(normal), Color(reflectance * share), RayKind::reflection, state.inside});
    if (!refract(-wo_, normal, eta, through)) return;
    if (dot(through, facing) >= 0 && !refract(-wo_, facing, eta, through)) return;
    const Color passed = transmission_ * ((1 - reflectance) * share);
    out.push_back({through, passed, RayKind::refraction, beyond, -1, false, pov_grey(passed)});
}

Color transmitted(const CompiledScene& scene, const ShadePoint& point, const Vec3& dir) {
    const GltfPbr* metal_rough = pbr(scene, point);
    if (!metal_rough) {
        Color sum(0);
        for_each_mixed_slot(scene, point, [&](const ShadePoint& own, double share) {
            PatternFrame frame = pattern_frame(own);
            sum += pov_transmitted(scene, material_at(scene, own), own, frame, dir) * share;
        });
        return sum;
    }
    const GltfPbr& m = *metal_rough;
    const Vec4 base = base_color<kAllFeatures>(scene, m, point);
    const double there = coverage(m, base.w);
    if (m.unlit) return Color(1 - there);
    const double transmission = m.transmission ? scalar(scene, m.transmission, point, 0) * (1 - scalar(scene, m.metallic, point, 1)) : 0;
    return Color(1 - there) + Color(base) * (transmission * there);
}

}  // namespace alidade
