// SPDX-License-Identifier: Apache-2.0
/// What need not be built again: a BVH refitted to new positions, and one mapped from a file, beside building it.
///
/// In each round all are done, in turn, on one thread, in CPU time; medians over the rounds of the ratios within a round. The new positions are twisted a little: what a skin does from frame to frame.
#include "accel/load.h"
#include "bench/words.h"
#include "stress/measure.h"
#include "stress/scene.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <unistd.h>

namespace alidade::bench {
namespace {

template <class F> double seconds_of(F&& work) {
    const double start = thread_seconds();
    work();
    return thread_seconds() - start;
}

/// About the middle of its box, by `angle` from one end to the other.
StressMesh twisted(StressMesh mesh, double angle) {
    Bounds box;
    for (const Vec3f& p : mesh.positions) box.extend(Vec3(p));
    for (Vec3f& p : mesh.positions) {
        const Vec3 v = Vec3(p) - box.center();
        const double turn = angle * v.y / std::max(1e-30, box.extent().y);
        p = Vec3f(box.center() + Vec3(std::cos(turn) * v.x - std::sin(turn) * v.z, v.y, std::sin(turn) * v.x + std::cos(turn) * v.z));
    }
    mesh.exact_positions.clear();
    return mesh;
}

void measure(const AcceleratorEntry& entry, const StressKind& kind, size_t triangles, Precision precision, int rounds) {
    const StressScene scene = kind.make(triangles, 1);
    const StressMesh rest = twisted(scene.mesh(), 0), moved = twisted(scene.mesh(), 0.2);
    if (!entry.over_triangles(rest.view(), {precision})->refit(moved.view())) return fmt::print("{}: cannot be refitted\n", entry.name);
    const std::string file = (std::filesystem::temp_directory_path() / fmt::format("alidade_build_again_{}", ::getpid())).string();
    std::vector<double> builds, refits, saves, loads;
    double refitted_cost = 0, built_cost = 0;
    for (int round = 0; round < rounds; ++round) {
        std::unique_ptr<Accelerator> structure;
        const double build = seconds_of([&] { structure = entry.over_triangles(rest.view(), {precision}); });
        builds.push_back(build);
        saves.push_back(seconds_of([&] { if (!structure->save(file, rest.view())) std::abort(); }) / build);
        loads.push_back(seconds_of([&] { if (!load_accelerator(file, rest.view(), {precision})) std::abort(); }) / build);
        refits.push_back(seconds_of([&] { if (!structure->refit(moved.view())) std::abort(); }) / build);
        refitted_cost = structure->stats().sah_cost;
        if (round == 0) built_cost = entry.over_triangles(moved.view(), {precision})->stats().sah_cost;
    }
    std::filesystem::remove(file);
    fmt::print("{:13} {:8} triangles  {:6} {:6}  build {:7.1f} ms  refit {:.3f} of that (cost {:.2f} of a new one's)  load {:.3f}  save {:.3f}\n", kind.name, rest.triangles.size(), entry.name,
               precision == Precision::float_ ? "float" : "double", 1e3 * median(builds), median(refits), refitted_cost / built_cost, median(loads), median(saves));
    std::fflush(stdout);
}

}  // namespace
}  // namespace alidade::bench

int main(int argc, char** argv) {
    using namespace alidade;
    bench::Words words;
    words.rounds = 9, words.accel = {"bvh", "hlbvh"};
    CLI::App app("What refitting and loading a BVH take of the time of building it.");
    bench::add_words(app, words);
    return bench::parsed(app, argc, argv, [&] {
        for (const AcceleratorEntry* entry : words.entries())
            for (const Precision precision : {Precision::float_, Precision::double_})
                words.for_each_kind([&](const StressKind& kind, size_t triangles) { bench::measure(*entry, kind, triangles, precision, words.rounds); });
    });
}
