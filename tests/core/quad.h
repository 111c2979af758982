// SPDX-License-Identifier: Apache-2.0
/// Numbers of 113 bits, as oracles for double arithmetic. g++ on x86 alone has them: what needs them stands in #ifdef ALIDADE_HAS_QUAD.
#pragma once

#include "core/vec.h"

#if defined(__SIZEOF_FLOAT128__) && !defined(__clang__)
#define ALIDADE_HAS_QUAD 1

#include <quadmath.h>

namespace alidade::test {

__extension__ typedef __float128 Quad;

struct QuadVec {
    Quad x = 0, y = 0, z = 0;
    QuadVec() = default;
    QuadVec(Quad a, Quad b, Quad c) : x(a), y(b), z(c) {}
    explicit QuadVec(const Vec3& v) : x(v.x), y(v.y), z(v.z) {}
};

inline QuadVec operator+(const QuadVec& a, const QuadVec& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline QuadVec operator-(const QuadVec& a, const QuadVec& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline QuadVec operator*(Quad k, const QuadVec& v) { return {k * v.x, k * v.y, k * v.z}; }
inline Quad dot(const QuadVec& a, const QuadVec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline QuadVec cross(const QuadVec& a, const QuadVec& b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline Quad length(const QuadVec& v) { return sqrtq(dot(v, v)); }

/// |got - want| in units of the last place of the double nearest to `want`.
inline double ulps(double got, Quad want) {
    const double near = std::abs(double(want));
    return double(fabsq(Quad(got) - want)) / (std::nextafter(near, kInf) - near);
}

}  // namespace alidade::test
#endif
