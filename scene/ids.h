// SPDX-License-Identifier: Apache-2.0
/// Indices into the arrays of a Scene, one type for each array.
#pragma once

#include <compare>
#include <cstdint>

namespace alidade {

template <class Tag> struct Id {
    uint32_t index = 0;
    friend constexpr auto operator<=>(const Id&, const Id&) = default;
};

using NodeId = Id<struct Node>;
using ShapeId = Id<struct ShapeEntry>;
using SignalId = Id<struct Signal>;
using MaterialId = Id<struct Material>;
using InteriorId = Id<struct Interior>;
using ImageId = Id<struct Image>;
using LightId = Id<struct Light>;
using CameraId = Id<struct Camera>;
using SkinId = Id<struct Skin>;
using FunctionId = Id<struct FunctionProgram>;

}  // namespace alidade
