// SPDX-License-Identifier: Apache-2.0
/// Scenes on which accelerators are measured: made from a kind, a number and a seed, or filled by whoever has meshes.
#pragma once

#include "accel/accelerator.h"
#include "core/transform.h"

#include <span>
#include <string_view>
#include <vector>

namespace alidade {

struct StressMesh {
    std::vector<Vec3f> positions;
    std::vector<Vec3> exact_positions;   ///< empty, or as many: what accelerators in double read instead
    std::vector<Index3> triangles;

    TriangleView view() const { return {positions, exact_positions, triangles}; }
};

struct StressPlace {
    Transform to_world;
    uint32_t mesh = 0;
};

/// Sees the points eye + t (ahead + u right + v up), t > 0, with u and v in [-1, 1].
struct StressCamera {
    Vec3 eye{0, 0, 4}, ahead{0, 0, -1}, right{0.5, 0, 0}, up{0, 0.5, 0};

    /// Upright; `window` is half the width of what is seen at distance 1.
    static StressCamera look(const Vec3& eye, const Vec3& target, double window);
};

struct StressLamp {
    Vec3 at{5, 5, 5};
    bool far = false;   ///< infinitely far away: `at` is the direction to it
};

struct StressScene {
    std::vector<StressMesh> meshes = std::vector<StressMesh>(1);
    std::vector<StressPlace> places;   ///< empty: the first mesh as it is, once
    StressCamera camera;
    std::vector<StressLamp> lamps;

    StressMesh& mesh() { return meshes.front(); }
    const StressMesh& mesh() const { return meshes.front(); }
    size_t triangles() const;          ///< of the meshes
    size_t primitives() const { return triangles() + places.size(); }   ///< of all structures over it
    size_t placed_triangles() const;   ///< of all places: what a ray could meet
    size_t bytes() const;              ///< of the arrays
};

/// The first `triangles` triangles of the largest mesh, as they are: to see what a structure costs before it is built over all.
StressScene part_of(const StressScene& scene, size_t triangles);

struct StressKind {
    const char* name;
    const char* doc;
    size_t triangles;                                       ///< when nobody asks for another number
    StressScene (*make)(size_t triangles, uint64_t seed);   ///< of about so many triangles (of one instance); the same for the same arguments
};

/// More are refused by who asks for them: vertices are counted by 32 bits.
inline constexpr size_t kMostStressTriangles = 1000000000;

std::span<const StressKind> stress_kinds();
/// The row of that name, or null.
const StressKind* find_stress_kind(std::string_view name);

}  // namespace alidade
