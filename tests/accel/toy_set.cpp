// SPDX-License-Identifier: Apache-2.0
#include "tests/accel/toy_set.h"

#include "core/clamp.h"
#include "core/draws.h"

namespace alidade::test {

namespace {

using Crossings = std::optional<std::array<double, 2>>;

Crossings sphere_crossings(const ToySolid& s, const Ray& ray) {
    const double a = dot(ray.dir, ray.dir), shift = dot(s.center - ray.origin, ray.dir) / a;
    const Vec3 nearest = ray.origin + shift * ray.dir - s.center;
    const double rest = s.size.x * s.size.x - dot(nearest, nearest);
    if (!(rest > 0)) return std::nullopt;
    const double half = std::sqrt(rest / a);
    return std::array{shift - half, shift + half};
}

Crossings box_crossings(const ToySolid& s, const Ray& ray) {
    const LineInterval inside = inside_bounds(ray, {s.center - s.size, s.center + s.size});
    if (!(inside.entry < inside.exit)) return std::nullopt;
    return std::array{inside.entry, inside.exit};
}

Crossings plane_crossings(const ToySolid& s, const Ray& ray) {
    const double slope = dot(s.size, ray.dir);
    if (slope == 0) return std::nullopt;
    const double t = dot(s.center - ray.origin, s.size) / slope;
    return std::array{t, t};
}

}  // namespace

/// Wider than the solid by far more than the rounding of a crossing, as the contract asks: entry(bounds) <= t <= exit(bounds).
Bounds ToySet::bounds(uint32_t id) const {
    const ToySolid& s = solids_[id];
    switch (s.kind) {
        case ToySolid::Kind::plane:
            return {Vec3(-kInf), Vec3(kInf)};
        case ToySolid::Kind::nan:
            return {Vec3(std::nan("")), Vec3(std::nan(""))};
        case ToySolid::Kind::sphere:
            return {s.center - Vec3(s.size.x * (1 + 1e-9)), s.center + Vec3(s.size.x * (1 + 1e-9))};
        case ToySolid::Kind::box:
            return {s.center - s.size * (1 + 1e-9), s.center + s.size * (1 + 1e-9)};
    }
    return {};
}

Crossings ToySet::crossings(uint32_t id, const Ray& ray) const {
    const ToySolid& s = solids_[id];
    switch (s.kind) {
        case ToySolid::Kind::sphere:
            return sphere_crossings(s, ray);
        case ToySolid::Kind::box:
            return box_crossings(s, ray);
        case ToySolid::Kind::plane:
            return plane_crossings(s, ray);
        case ToySolid::Kind::nan:
            break;
    }
    return std::nullopt;
}

std::vector<Hit> ToySet::hits_of(uint32_t id, const Ray& ray) const {
    std::vector<Hit> hits;
    const Crossings at = crossings(id, ray);
    if (!at) return hits;
    for (uint32_t part = 0; part < 2; ++part) {
        const double t = (*at)[part];
        if (part == 1 && t == (*at)[0]) continue;
        if (ray.tmin <= t && t <= ray.tmax) hits.push_back({t, 0, id, part, 0, 0, {}});
    }
    return hits;
}

bool ToySet::intersect(std::span<const uint32_t> ids, const Ray& ray, Hit& hit, WorkCounters& work) const {
    bool found = false;
    for (const uint32_t id : ids) {
        ++work.primitives;
        for (const Hit& candidate : hits_of(id, ray))
            if (comes_before(candidate.t, candidate.instance, candidate.primitive, hit)) hit = candidate, found = true;
    }
    return found;
}

bool ToySet::occluded(std::span<const uint32_t> ids, const Ray& ray, WorkCounters& work) const {
    work.primitives += ids.size();
    return std::any_of(ids.begin(), ids.end(), [&](uint32_t id) { return !hits_of(id, ray).empty(); });
}

void ToySet::all_hits(std::span<const uint32_t> ids, const Ray& ray, std::vector<Hit>& hits, WorkCounters& work) const {
    for (const uint32_t id : ids) {
        ++work.primitives;
        const std::vector<Hit> own = hits_of(id, ray);
        hits.insert(hits.end(), own.begin(), own.end());
    }
}

std::vector<ToySolid> random_solids(size_t count, double size, uint64_t seed) {
    Draws draws(RandomKey(seed, 0, 0, 0));
    std::vector<ToySolid> solids;
    for (size_t i = 0; i < count; ++i) {
        const auto kind = draws.coin() ? ToySolid::Kind::sphere : ToySolid::Kind::box;
        const Vec3 center = draws.in_box(Vec3(-1), Vec3(1));
        solids.push_back({kind, center, size * draws.in_box(Vec3(0.2), Vec3(1))});
    }
    return solids;
}

}  // namespace alidade::test
