// SPDX-License-Identifier: Apache-2.0
#include "core/lanes.h"
#include "eval/noise/hash.h"
#include "eval/noise/noise.h"
#include "eval/patterns/registry.h"

#include <algorithm>

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

/// One random point in each of the 81 cells around: offsets up to 2, of which at most one is 2. A cell for whose gaps `beyond` is true has nothing to add, and those behind it in its row have not, either.
template <class Gaps, class Beyond, class Visit> [[gnu::always_inline]] inline void for_each_point(const Gaps& x, const Gaps& y, const Gaps& z, const Beyond& beyond, const Visit& visit) {
    const auto random = cell_randoms();
    for (int i = 0; i < 5 && !beyond(x.gap[i]); ++i) {
        const unsigned in_x = kLatticeHash[x.index[i]];
        const int rows = i < 3 ? 5 : 3;
        for (int j = 0; j < rows && !beyond(x.gap[i] + y.gap[j]); ++j) {
            const unsigned in_y = kLatticeHash[in_x ^ y.index[j]];
            const int cells = i < 3 && j < 3 ? 5 : 3;
            for (int k = 0; k < cells && !beyond(x.gap[i] + y.gap[j] + z.gap[k]); ++k) {
                const unsigned h = kLatticeHash[in_y ^ z.index[k]];
                visit(x.origin[i] + random[h], y.origin[j] + random[h + 1], z.origin[k] + random[h + 2]);
            }
        }
    }
}

/// Cells that lie farther away than the third point so far are left out. `prunes`: sums grow with distances.
template <class Metric> Nearest nearest_by(const Vec3& p, Metric raised, bool prunes) {
    const Row x(p.x, raised), y(p.y, raised), z(p.z, raised);
    Nearest nearest;
    const auto beyond = [&](double sum) {
        constexpr double kRounding = 1 - 1e-9;   // a power is not monotonic to its last digit
        return prunes && sum * kRounding > nearest.distance[2];
    };
    for_each_point(x, y, z, beyond, [&](double at_x, double at_y, double at_z) {
        const Vec3 at(at_x, at_y, at_z), way = at - p;
        nearest.add(raised(way.x) + raised(way.y) + raised(way.z), at);
    });
    return nearest;
}

Nearest nearest_points(const Vec3& p, double metric) {
    if (metric == 2) return nearest_by(p, Squares(), true);
    if (metric == 1) return nearest_by(p, Absolutes(), true);
    return nearest_by(p, Powers{metric}, metric > 0);
}

/// What the three distances make.
double value_of(const double* distance, const PatternInput& in) {
    const double metric = in[3], offset = in[4], lifted = offset != 0 ? std::pow(std::abs(offset), metric) : 0;
    double value = 0;
    for (size_t i = 0; i < 3; ++i)
        if (in[i] != 0) value += in[i] * root(distance[i] + lifted, metric);
    return std::clamp(value, 0.0, 1.0);
}

#ifdef __x86_64__

/// The Row of four coordinates in one cell: gaps are not more than those of any of them, nor of a cell farther on.
struct SharedRow {
    double origin[5], gap[5];
    unsigned index[5];

    SharedRow(double a, double b, double c, double d) {
        const auto [low, high] = std::minmax({a, b, c, d});
        const int64_t own = cell_below(a);
        const double whole = double(own);
        const int near = a - whole < 0.5 ? -1 : 1, step[5] = {0, near, -near, 2 * near, -2 * near};
        for (int i = 4; i >= 0; --i) {
            origin[i] = whole + step[i];
            const double way = std::max(std::max(0.0, origin[i] - high), low - (origin[i] + 1));
            gap[i] = i < 4 ? std::min(way * way, gap[i + 1]) : way * way;
            index[i] = unsigned((own + step[i]) & 4095);
        }
    }
};

/// A coordinate of four points.
[[gnu::target("avx2"), gnu::always_inline]] inline __m256d coordinates(const Vec3* p, int axis) { return _mm256_setr_pd(p[0][axis], p[1][axis], p[2][axis], p[3][axis]); }

/// Are four points in one cell, and that where its numbers are exact?
[[gnu::target("avx2")]] bool share_a_cell(const Vec3* p) {
    const __m256d reach = _mm256_set1_pd(1e9), epsilon = _mm256_set1_pd(kBlockEpsilon), sign = _mm256_set1_pd(-0.0);
    int same = 15;
    for (int axis = 0; axis < 3; ++axis) {
        const __m256d x = coordinates(p, axis), cell = _mm256_floor_pd(_mm256_sub_pd(x, epsilon));
        const __m256d first = _mm256_permute4x64_pd(cell, 0), near = _mm256_cmp_pd(_mm256_andnot_pd(sign, x), reach, _CMP_LT_OQ);
        same &= _mm256_movemask_pd(_mm256_and_pd(near, _mm256_cmp_pd(cell, first, _CMP_EQ_OQ)));
    }
    return same == 15;
}

/// The three least squared distances of four points: a lane for each.
struct FourNearest {
    __m256d least, second, third;
    double farthest = kInf;   ///< the largest of the third ones

    [[gnu::target("avx2"), gnu::always_inline]] void add(const __m256d& d) {
        const __m256d above_least = _mm256_max_pd(least, d), above_second = _mm256_max_pd(second, above_least);
        least = _mm256_min_pd(least, d), second = _mm256_min_pd(second, above_least), third = _mm256_min_pd(third, above_second);
        const __m128d pair = _mm_max_pd(_mm256_castpd256_pd128(third), _mm256_extractf128_pd(third, 1));
        farthest = std::max(_mm_cvtsd_f64(pair), _mm_cvtsd_f64(_mm_unpackhi_pd(pair, pair)));
    }
};

/// As nearest_by() with Squares, of points that share a cell, and so the cells around. `distance` of each point, the nearest first.
[[gnu::target("avx2")]] void nearest_of_four(const Vec3* p, double (*distance)[3]) {
    constexpr double kRounding = 1 - 1e-9;
    const SharedRow x(p[0].x, p[1].x, p[2].x, p[3].x), y(p[0].y, p[1].y, p[2].y, p[3].y), z(p[0].z, p[1].z, p[2].z, p[3].z);
    const __m256d px = coordinates(p, 0), py = coordinates(p, 1), pz = coordinates(p, 2);
    FourNearest nearest;
    nearest.least = nearest.second = nearest.third = _mm256_set1_pd(kInf);
    const auto beyond = [&](double sum) { return sum * kRounding > nearest.farthest; };
    for_each_point(x, y, z, beyond, [&](double at_x, double at_y, double at_z) __attribute__((target("avx2"))) {
        const __m256d dx = _mm256_set1_pd(at_x) - px, dy = _mm256_set1_pd(at_y) - py, dz = _mm256_set1_pd(at_z) - pz;
        nearest.add(dx * dx + dy * dy + dz * dz);
    });
    for (size_t i = 0; i < 4; ++i) distance[i][0] = nearest.least[i], distance[i][1] = nearest.second[i], distance[i][2] = nearest.third[i];
}

#endif

}  // namespace

Vec3 nearest_point(const Vec3& p, double metric) { return nearest_points(p, metric).point; }

/// Source   S. Worley, "A Cellular Texture Basis Function", SIGGRAPH 1996; POV-Ray's points and neighbourhood by experiment.
double crackle(const Vec3& p, const PatternInput& in) {
    const Nearest near = nearest_points(p, in[3]);
    return in[5] != 0 ? noise(near.point, in.noise) : value_of(near.distance, in);
}

void four_crackles(const Vec3* p, const PatternInput& in, double* out) {
#ifdef __x86_64__
    if (kHasLanes && in[3] == 2 && in[5] == 0 && share_a_cell(p)) {
        double distance[4][3];
        nearest_of_four(p, distance);
        for (int i = 0; i < 4; ++i) out[i] = value_of(distance[i], in);
        return;
    }
#endif
    for (int i = 0; i < 4; ++i) out[i] = crackle(p[i], in);
}

}  // namespace alidade::pattern
