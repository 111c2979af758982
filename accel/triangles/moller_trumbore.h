// SPDX-License-Identifier: Apache-2.0
/// The fast test: eight triangles at once in the precision of the mesh, hits and all.
#pragma once

#include "accel/triangles/edge_filter.h"

namespace alidade {

/// A ray in T, and where the test puts what it finds of the lanes whose bits it returns.
template <class T> struct FastRay {
    explicit FastRay(const LocalRay& ray, double low, double high) : from(T(low)), until(T(std::min(high, double(std::numeric_limits<T>::max())))) {
        for (int a = 0; a < 3; ++a) origin[a] = T(ray.origin[a]), dir[a] = T(ray.dir[a]);
    }

    T origin[3], dir[3];
    T from, until;   ///< t of hits
    alignas(64) mutable T t[kLanes], u[kLanes], v[kLanes];
};

/// Bit i is set if triangle i of the block is hit, as far as T can tell: there is no error bound. What overflows, underflows or has no area as computed is not hit. `near` is of no account: t is compared in any case.
///
/// Method   Moeller, Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997, both sides.
template <class T> using FastTest = uint32_t (*)(const TriangleBlock<T>&, const FastRay<T>&, bool near);

/// The test for these instructions, as edge_filter() chooses. All give the same bits.
template <class T> FastTest<T> fast_test(Isa isa);
template <> FastTest<float> fast_test<float>(Isa isa);
template <> FastTest<double> fast_test<double>(Isa isa);

}  // namespace alidade
