// SPDX-License-Identifier: Apache-2.0
/// From a hit to a Surface: the material's signals are evaluated, those alone that the feature mask F says the scene has.
#pragma once

#include "tracer/surface.h"
#include "tracer/textures.h"

namespace alidade {

/// The metal-rough material of the slot that `p` lies in, or null for one of POV-Ray's.
const GltfPbr* pbr(const CompiledScene& scene, const ShadePoint& p);

/// The surface of one of POV-Ray's materials.
Surface shade_pov(const CompiledScene& scene, const ShadePoint& point, const Vec3& dir, const InteriorStack& inside);

/// The first channel of a signal, or `absent`.
double scalar(const CompiledScene& scene, const std::optional<SignalId>& signal, const ShadePoint& p, double absent);

/// The part of the surface that is there (specification 3.9.4).
double coverage(const GltfPbr& m, double alpha);

/// The shading normal, bent by a normal map whose first two components count `scale` times.
Vec3 bent_normal(const CompiledScene& scene, SignalId map, double scale, const ShadePoint& point);

/// The clear coat over a material that has one, seen from the unit direction `wo`. Its normal is not bent by the material's map, but by its own.
/// Source   KHR_materials_clearcoat, "Implementation" (fresnel_coat with index 1.5).
Coat coat_over(const CompiledScene& scene, const GltfPbr& m, const ShadePoint& point, const Vec3& wo);

template <unsigned F> Vec4 base_color(const CompiledScene& scene, const GltfPbr& m, const ShadePoint& p) {
    const Vec4 base = scene.textures->evaluate(m.base_color, p);
    if ((F & kTextures) != 0 && p.has_vertex_color()) return base * p.vertex_color();
    return base;
}

/// Not less than what the facets send back of light from everywhere to an eye at `cosine` from the normal: Schlick's term over them, by a fit that tests/tracer/facets_test.cpp holds against quadrature.
double reflected_bound(double f0, double f90, double alpha, double cosine);

/// Inline, so that a kernel leaves out what it does not ask of the surface.
template <unsigned F> [[gnu::always_inline]] inline Surface shade_metal_rough(const CompiledScene& scene, const GltfPbr& m, const ShadePoint& point, const Vec3& dir) {
    Surface s;
    s.point_ = &point;
    s.wo_ = -dir;
    const double side = point.front ? 1 : -1;
    s.normal_ = ((F & kTextures) != 0 && m.normal ? bent_normal(scene, *m.normal, m.normal_scale, point) : point.shading_normal) * side;
    const Vec4 base = base_color<F>(scene, m, point);
    const double metallic = scalar(scene, m.metallic, point, 1), roughness = scalar(scene, m.roughness, point, 1);
    s.albedo_ = Color(base);
    if ((F & kAlpha) != 0 && m.alpha_mode != AlphaMode::opaque) s.coverage_ = coverage(m, base.w);
    s.unlit_ = m.unlit;
    if (m.emissive) s.emitted_ = Color(scene.textures->evaluate(*m.emissive, point)) * m.emissive_strength;
    if (m.unlit) {
        s.emitted_ = s.albedo_;
        return s;
    }
    const double transmission = (F & kTransmission) != 0 && m.transmission ? scalar(scene, m.transmission, point, 0) * (1 - metallic) : 0;
    // KHR_materials_specular: strength and colour of the dielectric's reflection.
    const double specular = scalar(scene, m.specular, point, 1);
    const Color tint = m.specular_color ? Color(scene.textures->evaluate(*m.specular_color, point)) : Color(1);
    const Color dielectric_f0 = glm::min(tint * std::pow((m.ior - 1) / (m.ior + 1), 2), Color(1)) * specular;
    s.f0_ = dielectric_f0 * (1 - metallic) + s.albedo_ * metallic;
    s.f90_ = specular * (1 - metallic) + metallic;
    s.alpha_ = roughness * roughness;
    s.mirror_ = (1 - roughness) * (1 - roughness);
    s.ior_ = m.ior;
    s.mirrors_or_refracts_ = s.mirror_ > 0;
    if (metallic < 1) {
        const double cosine = s.cosine_to_eye();
        s.diffuse_ = s.albedo_ * ((1 - metallic) * (1 - transmission));
        s.most_diffuse_ = max_component(s.albedo_) * (1 - metallic);
        if (transmission > 0) {
            s.glass_ = fresnel_dielectric(cosine, point.front ? m.ior : 1 / m.ior);
            s.transmission_ = s.albedo_ * transmission;
            s.mirrors_or_refracts_ = true;
        }
        s.share_of_lights_ = diffuse_share(s.most_diffuse_, std::max(reflected_bound(max_component(s.f0_), s.f90_, s.alpha_, cosine), s.glass_));
    }
    if constexpr ((F & kMirrors) != 0) {
        if (m.clearcoat && (point.front || transmission <= 0)) {   // glass has its coat on the outside
            s.coat_ = coat_over(scene, m, point, s.wo_);
            s.emitted_ *= 1 - s.coat_.weight;
            if (s.coat_.weight > 0) s.mirrors_or_refracts_ = true;
        }
    }
    return s;
}

template <unsigned F> Surface shade(const CompiledScene& scene, const ShadePoint& point, const Vec3& dir, const InteriorStack& inside) {
    const GltfPbr* m = pbr(scene, point);
    return m ? shade_metal_rough<F>(scene, *m, point, dir) : shade_pov(scene, point, dir, inside);
}

}  // namespace alidade
