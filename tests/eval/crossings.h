// SPDX-License-Identifier: Apache-2.0
/// Where a ray crosses a shape, and what is wanted of it.
#pragma once

#include "eval/shapes/shape_ops.h"

#include <gtest/gtest.h>
#include <initializer_list>

namespace alidade::test {

template <class Shape> Crossings crossings(const Shape& shape, const Vec3& origin, const Vec3& dir) {
    Ray ray;
    ray.origin = origin, ray.dir = dir;
    return find_shape(shape)->crossings(shape, ray);
}

inline void expect_at(const Crossings& got, std::initializer_list<double> want, double tolerance = 4e-15) {
    ASSERT_EQ(size_t(got.count), want.size());
    int i = 0;
    for (const double t : want) EXPECT_NEAR(got.at[i++].t, t, tolerance);
}

}  // namespace alidade::test
