// SPDX-License-Identifier: Apache-2.0
/// libFuzzer target: any bytes as a glTF file, GLB or JSON. No file is read.
#include "importers/gltf/gltf.h"
#include "scene/queries.h"

#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    const auto result = alidade::import_gltf_bytes({reinterpret_cast<const std::byte*>(data), size}, "fuzz", "", {});
    if (result) alidade::validate(result->scene);
    return 0;
}
