// SPDX-License-Identifier: Apache-2.0
/// What threads gain a build, beside what they gain a loop of arithmetic that shares nothing: on a busy machine the one is worth as much as the other.
///
/// In each round the loop and the build run with one thread and with many, in turn, on the clock; medians over the rounds of the ratios within a round.
/// Usage     build_threads [--accel bvh] [--kinds scan,hair] [--scale 1] [--threads 2] [--rounds 9]
#include "core/parallel.h"
#include "stress/measure.h"
#include "stress/scene.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>

namespace alidade::bench {
namespace {

struct Options {
    std::string accel = "bvh", kinds;
    double scale = 1;
    int threads = 2, rounds = 9;
};

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

void measure(const AcceleratorEntry& entry, const StressKind& kind, const Options& options) {
    const StressScene scene = kind.make(size_t(double(kind.triangles) * options.scale), 1);
    const auto build = [&](int threads) {
        AccelOptions how;
        how.threads = threads;
        for (const StressMesh& mesh : scene.meshes) entry.over_triangles(mesh.view(), how);
    };
    std::vector<double> one, many, loop, both;
    for (int round = 0; round < options.rounds; ++round) {
        const double alone = seconds_of([&] { build(1); }), together = seconds_of([&] { build(options.threads); });
        const double loop_alone = seconds_of([&] { arithmetic(1); }), loop_together = seconds_of([&] { arithmetic(options.threads); });
        one.push_back(alone), many.push_back(alone / together), loop.push_back(loop_alone / loop_together), both.push_back(many.back() / loop.back());
    }
    fmt::print("{:13} {:8} triangles  {:8.3f} Mtri/s  {} threads {:.2f} times that, arithmetic {:.2f}: {:.2f}\n", kind.name, scene.triangles(), 1e-6 * double(scene.triangles()) / median(one),
               options.threads, median(many), median(loop), median(both));
    std::fflush(stdout);
}

bool listed(const std::string& list, std::string_view name) { return list.empty() || ("," + list + ",").find(fmt::format(",{},", name)) != std::string::npos; }

std::optional<Options> parse(int argc, char** argv) {
    Options options;
    for (int i = 1; i + 1 < argc; i += 2) {
        const std::string_view word = argv[i];
        const char* value = argv[i + 1];
        if (word == "--accel") options.accel = value;
        else if (word == "--kinds") options.kinds = value;
        else if (word == "--scale") options.scale = std::atof(value);
        else if (word == "--threads") options.threads = std::max(1, std::atoi(value));
        else if (word == "--rounds") options.rounds = std::max(1, std::atoi(value));
        else return std::nullopt;
    }
    return argc % 2 ? std::optional(options) : std::nullopt;
}

}  // namespace
}  // namespace alidade::bench

int main(int argc, char** argv) {
    using namespace alidade;
    const auto options = bench::parse(argc, argv);
    const AcceleratorEntry* entry = options ? find_accelerator(options->accel) : nullptr;
    if (!entry) {
        fmt::print(stderr, "build_threads [--accel bvh] [--kinds scan,hair] [--scale 1] [--threads 2] [--rounds 9]\n");
        return 64;
    }
    for (const StressKind& kind : stress_kinds())
        if (bench::listed(options->kinds, kind.name)) bench::measure(*entry, kind, *options);
}
