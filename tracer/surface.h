// SPDX-License-Identifier: Apache-2.0
/// A hit, shaded: the only face of a material that an integrator sees.
#pragma once

#include "tracer/pov_surface.h"
#include "tracer/shade_point.h"

#include <optional>

namespace alidade {

/// KHR_materials_clearcoat at a point: a clear layer of index 1.5 that takes `weight` of the light, its factor times Schlick's Fresnel term at the eye's
/// angle, and leaves the rest to what is under it.
struct Coat {
    double weight = 0;
    double alpha = 1;    ///< roughness squared
    double mirror = 0;   ///< of the light that it takes, how much the mirror ray stands for
    Vec3 normal{0, 0, 1};
};

/// The share of a diffuse lobe of at most `most` that is left where `mirrored` of all light is sent back before: by the facets, by the mirror ray in their place where a sky lights, or by glass. (The
/// specification takes from it what the one facet mirrors that turns light to the eye: smooth plastic would send back up to twice what arrives where the eye grazes it.)
inline double diffuse_share(double most, double mirrored) {
    return most > 0 && most > 1 - mirrored ? std::max(1 - mirrored, 0.0) / most : 1;   // colours may be above 1
}

/// glTF 2.0 metal-rough at a point (specification, appendix B): a diffuse and a microfacet lobe; where roughness is low, a mirror ray; with transmission,
/// refraction by Snell's law; over all of it, a clear coat. Or POV-Ray's layers (pov_surface.h).
class Surface {
  public:
    /// Below this alpha (roughness squared) a surface is a perfect mirror: a light without extent has no image in it, and the mirror ray shows the rest.
    static constexpr double kSmallestAlpha = 1e-4;

    Surface() {}   // not by default: that would clear the room of all of POV-Ray's layers first

    Color emitted() const { return emitted_; }
    /// f(wi, wo) |cos| for light from the unit direction `wi`; both sides of the surface reflect.
    /// `highlights`: POV-Ray's shadowless lights have none.
    Color scatter(const Vec3& wi, bool highlights = true) const;
    /// Is it plain without a look at the light that scatter() is black for light from the direction `way`, of any length?
    bool faces_away(const Vec3& way) const { return pov_ && pov_->faces_away(way); }
    /// Reflectance of the diffuse lobe: all of it that a sky lights (the mirror ray sees the sky itself).
    Color diffuse() const;
    Color albedo() const { return pov_ ? pov_->albedo() : albedo_; }
    const Vec3& normal() const { return normal_; }
    /// That, turned to the eye where it looks away from it: at silhouettes of smooth meshes, and where a relief bends it.
    Vec3 normal_towards_eye() const { return dot(normal_, wo_) < 0 ? -normal_ : normal_; }
    /// The part of the surface that is there: 1 for opaque ones.
    double coverage() const { return coverage_; }
    /// Is there any direction to follow?
    bool mirrors_or_refracts() const { return mirrors_or_refracts_; }
    /// Appends the directions to follow. `state` is that of the ray that arrived.
    void secondary(const CompiledScene& scene, const RayState& state, Secondaries& out) const;

  private:
    template <unsigned F> friend Surface shade_metal_rough(const CompiledScene&, const GltfPbr&, const ShadePoint&, const Vec3&);
    friend Surface shade_pov(const CompiledScene&, const ShadePoint&, const Vec3&, const InteriorStack&);
    Color scatter_base(const Vec3& wi) const;
    void add_mirror(const RayState& state, Secondaries& out) const;
    void add_coat(const RayState& state, Secondaries& out) const;
    void add_transmission(const CompiledScene& scene, const RayState& state, Secondaries& out) const;
    Color fresnel(double cos_angle) const;
    double cosine_to_eye() const { return std::max(dot(normal_, wo_), 0.0); }
    /// The eye's direction, mirrored by `normal`.
    Vec3 mirrored(const Vec3& normal) const;
    /// The geometric normal on the side of the eye.
    Vec3 facing_normal() const;

    const ShadePoint* point_ = nullptr;
    Vec3 wo_{0, 0, 1};           ///< unit, towards the eye
    Vec3 normal_{0, 0, 1};       ///< shading normal, on the side of wo
    Color albedo_{0}, diffuse_{0}, f0_{0}, emitted_{0}, transmission_{0};
    double alpha_ = 1, mirror_ = 0, coverage_ = 1, ior_ = 1.5, f90_ = 1;
    double most_diffuse_ = 0, share_of_lights_ = 1, glass_ = 0;   ///< the largest of diffuse_ if nothing went through; of it; what glass mirrors
    Coat coat_;
    bool unlit_ = false, mirrors_or_refracts_ = false;
    std::optional<PovSurface> pov_;   ///< takes the place of all the rest but the normal
};

/// The surface at `point`, seen along the unit direction `dir` by a ray that is in `inside`; defined in tracer/shade.h, which callers include. `point` must outlive it.
template <unsigned F> Surface shade(const CompiledScene& scene, const ShadePoint& point, const Vec3& dir, const InteriorStack& inside = {});

/// The share of light that passes straight through the surface at `point`: what shadow rays in the unit direction `dir` multiply by. 0 for opaque surfaces.
Color transmitted(const CompiledScene& scene, const ShadePoint& point, const Vec3& dir);

/// Reflectance of a smooth dielectric for unpolarised light. `eta` = n(transmitted) / n(incident), `cos_i` >= 0. 1 at total internal reflection.
/// Source   Born and Wolf, "Principles of Optics", section 1.5.
double fresnel_dielectric(double cos_i, double eta);

/// The direction in which `dir` (unit, arriving) leaves through a surface with the unit normal `n` on its side; false at total internal reflection.
bool refract(const Vec3& dir, const Vec3& n, double eta, Vec3& out);

}  // namespace alidade
