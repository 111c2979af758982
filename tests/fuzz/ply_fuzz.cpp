// SPDX-License-Identifier: Apache-2.0
/// libFuzzer target: any bytes as a PLY file.
#include "importers/mesh/ply.h"
#include "scene/queries.h"

#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    const auto result = alidade::mesh::import_mesh_bytes({reinterpret_cast<const std::byte*>(data), size}, "fuzz", {}, alidade::mesh::read_ply);
    if (result) alidade::validate(result->scene);
    return 0;
}
