// SPDX-License-Identifier: Apache-2.0
#include "importers/mesh/mesh_file.h"

#include "core/image.h"
#include "importers/local_path.h"
#include "importers/mesh/mtl_material.h"
#include "importers/mesh/obj_mesh.h"

#include <fmt/format.h>

#include <filesystem>

namespace alidade::mesh {
namespace {

void add_mesh(ObjText& polygons, const std::string& path, uint32_t file, Scene& scene, Diagnostics& said) {
    const SourcePos whole_file{file, 0, 0, {}};
    leave_out_broken_faces(polygons, file, said);
    BuiltMesh built = MeshBuilder(polygons).build({0, 0, polygons.sections.size()});
    if (built.complex_faces)
        said.warning({file, built.first_complex_line, 0, {}},
                     fmt::format("polygons that cross themselves or have no area, whose triangles may overlap: {}", built.complex_faces));
    if (built.mesh.triangles.empty()) {
        said.warning(whole_file, fmt::format("the file has {} vertices and no faces that can be drawn: the scene is empty", polygons.positions.size()));
        return;
    }
    MtlMaterial plain;
    plain.name = "default";
    plain.from = whole_file;
    if (!polygons.colors.empty()) plain.diffuse = Vec3(1);   // the vertices bring the colour
    Node node;
    node.name = std::filesystem::path(path).stem().string();
    node.from = whole_file;
    node.what = ShapeId{uint32_t(scene.shapes.size())};
    node.materials.push_back(MaterialBuilder(scene, said).add(plain, folder_of(path)));
    scene.shapes.push_back({node.name, std::move(built.mesh), whole_file});
    scene.roots.push_back({uint32_t(scene.nodes.size())});
    scene.nodes.push_back(std::move(node));
}

ImportResult import_bytes(std::span<const std::byte> bytes, const std::string& path, const ImportOptions& options, MeshReader read, Diagnostics said,
                          uint32_t file) {
    std::optional<ObjText> polygons = read(bytes, file, options.strict, said);
    if (!polygons || said.has_errors()) return tl::unexpected(std::move(said));
    Scene scene;
    add_mesh(*polygons, path, file, scene, said);
    scene.files = said.files();
    return Imported{std::move(scene), std::move(said)};
}

}  // namespace

ImportResult import_mesh_file(const std::string& path, const ImportOptions& options, MeshReader read) {
    Diagnostics said;
    const uint32_t file = said.add_file(path);
    const auto bytes = read_file(path, options.max_file_bytes);
    if (bytes) return import_bytes(*bytes, path, options, read, std::move(said), file);
    said.error({file, 0, 0, {}}, bytes.error());
    return tl::unexpected(std::move(said));
}

ImportResult import_mesh_bytes(std::span<const std::byte> bytes, const std::string& path, const ImportOptions& options, MeshReader read) {
    Diagnostics said;
    const uint32_t file = said.add_file(path);
    return import_bytes(bytes, path, options, read, std::move(said), file);
}

void begin_only_object(ObjText& out, uint32_t file) {
    out.objects.push_back({"", {file, 0, 0, {}}});
    out.sections.emplace_back();
}

bool add_face(ObjText& out, size_t first, uint32_t line) {
    if (out.corners.size() >= kAbsent) return false;
    out.faces.push_back({uint32_t(first), uint32_t(out.corners.size() - first), line});
    return true;
}

}  // namespace alidade::mesh
