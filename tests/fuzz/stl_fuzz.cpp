// SPDX-License-Identifier: Apache-2.0
/// libFuzzer target: any bytes as a STL file.
#include "importers/mesh/stl.h"
#include "scene/queries.h"

#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    const auto result = alidade::mesh::import_mesh_bytes({reinterpret_cast<const std::byte*>(data), size}, "fuzz", {}, alidade::mesh::read_stl);
    if (result) alidade::validate(result->scene);
    return 0;
}
