// SPDX-License-Identifier: Apache-2.0
#include "exporters/mesh/obj.h"

#include "core/image.h"
#include "exporters/mesh/mtl.h"
#include "exporters/numbers.h"
#include "exporters/vertices.h"
#include "exporters/world_meshes.h"

namespace alidade {

namespace {

constexpr uint32_t kUnused = ~uint32_t(0);

/// Numbers the elements of one array in the order of their first use, going on from object to object.
class Numbering {
  public:
    void begin(size_t count) { numbers_.assign(count, kUnused); }
    /// The number from 1 of element `i`; `first_use(i)` is called where it has none yet.
    template <class F> uint64_t of(uint32_t i, const F& first_use) {
        if (numbers_[i] == kUnused) first_use(i), numbers_[i] = used_++;
        return uint64_t(numbers_[i]) + 1;
    }

  private:
    std::vector<uint32_t> numbers_;
    uint32_t used_ = 0;
};

class ObjWriter {
  public:
    ObjWriter(const Scene& scene, OutputFiles& files, Losses& losses) : library_(scene, files, losses), losses_(losses) {}

    tl::expected<void, std::string> write(const std::vector<WorldMesh>& meshes) {
        floats_ = floats_suffice(meshes);
        for (const WorldMesh& m : meshes) {
            add_object(m);
            // Indices are signed 32-bit numbers for most readers.
            if (vertices_ > size_t(INT32_MAX)) return tl::unexpected(std::string("the scene has more vertices than OBJ can number"));
        }
        return {};
    }

    std::string text(const std::string& library) const { return library.empty() ? text_ : "mtllib " + library + "\n" + text_; }
    std::string library() const { return library_.text(); }

  private:
    void add_object(const WorldMesh& m) {
        const Mesh& mesh = *m.mesh;
        const std::string name = names_.make(m.name, "object");
        losses_.add("characters in names that could break a line or a path", name != m.name && !m.name.empty() && plain_name(m.name, "") != m.name, "_");
        text_ += "o " + name + "\n";
        const std::vector<uint32_t> points = colored_positions(m);
        of_positions_.begin(points.empty() ? 0 : *std::max_element(points.begin(), points.end()) + size_t(1));
        of_uvs_.begin(has_uv(mesh) ? mesh.uvs[0].values.size() : 0);
        of_normals_.begin(mesh.normals.values.size());
        faces_.clear();
        const uint32_t slots = uint32_t(m.materials.size());
        for (uint32_t slot = 0; slot < slots; ++slot) add_slot(m, points, slot);
        text_ += faces_;
    }

    static bool has_uv(const Mesh& mesh) { return !mesh.uvs.empty() && mesh.uvs[0].present(); }
    static bool has_color(const Mesh& mesh) { return !mesh.colors.empty() && mesh.colors[0].present(); }

    /// For each corner of m.finite the number of what its `v` line says: its position, and its colour.
    static std::vector<uint32_t> colored_positions(const WorldMesh& m) {
        const Mesh& mesh = *m.mesh;
        std::vector<uint32_t> points, colors;
        const bool paired = has_color(mesh) && !mesh.colors[0].corners.empty();
        for (const uint32_t t : m.finite)
            for (int c = 0; c < 3; ++c) {
                points.push_back(mesh.triangles[t][c]);
                if (paired) colors.push_back(mesh.colors[0].index(t, c, mesh.triangles[t]));
            }
        if (paired) number_pairs(points, colors);
        return points;
    }

    void add_slot(const WorldMesh& m, const std::vector<uint32_t>& points, uint32_t slot) {
        const Mesh& mesh = *m.mesh;
        bool any = false;
        for (size_t i = 0; i < m.finite.size(); ++i) {
            const uint32_t t = m.finite[i];
            if (!mesh.slots.empty() && mesh.slots[t] != slot) continue;
            if (!any) faces_ += "usemtl " + library_.name(m.materials[slot]) + "\n";
            any = true;
            faces_ += 'f';
            const Index3 order = m.order();
            for (int k = 0; k < 3; ++k) add_corner(m, t, int(order[k]), points[3 * i + order[k]]);
            faces_ += '\n';
        }
    }

    void add_corner(const WorldMesh& m, uint32_t t, int corner, uint32_t point) {
        const Mesh& mesh = *m.mesh;
        const Index3& v = mesh.triangles[t];
        const auto position = [&](uint32_t) { add_position(m, t, corner); };
        faces_ += ' ';
        append_number(faces_, of_positions_.of(point, position));
        const bool uv = has_uv(mesh), normal = mesh.normals.present();
        if (uv || normal) faces_ += '/';
        if (uv) append_number(faces_, of_uvs_.of(mesh.uvs[0].index(t, corner, v), [&](uint32_t i) { add_uv(mesh.uvs[0].values[i]); }));
        if (!normal) return;
        faces_ += '/';
        append_number(faces_, of_normals_.of(mesh.normals.index(t, corner, v), [&](uint32_t i) { add_normal(m.normal(mesh.normals.values[i])); }));
    }

    void add_position(const WorldMesh& m, uint32_t t, int corner) {
        const Mesh& mesh = *m.mesh;
        const Vec3 p = m.position(mesh.triangles[t][corner]);
        ++vertices_;
        text_ += 'v';
        if (floats_) append_numbers(text_, float(p.x), float(p.y), float(p.z));
        else append_numbers(text_, p.x, p.y, p.z);
        if (has_color(mesh)) add_color(mesh.colors[0].values[mesh.colors[0].index(t, corner, mesh.triangles[t])]);
        text_ += '\n';
    }

    void add_color(const Vec4f& linear) {
        if (linear.w != 1) losses_.add("opacity of vertex colours", !alpha_told_, "opaque"), alpha_told_ = true;
        for (int c = 0; c < 3; ++c) append_numbers(text_, std::isfinite(linear[c]) ? linear_to_srgb(double(linear[c])) : 1.0);
    }

    /// v grows upwards here. Of two numbers that read back alike the shorter is written.
    void add_uv(const Vec2f& uv) {
        const bool finite = std::isfinite(uv.x) && std::isfinite(uv.y);
        const double v = finite ? 1 - double(uv.y) : 0;
        std::string digits;
        append_number(digits, float(v));
        double back = 0;
        std::from_chars(digits.data(), digits.data() + digits.size(), back);
        if (float(1 - back) != uv.y) digits.clear(), append_number(digits, v);
        text_ += "vt";
        append_numbers(text_, finite ? uv.x : 0.0f);
        text_ += ' ' + digits + '\n';
    }

    void add_normal(const Vec3& n) {
        text_ += "vn";
        append_numbers(text_, float(n.x), float(n.y), float(n.z));
        text_ += '\n';
    }

    MtlLibrary library_;
    Losses& losses_;
    UniqueNames names_;
    Numbering of_positions_, of_uvs_, of_normals_;
    std::string text_, faces_;
    size_t vertices_ = 0;
    bool floats_ = false, alpha_told_ = false;
};

}  // namespace

tl::expected<void, std::string> write_obj(const Scene& scene, OutputFiles& files, Losses& losses) {
    const auto meshes = world_meshes(scene, losses);
    if (!meshes) return tl::unexpected(meshes.error());
    if (meshes->empty()) return tl::unexpected(std::string("no mesh is left to write, and OBJ holds nothing else"));
    ObjWriter writer(scene, files, losses);
    if (const auto done = writer.write(*meshes); !done) return done;
    files.set_main(writer.text(files.add_companion(".mtl", writer.library())));
    return {};
}

}  // namespace alidade
