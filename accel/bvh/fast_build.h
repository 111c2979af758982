// SPDX-License-Identifier: Apache-2.0
/// Builds the tree of a BVH fast: its lower levels by the bits of places on a Hilbert curve, those above by the surface area heuristic.
#pragma once

#include "accel/bvh/build.h"

namespace alidade {

/// As build_bvh; if the references are of `triangles`, large ones are cut before (bvh/presplit.h). The order does not depend on the number of threads.
///
/// Method   references are sorted along a Hilbert curve (bvh/hilbert.h) through their centroids; cells of the curve with few references become subtrees, divided by the bits of the codes
///          (the last few leaves, where areas times blocks are least), and binned SAH makes the tree above those: after Pantaleoni and Luebke, "HLBVH: Hierarchical LBVH Construction for Real-Time Ray Tracing", 2010.
template <class R> LargeVector<BvhNode<R>> build_bvh_fast(LargeVector<BvhReference<R>> references, const BvhLimits& limits, std::vector<uint32_t>& order, BuildStats& stats, const TriangleSource<R>* triangles = nullptr);

extern template LargeVector<BvhNode<float>> build_bvh_fast(LargeVector<BvhReference<float>>, const BvhLimits&, std::vector<uint32_t>&, BuildStats&, const TriangleSource<float>*);
extern template LargeVector<BvhNode<double>> build_bvh_fast(LargeVector<BvhReference<double>>, const BvhLimits&, std::vector<uint32_t>&, BuildStats&, const TriangleSource<double>*);

}  // namespace alidade
