// SPDX-License-Identifier: Apache-2.0
/// Our OBJ reader beside tinyobjloader's on the same file: a torus of 1,000,000 triangles with positions, texture coordinates and normals.
///
/// CPU time of the whole process, since ours reads in parallel; wall time stands beside it.
/// Example   obj_bench --benchmark_repetitions=3
#include "core/transform.h"
#include "importers/importer.h"

#include <benchmark/benchmark.h>
#include <filesystem>
#include <fmt/os.h>
#include <tiny_obj_loader.h>
#include <unistd.h>

namespace alidade::bench {
namespace {

constexpr int kAround = 1000, kTube = 500;   // quads; each is two triangles

void write_torus(const std::string& path) {
    auto out = fmt::output_file(path);
    for (int i = 0; i < kAround; ++i)
        for (int j = 0; j < kTube; ++j) {
            const double a = 2 * kPi * i / kAround, b = 2 * kPi * j / kTube;
            const Vec3 n(std::cos(a) * std::cos(b), std::sin(b), std::sin(a) * std::cos(b));
            out.print("v {:.6f} {:.6f} {:.6f}\nvt {:.6f} {:.6f}\nvn {:.4f} {:.4f} {:.4f}\n", std::cos(a) + 0.3 * n.x, 0.3 * n.y, std::sin(a) + 0.3 * n.z,
                      double(i) / kAround, double(j) / kTube, n.x, n.y, n.z);
        }
    const auto at = [](int i, int j) { return (i % kAround) * kTube + j % kTube + 1; };
    for (int i = 0; i < kAround; ++i)
        for (int j = 0; j < kTube; ++j) {
            const int a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
            out.print("f {0}/{0}/{0} {1}/{1}/{1} {2}/{2}/{2}\nf {0}/{0}/{0} {2}/{2}/{2} {3}/{3}/{3}\n", a, b, c, d);
        }
}

void check_count(benchmark::State& state, size_t triangles) {
    if (triangles != size_t(2) * kAround * kTube) state.SkipWithError("not all triangles were read");
}

void ours(benchmark::State& state, const std::string& path) {
    for (auto _ : state) {
        const ImportResult read = import_scene(path);
        size_t triangles = 0;
        if (read)
            for (const ShapeEntry& shape : read->scene.shapes)
                if (const auto* mesh = std::get_if<Mesh>(&shape.geometry)) triangles += mesh->triangles.size();
        check_count(state, triangles);
    }
}

void tinyobjloader(benchmark::State& state, const std::string& path) {
    for (auto _ : state) {
        tinyobj::attrib_t attributes;
        std::vector<tinyobj::shape_t> shapes;
        std::vector<tinyobj::material_t> materials;
        std::string warning, error;
        tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, path.c_str());
        size_t triangles = 0;
        for (const auto& shape : shapes) triangles += shape.mesh.num_face_vertices.size();
        check_count(state, triangles);
    }
}

}  // namespace
}  // namespace alidade::bench

int main(int argc, char** argv) {
    using namespace alidade::bench;
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 64;
    const std::string path = (std::filesystem::temp_directory_path() / fmt::format("alidade_obj_bench_{}.obj", getpid())).string();
    write_torus(path);
    benchmark::RegisterBenchmark("obj/alidade", ours, path)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark("obj/tinyobjloader", tinyobjloader, path)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    std::filesystem::remove(path);
    return 0;
}
