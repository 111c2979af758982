// SPDX-License-Identifier: Apache-2.0
#include "numerics/triangles/meshes.h"

#include "core/draws.h"

#include <fmt/format.h>

#include <array>
#include <map>
#include <unordered_map>

namespace alidade::numerics {

TriangleMesh::TriangleMesh(std::string mesh_name, std::vector<Vec3> mesh_vertices, std::vector<Index3> mesh_triangles, const Bounds& enclosed)
    : name(std::move(mesh_name)), vertices(std::move(mesh_vertices)), triangles(std::move(mesh_triangles)), inside(enclosed) {
    for (const Vec3& v : vertices) positions.emplace_back(v);
}

Bounds TriangleMesh::bounds() const {
    Bounds box;
    for (const Vec3& v : vertices) box.extend(v);
    return box;
}

TriangleMesh TriangleMesh::read_at(Precision precision) const {
    TriangleMesh mesh = *this;
    if (precision == Precision::float_)
        for (size_t i = 0; i < positions.size(); ++i) mesh.vertices[i] = Vec3(positions[i]);
    return mesh;
}

namespace {

Bounds box_around(const Vec3& center, double half) { return {center - Vec3(half), center + Vec3(half)}; }

/// The vertices of a cut icosahedron, each made once: a vertex is known by its integer weights on the corners of the icosahedron.
class GeodesicVertices {
  public:
    GeodesicVertices(int frequency, double bump) : frequency_(frequency), bump_(bump) {}

    uint32_t index(const Index3& face, const std::array<uint32_t, 3>& weights) {
        std::array<uint64_t, 3> terms{};
        for (int k = 0; k < 3; ++k) terms[k] = weights[k] ? uint64_t(weights[k]) << 4 | face[k] : 0;
        std::sort(terms.begin(), terms.end());
        const auto [entry, is_new] = known_.try_emplace(terms[0] << 40 | terms[1] << 20 | terms[2], uint32_t(vertices.size()));
        if (is_new) vertices.push_back(vertex(terms));
        return entry->second;
    }

    std::vector<Vec3> vertices;

  private:
    /// Summed in the order of `terms`, so that the faces of an edge agree on it.
    Vec3 vertex(const std::array<uint64_t, 3>& terms) const {
        static const double g = (1 + std::sqrt(5.0)) / 2;
        static const Vec3 corners[] = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                                       {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
        Vec3 sum(0);
        for (const uint64_t term : terms) sum += double(term >> 4) / frequency_ * corners[term & 15];
        const Vec3 n = normalized(sum);
        return n * (1 + bump_ * std::sin(7 * n.x) * std::sin(5 * n.y + 1) * std::sin(6 * n.z + 2));
    }

    int frequency_;
    double bump_;
    std::unordered_map<uint64_t, uint32_t> known_;
};

const Index3 kIcosahedron[] = {{0, 11, 5}, {0, 5, 1}, {0, 1, 7}, {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                               {3, 9, 4},  {3, 4, 2}, {3, 2, 6}, {3, 6, 8},  {3, 8, 9},   {4, 9, 5}, {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};

/// Joins meshes into one; the interior is the first one's.
TriangleMesh joined(std::string name, const std::vector<TriangleMesh>& parts) {
    std::vector<Vec3> vertices;
    std::vector<Index3> triangles;
    for (const TriangleMesh& part : parts) {
        for (const Index3& t : part.triangles) triangles.push_back(t + Index3(uint32_t(vertices.size())));
        vertices.insert(vertices.end(), part.vertices.begin(), part.vertices.end());
    }
    return {std::move(name), std::move(vertices), std::move(triangles), parts.front().inside};
}

}  // namespace

TriangleMesh geodesic_sphere(int frequency, double bump) {
    GeodesicVertices vertices(frequency, bump);
    std::vector<Index3> triangles;
    const uint32_t f = uint32_t(frequency);
    for (const Index3& face : kIcosahedron) {
        const auto vertex = [&](uint32_t i, uint32_t j) { return vertices.index(face, {i, j, f - i - j}); };
        for (uint32_t i = 0; i < f; ++i) {
            for (uint32_t j = 0; i + j < f; ++j) {
                triangles.emplace_back(vertex(i + 1, j), vertex(i, j + 1), vertex(i, j));
                if (i + j + 2 <= f) triangles.emplace_back(vertex(i, j + 1), vertex(i + 1, j), vertex(i + 1, j + 1));
            }
        }
    }
    return {fmt::format("geodesic_sphere({}, {})", frequency, bump), std::move(vertices.vertices), std::move(triangles), box_around(Vec3(0), 0.4)};
}

TriangleMesh cube(int n) {
    std::map<std::array<int, 3>, uint32_t> known;
    std::vector<Vec3> vertices;
    std::vector<Index3> triangles;
    const auto vertex = [&](int axis, int side, int i, int j) {
        std::array<int, 3> at{};
        at[axis] = side * n, at[(axis + 1) % 3] = i, at[(axis + 2) % 3] = j;
        const auto [entry, is_new] = known.try_emplace(at, uint32_t(vertices.size()));
        if (is_new) vertices.push_back(Vec3(at[0], at[1], at[2]) * (2.0 / n) - Vec3(1));
        return entry->second;
    };
    for (int axis = 0; axis < 3; ++axis) {
        for (int cell = 0; cell < 2 * n * n; ++cell) {
            const int side = cell % 2, i = cell / 2 / n, j = cell / 2 % n;
            Index3 first(vertex(axis, side, i, j), vertex(axis, side, i + 1, j), vertex(axis, side, i + 1, j + 1));
            Index3 second(first.x, first.z, vertex(axis, side, i, j + 1));
            if (side == 0) std::swap(first.y, first.z), std::swap(second.y, second.z);  // the normal points outwards
            triangles.push_back(first), triangles.push_back(second);
        }
    }
    return {fmt::format("cube({})", n), std::move(vertices), std::move(triangles), box_around(Vec3(0), 0.5)};
}

TriangleMesh torus(int around, int across) {
    std::vector<Vec3> vertices;
    std::vector<Index3> triangles;
    const auto vertex = [&](int i, int j) { return uint32_t((i % around) * across + j % across); };
    for (int i = 0; i < around; ++i) {
        for (int j = 0; j < across; ++j) {
            const double a = 2 * kPi * i / around, b = 2 * kPi * j / across, r = 1 + 0.25 * std::cos(b);
            vertices.emplace_back(r * std::cos(a), r * std::sin(a), 0.25 * std::sin(b));
            triangles.emplace_back(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
            triangles.emplace_back(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
        }
    }
    return {fmt::format("torus({}, {})", around, across), std::move(vertices), std::move(triangles), box_around({1, 0, 0}, 0.05)};
}

TriangleMesh tetrahedra(int count, uint64_t seed) {
    Draws draws(RandomKey(seed, 0, 0, 0));
    std::vector<TriangleMesh> parts;
    for (int i = 0; i < count; ++i) {
        Vec3 x(0), y(0);
        const Vec3 z = draws.direction(), center = draws.in_box(Vec3(-0.8), Vec3(0.8));
        orthonormal_basis(z, x, y);
        std::vector<Vec3> vertices{x + y + z, x - y - z, y - x - z, z - x - y};
        for (Vec3& v : vertices) v = center + 0.15 * v;
        parts.emplace_back("", vertices, std::vector<Index3>{{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}, box_around(center, 0.04));
    }
    return joined(fmt::format("tetrahedra({}, {})", count, seed), parts);
}

TriangleMesh cube_lattice(int nx, int ny, int nz) {
    std::vector<TriangleMesh> parts;
    for (int i = 0; i < nx * ny * nz; ++i) parts.push_back(moved(cube(1), Vec3(0.5), Vec3(i % nx, i / nx % ny, i / nx / ny) + Vec3(0.5), ""));
    return joined(fmt::format("cube_lattice({}, {}, {})", nx, ny, nz), parts);
}

TriangleMesh soup(int count, double size, uint64_t seed) {
    Draws draws(RandomKey(seed, 0, 0, 0));
    std::vector<Vec3> vertices;
    std::vector<Index3> triangles;
    for (uint32_t i = 0; i < uint32_t(count); ++i) {
        const Vec3 center = draws.in_box(Vec3(-1), Vec3(1));
        for (int k = 0; k < 3; ++k) vertices.push_back(center + draws.in_box(Vec3(-size), Vec3(size)));
        triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    return {fmt::format("soup({}, {}, {})", count, size, seed), std::move(vertices), std::move(triangles)};
}

TriangleMesh wild_soup(int count, uint64_t seed) {
    Draws draws(RandomKey(seed, 0, 0, 0));
    std::vector<Vec3> vertices;
    std::vector<Index3> triangles;
    for (uint32_t i = 0; i < uint32_t(count); ++i) {
        for (int k = 0; k < 3; ++k) {
            const double size = std::pow(10.0, draws.uniform(-45, 38));   // drawn first, whatever the compiler
            vertices.push_back(draws.in_box(Vec3(-1), Vec3(1)) * size);
        }
        triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    return {fmt::format("wild_soup({}, {})", count, seed), std::move(vertices), std::move(triangles)};
}

TriangleMesh slivers(int count, double width, uint64_t seed) {
    Draws draws(RandomKey(seed, 0, 0, 0));
    std::vector<Vec3> vertices;
    std::vector<Index3> triangles;
    for (uint32_t i = 0; i < uint32_t(count); ++i) {
        const Vec3 from = draws.in_box(Vec3(-1), Vec3(1)), to = draws.in_box(Vec3(-1), Vec3(1));
        vertices.insert(vertices.end(), {from, to, from + width * draws.direction()});
        triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    return {fmt::format("slivers({}, {}, {})", count, width, seed), std::move(vertices), std::move(triangles)};
}

TriangleMesh battens(int count) {
    std::vector<Vec3> vertices;
    std::vector<Index3> triangles;
    const Vec3 along = normalized(Vec3(2, 1, 0.4)), up = normalized(cross(along, Vec3(0.2, -1, 1))), out = cross(along, up);
    for (int i = 0; i < count; ++i) {
        for (const int side : {0, 1}) {
            const Vec3 at = (0.6 * i / count) * up + (0.1 * side) * out, wide = (0.3 / count) * (side ? out : up);
            const auto first = uint32_t(vertices.size());
            vertices.insert(vertices.end(), {at, at + along, at + along + wide, at + wide});
            triangles.emplace_back(first, first + 1, first + 2), triangles.emplace_back(first, first + 2, first + 3);
        }
    }
    return {fmt::format("battens({})", count), std::move(vertices), std::move(triangles)};
}

TriangleMesh stadium(int inner_frequency, int outer_frequency) {
    return joined(fmt::format("stadium({}, {})", inner_frequency, outer_frequency),
                  {scaled(geodesic_sphere(inner_frequency), 1e-3), geodesic_sphere(outer_frequency)});
}

TriangleMesh moved(const TriangleMesh& mesh, const Vec3& scale, const Vec3& offset, const std::string& name) {
    std::vector<Vec3> vertices = mesh.vertices;
    for (Vec3& v : vertices) v = scale * v + offset;
    return {name, std::move(vertices), mesh.triangles, {scale * mesh.inside.min + offset, scale * mesh.inside.max + offset}};
}

TriangleMesh scaled(const TriangleMesh& mesh, double scale) { return moved(mesh, Vec3(scale), Vec3(0), fmt::format("{} * {}", mesh.name, scale)); }

TriangleMesh turned(const TriangleMesh& mesh, const std::string& name) {
    const Vec3 x = normalized(Vec3(2, 1, 0.4)), y = normalized(cross(x, Vec3(0.2, -1, 1))), z = cross(x, y);
    std::vector<Vec3> vertices = mesh.vertices;
    for (Vec3& v : vertices) v = v.x * x + v.y * y + v.z * z;
    return {name, std::move(vertices), mesh.triangles, box_around(Vec3(0), 0.5 * std::min({mesh.inside.max.x, mesh.inside.max.y, mesh.inside.max.z}))};
}

std::vector<TriangleMesh> small_meshes() {
    const TriangleMesh sphere = geodesic_sphere(4);
    return {sphere,
            cube(5),
            torus(16, 10),
            tetrahedra(60, 1),
            cube_lattice(2, 3, 4),
            soup(300, 0.3, 2),
            stadium(3, 2),
            wild_soup(12, 4),
            slivers(200, 1e-4, 3),
            battens(80),
            moved(battens(40), Vec3(1), Vec3(1e5), "battens + 1e5"),
            moved(sphere, Vec3(1, 1, 1e-6), Vec3(0), "flat sphere"),
            moved(sphere, Vec3(1e4, 1, 1), Vec3(0), "needle sphere"),
            moved(sphere, Vec3(1), Vec3(1e3, -7e2, 3e2), "sphere + 1e3")};
}

const std::vector<TriangleMesh>& closed_meshes() {
    static const TriangleMesh sphere = geodesic_sphere(16);
    static const std::vector<TriangleMesh> meshes{sphere,
                                          cube(32),
                                          torus(80, 32),
                                          moved(sphere, Vec3(1), Vec3(1e3), "sphere + 1e3"),
                                          moved(sphere, Vec3(1), Vec3(1e5), "sphere + 1e5"),
                                          moved(sphere, Vec3(1), Vec3(1e6), "sphere + 1e6"),
                                          moved(sphere, Vec3(1, 1, 1e-6), Vec3(0), "flat sphere"),
                                          moved(sphere, Vec3(1e4, 1, 1), Vec3(0), "needle sphere"),
                                          turned(moved(sphere, Vec3(1e2, 1, 1e-2), Vec3(0), ""), "blade askew"),
                                          scaled(sphere, 1e-15),
                                          scaled(sphere, 1e15)};
    return meshes;
}

bool is_closed(const TriangleMesh& mesh) {
    std::map<std::pair<uint32_t, uint32_t>, int> uses;
    for (const Index3& t : mesh.triangles)
        for (int k = 0; k < 3; ++k) ++uses[{t[k], t[(k + 1) % 3]}];
    return std::all_of(uses.begin(), uses.end(), [&](const auto& use) {
        const auto opposite = uses.find({use.first.second, use.first.first});
        return use.second == 1 && opposite != uses.end() && opposite->second == 1;
    });
}

}  // namespace alidade::numerics
