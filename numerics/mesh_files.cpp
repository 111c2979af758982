// SPDX-License-Identifier: Apache-2.0
/// Meshes with the largest and the smallest coordinates that there are, written to files and read again.
#include "core/draws.h"
#include "exporters/exporter.h"
#include "importers/importer.h"
#include "numerics/rows.h"
#include "numerics/scene_maker.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <sstream>
#include <unistd.h>

namespace alidade::numerics {

namespace {

namespace fs = std::filesystem;

/// A folder that is there as long as this is.
class Folder {
  public:
    explicit Folder(uint64_t number) : path_(fs::temp_directory_path() / fmt::format("alidade-numerics-{}-{}", getpid(), number)) { fs::create_directories(path_); }
    ~Folder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    std::string file(const std::string& name) const { return (path_ / name).string(); }

  private:
    fs::path path_;
};

std::vector<std::string> endings() {
    std::vector<std::string> out;
    for (const ExporterEntry& entry : exporters()) {
        std::istringstream words(entry.extensions);
        for (std::string word; words >> word;) out.push_back(word);
    }
    return out;
}

/// Coordinates of a class: near 1, surveyed (1e7), denormal, as large as float goes, or of any size.
float coordinate(Draws& draws, uint32_t kind) {
    switch (kind) {
        case 0: return float(draws.uniform(-1, 1));
        case 1: return float(1e7 + draws.uniform(-100, 100));
        case 2: return float(draws.uniform(-1, 1) * 1e-40);
        case 3: return float(draws.sign() * draws.uniform(1e38, 3.4e38));
        default: return draws.below(8) == 0 ? 0.0f : float(draws.sign() * std::pow(10, draws.uniform(-44, 38)));
    }
}

/// A fan none of whose triangles has two corners at one place (OBJ leaves those out, with a warning), thin as a needle or not, now and then with more vertices than 16 bits can number, and with normals that may be as short as they can be.
Mesh extreme_mesh(Draws& draws) {
    Mesh mesh;
    const uint32_t kind = draws.below(5), count = draws.below(64) == 0 ? 66000 : 3 + draws.below(20);
    for (uint32_t i = 0; i < count; ++i) {
        Vec3f p;
        do
            for (int k = 0; k < 3; ++k) p[k] = coordinate(draws, kind);
        while (i > 0 && (p == mesh.positions.front() || p == mesh.positions.back()));
        mesh.positions.push_back(p);
    }
    for (uint32_t i = 2; i < count; ++i) mesh.triangles.emplace_back(0, i - 1, i);
    if (draws.coin())
        for (uint32_t i = 0; i < count; ++i) mesh.normals.values.emplace_back(Vec3f(draws.direction() * (draws.coin() ? 1 : 1e-38)));
    return mesh;
}

struct Corner {
    std::array<float, 3> position;
    Vec3 normal;   ///< unit; 0: none
};
using Corners = std::array<Corner, 3>;

std::array<float, 9> positions(const Corners& t) {
    std::array<float, 9> all{};
    for (size_t k = 0; k < 9; ++k) all[k] = t[k / 3].position[k % 3];
    return all;
}

Corners corners(const Mesh& mesh, size_t triangle, const Transform& place) {
    Corners out;
    for (int k = 0; k < 3; ++k) {
        const uint32_t vertex = mesh.triangles[triangle][k];
        const Vec3 p = place.point(mesh.origin + Vec3(mesh.positions[vertex]));
        out[size_t(k)] = {{float(p.x), float(p.y), float(p.z)}, Vec3(0)};
        if (mesh.normals.values.empty()) continue;
        const uint32_t normal = mesh.normals.corners.empty() ? vertex : mesh.normals.corners[3 * triangle + size_t(k)];
        const auto back = inverse(place);
        if (back) out[size_t(k)].normal = normalized(back->transposed(Vec3(mesh.normals.values[normal])));
    }
    return out;
}

/// All triangles of a scene where they stand, as floats.
void gather(const Scene& scene, NodeId id, const Transform& above, std::vector<Corners>& out) {
    const Node& node = scene.nodes[id.index];
    const Transform place = above * node.to_parent;
    if (const auto* shape = std::get_if<ShapeId>(&node.what))
        if (const auto* mesh = std::get_if<Mesh>(&scene.shapes[shape->index].geometry))
            for (size_t i = 0; i < mesh->triangles.size(); ++i) out.push_back(corners(*mesh, i, place));
    for (const NodeId child : node.children) gather(scene, child, place, out);
}

std::vector<Corners> triangles(const Scene& scene) {
    std::vector<Corners> out;
    for (const NodeId root : scene.roots) gather(scene, root, {}, out);
    std::stable_sort(out.begin(), out.end(), [](const Corners& a, const Corners& b) { return positions(a) < positions(b); });
    return out;
}

/// Bits of positions; normals, which files hold as unit vectors, as float tells directions apart. Empty if nothing differs.
std::string difference(const std::vector<Corners>& want, const std::vector<Corners>& got) {
    if (want.size() != got.size()) return fmt::format("{} triangles of {}", got.size(), want.size());
    for (size_t i = 0; i < want.size(); ++i) {
        const auto a = positions(want[i]), b = positions(got[i]);
        for (size_t k = 0; k < 9; ++k)
            if (std::bit_cast<uint32_t>(a[k]) != std::bit_cast<uint32_t>(b[k])) return fmt::format("{} became {}", a[k], b[k]);
        for (size_t k = 0; k < 3; ++k)
            if (const Vec3 n = want[i][k].normal, m = got[i][k].normal; !(length(n - m) < 3e-7)) return fmt::format("the normal <{}, {}, {}> became <{}, {}, {}>", n.x, n.y, n.z, m.x, m.y, m.z);
    }
    return "";
}

std::string read_back(const Scene& scene, const std::string& path) {
    const auto read = import_scene(path);
    if (!read) return "written, but not read: " + read.error().text();
    const std::string lost = difference(triangles(scene), triangles(read->scene));
    return lost.empty() ? "" : lost + "; " + read->diagnostics.text();
}

/// What the file does not hold; empty if it holds all.
std::string round_trip(const Scene& scene, const std::string& path) {
    const auto written = export_scene(scene, path);
    if (!written) return "not written: " + written.error();
    return read_back(scene, path);
}

/// No exporter writes strips and fans, which index what is there in 32 bits, nor normals that are no unit vectors: the fan by hand, as one.
std::string fan_trip(const Scene& scene, const Folder& folder) {
    const auto& mesh = std::get<Mesh>(scene.shapes[0].geometry);
    std::string bytes;
    const auto append = [&bytes](const auto& values) { bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values[0])); };
    std::vector<uint32_t> indices(mesh.positions.size());
    std::iota(indices.begin(), indices.end(), 0u);
    append(indices), append(mesh.positions), append(mesh.normals.values);
    const size_t n = indices.size(), vectors = 12 * n;
    const bool normals = !mesh.normals.values.empty();
    const BoundsT<float> box = std::accumulate(mesh.positions.begin(), mesh.positions.end(), BoundsT<float>(), [](BoundsT<float> sum, const Vec3f& p) { return sum.extend(p), sum; });
    const std::string json = fmt::format(R"({{"asset": {{"version": "2.0"}}, "scene": 0, "scenes": [{{"nodes": [0]}}], "nodes": [{{"mesh": 0}}],
        "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 1{}}}, "indices": 0, "mode": 6}}]}}], "buffers": [{{"byteLength": {}, "uri": "fan.bin"}}],
        "bufferViews": [{{"buffer": 0, "byteLength": {}}}, {{"buffer": 0, "byteOffset": {}, "byteLength": {}}}{}],
        "accessors": [{{"bufferView": 0, "componentType": 5125, "count": {}, "type": "SCALAR"}},
                      {{"bufferView": 1, "componentType": 5126, "count": {}, "type": "VEC3", "min": [{}, {}, {}], "max": [{}, {}, {}]}}{}]}})",
                                         normals ? R"(, "NORMAL": 2)" : "", bytes.size(), 4 * n, 4 * n, vectors, normals ? fmt::format(R"(, {{"buffer": 0, "byteOffset": {}, "byteLength": {}}})", 4 * n + vectors, vectors) : "", n,
                                         n, box.min.x, box.min.y, box.min.z, box.max.x, box.max.y, box.max.z, normals ? fmt::format(R"(, {{"bufferView": 2, "componentType": 5126, "count": {}, "type": "VEC3"}})", n) : "");
    std::ofstream(folder.file("fan.bin"), std::ios::binary) << bytes;
    std::ofstream(folder.file("fan.gltf")) << json;
    return read_back(scene, folder.file("fan.gltf"));
}

}  // namespace

Check mesh_files() {
    return [](uint64_t number, NumericsTally& tally) {
        static const std::vector<std::string> all = endings();
        Draws draws(RandomKey(26, 0, number));
        const bool fan = number % (all.size() + 1) == all.size();
        Mesh mesh = extreme_mesh(draws);
        if (fan)
            for (Index3& t : mesh.triangles) t = {t[1], t[2], t[0]};   // specification, 3.7.2.1: a fan's triangles are (i + 1, i + 2, 0)
        SceneMaker maker;
        maker.object(std::move(mesh), maker.unlit(Color(1)));
        const Folder folder(number);
        const std::string ending = fan ? "a fan in .gltf" : all[number % (all.size() + 1)];
        const std::string wrong = fan ? fan_trip(maker.scene, folder) : round_trip(maker.scene, folder.file("mesh" + ending));
        tally.decide(wrong.empty(), [&] { return ending + ": " + wrong; });
    };
}

}  // namespace alidade::numerics
