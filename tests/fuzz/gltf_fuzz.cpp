// SPDX-License-Identifier: Apache-2.0
/// libFuzzer target: any bytes as a glTF file, GLB or JSON. No file is read.
#include "importers/gltf/gltf.h"
#include "scene/queries.h"

#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    for (const bool shown_only : {false, true}) {
        alidade::ImportOptions options;
        options.shown_only = shown_only;
        const auto result = alidade::import_gltf_bytes({reinterpret_cast<const std::byte*>(data), size}, "fuzz", "", options);
        if (result) alidade::validate(result->scene);
    }
    return 0;
}
