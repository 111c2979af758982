// SPDX-License-Identifier: Apache-2.0
/// New positions for a wide BVH over the same triangles.
#pragma once

#include "accel/bvh/wide.h"

namespace alidade {

/// Packs the triangles of all leaves again, and makes all boxes anew, from the leaves up; returns the surface area heuristic's cost. A leaf's box becomes that of its whole triangles, also where
/// planes had cut them. Children must have larger numbers than their parents. The same bits for any number of threads.
template <class R> double refit_wide(std::span<WideNode<R>> nodes, std::span<TriangleBlock<R>> blocks, const TriangleSource<R>& triangles, int threads);
extern template double refit_wide(std::span<WideNode<float>>, std::span<TriangleBlock<float>>, const TriangleSource<float>&, int);
extern template double refit_wide(std::span<WideNode<double>>, std::span<TriangleBlock<double>>, const TriangleSource<double>&, int);

}  // namespace alidade
