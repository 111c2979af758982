// SPDX-License-Identifier: Apache-2.0
/// Materials -> declared textures.
#pragma once

#include "exporters/pov/metal_rough.h"
#include "exporters/pov/patterns.h"

namespace alidade::pov_export {

class TextureWriter {
  public:
    TextureWriter(const Scene& scene, Sdl& sdl, ImageWriter& images, Losses& losses)
        : scene_(scene), sdl_(sdl), images_(images), losses_(losses), patterns_(scene, sdl, images, losses) {}

    /// Declares the materials that are marked, and all that they are made of. `pigments`: signals that others need as well.
    void declare(std::vector<bool> used, const std::vector<SignalId>& pigments);
    /// The texture of what no node gives a material.
    void declare_default();
    /// What lights all surfaces from all sides.
    void set_sky(const Color& radiance) { sky_ = radiance; }
    /// `texture { }` of a metal-rough material with a constant base colour, multiplied by `tint`.
    void tinted(MaterialId material, const Vec4& tint);
    /// `texture { }`; of nothing: the default.
    void use(std::optional<MaterialId> material);
    /// What a solid of this material is filled with: `inside`, and the refraction that the material itself asks for. Nothing where that is nothing.
    void interior(std::optional<MaterialId> material, std::optional<InteriorId> inside);
    /// `media { }`.
    void medium(const Interior::Medium& m);
    PatternWriter& patterns() { return patterns_; }

  private:
    void declare_one(MaterialId id);
    void turn(MaterialId id);
    void layer(const PovFinish& f);
    void layer(const PovTextureMap& m);
    void material_map(const PovTextureMap& m, const PatternSignal& pattern);
    void layer(const GltfPbr&) {}

    const Scene& scene_;
    Sdl& sdl_;
    ImageWriter& images_;
    Losses& losses_;
    HighlightFits highlights_;
    TextureOutput output_{sdl_, images_, losses_, highlights_};
    PatternWriter patterns_;
    Color sky_{0};
};

/// POV-Ray's finish, all that differs from its defaults.
void write_finish(Sdl& sdl, const PovFinish& f);

/// `#version`: that whose rules of transparency the scene has.
const char* version_line(const Scene& scene);

}  // namespace alidade::pov_export
