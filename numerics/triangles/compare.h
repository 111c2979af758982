// SPDX-License-Identifier: Apache-2.0
/// The three questions put to two structures, and what differs between their answers.
#pragma once

#include "accel/accelerator.h"
#include "numerics/triangles/meshes.h"

#include <string>

namespace alidade::numerics {

/// In hex floats.
std::string describe(const Hit& hit);

/// What differs, in hex floats; empty if every bit of the hits is the same.
std::string difference(const Hit& got, const Hit& want);
std::string difference(const std::vector<Hit>& got, const std::vector<Hit>& want);

/// The first hit, or a default Hit.
Hit first_hit(const Accelerator& accelerator, const Ray& ray);
std::vector<Hit> all_hits(const Accelerator& accelerator, const Ray& ray);
bool is_occluded(const Accelerator& accelerator, const Ray& ray);

/// The answers of one structure to the three questions about one ray.
struct Answers {
    Hit first;
    bool occluded = false;
    std::vector<Hit> all;
};
Answers answers(const Accelerator& accelerator, const Ray& ray);
std::string difference(const Answers& got, const Answers& want);

const char* name(Precision precision);
/// Every row of the registry but brute force.
std::vector<const AcceleratorEntry*> accelerators_under_test();
std::unique_ptr<Accelerator> brute_force(const TriangleMesh& mesh, Precision precision);
std::unique_ptr<Accelerator> build(const AcceleratorEntry& entry, const TriangleMesh& mesh, const AccelOptions& options);

}  // namespace alidade::numerics
