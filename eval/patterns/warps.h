// SPDX-License-Identifier: Apache-2.0
/// Distortions of a point before a pattern is looked up.
#pragma once

#include "core/vec.h"
#include "scene/material.h"

#include <array>
#include <string>
#include <tl/expected.hpp>

namespace alidade {

/// A warp, ready to be undone: POV-Ray transforms the pattern, so a point goes the other way.
struct PreparedWarp {
    WarpKind kind = WarpKind::transform;
    Transform inverse;
    std::array<double, 14> parameters{};   ///< all of the kind's, those that were left out with POV-Ray's defaults
};

/// Why it cannot be: a transform without inverse, too many parameters, a repeat without a width.
tl::expected<PreparedWarp, std::string> prepare(const Warp& warp);

/// Where a pattern under this warp is looked up.
/// Source   POV-Ray 3.7 user documentation, 3.4.7.7 "Warps"; what it leaves open by experiment
Vec3 warped(const PreparedWarp& warp, const Vec3& p);

}  // namespace alidade
