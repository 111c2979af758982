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
#include <filesystem>
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

/// A fan, thin as a needle or not, now and then with more vertices than 16 bits can number, and with normals that may be as short as they can be.
Mesh extreme_mesh(uint64_t number, Draws& draws) {
    Mesh mesh;
    const uint32_t kind = draws.below(5), count = number % 256 == 255 ? 66000 : 3 + draws.below(20);
    for (uint32_t i = 0; i < count; ++i) {
        const float x = coordinate(draws, kind), y = coordinate(draws, kind), z = coordinate(draws, kind);
        mesh.positions.emplace_back(x, y, z);
    }
    for (uint32_t i = 2; i < count; ++i) mesh.triangles.emplace_back(0, i - 1, i);
    if (draws.coin())
        for (uint32_t i = 0; i < count; ++i) mesh.normals.values.emplace_back(Vec3f(draws.direction() * (draws.coin() ? 1 : 1e-38)));
    return mesh;
}

using Corners = std::array<float, 9>;

/// All triangles of a scene where they stand, as floats, in order.
void gather(const Scene& scene, NodeId id, const Transform& above, std::vector<Corners>& out) {
    const Node& node = scene.nodes[id.index];
    const Transform place = above * node.to_parent;
    if (const auto* shape = std::get_if<ShapeId>(&node.what)) {
        if (const auto* mesh = std::get_if<Mesh>(&scene.shapes[shape->index].geometry)) {
            for (const Index3& t : mesh->triangles) {
                Corners c{};
                for (int k = 0; k < 9; ++k) c[size_t(k)] = float(place.point(mesh->origin + Vec3(mesh->positions[t[k / 3]]))[k % 3]);
                out.push_back(c);
            }
        }
    }
    for (const NodeId child : node.children) gather(scene, child, place, out);
}

std::vector<Corners> triangles(const Scene& scene) {
    std::vector<Corners> out;
    for (const NodeId root : scene.roots) gather(scene, root, {}, out);
    std::sort(out.begin(), out.end());
    return out;
}

/// What the file says differently without a word; empty if nothing.
std::string round_trip(const Scene& scene, const std::string& path) {
    const auto written = export_scene(scene, path);
    if (!written) return "";   // refused, in a sentence
    const auto read = import_scene(path);
    if (!read) return "written, but not read: " + read.error().text();
    const std::vector<Corners> want = triangles(scene), got = triangles(read->scene);
    if (want == got) return "";
    const bool told = !written->losses.empty() || !read->diagnostics.text().empty();
    if (told && std::includes(want.begin(), want.end(), got.begin(), got.end())) return "";
    for (size_t i = 0; i < std::min(want.size(), got.size()); ++i)
        for (size_t k = 0; k < 9; ++k)
            if (want[i][k] != got[i][k]) return fmt::format("{} triangles of {}; {} became {}", got.size(), want.size(), want[i][k], got[i][k]);
    return fmt::format("{} triangles of {}", got.size(), want.size());
}

}  // namespace

Check mesh_files() {
    return [](uint64_t number, NumericsTally& tally) {
        static const std::vector<std::string> all = endings();
        Draws draws(RandomKey(26, 0, number));
        SceneMaker maker;
        maker.object(extreme_mesh(number, draws), maker.unlit(Color(1)));
        const Folder folder(number);
        const std::string& ending = all[number % all.size()];
        const std::string wrong = round_trip(maker.scene, folder.file("mesh" + ending));
        tally.decide(wrong.empty(), [&] { return ending + ": " + wrong; });
    };
}

}  // namespace alidade::numerics
