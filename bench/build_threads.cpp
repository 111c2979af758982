// SPDX-License-Identifier: Apache-2.0
/// What threads gain a build and the rays through what is built, beside what they gain a loop of arithmetic that shares nothing: on a busy machine the one is worth as much as the other.
///
/// In each round the loop, the build and the rays run with one thread and with many, in turn, on the clock; medians over the rounds of the ratios within a round.
#include "bench/words.h"
#include "core/parallel.h"
#include "stress/measure.h"
#include "stress/run.h"
#include "stress/scene.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

namespace alidade::bench {
namespace {

template <class F> double seconds_of(F&& work) {
    const double start = wall_seconds();
    work();
    return wall_seconds() - start;
}

/// Arithmetic in registers, in pieces as small as the builders'.
void arithmetic(int threads) {
    parallel_for(256, threads, [](size_t i) {
        double x = double(i) * 1e-3;
        for (int k = 0; k < 100000; ++k) x = x * 0.999 + 1e-3;
        if (x < 0) std::abort();   // never: but x is computed
    });
}

/// Camera rays, then rays anywhere, in pieces of as many as a picture's tile has.
void trace(std::span<const RaySet> sets, const Accelerator& accelerator, int threads) {
    constexpr size_t kTile = 1024;
    for (const RaySet& set : sets)
        parallel_for((set.rays.size() + kTile - 1) / kTile, threads, [&](size_t tile) {
            WorkCounters work;
            for (size_t i = tile * kTile; i < std::min(set.rays.size(), (tile + 1) * kTile); ++i) {
                Hit hit;
                accelerator.intersect(set.rays[i].ray(), hit, work);
            }
        });
}

struct Gains {
    std::vector<double> one, gain, of_arithmetic;

    /// `work` with one thread and with many, where the loop gains `arithmetic`.
    template <class Work> void add(const Work& work, int threads, double arithmetic) {
        one.push_back(seconds_of([&] { work(1); }));
        gain.push_back(one.back() / seconds_of([&] { work(threads); }));
        of_arithmetic.push_back(gain.back() / arithmetic);
    }
    std::string text() { return fmt::format("{:.2f} times, {:.2f} of arithmetic's", median(gain), median(of_arithmetic)); }
};

void measure(const AcceleratorEntry& entry, const StressKind& kind, size_t triangles, int threads, int rounds) {
    const StressScene scene = kind.make(triangles, 1);
    const std::vector<RaySet> sets = stress_rays(scene, camera_rays(scene, 512), 1);
    const auto built = entry.over_triangles(scene.mesh().view(), {});
    Gains build, rays;
    std::vector<double> loop;
    for (int round = 0; round < rounds; ++round) {
        loop.push_back(seconds_of([] { arithmetic(1); }) / seconds_of([&] { arithmetic(threads); }));
        build.add([&](int count) {
            AccelOptions how;
            how.threads = count;
            for (const StressMesh& mesh : scene.meshes) entry.over_triangles(mesh.view(), how);
        }, threads, loop.back());
        rays.add([&](int count) { trace(sets, *built, count); }, threads, loop.back());
    }
    fmt::print("{:13} {:8} triangles  {:8.3f} Mtri/s  {} threads: build {}; rays {}; arithmetic {:.2f} times\n", kind.name, scene.triangles(), 1e-6 * double(scene.triangles()) / median(build.one), threads,
               build.text(), rays.text(), median(loop));
    std::fflush(stdout);
}

}  // namespace
}  // namespace alidade::bench

int main(int argc, char** argv) {
    using namespace alidade;
    bench::Words words;
    words.rounds = 9;
    int threads = 2;
    CLI::App app("What threads gain a build.");
    bench::add_words(app, words);
    app.add_option("--threads", threads)->check(CLI::Range(2, 1024))->capture_default_str();
    return bench::parsed(app, argc, argv, [&] {
        for (const AcceleratorEntry* entry : words.entries())
            words.for_each_kind([&](const StressKind& kind, size_t triangles) { bench::measure(*entry, kind, triangles, threads, words.rounds); });
    });
}
