// SPDX-License-Identifier: Apache-2.0
#include "stress/rays.h"

#include "core/draws.h"

namespace alidade {

namespace {

/// The normal of what was hit, towards where the ray came from.
Vec3 facing_normal(const StressScene& scene, const Hit& hit, const Ray& ray) {
    const Index3& t = scene.triangles[hit.primitive];
    Vec3 corners[3];
    for (int i = 0; i < 3; ++i) {
        corners[i] = Vec3(scene.positions[t[i]]);
        if (!scene.instances.empty()) corners[i] = scene.instances[hit.instance].point(corners[i]);
    }
    const Vec3 n = normalized(cross(corners[1] - corners[0], corners[2] - corners[0]));
    return dot(n, ray.dir) > 0 ? -n : n;
}

StressRay narrowed(const Vec3& origin, const Vec3& dir, float tmax) { return {Vec3f(origin), Vec3f(dir), 0, tmax}; }

/// Off the surface by some 64 roundings of float coordinates: for all ray tracers the same.
Vec3 lifted(const Vec3& p, const Vec3& normal) { return p + 64 * double(std::numeric_limits<float>::epsilon()) * max_abs(p) * normal; }

StressRay primary_ray(const StressScene& scene, size_t x, size_t y, size_t side) {
    const Vec3 ahead = normalized(scene.target - scene.eye), right = normalized(cross(ahead, Vec3(0, 1, 0))), up = cross(right, ahead);
    const double u = (double(x) + 0.5) / double(side) * 2 - 1, v = 1 - (double(y) + 0.5) / double(side) * 2;
    return narrowed(scene.eye, ahead + scene.window * (u * right + v * up), std::numeric_limits<float>::infinity());
}

}  // namespace

Ray StressRay::ray() const {
    Ray out;
    out.origin = Vec3(origin), out.dir = Vec3(dir), out.tmin = double(tmin), out.tmax = double(tmax);
    return out;
}

StressRays make_stress_rays(const StressScene& scene, const Accelerator& accelerator, size_t side, uint64_t seed) {
    StressRays rays;
    WorkCounters work;
    for (size_t i = 0; i < side * side; ++i) {
        rays.primary.push_back(primary_ray(scene, i % side, i / side, side));
        const Ray ray = rays.primary.back().ray();
        Hit hit;
        if (!accelerator.intersect(ray, hit, work)) continue;
        Draws draws(RandomKey(seed, 8, i, 0));
        const Vec3 normal = facing_normal(scene, hit, ray), from = lifted(ray.at(hit.t), normal);
        rays.shadow.push_back(narrowed(from, scene.lamp - from, 1));
        rays.diffuse.push_back(narrowed(from, normalized(normal + draws.direction() * (1 - 1e-6)), std::numeric_limits<float>::infinity()));
    }
    return rays;
}

}  // namespace alidade
