// SPDX-License-Identifier: Apache-2.0
/// What stands around a picture that is clamped or mirrored: POV-Ray repeats all.
#pragma once

#include "core/image.h"
#include "scene/scene.h"

namespace alidade::pov_export {

/// Pixels that are added so that the picture, repeated, shows what it should wherever it is looked up.
struct PictureEdges {
    int left = 0, right = 0, top = 0, bottom = 0;   ///< copies of those at the edges
    bool mirror_u = false, mirror_v = false;        ///< a mirrored picture beside it, above it
    bool exact = true;                              ///< false: there would be too many, or nobody knows where it is looked up
    friend auto operator<=>(const PictureEdges&, const PictureEdges&) = default;
    bool none() const { return *this == PictureEdges{} || *this == PictureEdges{.exact = false}; }
};

/// Of a picture of width x height pixels, by the texture coordinates of all meshes whose materials show it so.
PictureEdges edges_of(const Scene& scene, const ImageSignal& image, int width, int height);

Picture with_edges(const Picture& picture, const PictureEdges& edges);

/// From the unit square that POV-Ray gives the larger picture to where it belongs, v upwards.
Transform place_of(const PictureEdges& edges, int width, int height);

}  // namespace alidade::pov_export
