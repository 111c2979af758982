// SPDX-License-Identifier: Apache-2.0
/// MTL files, the material libraries of OBJ, as plain data.
#pragma once

#include "core/diagnostics.h"
#include "core/vec.h"

#include <optional>
#include <string_view>
#include <vector>

namespace alidade::mesh {

/// A picture with its options.
struct MtlMap {
    std::string file;       ///< as the file writes it
    Vec3 scale{1}, offset{0};   ///< -s, -o: of (u, v), v growing upwards
    double bump = 1;        ///< -bm
    bool clamp = false;     ///< -clamp on
    char channel = 0;       ///< -imfchan: r, g, b, m (alpha), l (luminance), z; 0: not given
    SourcePos from;
};

/// A material: what the file says, and nothing where it says nothing.
struct MtlMaterial {
    std::string name;
    SourcePos from;
    std::optional<Vec3> diffuse, specular, emission, transmission_filter;        ///< Kd, Ks, Ke, Tf
    std::optional<double> exponent, opacity, ior;                                ///< Ns, d (or 1 - Tr), Ni
    std::optional<double> roughness, metallic, clearcoat, clearcoat_roughness;   ///< Pr, Pm, Pc, Pcr
    std::optional<int> illumination;                                             ///< illum
    std::optional<MtlMap> diffuse_map, emission_map, opacity_map, roughness_map, metallic_map, normal_map, bump_map;
};

/// Reads all materials of `text`. What is unknown, or has no counterpart in the scene, is left out with a warning; malformed numbers are errors
/// of `said`.
/// Source   Wavefront, "Material Library File (.mtl)"; the P... statements and norm: "Extending the Wavefront MTL format for PBR", exocortex.
std::vector<MtlMaterial> read_mtl(std::string_view text, uint32_t file, bool strict, Diagnostics& said);

}  // namespace alidade::mesh
