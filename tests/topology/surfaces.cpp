// SPDX-License-Identifier: Apache-2.0
#include "tests/topology/surfaces.h"

#include <filesystem>

namespace alidade {

Mesh cube(const Vec3& by) {
    std::vector<Vec3> points;
    for (int i = 0; i < 8; ++i) points.push_back(by + Vec3(i & 1, i >> 1 & 1, i >> 2));
    return mesh_from(points, {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4}, {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}});
}

Mesh octahedron() {
    return mesh_from({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                     {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}});
}

Mesh grid(int columns, int rows, const std::function<Vec3(double, double)>& at, bool with_uv) {
    Mesh mesh;
    Attribute<Vec2f> uv;
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i) {
            mesh.positions.emplace_back(at(double(i) / columns, double(j) / rows));
            uv.values.emplace_back(float(i) / float(columns), float(j) / float(rows));
        }
    const auto index = [&](int i, int j) { return uint32_t(j * (columns + 1) + i); };
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            mesh.triangles.emplace_back(index(i, j), index(i + 1, j), index(i + 1, j + 1));
            mesh.triangles.emplace_back(index(i, j), index(i + 1, j + 1), index(i, j + 1));
        }
    if (with_uv) mesh.uvs.push_back(uv);
    return mesh;
}

namespace {

/// Sine and cosine of a whole turn times u, the same for u = 0 and u = 1.
double turn_sin(double u) { return u == 1 ? 0 : std::sin(2 * kPi * u); }
double turn_cos(double u) { return u == 1 ? 1 : std::cos(2 * kPi * u); }

}  // namespace

Mesh torus(int around, int across) {
    return grid(around, across, [](double u, double v) {
        const double r = 2 + turn_cos(v);
        return Vec3(r * turn_cos(u), r * turn_sin(u), turn_sin(v));
    });
}

Mesh sphere(int around, int rows, int left_out) {
    Mesh mesh = grid(around, rows, [](double u, double v) {
        const double r = v == 0 || v == 1 ? 0 : std::sin(kPi * v);
        return Vec3(r * turn_cos(u), r * turn_sin(u), -std::cos(kPi * v));
    });
    mesh.triangles.resize(mesh.triangles.size() - size_t(2 * around * left_out));
    return mesh;
}

Mesh moebius(int around) {
    Mesh mesh = grid(around, 1, [](double u, double v) {
        const double across = v - 0.5, half = kPi * u, r = 2 + across * std::cos(half);
        return Vec3(r * turn_cos(u), r * turn_sin(u), across * std::sin(half));
    });
    const uint32_t last = uint32_t(around);   // the end of the band is its beginning, turned round: sine and cosine alone do not meet exactly
    mesh.positions[last] = mesh.positions[last + 1];
    mesh.positions[2 * last + 1] = mesh.positions[0];
    return mesh;
}

Mesh together(const Mesh& a, const Mesh& b) {
    Mesh both = a;
    const uint32_t shift = uint32_t(a.positions.size());
    both.positions.insert(both.positions.end(), b.positions.begin(), b.positions.end());
    for (const Index3& t : b.triangles) both.triangles.push_back(t + Index3(shift));
    return both;
}

Mesh soup(const Mesh& mesh) {
    Mesh out;
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (int k = 0; k < 3; ++k) out.positions.push_back(mesh.positions[mesh.triangles[t][k]]);
        const uint32_t first = uint32_t(3 * t);
        out.triangles.emplace_back(first, first + 1, first + 2);
    }
    return out;
}

Mesh mess(uint32_t seed, int vertices, int triangles) {
    std::mt19937 random(seed);
    const auto below = [&](int n) { return uint32_t(random() % uint32_t(n)); };
    std::vector<Vec3> points;
    for (int i = 0; i < vertices; ++i) points.emplace_back(below(3), below(3), below(3));
    std::vector<Index3> indices;
    for (int i = 0; i < triangles; ++i) indices.emplace_back(below(vertices), below(vertices), below(vertices));
    return mesh_from(points, indices);
}

size_t for_each_mesh_file(size_t most_bytes, const std::function<void(const std::string&, const Mesh&)>& body) {
    namespace fs = std::filesystem;
    size_t meshes = 0;
    for (const char* folder : {ASSETS, SHARED_DATA}) {
        if (!fs::exists(folder)) continue;
        std::vector<fs::path> paths;
        for (const auto& entry : fs::recursive_directory_iterator(folder))
            if (entry.is_regular_file() && entry.file_size() <= most_bytes) paths.push_back(entry.path());
        std::sort(paths.begin(), paths.end());
        for (const fs::path& path : paths) {
            const std::string ending = path.extension().string();
            const auto knows = [&](const ImporterEntry& e) { return (std::string(e.extensions) + " ").find(ending + " ") != std::string::npos; };
            if (ending.empty() || std::none_of(importers().begin(), importers().end(), knows)) continue;
            const auto imported = import_scene(path.string());
            if (!imported) continue;
            for (const ShapeEntry& shape : imported->scene.shapes)
                if (const auto* mesh = std::get_if<Mesh>(&shape.geometry)) body(path.string() + " " + shape.name, *mesh), ++meshes;
        }
    }
    return meshes;
}

}  // namespace alidade
