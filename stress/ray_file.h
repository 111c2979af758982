// SPDX-License-Identifier: Apache-2.0
/// Rays in files: docs/stress.md has the format.
#pragma once

#include "stress/rays.h"

#include <cstddef>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace alidade {

enum class RayNumbers : uint32_t { float32 = 4, float64 = 8 };

std::vector<std::byte> encode_rays(std::span<const StressRay> rays, RayNumbers numbers);

/// An error is one clause that says at which byte: what is no such file, is cut off or too long, or holds what is no ray.
tl::expected<std::vector<StressRay>, std::string> decode_rays(std::span<const std::byte> bytes);

}  // namespace alidade
