// SPDX-License-Identifier: Apache-2.0
/// libFuzzer target: any bytes as an OBJ file and as an MTL library. No file is read.
#include "importers/mesh/mtl.h"
#include "importers/mesh/obj_mesh.h"

#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    using namespace alidade;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    Diagnostics said;
    mesh::read_mtl(text, said.add_file("fuzz.mtl"), false, said);
    const uint32_t file = said.add_file("fuzz.obj");
    if (std::optional<mesh::ObjText> obj = mesh::read_obj_text(text, file, false, said)) {
        mesh::leave_out_broken_faces(*obj, file, said);
        mesh::MeshBuilder builder(*obj);
        for (const mesh::ObjectSections& object : mesh::objects_with_faces(*obj)) builder.build(object);
    }
    return 0;
}
