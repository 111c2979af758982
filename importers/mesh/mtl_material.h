// SPDX-License-Identifier: Apache-2.0
/// MTL materials as metal-rough surfaces.
#pragma once

#include "importers/mesh/mtl.h"
#include "scene/scene.h"

#include <map>

namespace alidade::mesh {

/// Adds materials to a scene. MTL describes Phong highlights, the scene's surfaces are physical ones; this is the mapping:
///
/// base colour   Kd x map_Kd; 1 without Kd if there is a map, else 0.8. Ka is not used: a ray tracer computes ambient light.
/// roughness     Pr x map_Pr; else from the exponent Ns: the microfacet width alpha = sqrt(2 / (Ns + 2)) has a highlight as wide as that of
///               Blinn and Phong (Walter et al., "Microfacet Models for Refraction", EGSR 2007, section 5.2), and roughness = sqrt(alpha). Else 1.
/// metallic      Pm x map_Pm, else 0. A mirror (illum 3 and above) whose Kd is black is a metal of the colour Ks.
/// specular      0 if illum is 0 or 1, or Ks is black. Mirrors that are no metals reflect Ks head-on. Else that of Ni (if over 1; else 1.5).
/// refraction    illum 6 and 7: 1 - d is transmitted (all if d is 1), tinted by Tf; the base colour is Tf then.
/// opacity       d < 1 otherwise is blended; so is the alpha of map_Kd if map_d names the same picture. A map_d of its own is left out.
/// emission      Ke x map_Ke.   clear coat   Pc, Pcr.
/// normals       norm, scaled by -bm; also map_Bump, if the picture looks like a normal map (bluish): height maps are left out.
///
/// All are double-sided, as OBJ has no front faces. Pictures that are missing or not allowed are left out with a warning.
class MaterialBuilder {
  public:
    MaterialBuilder(Scene& scene, Diagnostics& said) : scene_(scene), said_(said) {}

    /// `folder` is where the library stands: its pictures are looked for there.
    MaterialId add(const MtlMaterial& mtl, const std::string& folder);

  private:
    void set_base_color(GltfPbr& pbr, const MtlMaterial& mtl);
    void set_highlight(GltfPbr& pbr, const MtlMaterial& mtl);
    void set_normal(GltfPbr& pbr, const MtlMaterial& mtl);
    SignalId add(Signal signal);
    SignalId constant(const Vec4& value, const SourcePos& from);
    SignalId scalar(double value, const SourcePos& from) { return constant(Vec4(value), from); }
    /// factor x map, or whichever there is; nothing if neither.
    std::optional<SignalId> scaled(const std::optional<MtlMap>& map, const std::optional<Vec4>& factor, bool is_color, const SourcePos& from);
    SignalId image(const MtlMap& map, const std::string& path, bool is_color);
    /// Nothing, and a warning, if the picture may not be read or is not there.
    std::optional<std::string> picture_path(const MtlMap& map);
    bool is_normal_map(const MtlMap& map, const std::string& path);

    Scene& scene_;
    Diagnostics& said_;
    std::string folder_;
    std::map<std::string, ImageId> images_;   ///< by path
};

}  // namespace alidade::mesh
