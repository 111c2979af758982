// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "exporters/output_files.h"
#include "exporters/surfaces.h"

namespace alidade {

/// A material library of OBJ in the making. Metal-rough surfaces become the statements that MTL has for them: Kd and map_Kd (base colour), Pr, Pm and
/// their maps (-imfchan names the channel), Ke, d, Ni, Pc, Pcr, norm; Ns is that roughness as Phong's exponent, for who reads no Pr. Glass is illum 6
/// with Tf, a tinted reflection illum 3 with Ks, none illum 1. Pictures are copied beside, byte by byte.
/// Source   as importers/mesh/mtl.h.
class MtlLibrary {
  public:
    MtlLibrary(const Scene& scene, OutputFiles& files, Losses& losses) : scene_(scene), files_(files), losses_(losses) {}

    /// The name of a material; without one, of glTF's default.
    const std::string& name(const std::optional<MaterialId>& id);
    const std::string& text() const { return text_; }

  private:
    void add(const PlainSurface& surface);
    void add_base_color(const PlainSurface& surface);
    void add_reflection(const PlainSurface& surface);
    void add_losses(const PlainSurface& surface);
    void add_map(const char* statement, const std::optional<Texel>& texel, const std::string& options = {});
    std::string picture(ImageId id);

    const Scene& scene_;
    OutputFiles& files_;
    Losses& losses_;
    UniqueNames names_;
    std::map<std::optional<MaterialId>, std::string> known_;
    std::map<ImageId, std::string> pictures_;   ///< "" if it cannot be read
    std::string text_;
};

}  // namespace alidade
