// SPDX-License-Identifier: Apache-2.0
#include "accel/automatic.h"

#include "core/draws.h"

#include <cmath>
#include <string>

namespace alidade {

namespace {

/// Where the heuristic says that a ray through a BVH meets this part of all primitives, boxes do not tell them apart: long thin ones, criss-cross. Made scenes of other kinds are below 1 / 80.
constexpr double kCrowded = 1.0 / 16;
constexpr size_t kFew = 1000;    // primitives, below which it does not matter
constexpr size_t kProbes = 256;

/// Nanoseconds of a box and of a triangle, in either: both are walked by the same code. Measured on the made scenes (docs/stress.md), good to some 20 %.
constexpr double kBox = 6, kTriangle = 2;

/// Of random rays through the bounds: nobody knows the scene's yet. No clock is asked, so that the choice is always the same.
double price_of(const Accelerator& accelerator) {
    WorkCounters work;
    for (size_t i = 0; i < kProbes; ++i) {
        Draws draws(RandomKey(1, 0, i, 0));
        Ray ray;
        ray.origin = draws.in_box(accelerator.bounds().min, accelerator.bounds().max);
        ray.dir = draws.in_box(accelerator.bounds().min, accelerator.bounds().max) - ray.origin;
        Hit hit;
        accelerator.intersect(ray, hit, work);
    }
    return kBox * double(work.boxes) + kTriangle * double(work.filtered);
}

}  // namespace

std::unique_ptr<Accelerator> over_triangles_auto(const TriangleView& mesh, const AccelOptions& options) {
    auto bvh = find_accelerator("bvh")->over_triangles(mesh, options);
    const BuildStats& stats = bvh->stats();
    if (stats.primitives < kFew || stats.sah_cost < kCrowded * double(stats.primitives)) {
        bvh->why = "bvh: a ray through it meets few of the triangles";
        return bvh;
    }
    auto octree = find_accelerator("octree")->over_triangles(mesh, options);
    const double ratio = price_of(*octree) / price_of(*bvh);
    auto& best = ratio < 1 ? octree : bvh;
    const auto percent = [](double part) { return std::to_string(std::lround(100 * part)) + " %"; };
    best->why = std::string(ratio < 1 ? "octree" : "bvh") + ": boxes do not separate the triangles (a ray meets " + percent(stats.sah_cost / double(stats.primitives)) + "), and by " +
                std::to_string(kProbes) + " probe rays the octree takes " + percent(ratio) + " of the BVH's time";
    return std::move(best);
}

std::unique_ptr<Accelerator> over_set_auto(std::shared_ptr<const PrimitiveSet> set, const AccelOptions& options) {
    auto bvh = find_accelerator("bvh")->over_set(std::move(set), options);
    bvh->why = "bvh: always over shapes and instances";
    return bvh;
}

}  // namespace alidade
