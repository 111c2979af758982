// SPDX-License-Identifier: Apache-2.0
#include "eval/noise/hash.h"
#include "eval/noise/noise.h"
#include "eval/patterns/registry.h"

namespace alidade::pattern {

namespace {

/// The three points that are nearest.
struct Nearest {
    double distance[3] = {kInf, kInf, kInf};
    Vec3 point{0};

    void add(double d, const Vec3& at) {
        if (!(d < distance[2])) return;
        if (d < distance[0]) distance[2] = distance[1], distance[1] = distance[0], distance[0] = d, point = at;
        else if (d < distance[1]) distance[2] = distance[1], distance[1] = d;
        else distance[2] = d;
    }
};

/// The metric's sum, before its root is taken: the order of distances is the same.
double raised(const Vec3& v, double metric) {
    if (metric == 2) return dot(v, v);
    if (metric == 1) return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
    return std::pow(std::abs(v.x), metric) + std::pow(std::abs(v.y), metric) + std::pow(std::abs(v.z), metric);
}

double root(double sum, double metric) {
    if (metric == 2) return std::sqrt(sum);
    return metric == 1 ? sum : std::pow(sum, 1 / metric);
}

int64_t cell_below(double x) {
    const double whole = std::floor(x - kBlockEpsilon);
    return std::abs(whole) < 9e18 ? int64_t(whole) : 0;
}

/// One random point in each of the 81 cells around: offsets up to 2, of which at most one is 2.
Nearest nearest_points(const Vec3& p, double metric) {
    Nearest nearest;
    const int64_t x = cell_below(p.x), y = cell_below(p.y), z = cell_below(p.z);
    for (int i = -2; i <= 2; ++i)
        for (int j = -2; j <= 2; ++j) {
            const int edges = (std::abs(i) == 2) + (std::abs(j) == 2);
            if (edges > 1) continue;
            const int reach = edges ? 1 : 2;
            for (int k = -reach; k <= reach; ++k) {
                const unsigned h = cell_hash(x + i, y + j, z + k);
                const Vec3 at(double(x + i) + cell_random(h), double(y + j) + cell_random(h + 1), double(z + k) + cell_random(h + 2));
                nearest.add(raised(at - p, metric), at);
            }
        }
    return nearest;
}

}  // namespace

Vec3 nearest_point(const Vec3& p, double metric) { return nearest_points(p, metric).point; }

/// Source   S. Worley, "A Cellular Texture Basis Function", SIGGRAPH 1996; POV-Ray's points and neighbourhood by experiment.
double crackle(const Vec3& p, const PatternInput& in) {
    const double metric = in[3], offset = in[4];
    const Nearest near = nearest_points(p, metric);
    if (in[5] != 0) return noise(near.point, in.noise);
    const double lifted = offset != 0 ? std::pow(std::abs(offset), metric) : 0;
    double value = 0;
    for (size_t i = 0; i < 3; ++i)
        if (in[i] != 0) value += in[i] * root(near.distance[i] + lifted, metric);
    return std::clamp(value, 0.0, 1.0);
}

}  // namespace alidade::pattern
