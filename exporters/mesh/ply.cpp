// SPDX-License-Identifier: Apache-2.0
#include "exporters/mesh/ply.h"

#include "exporters/vertices.h"
#include "exporters/world_meshes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>

namespace alidade {

namespace {

/// How the properties of a vertex are stored.
struct Layout {
    bool double_positions = false, normals = false, uvs = false, double_v = false, colors = false, byte_colors = true;
};

bool has_uv(const Mesh& mesh) { return !mesh.uvs.empty() && mesh.uvs[0].present(); }
bool has_color(const Mesh& mesh) { return !mesh.colors.empty() && mesh.colors[0].present(); }

bool is_byte(const Vec4f& c) {
    const double alpha = std::round(double(c.w) * 255);
    return srgb_byte(c.x) >= 0 && srgb_byte(c.y) >= 0 && srgb_byte(c.z) >= 0 && alpha >= 0 && alpha <= 255 && float(alpha / 255) == c.w;
}

Layout choose_layout(const std::vector<WorldMesh>& meshes) {
    Layout out;
    out.double_positions = !floats_suffice(meshes);
    for (const WorldMesh& m : meshes) {
        const Mesh& mesh = *m.mesh;
        out.normals = out.normals || mesh.normals.present();
        out.uvs = out.uvs || has_uv(mesh);
        out.colors = out.colors || has_color(mesh);
        if (has_uv(mesh))   // v grows upwards in PLY, and 1 - v may have more digits than a float
            for (const Vec2f& uv : mesh.uvs[0].values) out.double_v = out.double_v || float(1 - double(float(1 - double(uv.y)))) != uv.y;
        if (has_color(mesh)) out.byte_colors = out.byte_colors && std::all_of(mesh.colors[0].values.begin(), mesh.colors[0].values.end(), is_byte);
    }
    return out;
}

std::string header(const Layout& layout, size_t vertices, size_t triangles) {
    std::string out = fmt::format("ply\nformat binary_little_endian 1.0\nelement vertex {}\n", vertices);
    const auto add = [&](const char* type, std::initializer_list<const char*> names) {
        for (const char* name : names) out += fmt::format("property {} {}\n", type, name);
    };
    add(layout.double_positions ? "double" : "float", {"x", "y", "z"});
    if (layout.normals) add("float", {"nx", "ny", "nz"});
    if (layout.uvs) add("float", {"u"}), add(layout.double_v ? "double" : "float", {"v"});
    if (layout.colors) add(layout.byte_colors ? "uchar" : "float", {"red", "green", "blue", "alpha"});
    return out + fmt::format("element face {}\nproperty list uchar uint vertex_indices\nend_header\n", triangles);
}

class PlyWriter {
  public:
    explicit PlyWriter(const Layout& layout) : layout_(layout) {}

    void add(const WorldMesh& m) {
        const Vertices vertices = collect(m);
        const Mesh& mesh = *m.mesh;
        for (size_t v = 0; v < vertices.size(); ++v) {
            put_position(m.position(vertices.positions[v]));
            if (layout_.normals) put_normal(m, vertices, v);
            if (layout_.uvs) put_uv(has_uv(mesh) ? vertices.value(mesh.uvs[0], v) : Vec2f(0, 1));
            if (layout_.colors) put_color(has_color(mesh) ? vertices.value(mesh.colors[0], v) : Vec4f(1));
        }
        const Index3 order = m.order();
        for (const Index3& t : vertices.triangles) faces_.push_back(Index3(t[int(order.x)], t[int(order.y)], t[int(order.z)]) + uint32_t(vertices_));
        vertices_ += vertices.size();
    }

    size_t vertices() const { return vertices_; }

    std::string file() {
        std::string out = header(layout_, vertices_, faces_.size());
        out += body_;
        body_.swap(out);
        for (const Index3& t : faces_) put<uint8_t>(3), put(t.x), put(t.y), put(t.z);
        return std::move(body_);
    }

  private:
    /// Of a mesh that gets the normals of its triangles, no two triangles share a vertex.
    Vertices collect(const WorldMesh& m) {
        if (!layout_.normals || m.mesh->normals.present()) return collect_vertices(*m.mesh, m.finite);
        Vertices out;
        for (const uint32_t t : m.finite) {
            const auto first = uint32_t(out.positions.size());
            for (int c = 0; c < 3; ++c) out.positions.push_back(m.mesh->triangles[t][c]), out.corners.push_back(3 * t + uint32_t(c));
            out.triangles.emplace_back(first, first + 1, first + 2);
        }
        return out;
    }

    /// Little-endian, as the header says.
    template <class T> void put(T value) {
        std::array<char, sizeof(T)> bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
        if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
        body_.append(bytes.data(), bytes.size());
    }

    void put_position(const Vec3& p) {
        for (int c = 0; c < 3; ++c) {
            const double x = std::isfinite(p[c]) ? p[c] : 0;   // of a vertex that no written triangle has
            if (layout_.double_positions) put(x);
            else put(float(x));
        }
    }

    void put_normal(const WorldMesh& m, const Vertices& vertices, size_t v) {
        Vec3 n(0);
        if (m.mesh->normals.present()) {
            n = m.normal(vertices.value(m.mesh->normals, v));
        } else {
            const Index3 order = m.order(), t = m.mesh->triangles[vertices.corners[v] / 3];
            const Vec3 a = m.position(t[int(order.x)]), b = m.position(t[int(order.y)]), c = m.position(t[int(order.z)]);
            n = normalized(cross(b - a, c - a));
        }
        for (int c = 0; c < 3; ++c) put(is_finite(n) ? float(n[c]) : 0.0f);
    }

    void put_uv(const Vec2f& uv) {
        const bool finite = std::isfinite(uv.x) && std::isfinite(uv.y);
        const double v = finite ? 1 - double(uv.y) : 0;
        put(finite ? uv.x : 0.0f);
        if (layout_.double_v) put(v);
        else put(float(v));
    }

    void put_color(const Vec4f& c) {
        for (int i = 0; i < 4; ++i) {
            if (!layout_.byte_colors) put(std::isfinite(c[i]) ? c[i] : 1.0f);
            else put(uint8_t(i < 3 ? srgb_byte(c[i]) : std::lround(double(c.w) * 255)));
        }
    }

    Layout layout_;
    std::string body_;
    std::vector<Index3> faces_;
    size_t vertices_ = 0;
};

}  // namespace

tl::expected<void, std::string> write_ply(const Scene& scene, OutputFiles& files, Losses& losses) {
    const auto meshes = world_meshes(scene, losses);
    if (!meshes) return tl::unexpected(meshes.error());
    if (meshes->empty()) return tl::unexpected(std::string("no mesh is left to write, and PLY holds nothing else"));
    losses.add("materials", scene.materials.size());
    losses.add("pictures", scene.images.size());
    losses.add("meshes of their own", meshes->size() - 1, "one mesh");
    PlyWriter writer(choose_layout(*meshes));
    for (const WorldMesh& m : *meshes) {
        writer.add(m);
        if (writer.vertices() > size_t(INT32_MAX)) return tl::unexpected(std::string("the scene has more vertices than PLY readers can number"));
    }
    files.set_main(writer.file());
    return {};
}

}  // namespace alidade
