// SPDX-License-Identifier: Apache-2.0
/// POV-Ray's surfaces: layers of pigment and finish at a point. The formulas are those of its reference, 3.4.3.3 "Finish", with what probing found
/// where that is silent; colours are calculated with as the scene gives them, before any gamma.
#pragma once

#include "core/short_list.h"
#include "tracer/secondary.h"
#include "tracer/textures.h"

namespace alidade {

/// A layer at a point, from the top.
struct PovLayer {
    const PovFinish* finish = nullptr;
    Color color{0};
    double opacity = 1;
    Color above{1};             ///< what all layers above let through
    Vec3 normal{0, 0, 1};       ///< unit, bent by the layer's own relief, on the side of the eye
};

/// One of the textures that are mixed at a point: all of a plain material, the parts of a texture map.
struct PovTexture {
    double share = 1;
    size_t begin = 0, end = 0;  ///< of its layers
    Color through{1};           ///< what all of them let through
};

/// What is the same at all points of a surface, and from all directions: of layers of one colour each, without reliefs.
struct PlainPovSurface {
    PovTexture texture;
    std::vector<PovLayer> layers;   ///< their normals are the points'
    Color emitted{0};
    bool sends_on = false, hole = false;
};

/// By slot: null where the surface is not plain.
using PlainPovSurfaces = std::vector<std::unique_ptr<const PlainPovSurface>>;
PlainPovSurfaces plain_surfaces(const CompiledScene& scene);

class PovSurface {
  public:
    /// The surface of a slot, if it is plain.
    static std::unique_ptr<const PlainPovSurface> plain(const CompiledScene& scene, const SlotMaterial& slot);
    /// `dir` is the unit direction of the ray, which is in `inside`, `normal` the shading normal on the side of the eye.
    PovSurface(const CompiledScene& scene, const ShadePoint& point, const Vec3& dir, const Vec3& normal, const InteriorStack& inside);

    Color emitted(const Color& ambient_light) const;
    /// Light from the unit direction `wi`, diffuse and in highlights.
    Color scatter(const Vec3& wi, bool highlights) const;
    /// Is it plain that no light comes from the direction `way`, of any length, to the eye: is that behind all layers, and does none let it through?
    bool faces_away(const Vec3& way) const;
    /// Can there be any mirror or transmitted ray?
    bool sends_on() const { return sends_on_; }
    /// The mirrors and the transmitted rays. `facing` is the geometric normal on the side of the eye.
    void secondary(const CompiledScene& scene, const ShadePoint& point, const RayState& state, const Vec3& facing, Secondaries& out) const;
    /// Of the layer on top of the first texture, if there is any.
    const Vec3& normal() const { return layers_.empty() ? normal_ : layers_.front().normal; }
    /// The colours of the layers as they cover each other, mixed as the textures are; of what covers nothing, such as glass, that of the layer on top.
    Color albedo() const;
    /// Does the surface neither reflect, nor emit, nor take anything from what is behind it? So are the holes of a texture that is cut out.
    bool is_hole() const;

  private:
    struct Passage;
    PovSurface() = default;
    /// All of it but for the normals; null where other slots than the point's count, too, or that is not plain.
    static const PlainPovSurface* plain_at(const CompiledScene& scene, const ShadePoint& point);
    void take(const PlainPovSurface& plain);
    void become_black();
    void add(const CompiledScene& scene, const ShadePoint& point, const Material& material, double share, PatternFrame& frame);
    void add_layers(const CompiledScene& scene, const ShadePoint& point, const Material& material, double share, const PatternFrame& frame);
    Color lit(const PovLayer& layer, const Vec3& wi, double nl, bool highlights) const;
    Color film(const PovFinish& finish, double nl, double nd) const;
    Color mirroring_film(const PovFinish& finish, double nr, double nd) const;
    Vec3 mirrored(const Vec3& normal, const Vec3& facing) const;
    Passage passage(const CompiledScene& scene, const ShadePoint& point, const RayState& state) const;
    void add_texture(const CompiledScene& scene, const PovTexture& texture, const Passage& passage, const RayState& state, const Vec3& facing, Secondaries& out) const;
    void add_reflections(const CompiledScene& scene, const PovTexture& texture, const RayState& state, const Vec3* totally, const Vec3& facing, Secondaries& out) const;
    void add_reflection(const CompiledScene& scene, const PovTexture& texture, size_t first, const RayState& state, const Vec3& facing, Secondaries& out) const;

    ShortList<PovTexture, 2> textures_;
    ShortList<PovLayer, 4> layers_;   ///< of all textures, from the top
    double grain(const Vec3& wi) const;

    Vec3 dir_{0}, normal_{0}, position_{0};
    const PlainPovSurface* plain_ = nullptr;   ///< what it is a copy of
    double mirror_ior_ = 1;     ///< the index of refraction behind the surface over that in front, as Fresnel's mirrors have it
    Color irid_wavelength_{1};
    NoiseGenerator noise_ = NoiseGenerator::range_corrected;
    bool double_illuminate_ = false, sends_on_ = false;
};

/// What the layers of a material let through at a point: what shadow rays in the unit direction `dir` multiply by. `frame`: Textures::for_each_share.
Color pov_transmitted(const CompiledScene& scene, const Material& material, const ShadePoint& point, PatternFrame& frame, const Vec3& dir);

/// The same where it is the same at all points and in all directions: of layers of one colour each, and no caustics. For a slot in which the ray's side does not matter, either.
std::optional<Color> uniform_filter(const CompiledScene& scene, const SlotMaterial& slot);

}  // namespace alidade
