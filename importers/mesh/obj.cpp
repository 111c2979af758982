// SPDX-License-Identifier: Apache-2.0
#include "importers/mesh/obj.h"

#include "core/image.h"
#include "importers/local_path.h"
#include "importers/mesh/mtl_material.h"
#include "importers/mesh/obj_mesh.h"
#include "importers/mesh/obj_text.h"

#include <fmt/format.h>

#include <filesystem>

namespace alidade {
namespace {

using namespace mesh;
using namespace std::string_view_literals;

constexpr std::string_view kUtf8Mark = "\xef\xbb\xbf";

std::string_view as_text(std::span<const std::byte> bytes) {
    std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (text.starts_with(kUtf8Mark)) text.remove_prefix(kUtf8Mark.size());
    return text;
}

/// Why a file is no text that can be read here, and what to do; nothing if it is.
std::optional<std::pair<std::string, const char*>> not_text(std::string_view text, const char* format) {
    if (text.starts_with("\xff\xfe"sv) || text.starts_with("\xfe\xff"sv)) return {{"the file is UTF-16", "save it as UTF-8"}};
    if (text.find('\0') != std::string_view::npos) return {{fmt::format("the file is binary, {} is text", format), ""}};
    return std::nullopt;
}

/// The names of an mtllib line: the whole line if there is such a file, since names may hold blanks; else its words, in which `\ ` is a blank.
std::vector<std::string> library_names(const std::string& folder, const std::string& line) {
    std::error_code error;
    const auto whole = local_path(folder, line);
    if (whole && std::filesystem::exists(*whole, error)) return {line};
    std::vector<std::string> names(1);
    for (size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '\\' && i + 1 < line.size() && line[i + 1] == ' ') names.back() += line[++i];
        else if (line[i] != ' ' && line[i] != '\t') names.back() += line[i];
        else if (!names.back().empty()) names.emplace_back();
    }
    return names;
}

/// Makes a scene of one file.
class ObjImport {
  public:
    ObjImport(const std::string& path, const ImportOptions& options)
        : path_(path), folder_(folder_of(path)), options_(options), file_(said_.add_file(path)), materials_(scene_, said_) {}

    ImportResult run();

  private:
    struct Library {
        std::string folder;
        std::vector<MtlMaterial> materials;
    };

    std::optional<ObjText> read();
    void read_libraries(const ObjText& text);
    void read_library(const std::string& name, const SourcePos& from);
    void add_object(MeshBuilder& builder, const ObjectSections& object, const ObjText& text);
    MaterialId material(const ObjText& text, uint32_t index);
    MaterialId default_material(const ObjText& text);

    const std::string& path_;
    std::string folder_;
    const ImportOptions& options_;
    Scene scene_;
    Diagnostics said_;
    uint32_t file_;
    MaterialBuilder materials_;
    std::vector<Library> libraries_;
    std::map<uint32_t, MaterialId> built_;   ///< by index in ObjText::materials
    std::optional<MaterialId> default_;
};

std::optional<ObjText> ObjImport::read() {
    const auto bytes = read_file(path_, options_.max_file_bytes);
    if (!bytes) {
        said_.error({file_, 0, 0, {}}, bytes.error());
        return std::nullopt;
    }
    const std::string_view text = as_text(*bytes);
    if (const auto why = not_text(text, "OBJ")) {
        said_.error({file_, 0, 0, {}}, why->first, why->second);
        return std::nullopt;
    }
    return read_obj_text(text, file_, options_.strict, said_);
}

void ObjImport::read_library(const std::string& name, const SourcePos& from) {
    const auto path = local_path(folder_, name);
    if (!path) return said_.warning(from, fmt::format("the material library \"{}\" is not read: {}", name, path.error()));
    const auto bytes = read_file(*path, options_.max_file_bytes);
    if (!bytes) return said_.warning(from, fmt::format("no material library: {}", bytes.error()));
    const uint32_t file = said_.add_file(*path);
    const std::string_view text = as_text(*bytes);
    if (const auto why = not_text(text, "MTL")) return said_.error({file, 0, 0, {}}, fmt::format("{} (mtllib names it as a material library)", why->first), why->second);
    libraries_.push_back({folder_of(*path), read_mtl(text, file, options_.strict, said_)});
}

void ObjImport::read_libraries(const ObjText& text) {
    std::vector<std::string> seen;
    for (const Named& line : text.libraries)
        for (const std::string& name : library_names(folder_, line.name)) {
            if (name.empty() || std::find(seen.begin(), seen.end(), name) != seen.end()) continue;
            seen.push_back(name);
            read_library(name, line.from);
        }
}

MaterialId ObjImport::default_material(const ObjText& text) {
    if (default_) return *default_;
    MtlMaterial gray;
    gray.name = "default";
    gray.from = {file_, 0, 0, {}};
    if (!text.colors.empty()) gray.diffuse = Vec3(1);   // the vertices bring the colour
    default_ = materials_.add(gray, folder_);
    return *default_;
}

MaterialId ObjImport::material(const ObjText& text, uint32_t index) {
    if (index == kAbsent) return default_material(text);
    if (const auto known = built_.find(index); known != built_.end()) return known->second;
    const Named& wanted = text.materials[index];
    for (const Library& library : libraries_)
        for (const MtlMaterial& m : library.materials)
            if (m.name == wanted.name) return built_[index] = materials_.add(m, library.folder);
    said_.warning(wanted.from, fmt::format("no library defines the material \"{}\": gray is taken", wanted.name));
    return built_[index] = default_material(text);
}

void ObjImport::add_object(MeshBuilder& builder, const ObjectSections& object, const ObjText& text) {
    BuiltMesh built = builder.build(object);
    if (built.complex_faces)
        said_.warning({file_, built.first_complex_line, 0, {}},
                      fmt::format("polygons that cross themselves or have no area, whose triangles may overlap: {}", built.complex_faces));
    if (built.mesh.triangles.empty()) return;
    const Named& named = text.objects[object.object];
    Node node;
    node.name = named.name.empty() ? std::filesystem::path(path_).stem().string() : named.name;
    node.from = named.from;
    node.what = ShapeId{uint32_t(scene_.shapes.size())};
    for (const uint32_t slot : built.slot_materials) node.materials.push_back(material(text, slot));
    scene_.shapes.push_back({node.name, std::move(built.mesh), named.from});
    scene_.roots.push_back({uint32_t(scene_.nodes.size())});
    scene_.nodes.push_back(std::move(node));
}

ImportResult ObjImport::run() {
    std::optional<ObjText> text = read();
    if (!text) return tl::unexpected(std::move(said_));
    read_libraries(*text);
    if (said_.has_errors()) return tl::unexpected(std::move(said_));
    leave_out_broken_faces(*text, file_, said_);
    MeshBuilder builder(*text);
    for (const ObjectSections& object : objects_with_faces(*text)) add_object(builder, object, *text);
    if (scene_.shapes.empty()) said_.warning({file_, 0, 0, {}}, "the file has no faces that can be drawn: the scene is empty");
    scene_.files = said_.files();
    if (said_.has_errors()) return tl::unexpected(std::move(said_));
    return Imported{std::move(scene_), std::move(said_)};
}

}  // namespace

ImportResult import_obj(const std::string& path, const ImportOptions& options) { return ObjImport(path, options).run(); }

bool looks_like_obj(std::span<const std::byte> head) {
    const std::string_view text = as_text(head);
    return !not_text(text, "OBJ") && begins_like_obj(text);
}

}  // namespace alidade
