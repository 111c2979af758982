// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <tl/expected.hpp>

namespace alidade::gltf {

/// How large a mesh a Draco bitstream claims to be.
struct DracoSizes {
    uint64_t faces = 0;
    uint64_t points = 0;   ///< of edgebreaker meshes: the vertices before they are split at seams
};

/// Reads the claim from the head of `data`, before Draco allocates on its word. An error is one sentence.
/// Source   "Draco 3D Data Compression: Bitstream Specification", version 2.2, sections "Draco Decoder", "Sequential Connectivity Decoder" and
///          "EdgeBreaker Decoder".
tl::expected<DracoSizes, std::string> draco_sizes(std::span<const unsigned char> data);

}  // namespace alidade::gltf
