// SPDX-License-Identifier: Apache-2.0
/// From a file to the first picture: one importer, and behind it our structures or Embree's. One thread.
///
/// The made scene is written as a PLY file first. In each round every tracer gets the file anew: it is read, its structure is built, and side x side camera rays are traced; medians over the rounds.
#include "bench/words.h"
#include "exporters/exporter.h"
#include "importers/importer.h"
#include "stress/measure.h"
#include "stress/peer.h"
#include "tools/stress/from_scene.h"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <random>

namespace alidade::bench {
namespace {

[[noreturn]] void fail(const std::string& why) {
    fmt::print(stderr, "{}\n", why);
    std::exit(1);
}

void write_made(const StressKind& kind, size_t triangles, const std::string& path) {
    StressScene made = kind.make(triangles, 1);
    Scene scene;
    Mesh mesh;
    mesh.positions = std::move(made.mesh().positions), mesh.triangles = std::move(made.mesh().triangles);
    ShapeEntry shape;
    shape.geometry = std::move(mesh);
    scene.shapes.push_back(std::move(shape));
    Node node;
    node.what = ShapeId{0};
    scene.nodes.push_back(std::move(node));
    scene.roots.push_back(NodeId{0});
    if (const auto done = export_scene(scene, path); !done) fail(done.error());
}

struct Times {
    double read = 0, build = 0, rays = 0;
    double all() const { return read + build + rays; }
    size_t hits = 0, triangles = 0;
};

Times first_picture(const std::string& path, StressPeer& peer, size_t side) {
    Times times;
    const double start = wall_seconds();
    auto imported = import_scene(path, {});
    if (!imported) fail(imported.error().text());
    Diagnostics said;
    const auto subject = stress_subject(std::move(imported->scene), path, side, said);
    if (!subject) fail(said.text());
    const double read = wall_seconds();
    peer.build(subject->scene);
    const double built = wall_seconds();
    std::vector<StressHit> hits(subject->primary.size());
    peer.closest(subject->primary, hits);
    times = {read - start, built - read, wall_seconds() - built};
    times.hits = size_t(std::count_if(hits.begin(), hits.end(), [](const StressHit& hit) { return hit.hits(); }));
    times.triangles = subject->scene.placed_triangles();
    peer.drop();
    return times;
}

double median_of(const std::vector<Times>& list, double (*part)(const Times&)) {
    std::vector<double> values;
    for (const Times& t : list) values.push_back(part(t));
    return median(values);
}

void measure(const Words& words, const std::string& path, size_t side) {
    std::vector<std::unique_ptr<StressPeer>> peers;
    for (const AcceleratorEntry* entry : words.entries()) peers.push_back(make_own_peer(*entry, {}));
    for (auto& peer : make_embree_peers()) peers.push_back(std::move(peer));
    std::vector<std::vector<Times>> times(peers.size());
    for (int round = 0; round < words.rounds; ++round)
        for (size_t i = 0; i < peers.size(); ++i) times[i].push_back(first_picture(path, *peers[i], side));
    const auto all = [](const Times& t) { return t.all(); };
    double embree = 0;
    for (size_t i = 0; i < peers.size(); ++i)
        if (peers[i]->name == "embree") embree = median_of(times[i], all);
    for (size_t i = 0; i < peers.size(); ++i) {
        const auto part = [&](double (*of)(const Times&)) { return median_of(times[i], of); };
        fmt::print("  {:14} read {:6.3f} s, build {:6.3f} s, {} x {} rays {:6.3f} s: {:6.3f} s{}; {} rays hit\n", peers[i]->name, part([](const Times& t) { return t.read; }), part([](const Times& t) { return t.build; }),
                   side, side, part([](const Times& t) { return t.rays; }), part(all), embree > 0 ? fmt::format(", {:.3f} of Embree's", part(all) / embree) : "", times[i].front().hits);
    }
}

}  // namespace
}  // namespace alidade::bench

int main(int argc, char** argv) {
    using namespace alidade;
    bench::Words words;
    words.accel = {"auto", "hlbvh"}, words.kinds = {"sphere"}, words.scale = 4, words.rounds = 3;
    size_t side = 512;
    CLI::App app("From a file of triangles to the first picture.");
    bench::add_words(app, words);
    app.add_option("--rays", side, "along each side of the picture")->check(CLI::PositiveNumber)->capture_default_str();
    return bench::parsed(app, argc, argv, [&] {
        const auto path = (std::filesystem::temp_directory_path() / fmt::format("alidade_first_picture_{}.ply", std::random_device{}())).string();
        words.for_each_kind([&](const StressKind& kind, size_t triangles) {
            bench::write_made(kind, triangles, path);
            fmt::print("{}: {:.1f} MB for {} triangles\n", kind.name, 1e-6 * double(std::filesystem::file_size(path)), triangles);
            bench::measure(words, path, side);
        });
        std::filesystem::remove(path);
    });
}
