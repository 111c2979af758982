// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/shapes.h"

#include "eval/flat_triangle.h"
#include "importers/pov/builders/textures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace alidade::pov {

namespace {

/// Of length 1, as POV-Ray has it, which takes x for one without length; but one that is so to single precision stays as it is written: a second rounding would move it.
Vec3f unit_normal(const Vec3& n) {
    constexpr double kSinglePrecision = 1e-6;
    if (n == Vec3(0)) return Vec3f(1, 0, 0);
    return Vec3f(std::abs(dot(n, n) - 1) < kSinglePrecision ? n : normalized(n));
}

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
        if (smooth) mesh.normals.values.push_back(unit_normal(at.vector("a normal of a triangle")));
    }
}

Vec3f flat_normal(const Mesh& mesh, const Index3& t) {
    const Vec3 a = mesh.exact_positions[t.x];
    return Vec3f(normalized(cross(mesh.exact_positions[t.y] - a, mesh.exact_positions[t.z] - a)));
}

/// A flat triangle of a mesh that has normals gets its own three times.
void fill_normals(Mesh& mesh) { mesh.normals.values.resize(mesh.positions.size(), flat_normal(mesh, mesh.triangles.back())); }

std::array<Vec3, 3> corners_of(const Mesh& mesh, const Index3& t) { return {mesh.exact_positions[t.x], mesh.exact_positions[t.y], mesh.exact_positions[t.z]}; }

/// Triangles that POV-Ray draws flat get their own normal. Before the exact positions are dropped.
void flatten(Mesh& mesh) {
    Attribute<Vec3f>& normals = mesh.normals;
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Index3& corners = mesh.triangles[t];
        const auto at = [&](int corner) { return Vec3(normals.values[normals.index(t, corner, corners)]); };
        const std::array<Vec3, 3> places = corners_of(mesh, corners), three{at(0), at(1), at(2)};
        if (!is_drawn_flat(places, three)) continue;
        if (normals.corners.empty())
            for (const Index3& each : mesh.triangles) normals.corners.insert(normals.corners.end(), {each.x, each.y, each.z});
        std::fill_n(normals.corners.begin() + std::ptrdiff_t(3 * t), 3, uint32_t(normals.values.size()));
        normals.values.emplace_back(own_normal(places, three[0]));
    }
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

/// The texture itself where a block only names it.
const Block& named(const Block& texture) {
    const bool only = texture.items().size() == 1 && texture.items()[0].value_kind() == Kind::block;
    return only && texture.items()[0].block().word == "texture"_w ? texture.items()[0].block() : texture;
}

/// POV-Ray's v grows upwards.
Vec2f uv_of(const Vec3& v) { return Vec2f(float(v.x), float(1 - v.y)); }

/// `uv_vectors <u, v>, <u, v>, <u, v>` of the last triangle; those without have <0, 0>.
void take_triangle_uvs(Cursor& at, Mesh& mesh) {
    if (mesh.uvs.empty()) mesh.uvs.resize(1);
    mesh.uvs[0].values.resize(mesh.positions.size() - 3, uv_of(Vec3(0)));
    for (int corner = 0; corner < 3; ++corner) mesh.uvs[0].values.push_back(uv_of(at.vector("texture coordinates", 2)));
}

/// How many things a list says that it has, and who must have as many: a file that was cut off, or joined wrongly, is not taken for a smaller mesh.
class Announced {
  public:
    explicit Announced(Cursor& at) : place_(at.place()), count_(std::trunc(at.number("how many there are"))) {}
    void check(Build& build, const Block& block, size_t found) const {
        if (count_ != double(found)) build.p.fail(place_, fmt::format("{} says that it has {:.0f}, and has {}", kWords[block.word], count_, found));
    }

  private:
    Place place_;
    double count_;
};

/// `by_name`: a triangle's list has names alone; that of a mesh2 has none.
std::vector<uint32_t> take_textures(Build& build, Cursor& at, Slots& slots, bool by_name) {
    std::vector<uint32_t> out;
    while (const Block* texture = at.block_at("texture"_w)) {
        if (at.at_declared() != by_name) build.p.fail(at.place(), by_name ? "a triangle's texture_list holds names of textures, without texture { } around them" : "a mesh2's texture_list holds textures: texture { NAME }, not the name alone");
        at.next(), out.push_back(slots.of(named(*texture)));
    }
    if (!at.done()) at.skip_unmodelled();
    return out;
}

/// Sets the slots of the last triangle, one or three.
void set_slots(Mesh& mesh, const Index3& corners) {
    const size_t before = mesh.triangles.size() - 1;
    mesh.slots.push_back(corners.x);
    const bool mixed = corners != Index3(corners.x);
    if (!mixed && mesh.corner_slots.empty()) return;
    for (size_t t = mesh.corner_slots.size() / 3; t < before; ++t) mesh.corner_slots.insert(mesh.corner_slots.end(), 3, mesh.slots[t]);
    mesh.corner_slots.insert(mesh.corner_slots.end(), {corners.x, corners.y, corners.z});
}

/// That of a triangle is `texture { NAME }`, and no more.
void check_triangle_texture(Build& build, const Block& texture, const Cursor& at) {
    const bool is_name = &named(texture) != &texture && texture.items()[0].kind == Item::Kind::value;
    if (at.at_declared() || !is_name) build.p.fail(at.place(), "the texture of a triangle is texture { NAME }, without a word more: POV-Ray refuses it, too", "declare the texture before the mesh");
}

/// What may stand behind the corners of a mesh's triangle.
void take_triangle_modifiers(Build& build, Cursor& at, Slots& slots, Mesh& mesh) {
    Index3 corners(0u);
    while (!at.done()) {
        if (const Block* texture = at.block_at("texture"_w)) {
            check_triangle_texture(build, *texture, at);
            at.next(), corners = Index3(slots.of(named(*texture)));
        }
        else if (const Block* list = at.block_at("texture_list"_w)) {
            Cursor textures(build, *list);
            const std::vector<uint32_t> three = take_textures(build, textures, slots, true);
            if (three.size() != 3) build.p.fail(list->place, "the texture_list of a triangle has three textures");
            at.next(), corners = Index3(three[0], three[1], three[2]);
        } else if (at.accept("uv_vectors"_w)) take_triangle_uvs(at, mesh);
        else at.skip_unmodelled();
    }
    set_slots(mesh, corners);
}

/// The vectors behind their number in `vertex_vectors { ... }` and the like.
std::vector<Vec3> take_vectors(Build& build, const Block& block, uint8_t terms = 3) {
    Cursor at(build, block);
    const Announced announced(at);
    std::vector<Vec3> out;
    out.reserve(block.items().size());
    while (!at.done()) out.push_back(at.vector("a vector of a mesh", terms));
    announced.check(build, block, out.size());
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

/// Lines in this direction tell what is inside; 0 says that nothing is.
void take_inside(Cursor& at, std::optional<Vec3>& direction) {
    direction = at.vector("inside_vector");
    if (*direction == Vec3(0)) direction.reset();
}

struct Mesh2Parts {
    const Block *vertices = nullptr, *normals = nullptr, *uvs = nullptr, *textures = nullptr, *faces = nullptr, *normal_indices = nullptr, *uv_indices = nullptr;
    std::optional<Vec3> inside_vector;
};

Mesh2Parts take_parts(Cursor& at) {
    Mesh2Parts parts;
    while (!at.done()) {
        if (const Block* b = at.block_at("vertex_vectors"_w)) parts.vertices = b;
        else if (const Block* n = at.block_at("normal_vectors"_w)) parts.normals = n;
        else if (const Block* t = at.block_at("texture_list"_w)) parts.textures = t;
        else if (const Block* f = at.block_at("face_indices"_w)) parts.faces = f;
        else if (const Block* i = at.block_at("normal_indices"_w)) parts.normal_indices = i;
        else if (const Block* u = at.block_at("uv_vectors"_w)) parts.uvs = u;
        else if (const Block* k = at.block_at("uv_indices"_w)) parts.uv_indices = k;
        else if (at.accept("inside_vector"_w)) {
            take_inside(at, parts.inside_vector);
            continue;
        } else break;
        at.next();
    }
    return parts;
}

/// The triangles, and the slots of each: one texture index for the whole triangle, or three that are mixed over it.
void take_faces(Build& build, const Block& block, const std::vector<uint32_t>& textures, Mesh& mesh) {
    Cursor at(build, block);
    const Announced announced(at);
    while (!at.done()) {
        const Place place = at.place();
        mesh.triangles.push_back(take_indices(build, at, mesh.positions.size()));
        Index3 corners(0u);
        for (int n = 0; at.at_number(); ++n) {
            const double index = at.number("the number of a texture");
            if (!(index >= 0 && index < double(textures.size()))) build.p.fail(place, fmt::format("there is no texture {}: the mesh has {}", index, textures.size()));
            if (n == 0) corners = Index3(textures[size_t(index)]);
            else if (n < 3) corners[n] = textures[size_t(index)];
        }
        if (!textures.empty()) set_slots(mesh, corners);
    }
    announced.check(build, block, mesh.triangles.size());
}

/// The indices of an attribute, three for each triangle. Returns the number of triangles that have them.
template <class T> size_t take_corners(Build& build, const Block& indices, Attribute<T>& out) {
    Cursor at(build, indices);
    const Announced announced(at);
    while (!at.done()) {
        const Index3 i = take_indices(build, at, out.values.size());
        out.corners.insert(out.corners.end(), {i.x, i.y, i.z});
    }
    announced.check(build, indices, out.corners.size() / 3);
    return out.corners.size() / 3;
}

/// Triangles from `first` on get their own normal, as those that POV-Ray has no indices for.
void fill_normals_from(size_t first, Mesh& mesh) {
    for (size_t t = first; t < mesh.triangles.size(); ++t) {
        mesh.normals.corners.insert(mesh.normals.corners.end(), 3, uint32_t(mesh.normals.values.size()));
        mesh.normals.values.push_back(flat_normal(mesh, mesh.triangles[t]));
    }
}

void take_normals(Build& build, const Mesh2Parts& parts, Mesh& mesh, Place place) {
    if (!parts.normals) return;
    for (const Vec3& n : take_vectors(build, *parts.normals)) mesh.normals.values.push_back(unit_normal(n));
    if (mesh.normals.values.empty()) return;
    if (parts.normal_indices) {   // those of the first triangles are enough: the others are flat
        const size_t smooth = take_corners(build, *parts.normal_indices, mesh.normals), count = mesh.triangles.size();
        if (smooth > count) build.p.fail(parts.normal_indices->place, fmt::format("there are {} normal_indices for {} triangles", smooth, count));
        if (smooth == 0) return void(mesh.normals = {});
        fill_normals_from(smooth, mesh);
    } else if (mesh.normals.values.size() != mesh.positions.size()) {
        build.p.warn(place, "the mesh has another number of normals than of vertices or triangles: it is drawn flat");
        return void(mesh.normals = {});
    }
    flatten(mesh);
}

void take_uvs(Build& build, const Mesh2Parts& parts, Mesh& mesh) {
    if (!parts.uvs) return;
    Attribute<Vec2f> uvs;
    for (const Vec3& uv : take_vectors(build, *parts.uvs, 2)) uvs.values.push_back(uv_of(uv));
    if (uvs.values.empty()) return;
    const size_t count = parts.uv_indices ? take_corners(build, *parts.uv_indices, uvs) : uvs.values.size(), wanted = parts.uv_indices ? mesh.triangles.size() : mesh.positions.size();
    if (count != wanted)
        build.p.fail((parts.uv_indices ? parts.uv_indices : parts.uvs)->place, parts.uv_indices ? fmt::format("there are {} uv_indices for {} triangles", count, wanted) : fmt::format("there are {} uv_vectors for {} vertices: uv_indices are missing", count, wanted));
    mesh.uvs.push_back(std::move(uvs));
}

}  // namespace

BuiltShape build_triangle(Build&, Cursor& at) { return one_triangle(at, false); }

/// POV-Ray leaves out one that stands alone if its normals are not all on one side of its plane; in a mesh it draws it.
BuiltShape build_smooth_triangle(Build& build, Cursor& at) {
    const Place place = at.place();
    const BuiltShape shape = one_triangle(at, true);
    const Mesh& mesh = std::get<Mesh>(shape.geometry);
    const auto corner = [&](size_t i) { return mesh.exact_positions.empty() ? Vec3(mesh.positions[i]) : mesh.exact_positions[i]; };
    const Vec3 across = cross(corner(1) - corner(0), corner(2) - corner(0));
    int side = 0;
    for (const Vec3f& n : mesh.normals.values) side += (dot(Vec3(n), across) > 0) - (dot(Vec3(n), across) < 0);
    if (std::abs(side) == 3) return shape;
    build.p.tally(place, "a smooth triangle whose normals are not all on one side of it is left out, as POV-Ray does");
    return {Mesh(), {}};
}

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
            mesh.slots = std::move(flat.slots), mesh.corner_slots = std::move(flat.corner_slots), mesh.uvs = std::move(flat.uvs);
            for (const Index3& t : flat.triangles) {
                mesh.triangles.push_back(t);
                for (int i = 0; i < 3; ++i) add_vertex(mesh, flat.exact_positions[t[i]]);
                fill_normals(mesh);
            }
            smooth_seen = true;
        }
        take_triangle(mesh, corners, smooth);
        if (smooth_seen && !smooth) fill_normals(mesh);
        take_triangle_modifiers(build, corners, slots, mesh);
    }
    if (mesh.triangles.empty()) build.p.fail(at.place(), "a mesh needs triangles");
    if (at.accept("inside_vector"_w)) take_inside(at, mesh.inside_vector);
    if (!mesh.uvs.empty()) mesh.uvs[0].values.resize(mesh.positions.size(), uv_of(Vec3(0)));
    if (smooth_seen) flatten(mesh);
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
    if (parts.textures) {
        Cursor list(build, *parts.textures);
        const Announced announced(list);
        textures = take_textures(build, list, slots, false);
        announced.check(build, *parts.textures, textures.size());
    }
    take_faces(build, *parts.faces, textures, mesh);
    take_normals(build, parts, mesh, place);
    take_uvs(build, parts, mesh);
    mesh.inside_vector = parts.inside_vector;
    drop_exact_copies(mesh);
    return {std::move(mesh), slots.take()};
}

void map_triangles(Build& build, const Node& mesh, const Transform& before) {
    for (size_t slot = 1; slot < mesh.materials.size(); ++slot) {
        if (!mesh.materials[slot]) continue;
        TextureLayers& layers = build.scene.materials[mesh.materials[slot]->index].layers;   // the mesh's alone: a reference that says uv_mapping is built anew
        move_layers(build, layers, before);
        set_uv_mapped(build, layers, Bumps::stay);
    }
}

}  // namespace alidade::pov
