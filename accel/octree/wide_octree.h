// SPDX-License-Identifier: Apache-2.0
/// The octree of triangles: eight cells a node, tested at once.
#pragma once

#include "accel/bvh/wide.h"

namespace alidade {

/// Cut triangles may make references at most this many times as many as there are triangles; each cell has its share of that.
inline constexpr double kTriangleGrowth = 4;

/// What a node costs beside a block of triangles, when it is asked whether halving a cell pays.
inline constexpr double kHalvingCost = 0.1;

/// Cells below so many nodes are not halved. What they hold needs at most ten nodes more.
inline constexpr uint32_t kWideOctreeDepth = 64;
static_assert(kWideOctreeDepth + 11 <= kBvhDepth);

/// The nodes in depth-first order, the root first; none for no references. Appends the ids to `order`, padded to blocks.
///
/// Cells    the box of what is in them, halved in the middle of their longest axis, in `typical` triangles (or of another, where only that pays). A node is a cell halved seven times, the largest
///          part that does not fit into a block first: eight octants, where triangles are evenly spread.
/// Planes   a triangle in the way of one goes whole to the half that holds its middle, as in a loose octree. Where triangles are large beside their cell (spatial_splits_promise) or only that
///          pays it is cut instead (bvh/spatial.h), so that an id may be in several cells, never twice in one.
template <class R>
LargeVector<WideNode<R>> build_wide_octree(std::vector<BvhReference<R>> references, const TriangleSource<R>& triangles, const Vec3& typical, std::vector<uint32_t>& order, BuildStats& stats);
extern template LargeVector<WideNode<float>> build_wide_octree(std::vector<BvhReference<float>>, const TriangleSource<float>&, const Vec3&, std::vector<uint32_t>&, BuildStats&);
extern template LargeVector<WideNode<double>> build_wide_octree(std::vector<BvhReference<double>>, const TriangleSource<double>&, const Vec3&, std::vector<uint32_t>&, BuildStats&);

}  // namespace alidade
