// SPDX-License-Identifier: Apache-2.0
#include "stress/rays.h"

#include "core/draws.h"

namespace alidade {

namespace {

/// The normal of what was hit, towards where the ray came from.
Vec3 facing_normal(const StressScene& scene, const Hit& hit, const Ray& ray) {
    const StressMesh& mesh = scene.meshes[scene.places.empty() ? 0 : scene.places[hit.instance].mesh];
    Vec3 corners[3];
    for (int i = 0; i < 3; ++i) {
        corners[i] = Vec3(mesh.positions[mesh.triangles[hit.primitive][i]]);
        if (!scene.places.empty()) corners[i] = scene.places[hit.instance].to_world.point(corners[i]);
    }
    const Vec3 n = normalized(cross(corners[1] - corners[0], corners[2] - corners[0]));
    return dot(n, ray.dir) > 0 ? -n : n;
}

StressRay narrowed(const Vec3& origin, const Vec3& dir, double tmax) { return {Vec3(Vec3f(origin)), Vec3(Vec3f(dir)), 0, tmax}; }

/// Off the surface by some 64 roundings of float coordinates: for all ray tracers the same.
Vec3 lifted(const Vec3& p, const Vec3& normal) { return p + 64 * double(std::numeric_limits<float>::epsilon()) * max_abs(p) * normal; }

StressRay shadow_ray(const StressScene& scene, const Vec3& from, Draws& draws) {
    const StressLamp& lamp = scene.lamps[scene.lamps.size() > 1 ? draws.below(scene.lamps.size()) : 0];
    return lamp.far ? narrowed(from, lamp.at, kInf) : narrowed(from, lamp.at - from, 1);
}

/// A ray without a direction hits nothing, in every tracer in its own way: another pair of points is drawn.
StressRay random_ray(const Bounds& box, Draws& draws) {
    StressRay ray;
    do {
        const Vec3 from = draws.in_box(box.min, box.max), to = draws.in_box(box.min, box.max);
        ray = narrowed(from, normalized(to - from), kInf);
    } while (ray.dir == Vec3(0) && box.max != box.min);
    return ray;
}

}  // namespace

std::vector<StressRay> camera_rays(const StressScene& scene, size_t side) {
    const StressCamera& c = scene.camera;
    std::vector<StressRay> rays;
    rays.reserve(side * side);
    for (size_t i = 0; i < side * side; ++i) {
        const double u = (double(i % side) + 0.5) / double(side) * 2 - 1, v = 1 - (double(i / side) + 0.5) / double(side) * 2;
        rays.push_back(narrowed(c.eye, c.ahead + u * c.right + v * c.up, kInf));
    }
    return rays;
}

std::vector<RaySet> make_ray_sets(const StressScene& scene, const Accelerator& accelerator, std::vector<StressRay> primary, uint64_t seed) {
    RaySet shadow{"shadow", Question::any, {}}, diffuse{"diffuse", Question::closest, {}}, random{"random", Question::closest, {}};
    WorkCounters work;
    for (size_t i = 0; i < primary.size(); ++i) {
        const Ray ray = primary[i].ray();
        Hit hit;
        if (!accelerator.intersect(ray, hit, work)) continue;
        Draws draws(RandomKey(seed, 8, i, 0));
        const Vec3 normal = facing_normal(scene, hit, ray), from = lifted(ray.at(hit.t), normal);
        diffuse.rays.push_back(narrowed(from, normalized(normal + draws.direction() * (1 - 1e-6)), kInf));
        if (!scene.lamps.empty()) shadow.rays.push_back(shadow_ray(scene, from, draws));
    }
    Draws draws(RandomKey(seed, 13, 0, 0));
    const Bounds box = accelerator.bounds();
    for (size_t i = 0; i < primary.size() && box.finite(); ++i) random.rays.push_back(random_ray(box, draws));
    return {{"primary", Question::closest, std::move(primary)}, std::move(shadow), std::move(diffuse), std::move(random)};
}

}  // namespace alidade
