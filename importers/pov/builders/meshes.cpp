// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/shapes.h"

#include "importers/pov/builders/textures.h"

#include <fmt/format.h>

namespace alidade::pov {

namespace {

void add_vertex(Mesh& mesh, const Vec3& v) {
    mesh.positions.emplace_back(v);
    mesh.exact_positions.push_back(v);
}

/// The file's numbers are kept beside the rounded ones only where rounding changes them.
void drop_exact_copies(Mesh& mesh) {
    for (size_t i = 0; i < mesh.positions.size(); ++i)
        if (Vec3(mesh.positions[i]) != mesh.exact_positions[i]) return;
    mesh.exact_positions.clear();
}

/// Three corners, each with its normal if the triangle is smooth.
void take_triangle(Mesh& mesh, Cursor& at, bool smooth) {
    const uint32_t first = uint32_t(mesh.positions.size());
    mesh.triangles.emplace_back(first, first + 1, first + 2);
    for (int corner = 0; corner < 3; ++corner) {
        add_vertex(mesh, at.vector("a corner of a triangle"));
        if (smooth) mesh.normals.values.emplace_back(normalized(at.vector("a normal of a triangle")));   // as POV-Ray does
    }
}

/// A flat triangle of a mesh that has normals gets its own three times.
void fill_normals(Mesh& mesh) {
    const Index3& t = mesh.triangles.back();
    const Vec3 a = mesh.exact_positions[t.x], n = cross(mesh.exact_positions[t.y] - a, mesh.exact_positions[t.z] - a);
    mesh.normals.values.resize(mesh.positions.size(), Vec3f(normalized(n)));
}

BuiltShape one_triangle(Cursor& at, bool smooth) {
    Mesh mesh;
    take_triangle(mesh, at, smooth);
    drop_exact_copies(mesh);
    return {std::move(mesh), {}};
}

/// Textures of triangles as material slots: slot 0 is the object's own.
class Slots {
  public:
    explicit Slots(Build& build) : build_(build), materials_(1) {}

    uint32_t of(const Block& texture) {
        if (build_.shapes_alone) return 0;
        const auto [at, added] = known_.try_emplace(&texture, uint32_t(materials_.size()));
        if (added) materials_.emplace_back(add_material(build_, build_texture(build_, texture), texture.place));
        return at->second;
    }
    std::vector<std::optional<MaterialId>> take() { return materials_.size() > 1 ? std::move(materials_) : std::vector<std::optional<MaterialId>>(); }

  private:
    Build& build_;
    std::vector<std::optional<MaterialId>> materials_;
    std::map<const Block*, uint32_t> known_;
};

/// What may stand behind the corners of a mesh's triangle; returns its material slot.
uint32_t take_triangle_modifiers(Cursor& at, Slots& slots) {
    uint32_t slot = 0;
    while (!at.done()) {
        const Block* texture = at.block_at("texture"_w);
        const Block* named = nullptr;
        if (texture && texture->items.size() == 1 && texture->items[0].value.kind == Kind::block) named = &texture->items[0].block();
        if (!texture) at.skip_unmodelled();
        else at.next(), slot = slots.of(named && named->word == "texture"_w ? *named : *texture);
    }
    return slot;
}

/// The vectors behind their number in `vertex_vectors { ... }` and the like.
std::vector<Vec3> take_vectors(Build& build, const Block& block) {
    Cursor at(build, block);
    if (at.at_number()) at.next();                                   // how many there are is seen
    std::vector<Vec3> out;
    out.reserve(block.items.size());
    while (!at.done()) out.push_back(at.vector("a vector of a mesh"));
    return out;
}

/// Indices into `count` vectors.
Index3 take_indices(Build& build, Cursor& at, size_t count) {
    const Place place = at.place();
    const Vec3 v = at.vector("the indices of a triangle");
    for (int i = 0; i < 3; ++i)
        if (!(v[i] >= 0 && v[i] < double(count))) build.p.fail(place, fmt::format("there is no vector {}: the mesh has {}", v[i], count));
    return Index3(uint32_t(v.x), uint32_t(v.y), uint32_t(v.z));
}

struct Mesh2Parts {
    const Block *vertices = nullptr, *normals = nullptr, *textures = nullptr, *faces = nullptr, *normal_indices = nullptr;
};

Mesh2Parts take_parts(Cursor& at) {
    Mesh2Parts parts;
    while (!at.done()) {
        if (const Block* b = at.block_at("vertex_vectors"_w)) parts.vertices = b;
        else if (const Block* n = at.block_at("normal_vectors"_w)) parts.normals = n;
        else if (const Block* t = at.block_at("texture_list"_w)) parts.textures = t;
        else if (const Block* f = at.block_at("face_indices"_w)) parts.faces = f;
        else if (const Block* i = at.block_at("normal_indices"_w)) parts.normal_indices = i;
        else if (at.at_block("uv_vectors"_w) || at.at_block("uv_indices"_w) || at.at_word("inside_vector"_w)) {
            at.skip_unmodelled();
            continue;
        } else break;
        at.next();
    }
    return parts;
}

std::vector<uint32_t> take_texture_list(Build& build, const Block& block, Slots& slots) {
    std::vector<uint32_t> out;
    for (Cursor at(build, block); !at.done(); ) {
        if (const Block* texture = at.block_at("texture"_w)) out.push_back(slots.of(*texture));
        at.next();
    }
    return out;
}

/// The triangles, and the slot of each: one texture index for the whole triangle. (Three of them would be blended over it.)
void take_faces(Build& build, const Block& block, const std::vector<uint32_t>& textures, Mesh& mesh) {
    Cursor at(build, block);
    if (at.at_number()) at.next();
    while (!at.done()) {
        const Place place = at.place();
        mesh.triangles.push_back(take_indices(build, at, mesh.positions.size()));
        uint32_t slot = 0;
        for (int n = 0; at.at_number(); ++n) {
            const double index = at.number("the number of a texture");
            if (!(index >= 0 && index < double(textures.size()))) build.p.fail(place, fmt::format("there is no texture {}: the mesh has {}", index, textures.size()));
            if (n == 0) slot = textures[size_t(index)];
            if (n == 1) build.p.tally(place, "triangles whose corners have different textures are not modelled yet: the first is taken");
        }
        if (!textures.empty()) mesh.slots.push_back(slot);
    }
}

void take_normals(Build& build, const Mesh2Parts& parts, Mesh& mesh) {
    if (!parts.normals) return;
    for (const Vec3& n : take_vectors(build, *parts.normals)) mesh.normals.values.emplace_back(normalized(n));
    if (!parts.normal_indices) return;
    Cursor at(build, *parts.normal_indices);
    if (at.at_number()) at.next();
    while (!at.done()) {
        const Index3 i = take_indices(build, at, mesh.normals.values.size());
        mesh.normals.corners.insert(mesh.normals.corners.end(), {i.x, i.y, i.z});
    }
}

}  // namespace

BuiltShape build_triangle(Build&, Cursor& at) { return one_triangle(at, false); }
BuiltShape build_smooth_triangle(Build&, Cursor& at) { return one_triangle(at, true); }

BuiltShape build_mesh(Build& build, Cursor& at) {
    Mesh mesh;
    Slots slots(build);
    bool smooth_seen = false;
    while (at.at_block("triangle"_w) || at.at_block("smooth_triangle"_w)) {
        const bool smooth = at.at_block("smooth_triangle"_w);
        Cursor corners(build, *at.any_block());
        at.next();
        if (smooth && !smooth_seen) {                                // those before it were flat
            Mesh flat = std::move(mesh);
            mesh = Mesh();
            mesh.slots = std::move(flat.slots);
            for (const Index3& t : flat.triangles) {
                mesh.triangles.push_back(t);
                for (int i = 0; i < 3; ++i) add_vertex(mesh, flat.exact_positions[t[i]]);
                fill_normals(mesh);
            }
            smooth_seen = true;
        }
        take_triangle(mesh, corners, smooth);
        if (smooth_seen && !smooth) fill_normals(mesh);
        mesh.slots.push_back(take_triangle_modifiers(corners, slots));
    }
    if (mesh.triangles.empty()) build.p.fail(at.place(), "a mesh needs triangles");
    drop_exact_copies(mesh);
    return {std::move(mesh), slots.take()};
}

BuiltShape build_mesh2(Build& build, Cursor& at) {
    const Place place = at.place();
    const Mesh2Parts parts = take_parts(at);
    if (!parts.vertices || !parts.faces) build.p.fail(place, "a mesh2 needs vertex_vectors and face_indices");
    Mesh mesh;
    Slots slots(build);
    for (const Vec3& v : take_vectors(build, *parts.vertices)) add_vertex(mesh, v);
    std::vector<uint32_t> textures;
    if (parts.textures) textures = take_texture_list(build, *parts.textures, slots);
    take_faces(build, *parts.faces, textures, mesh);
    take_normals(build, parts, mesh);
    const size_t normals = mesh.normals.values.size(), corners = mesh.normals.corners.size();
    if ((corners ? corners != 3 * mesh.triangles.size() : normals && normals != mesh.positions.size())) {
        build.p.warn(place, "the mesh has another number of normals than of vertices or triangles: it is drawn flat");
        mesh.normals = {};
    }
    drop_exact_copies(mesh);
    return {std::move(mesh), slots.take()};
}

}  // namespace alidade::pov
