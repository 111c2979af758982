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

/// The cells next to a coordinate's own along one axis, from 2 below to 2 above.
struct Row {
    double origin[5], gap[5];   ///< where the cell begins; from the coordinate to the cell, 0 where it lies inside
    unsigned index[5];

    explicit Row(double x) {
        const int64_t own = cell_below(x);
        for (int i = 0; i < 5; ++i) {
            origin[i] = double(own + i - 2);
            gap[i] = std::max({0.0, origin[i] - x, x - (origin[i] + 1)});
            index[i] = unsigned((own + i - 2) & 4095);
        }
    }
};

/// One random point in each of the 81 cells around: offsets up to 2, of which at most one is 2. The near cells come first, because a cell that lies
/// farther away than the third point so far has nothing to add.
Nearest nearest_points(const Vec3& p, double metric) {
    static constexpr int kFromTheMiddle[] = {2, 1, 3, 0, 4};
    const auto random = cell_randoms();
    const Row x(p.x), y(p.y), z(p.z);
    Nearest nearest;
    const auto beyond = [&](double dx, double dy, double dz) {
        constexpr double kRounding = 1 - 1e-9;   // a power is not monotonic to its last digit
        return metric > 0 && raised({dx, dy, dz}, metric) * kRounding > nearest.distance[2];
    };
    for (const int i : kFromTheMiddle) {
        if (beyond(x.gap[i], 0, 0)) continue;
        const unsigned in_x = kLatticeHash[x.index[i]];
        for (const int j : kFromTheMiddle) {
            const int edges = (i % 4 == 0) + (j % 4 == 0);
            if (edges > 1 || beyond(x.gap[i], y.gap[j], 0)) continue;
            const unsigned in_y = kLatticeHash[in_x ^ y.index[j]];
            for (const int k : kFromTheMiddle) {
                if (edges + (k % 4 == 0) > 1 || beyond(x.gap[i], y.gap[j], z.gap[k])) continue;
                const unsigned h = kLatticeHash[in_y ^ z.index[k]];
                const Vec3 at(x.origin[i] + random[h], y.origin[j] + random[h + 1], z.origin[k] + random[h + 2]);
                nearest.add(raised(at - p, metric), at);
            }
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
