// SPDX-License-Identifier: Apache-2.0
/// What stands around a picture that is clamped or mirrored: POV-Ray repeats all.
#pragma once

#include "core/image.h"
#include "scene/scene.h"

#include <array>
#include <cmath>
#include <compare>
#include <map>
#include <vector>

namespace alidade::pov_export {

/// What metal-rough layers of a material show by texture coordinates, and what that is made of; the base colour first.
std::vector<SignalId> shown_signals(const Scene& scene, MaterialId id);

/// What of a signal decides where its picture is looked up, and what is there.
struct Lookup {
    explicit Lookup(const ImageSignal& image);
    friend auto operator<=>(const Lookup&, const Lookup&) = default;

    uint32_t image, uv_set;
    Wrap wrap_u, wrap_v;
    std::array<double, 9> uv_transform;
    bool clamps() const { return wrap_u == Wrap::clamp || wrap_v == Wrap::clamp; }
    bool mirrors() const { return wrap_u == Wrap::mirror || wrap_v == Wrap::mirror; }
};

/// Where a picture is looked up: bounds of u and v.
struct LookupRange {
    Vec2 min{INFINITY}, max{-INFINITY};
    bool known = true;   ///< false: not by meshes alone
};

/// Of the pictures that are clamped, by the texture coordinates of all meshes whose materials show them so.
std::map<Lookup, LookupRange> ranges_of_clamped(const Scene& scene);

/// Pixels that are added so that the picture, repeated, shows what it should wherever it is looked up.
struct PictureEdges {
    int left = 0, right = 0, top = 0, bottom = 0;   ///< copies of those at the edges
    bool mirror_u = false, mirror_v = false;        ///< a mirrored picture beside it, above it
    bool exact = true;                              ///< false: there would be too many, or nobody knows where it is looked up
    friend auto operator<=>(const PictureEdges&, const PictureEdges&) = default;
    bool none() const { return *this == PictureEdges{} || *this == PictureEdges{.exact = false}; }
};

/// Of a picture of width x height pixels. `range` counts where it is clamped.
PictureEdges edges_of(const Lookup& lookup, const LookupRange& range, int width, int height);

Picture with_edges(const Picture& picture, const PictureEdges& edges);

/// From the unit square that POV-Ray gives the larger picture to where it belongs, v upwards.
Transform place_of(const PictureEdges& edges, int width, int height);

}  // namespace alidade::pov_export
