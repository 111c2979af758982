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

/// What a metric adds up, a coordinate each, before the root of the sum is taken: the order of distances is the same.
struct Squares {
    double operator()(double v) const { return v * v; }
};
struct Absolutes {
    double operator()(double v) const { return std::abs(v); }
};
struct Powers {
    double metric;
    double operator()(double v) const { return std::pow(std::abs(v), metric); }
};

double root(double sum, double metric) {
    if (metric == 2) return std::sqrt(sum);
    return metric == 1 ? sum : std::pow(sum, 1 / metric);
}

int64_t cell_below(double x) {
    const double whole = std::floor(x - kBlockEpsilon);
    return std::abs(whole) < 9e18 ? int64_t(whole) : 0;
}

/// The cells next to a coordinate's own along one axis, up to 2 away, the nearest first.
struct Row {
    double origin[5], gap[5];   ///< where the cell begins; what the metric adds for the way from the coordinate to the cell, 0 where it lies inside
    unsigned index[5];

    template <class Metric> Row(double x, Metric raised) {
        const int64_t own = cell_below(x);
        const double whole = double(own);
        const int near = x - whole < 0.5 ? -1 : 1, step[5] = {0, near, -near, 2 * near, -2 * near};
        for (int i = 0; i < 5; ++i) {
            origin[i] = whole + step[i];
            gap[i] = raised(std::max(std::max(0.0, origin[i] - x), x - (origin[i] + 1)));
            index[i] = unsigned((own + step[i]) & 4095);
        }
    }
};

/// One random point in each of the 81 cells around: offsets up to 2, of which at most one is 2. A cell that lies farther away than the third point so far
/// has nothing to add, and those behind it in its row have not, either. `prunes`: sums grow with distances.
template <class Metric> Nearest nearest_by(const Vec3& p, Metric raised, bool prunes) {
    const auto random = cell_randoms();
    const Row x(p.x, raised), y(p.y, raised), z(p.z, raised);
    Nearest nearest;
    const auto beyond = [&](double sum) {
        constexpr double kRounding = 1 - 1e-9;   // a power is not monotonic to its last digit
        return prunes && sum * kRounding > nearest.distance[2];
    };
    for (int i = 0; i < 5 && !beyond(x.gap[i]); ++i) {
        const unsigned in_x = kLatticeHash[x.index[i]];
        const int rows = i < 3 ? 5 : 3;
        for (int j = 0; j < rows && !beyond(x.gap[i] + y.gap[j]); ++j) {
            const unsigned in_y = kLatticeHash[in_x ^ y.index[j]];
            const int cells = i < 3 && j < 3 ? 5 : 3;
            for (int k = 0; k < cells && !beyond(x.gap[i] + y.gap[j] + z.gap[k]); ++k) {
                const unsigned h = kLatticeHash[in_y ^ z.index[k]];
                const Vec3 at(x.origin[i] + random[h], y.origin[j] + random[h + 1], z.origin[k] + random[h + 2]), way = at - p;
                nearest.add(raised(way.x) + raised(way.y) + raised(way.z), at);
            }
        }
    }
    return nearest;
}

Nearest nearest_points(const Vec3& p, double metric) {
    if (metric == 2) return nearest_by(p, Squares(), true);
    if (metric == 1) return nearest_by(p, Absolutes(), true);
    return nearest_by(p, Powers{metric}, metric > 0);
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
