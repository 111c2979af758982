// SPDX-License-Identifier: Apache-2.0
/// Build, first hit and any hit for every row of the accelerator registry, with the work counters beside the time (accel_peers compares with Embree).
///
/// One thread, single rays. Seconds on a shared machine are noisy; boxes_per_ray and tests_per_ray are not.
/// Example   accel_bench --benchmark_filter=first_hit.*float --benchmark_repetitions=5
#include "accel/accelerator.h"
#include "numerics/triangles/rays.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <memory>
#include <vector>

namespace alidade::bench {

namespace {

/// A mesh in float precision and rays around it: every second one is aimed at a triangle, the others at nothing.
struct Workload {
    numerics::TriangleMesh mesh;
    std::vector<Ray> rays;
};

std::shared_ptr<const Workload> make_workload(const numerics::TriangleMesh& mesh) {
    auto workload = std::make_shared<Workload>(Workload{mesh.read_at(Precision::float_), {}});
    const auto aimed = numerics::ray_classes()[0].make, stray = numerics::ray_classes()[1].make;
    for (size_t i = 0; i < 16384; ++i) workload->rays.push_back((i % 2 ? stray : aimed)(workload->mesh, RandomKey(1, 0, i, 0)));
    return workload;
}

using SharedWorkload = std::shared_ptr<const Workload>;

void build_rate(benchmark::State& state, const AcceleratorEntry& entry, const Workload& workload, const AccelOptions& options) {
    size_t bytes = 0;
    for (auto _ : state) bytes = entry.over_triangles(workload.mesh.view(), options)->stats().bytes;
    const double triangles = double(workload.mesh.triangles.size());
    state.counters["triangles_per_s"] = benchmark::Counter(triangles, benchmark::Counter::kIsIterationInvariantRate);
    state.counters["bytes_per_triangle"] = double(bytes) / triangles;
}

/// `ask(ray, work)` is true for a hit.
template <class Ask>
void ray_rate(benchmark::State& state, const Workload& workload, const Ask& ask) {
    WorkCounters work;
    size_t next = 0, hits = 0;
    for (auto _ : state) {
        hits += ask(workload.rays[next], work);
        next = (next + 1) % workload.rays.size();
    }
    const double rays = double(state.iterations());
    state.SetItemsProcessed(state.iterations());
    state.counters["hit_rate"] = double(hits) / rays;  // a speed without a hit rate says nothing
    state.counters["boxes_per_ray"] = double(work.boxes) / rays;
    state.counters["tests_per_ray"] = double(work.filtered) / rays;
}

void register_rows(const AcceleratorEntry& entry, const SharedWorkload& workload, Precision precision) {
    AccelOptions options;
    options.precision = precision;
    const std::string row = fmt::format("{}/{}/{}", workload->mesh.name, entry.name, precision == Precision::float_ ? "float" : "double");
    benchmark::RegisterBenchmark(("build/" + row).c_str(), [&entry, workload, options](benchmark::State& state) {
        build_rate(state, entry, *workload, options);
    })->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark(("first_hit/" + row).c_str(), [&entry, workload, options](benchmark::State& state) {
        const auto accelerator = entry.over_triangles(workload->mesh.view(), options);
        ray_rate(state, *workload, [&](const Ray& ray, WorkCounters& work) {
            Hit hit;
            return accelerator->intersect(ray, hit, work);
        });
    });
    benchmark::RegisterBenchmark(("any_hit/" + row).c_str(), [&entry, workload, options](benchmark::State& state) {
        const auto accelerator = entry.over_triangles(workload->mesh.view(), options);
        ray_rate(state, *workload, [&](const Ray& ray, WorkCounters& work) { return accelerator->occluded(ray, work); });
    });
}

void register_all() {
    for (const numerics::TriangleMesh& mesh : {numerics::geodesic_sphere(71, 0.2), numerics::soup(100000, 0.02, 4), numerics::slivers(20000, 1e-3, 5)}) {
        const SharedWorkload workload = make_workload(mesh);
        for (const AcceleratorEntry& entry : accelerators().subspan(1))  // brute force is not a contender at 1e5 triangles
            for (const Precision precision : {Precision::float_, Precision::double_}) register_rows(entry, workload, precision);
    }
}

}  // namespace
}  // namespace alidade::bench

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 64;
    alidade::bench::register_all();
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
