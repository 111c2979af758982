// SPDX-License-Identifier: Apache-2.0
/// Patterns that fill space with blocks: their values are whole numbers, the places in a list of colours.
/// Source   POV-Ray 3.7 user documentation, 3.4.7.2 "Discontinuous Patterns"; what it leaves open by experiment
#include "eval/noise/hash.h"
#include "eval/noise/single.h"
#include "eval/patterns/registry.h"

namespace alidade::pattern {

namespace {

constexpr double kRow = 0.866025404;   ///< sqrt(3) / 2, as POV-Ray has it

bool odd(double whole) { return std::fmod(whole, 2.0) != 0; }

/// The fraction of a, in [0, 1).
double fraction(double a) {
    const double f = a - std::trunc(a);
    return f < 0 ? f + 1 : f;
}

double positive_mod(double a, double n) { return a - n * std::floor(a / n); }

/// The whole part of a number in [0, n), for an index: what rounding, or a NaN, has put outside is brought in.
int place(double v, int n) { return v >= n ? n - 1 : v >= 0 ? int(v) : 0; }

int64_t cell_of(double x) {
    const double whole = std::floor(x + kBlockEpsilon);
    return std::abs(whole) < 9e18 ? int64_t(whole) : 0;
}

}  // namespace

int cube_face(const Vec3& p) {
    const double m = max_abs(p);
    for (int k = 0; k < 3; ++k)
        if (p[k] == m) return k;
    return -p.x == m ? 3 : -p.y == m ? 4 : 5;
}

double checker(const Vec3& p, const PatternInput&) {
    return odd(std::floor(p.x + kBlockEpsilon) + std::floor(p.y + kBlockEpsilon) + std::floor(p.z + kBlockEpsilon)) ? 1 : 0;
}

double hexagon(const Vec3& p, const PatternInput&) {
    constexpr int kOuter[6] = {0, 1, 1, 2, 2, 0}, kInner[6] = {2, 2, 0, 0, 1, 1}, kBelow[6] = {0, 2, 1, 0, 2, 1}, kAbove[6] = {2, 1, 0, 2, 1, 0};
    const double z = p.z < 0 ? 5.196152424 - std::abs(p.z) : p.z;   // six rows
    const double columns = positive_mod(std::abs(p.x) / 0.5, 6), rows = positive_mod(z / kRow, 6);
    const int i = place(columns, 6), j = place(rows, 6);
    if (i == 0 || i == 5) return kOuter[j];
    if (i == 2 || i == 3) return kInner[j];
    const double x = (i + j) % 2 ? 1 - (columns - i) : columns - i;   // the two columns that slanted edges cross
    const double height = rows - j;
    return height == 0 || height < x ? kBelow[j] : kAbove[j];
}

double brick(const Vec3& p, const PatternInput& in) {
    const Vec3 size = in.vector(0);
    const double mortar = single(in[3] - 2 * kBlockEpsilon);
    const Vec3 q = p + Vec3(mortar + kBlockEpsilon), joint = Vec3(mortar) / size;
    if (fraction(q.y / size.y) <= joint.y) return 0;
    const bool upper = fraction(q.y / (2 * size.y)) > 0.5;   // courses are laid in turn, half a brick apart
    if (fraction(q.x / size.x + (upper ? 0.5 : 0)) <= joint.x) return 0;
    if (fraction(q.z / size.z + (upper ? 0 : 0.5)) <= joint.z) return 0;
    return 1;
}

double cubic(const Vec3& p, const PatternInput&) { return cube_face(p); }

double square(const Vec3& p, const PatternInput&) {
    const bool x = odd(std::floor(p.x)), z = odd(std::floor(p.z));
    return x ? (z ? 2 : 3) : (z ? 1 : 0);
}

double triangular(const Vec3& p, const PatternInput&) {
    constexpr int kUp[3] = {0, 4, 2}, kDown[3] = {1, 3, 5};   // by the left corner of the base, and by the apex below
    const double row = std::floor(p.z / kRow), height = (p.z / kRow - row) / 2;   // at the height of the row, the edges are half a side away
    const double x = positive_mod(odd(row) ? p.x - 1.5 : p.x, 3);
    const int k = place(x, 3);
    const double along = x - k;
    if (along <= height) return kDown[k];
    return along > 1 - height ? kDown[(k + 1) % 3] : kUp[k];
}

double cells(const Vec3& p, const PatternInput&) { return cell_random(cell_hash(cell_of(p.x), cell_of(p.y), cell_of(p.z))); }

}  // namespace alidade::pattern
