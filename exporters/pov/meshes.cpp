// SPDX-License-Identifier: Apache-2.0
#include "eval/flat_triangle.h"
#include "exporters/pov/picture_edges.h"
#include "exporters/pov/shapes.h"
#include "exporters/pov/vertex_colors.h"
#include "exporters/vertices.h"

#include <algorithm>
#include <array>

namespace alidade::pov_export {

namespace {

class MeshText {
  public:
    MeshText(const Mesh& mesh, const SlotMaterials& slots, const ShapeContext& c) : mesh_(mesh), slots_(slots), c_(c), finite_(finite_triangles(mesh)), colors_(mesh, slots, finite_, c.scene, c.losses), normals_(mesh.normals) {
        if (normals_.present() && !stands_alone()) keep_from_flatness();
        choose_uvs();
    }

    void begin() {
        tell_losses();
        if (stands_alone()) return lone_triangle();
        c_.sdl.begin("mesh2");
        vertices();
        if (normals_.present()) normals();
        if (uvs_) write_uvs(*uvs_);
        textures();
        faces();
        if (!normals_.corners.empty()) indices("normal_indices", normals_);
        if (uvs_ && !uvs_->corners.empty()) indices("uv_indices", *uvs_);
        if (mesh_.inside_vector) c_.sdl.line("inside_vector", *mesh_.inside_vector);
        if (mesh_.origin != Vec3(0)) c_.sdl.line("translate", mesh_.origin);
    }

  private:
    void tell_losses() const {
        c_.losses.add("triangles with a vertex that is not finite", mesh_.triangles.size() - finite_.size());
        c_.losses.add("further texture coordinate sets", mesh_.uvs.size() - std::min(mesh_.uvs.size(), sets_written_));
        c_.losses.add("faces of more than three corners", !mesh_.faces.empty(), "their triangles");
    }

    /// The texture coordinates that the first picture of a material asks for.
    size_t uv_set(const std::optional<MaterialId>& material) const {
        if (!material) return 0;
        for (const SignalId id : shown_signals(c_.scene, *material))
            if (const auto* image = std::get_if<ImageSignal>(&c_.scene.signals[id.index].what)) return image->uv_set;
        return 0;
    }

    /// Of each triangle those of its material's set.
    void choose_uvs() {
        std::vector<size_t> sets;
        for (const auto& slot : slots_) sets.push_back(uv_set(slot));
        if (sets.empty()) sets.push_back(0);
        if (std::all_of(sets.begin(), sets.end(), [&](size_t set) { return set == sets[0]; }) || mesh_.slots.empty()) {
            if (sets[0] < mesh_.uvs.size()) uvs_ = &mesh_.uvs[sets[0]];
            return;
        }
        std::vector<uint32_t> first(mesh_.uvs.size(), kNoId);   // of each set, among all coordinates
        for (size_t& set : sets) {
            if (set >= first.size()) set = 0;
            if (set >= first.size() || first[set] != kNoId) continue;
            first[set] = uint32_t(several_.values.size());
            several_.values.insert(several_.values.end(), mesh_.uvs[set].values.begin(), mesh_.uvs[set].values.end());
        }
        if (first.empty()) return;
        for (uint32_t t = 0; t < mesh_.triangles.size(); ++t)
            for (int corner = 0; corner < 3; ++corner) {
                const size_t set = sets[slot_of(mesh_, sets.size(), t)];
                several_.corners.push_back(first[set] + mesh_.uvs[set].index(t, corner, mesh_.triangles[t]));
            }
        uvs_ = &several_;
        sets_written_ = size_t(std::count_if(first.begin(), first.end(), [](uint32_t at) { return at != kNoId; }));
    }

    Vec3 position(size_t i) const { return mesh_.exact_positions.empty() ? Vec3(mesh_.positions[i]) : mesh_.exact_positions[i]; }

    std::array<Vec3, 3> corners(uint32_t t) const { return {position(mesh_.triangles[t].x), position(mesh_.triangles[t].y), position(mesh_.triangles[t].z)}; }
    std::array<Vec3, 3> corner_normals(uint32_t t) const {
        const auto at = [&](int corner) { return Vec3(mesh_.normals.values[mesh_.normals.index(t, corner, mesh_.triangles[t])]); };
        return {at(0), at(1), at(2)};
    }

    /// One that POV-Ray would draw flat only in a mesh.
    bool stands_alone() const {
        return mesh_.triangles.size() == 1 && !mesh_.inside_vector && finite_.size() == 1 && mesh_.normals.present() && mesh_.uvs.empty() && slots_.size() <= 1 && !colors_.present() && is_drawn_flat(corners(0), corner_normals(0));
    }
    void lone_triangle() {
        const std::array<Vec3, 3> places = corners(0), normals = corner_normals(0);
        c_.sdl.begin("smooth_triangle");
        for (size_t k = 0; k < 3; ++k) c_.sdl.item(places[k]), c_.sdl.item(normals[k]);
        c_.sdl.end_items();
        if (mesh_.origin != Vec3(0)) c_.sdl.line("translate", mesh_.origin);
    }

    /// Where POV-Ray would draw a triangle flat, the normal of one corner is turned by a little more than it takes for nothing.
    void keep_from_flatness() {
        constexpr double kTurn = 1.5 * kSameNormal;
        for (const uint32_t t : finite_) {
            const std::array<Vec3, 3> normals = corner_normals(t);
            if (!is_drawn_flat(corners(t), normals)) continue;
            if (normals_.corners.empty())
                for (const Index3& each : mesh_.triangles) normals_.corners.insert(normals_.corners.end(), {each.x, each.y, each.z});
            const Vec3 unit = normalized(normals[2]);   // as POV-Ray makes it before it compares
            Vec3 across, other;
            orthonormal_basis(unit, across, other);
            normals_.corners[3 * size_t(t) + 2] = uint32_t(normals_.values.size());
            normals_.values.emplace_back(unit + across * kTurn);
        }
    }

    void vertices() {
        c_.sdl.begin("vertex_vectors");
        c_.sdl.line(mesh_.positions.size(), ",");
        for (size_t i = 0; i < mesh_.positions.size(); ++i) {
            const Vec3 p = position(i);
            c_.sdl.item(is_finite(p) ? p : Vec3(0));   // what is not finite belongs to no triangle that is written
        }
        end();
    }

    void normals() {
        size_t without = 0;
        c_.sdl.begin("normal_vectors");
        c_.sdl.line(normals_.values.size(), ",");
        for (const Vec3f& n : normals_.values) {
            const bool good = is_finite(n) && n != Vec3f(0.0f);
            without += !good;
            c_.sdl.item(good ? Vec3(n) : Vec3(0, 1, 0));
        }
        end();
        c_.losses.add("normals without direction", without, "<0, 1, 0>");
    }

    void write_uvs(const Attribute<Vec2f>& uv) {
        size_t without = 0;
        c_.sdl.begin("uv_vectors");
        c_.sdl.line(uv.values.size(), ",");
        for (const Vec2f& at : uv.values) {
            const bool good = std::isfinite(at.x) && std::isfinite(at.y);
            without += !good;
            c_.sdl.item(good ? Vec2(double(at.x), 1 - double(at.y)) : Vec2(0));   // POV-Ray's v grows upwards
        }
        end();
        c_.losses.add("texture coordinates that are not finite", without, "0");
    }

    /// Slot 0 is the object's own texture; the others are numbered from 0. One that no node gives a material takes the default.
    void textures() {
        const bool several = slots_.size() > 1 && (!mesh_.slots.empty() || mixed());
        if (!several && !colors_.present()) return;
        c_.sdl.begin("texture_list");
        c_.sdl.line(colors_.present() ? colors_.size() : slots_.size() - 1, ",");
        if (colors_.present()) colors_.write(c_.textures);
        for (size_t i = 1; i < slots_.size() && !colors_.present(); ++i) c_.textures.use(slots_[i]);
        c_.sdl.end();
    }

    void faces() {
        c_.sdl.begin("face_indices");
        c_.sdl.line(finite_.size(), ",");
        for (size_t n = 0; n < finite_.size(); ++n) {
            const uint32_t t = finite_[n];
            c_.sdl.item(mesh_.triangles[t]);
            if (colors_.present()) c_.sdl.item(colors_.at(n).x), c_.sdl.item(colors_.at(n).y), c_.sdl.item(colors_.at(n).z);
            else if (mixed() && mixes(t))
                for (int corner = 0; corner < 3; ++corner) c_.sdl.item(mesh_.corner_slots[3 * size_t(t) + size_t(corner)] - 1);
            else if (const uint32_t slot = slot_of(mesh_, slots_.size(), t); slot > 0) c_.sdl.item(slot - 1);
        }
        end();
    }

    bool mixed() const { return slots_.size() > 1 && !mesh_.corner_slots.empty(); }
    /// Three textures, none of which is the object's own: that has no number.
    bool mixes(uint32_t t) const {
        const uint32_t* s = &mesh_.corner_slots[3 * size_t(t)];
        return (s[0] != s[1] || s[1] != s[2]) && s[0] > 0 && s[1] > 0 && s[2] > 0;
    }

    template <class T> void indices(const char* word, const Attribute<T>& attribute) {
        c_.sdl.begin(word);
        c_.sdl.line(finite_.size(), ",");
        for (const uint32_t t : finite_) {
            const uint32_t* corner = &attribute.corners[3 * size_t(t)];
            c_.sdl.item(Index3(corner[0], corner[1], corner[2]));
        }
        end();
    }

    void end() {
        c_.sdl.end_items();
        c_.sdl.end();
    }

    const Mesh& mesh_;
    const SlotMaterials& slots_;
    const ShapeContext& c_;
    std::vector<uint32_t> finite_;
    VertexColors colors_;
    Attribute<Vec3f> normals_;
    const Attribute<Vec2f>* uvs_ = nullptr;
    Attribute<Vec2f> several_;   ///< if its materials ask for several sets
    size_t sets_written_ = 1;
};

}  // namespace

void begin_mesh(const Mesh& mesh, const SlotMaterials& slots, const ShapeContext& context) { MeshText(mesh, slots, context).begin(); }

}  // namespace alidade::pov_export
