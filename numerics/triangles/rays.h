// SPDX-License-Identifier: Apache-2.0
/// The rays that structures get wrong, by class. Tests go through the table, so that a new class is tried on everything.
#pragma once

#include "core/random.h"
#include "numerics/triangles/meshes.h"

#include <span>

namespace alidade::numerics {

struct RayClass {
    const char* name;
    double least_hits;  ///< share of the rays that must hit, so that a test cannot pass on misses alone; holds for small_meshes()
    Ray (*make)(const TriangleMesh& mesh, const RandomKey& key);
};

std::span<const RayClass> ray_classes();

/// From inside a closed mesh through a point of an edge, or through a vertex: must hit. Half of the origins and of the points lie on a lattice
/// of 1/16, so that edge functions become exactly 0.
Ray edge_aimed_from_inside(const TriangleMesh& mesh, const RandomKey& key);
Ray vertex_aimed_from_inside(const TriangleMesh& mesh, const RandomKey& key);

/// "origin (hex, hex, hex) dir (...) tmin .. tmax ..": can be pasted into a test as it stands.
std::string describe(const Ray& ray);

}  // namespace alidade::numerics
