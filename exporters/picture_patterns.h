// SPDX-License-Identifier: Apache-2.0
/// POV-Ray's pictures as textures.
#pragma once

#include "scene/scene.h"

namespace alidade {

/// The texture that an `image_map` is: one on texture coordinates, sRGB-encoded, moved by nothing but transforms, with its own transparency. Nothing for all others.
std::optional<ImageSignal> as_texture(const PatternSignal& pattern, const RenderSettings& settings);

/// Is any alpha stored in the picture? (False where it cannot be decoded.)
bool has_alpha(const Image& image);

}  // namespace alidade
