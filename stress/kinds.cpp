// SPDX-License-Identifier: Apache-2.0
#include "stress/builder.h"

#include <algorithm>
#include <unordered_map>

namespace alidade {

static constexpr StressKind kKinds[] = {
    {"scan", "a scanned figure: a closed surface, rough at all scales, of even triangles", 270000, make_scan},
    {"architecture", "a nave of fluted columns, arches, battens, tiles and cloth, turned off the axes: long thin triangles", 260000, make_architecture},
    {"stadium", "a figure of size 0.5 in a bowl of radius 1000", 117000, make_stadium},
    {"hair", "ribbons of slivers on a ball", 520000, make_hair},
    {"soup", "small triangles anywhere", 1000000, make_soup},
    {"sphere", "a sphere with gentle hills, of very many triangles", 2000000, make_sphere},
    {"forest", "a tree, a thousand times, by instances", 20000, make_forest},
    {"lattice", "cubes side by side, an eighth of them missing: faces on faces, along the axes", 300000, make_lattice},
    {"needle", "slivers from anywhere to anywhere", 100000, make_needle},
    {"nested", "a figure in clusters of clusters of clusters, by instances", 5000, make_nested},
    {"zoo", "degenerate triangles: without area, twice the same, nested, coplanar, tiny, far away, huge", 100000, make_zoo},
};

std::span<const StressKind> stress_kinds() { return kKinds; }

const StressKind* find_stress_kind(std::string_view name) {
    for (const StressKind& kind : kKinds) {
        if (name == kind.name) return &kind;
    }
    return nullptr;
}

StressCamera StressCamera::look(const Vec3& eye, const Vec3& target, double window) {
    const Vec3 ahead = normalized(target - eye), right = normalized(cross(ahead, Vec3(0, 1, 0))), up = cross(right, ahead);
    return {eye, ahead, window * right, window * up};
}

size_t StressScene::triangles() const {
    size_t count = 0;
    for (const StressMesh& mesh : meshes) count += mesh.triangles.size();
    return count;
}

size_t StressScene::placed_triangles() const {
    if (places.empty()) return mesh().triangles.size();
    size_t count = 0;
    for (const StressPlace& place : places) count += meshes[place.mesh].triangles.size();
    return count;
}

size_t StressScene::bytes() const {
    size_t bytes = places.capacity() * sizeof(StressPlace);
    for (const StressMesh& m : meshes)
        bytes += m.positions.capacity() * sizeof(Vec3f) + m.exact_positions.capacity() * sizeof(Vec3) + m.triangles.capacity() * sizeof(Index3);
    return bytes;
}

StressScene part_of(const StressScene& scene, size_t triangles) {
    const auto less = [](const StressMesh& a, const StressMesh& b) { return a.triangles.size() < b.triangles.size(); };
    const StressMesh& from = *std::max_element(scene.meshes.begin(), scene.meshes.end(), less);
    StressScene part;
    part.camera = scene.camera, part.lamps = scene.lamps;
    std::unordered_map<uint32_t, uint32_t> known;
    for (size_t i = 0; i < std::min(triangles, from.triangles.size()); ++i) {
        Index3 corners;
        for (int k = 0; k < 3; ++k) {
            const uint32_t vertex = from.triangles[i][k];
            const auto [at, added] = known.try_emplace(vertex, uint32_t(known.size()));
            corners[k] = at->second;
            if (!added) continue;
            part.mesh().positions.push_back(from.positions[vertex]);
            if (!from.exact_positions.empty()) part.mesh().exact_positions.push_back(from.exact_positions[vertex]);
        }
        part.mesh().triangles.push_back(corners);
    }
    return part;
}

void add_triangle(StressMesh& mesh, const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto first = uint32_t(mesh.positions.size());
    for (const Vec3& p : {a, b, c}) mesh.positions.emplace_back(p);
    mesh.triangles.emplace_back(first, first + 1, first + 2);
}

Ripples::Ripples(int octaves, double frequency, Draws& draws) {
    double height = 1.0 / 6;
    for (int octave = 0; octave < octaves; ++octave, frequency *= 2, height /= 2) {
        for (int i = 0; i < 3; ++i) waves_.push_back({frequency * draws.direction(), draws.uniform(0, 2 * kPi), height});
    }
}

double Ripples::operator()(const Vec3& p) const {
    double sum = 0;
    for (const Wave& wave : waves_) sum += wave.height * std::sin(dot(wave.direction, p) + wave.phase);
    return sum;
}

}  // namespace alidade
