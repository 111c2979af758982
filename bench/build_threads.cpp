// SPDX-License-Identifier: Apache-2.0
/// What threads gain a build, beside what they gain a loop of arithmetic that shares nothing: on a busy machine the one is worth as much as the other.
///
/// In each round the loop and the build run with one thread and with many, in turn, on the clock; medians over the rounds of the ratios within a round.
#include "bench/words.h"
#include "core/parallel.h"
#include "stress/measure.h"
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

void measure(const AcceleratorEntry& entry, const StressKind& kind, size_t triangles, int threads, int rounds) {
    const StressScene scene = kind.make(triangles, 1);
    const auto build = [&](int count) {
        AccelOptions how;
        how.threads = count;
        for (const StressMesh& mesh : scene.meshes) entry.over_triangles(mesh.view(), how);
    };
    std::vector<double> one, many, loop, both;
    for (int round = 0; round < rounds; ++round) {
        const double alone = seconds_of([&] { build(1); }), together = seconds_of([&] { build(threads); });
        const double loop_alone = seconds_of([&] { arithmetic(1); }), loop_together = seconds_of([&] { arithmetic(threads); });
        one.push_back(alone), many.push_back(alone / together), loop.push_back(loop_alone / loop_together), both.push_back(many.back() / loop.back());
    }
    fmt::print("{:13} {:8} triangles  {:8.3f} Mtri/s  {} threads {:.2f} times that, arithmetic {:.2f}: {:.2f}\n", kind.name, scene.triangles(), 1e-6 * double(scene.triangles()) / median(one),
               threads, median(many), median(loop), median(both));
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
