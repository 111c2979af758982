// SPDX-License-Identifier: Apache-2.0
/// Spatial splits: a plane divides a node's references, and triangles that straddle it are cut in two.
///
/// Method   Stich, Friedrich, Dietrich, "Spatial splits in bounding volume hierarchies", 2009.
#pragma once

#include "accel/bvh/binning.h"
#include "accel/triangles/triangle_source.h"

namespace alidade {

/// The parts of a reference on both sides of a plane; empty where nothing of it is.
template <class R> struct Parts {
    BoxEnds<R> below, above;
};

/// Cuts a triangle whose part in `box` a reference stands for. Each point of the triangle in `box` is in one of the parts, exactly: docs/numerics.md, "Parts of triangles".
template <class R> Parts<R> cut(const Corners& corners, const BoxEnds<R>& box, int axis, R plane);
extern template Parts<float> cut(const Corners&, const BoxEnds<float>&, int, float);
extern template Parts<double> cut(const Corners&, const BoxEnds<double>&, int, double);

/// Between more slabs better planes are found, and more so than by looking at more references (kSampled).
inline constexpr int kSpatialBins = 16;

/// A side of a plane, as bins foretell it.
template <class R> struct SpatialSide {
    BoxEnds<R> box = BoxEnds<R>::none();
    uint32_t count = 0;
};

template <class R> struct SpatialSplit {
    double cost = kInf;   ///< area times blocks, of both sides
    int axis = -1;
    R plane = 0;
    SpatialSide<R> below, above;
    explicit operator bool() const { return axis >= 0; }
};

/// The cheapest of the planes between kSpatialBins slabs of `box`, along each axis; costs count started blocks.
template <class R> SpatialSplit<R> best_plane(std::span<const BvhReference<R>> references, const TriangleSource<R>& triangles, const BoundsT<R>& box, uint32_t block);
extern template SpatialSplit<float> best_plane(std::span<const BvhReference<float>>, const TriangleSource<float>&, const BoundsT<float>&, uint32_t);
extern template SpatialSplit<double> best_plane(std::span<const BvhReference<double>>, const TriangleSource<double>&, const BoundsT<double>&, uint32_t);

/// Moves what is above the plane to the front of `references`, and what is below to `below`, which has room for all; returns both numbers. A triangle is not cut where it is cheaper to
/// leave it whole on one side ("reference unsplitting"), nor any more once `budget` were.
template <class R>
std::pair<size_t, size_t> divide_by_plane(std::span<BvhReference<R>> references, BvhReference<R>* below, const TriangleSource<R>& triangles, const SpatialSplit<R>& split, size_t budget);
extern template std::pair<size_t, size_t> divide_by_plane(std::span<BvhReference<float>>, BvhReference<float>*, const TriangleSource<float>&, const SpatialSplit<float>&, size_t);
extern template std::pair<size_t, size_t> divide_by_plane(std::span<BvhReference<double>>, BvhReference<double>*, const TriangleSource<double>&, const SpatialSplit<double>&, size_t);

}  // namespace alidade
