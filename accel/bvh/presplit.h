// SPDX-License-Identifier: Apache-2.0
/// Large triangles are cut before a tree is built over their parts, for builders that do not look for planes themselves.
#pragma once

#include "accel/bvh/build.h"

namespace alidade {

/// Replaces references whose boxes are much larger than their triangles need by such of parts: at most `growth` of their number more. An id may then be in several references.
/// Nothing is done where triangles are of like sizes. `box` is of all references.
///
/// Method   the priority of a triangle is the cube root of the area that its box could lose times the size of the coarsest plane of a dyadic grid that cuts it; parts lie on both sides of
///          such planes: Karras and Aila, "Fast Parallel Construction of High-Quality Bounding Volume Hierarchies", 2013, section 4.
template <class R> void presplit(LargeVector<BvhReference<R>>& references, const BoxEnds<R>& box, const TriangleSource<R>& triangles, double growth, int threads);

extern template void presplit(LargeVector<BvhReference<float>>&, const BoxEnds<float>&, const TriangleSource<float>&, double, int);
extern template void presplit(LargeVector<BvhReference<double>>&, const BoxEnds<double>&, const TriangleSource<double>&, double, int);

}  // namespace alidade
