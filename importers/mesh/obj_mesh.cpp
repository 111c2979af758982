// SPDX-License-Identifier: Apache-2.0
#include "importers/mesh/obj_mesh.h"

#include "core/bounds.h"
#include "importers/mesh/obj_normals.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

namespace alidade::mesh {
namespace {

/// How many faces were left out for one reason, and the line of the first.
struct LeftOut {
    uint32_t count = 0, line = 0;

    void add(Face& face) {
        if (count++ == 0) line = face.line;
        face.count = 0;
    }
    void tell(uint32_t file, const char* why, Diagnostics& said) const {
        if (count) said.warning({file, line, 0, {}}, fmt::format("faces {} are left out: {}", why, count));
    }
};

bool fits_float(const Vec3& p) { return is_finite(p) && max_abs(p) <= double(std::numeric_limits<float>::max()); }

uint32_t drop_repeated(std::span<Corner> corners, const ObjText& text) {
    const auto same = [&](const Corner& a, const Corner& b) { return text.positions[a.position] == text.positions[b.position]; };
    uint32_t count = uint32_t(std::unique(corners.begin(), corners.end(), same) - corners.begin());
    while (count > 1 && same(corners[0], corners[count - 1])) --count;
    return count;
}

/// See MeshBuilder. The origin is a multiple of a power of two no smaller than the mesh: it has few digits, and is 0 along an axis near 0.
Vec3 choose_origin(const Bounds& bounds) {
    const double size = max_component(bounds.extent());
    const double distance = std::max(max_abs(bounds.min), max_abs(bounds.max));
    if (!(distance > 64 * size)) return Vec3(0);
    const double step = size > 0 ? std::exp2(std::ceil(std::log2(size))) : std::exp2(std::floor(std::log2(distance)) - 20);
    const Vec3 center = bounds.center();
    return step * Vec3(std::round(center.x / step), std::round(center.y / step), std::round(center.z / step));
}

}  // namespace

std::vector<ObjectSections> objects_with_faces(const ObjText& text) {
    std::vector<ObjectSections> objects;
    for (size_t s = 0; s < text.sections.size(); ++s) {
        if (objects.empty() || objects.back().object != text.sections[s].object) objects.push_back({text.sections[s].object, s, s});
        objects.back().last = s + 1;
    }
    return objects;
}

void leave_out_broken_faces(ObjText& text, uint32_t file, Diagnostics& said) {
    LeftOut not_finite, no_area;
    for (Face& face : text.faces) {
        const std::span<Corner> corners = corners_of(text, face);
        const auto usable = [&](const Corner& c) { return fits_float(text.positions[c.position]); };
        if (!std::all_of(corners.begin(), corners.end(), usable)) {
            not_finite.add(face);
            continue;
        }
        face.count = drop_repeated(corners, text);
        if (face.count < 3) no_area.add(face);
    }
    not_finite.tell(file, "with a vertex that is not finite or is beyond 3.4e38", said);
    no_area.tell(file, "with fewer than three different corners", said);
}

std::vector<uint32_t> MeshBuilder::Renumbering::apply(std::vector<uint32_t>& indices, size_t count) {
    if (number_.size() < count) number_.resize(count, kAbsent);
    std::vector<uint32_t> used;
    for (uint32_t& i : indices) {
        uint32_t& number = number_[i];
        if (number == kAbsent) {
            number = uint32_t(used.size());
            used.push_back(i);
        }
        i = number;
    }
    for (const uint32_t i : used) number_[i] = kAbsent;
    return used;
}

std::vector<uint32_t> MeshBuilder::indices(uint32_t Corner::*which, uint32_t instead) const {
    std::vector<uint32_t> out(cut_.size());
    for (size_t i = 0; i < cut_.size(); ++i) {
        const uint32_t index = text_.corners[cut_[i]].*which;
        out[i] = index == kAbsent ? instead : index;
    }
    return out;
}

/// Appends the triangles of a face to the cut; returns how many.
size_t MeshBuilder::cut_face(const Face& face, BuiltMesh& out) {
    polygon_.clear(), triangles_.clear();
    for (const Corner& c : corners_of(text_, face)) polygon_.push_back(text_.positions[c.position]);
    if (!triangulator_.triangulate(polygon_, triangles_) && out.complex_faces++ == 0) out.first_complex_line = face.line;
    for (const Index3& t : triangles_)
        for (int k = 0; k < 3; ++k) cut_.push_back(face.first + t[k]);
    return triangles_.size();
}

void MeshBuilder::cut_into_triangles(const ObjectSections& object, BuiltMesh& out) {
    cut_.clear();
    Mesh& mesh = out.mesh;
    std::unordered_map<uint32_t, uint32_t> slot_of;   // by material
    bool all_are_triangles = true;
    uint32_t face_number = 0;
    for (size_t s = object.first; s < object.last; ++s) {
        const uint32_t material = text_.sections[s].material;
        const auto [slot, added] = slot_of.try_emplace(material, uint32_t(slot_of.size()));
        if (added) out.slot_materials.push_back(material);
        for (uint32_t f = text_.sections[s].first_face; f < text_.section_end(s); ++f, ++face_number) {
            const Face& face = text_.faces[f];
            all_are_triangles = all_are_triangles && face.count == 3;
            const size_t triangles = face.count ? cut_face(face, out) : 0;
            mesh.slots.insert(mesh.slots.end(), triangles, slot->second);
            mesh.faces.insert(mesh.faces.end(), triangles, face_number);
        }
    }
    if (slot_of.size() < 2) mesh.slots.clear();
    if (all_are_triangles) mesh.faces.clear();
}

void MeshBuilder::set_positions(BuiltMesh& out) {
    Mesh& mesh = out.mesh;
    positions_ = indices(&Corner::position, 0);
    const std::vector<uint32_t> used = of_positions_.apply(positions_, text_.positions.size());
    Bounds bounds;
    for (const uint32_t i : used) bounds.extend(text_.positions[i]);
    if (!used.empty()) mesh.origin = choose_origin(bounds);
    mesh.positions.reserve(used.size());
    for (const uint32_t i : used) mesh.positions.emplace_back(text_.positions[i] - mesh.origin);
    if (text_.exceeds_float)
        for (const uint32_t i : used) mesh.exact_positions.push_back(text_.positions[i] - mesh.origin);
    mesh.triangles.reserve(positions_.size() / 3);
    for (size_t i = 0; i < positions_.size(); i += 3) mesh.triangles.emplace_back(positions_[i], positions_[i + 1], positions_[i + 2]);
    if (text_.colors.empty()) return;
    Attribute<Vec4f> colors;
    for (const uint32_t i : used) colors.values.push_back(text_.colors[i]);
    mesh.colors.push_back(std::move(colors));
}

void MeshBuilder::set_uvs(Mesh& mesh) {
    const uint32_t absent = uint32_t(text_.uvs.size());   // stands for a corner without one, in an object where others have it
    std::vector<uint32_t> corners = indices(&Corner::uv, absent);
    if (std::all_of(corners.begin(), corners.end(), [&](uint32_t i) { return i == absent; })) return;
    Attribute<Vec2f> uv;
    for (const uint32_t i : of_uvs_.apply(corners, size_t(absent) + 1)) uv.values.push_back(i == absent ? Vec2f(0, 1) : text_.uvs[i]);
    if (corners != positions_ || uv.values.size() != mesh.positions.size()) uv.corners = std::move(corners);
    mesh.uvs.push_back(std::move(uv));
}

void MeshBuilder::set_normals(Mesh& mesh) {
    std::vector<uint32_t> corners = indices(&Corner::normal, kAbsent);
    if (corners.empty() || corners[0] == kAbsent) return;   // complete_normals gave one to all or to none
    for (const uint32_t i : of_normals_.apply(corners, text_.normals.size())) mesh.normals.values.push_back(text_.normals[i]);
    if (corners != positions_ || mesh.normals.values.size() != mesh.positions.size()) mesh.normals.corners = std::move(corners);
}

BuiltMesh MeshBuilder::build(const ObjectSections& object) {
    complete_normals(text_, object.first, object.last);
    BuiltMesh out;
    cut_into_triangles(object, out);
    set_positions(out);
    set_uvs(out.mesh);
    set_normals(out.mesh);
    return out;
}

}  // namespace alidade::mesh
