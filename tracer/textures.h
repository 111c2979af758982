// SPDX-License-Identifier: Apache-2.0
/// Decoded images, and signals evaluated at a surface point.
#pragma once

#include "core/diagnostics.h"
#include "core/image.h"
#include "scene/scene.h"

#include <memory>
#include <unordered_map>
#include <vector>

namespace alidade {

struct ShadePoint;

/// The images that used materials read, each decoded once for each encoding that is asked of it.
class Textures {
  public:
    /// Decodes, in parallel, what the signals in `used` read. An image that cannot be decoded is an error in `said`.
    Textures(const Scene& scene, const std::vector<SignalId>& used, int threads, Diagnostics& said);

    /// The value of a signal at a surface point. Channels that an image does not have: gray is repeated, alpha is 1.
    Vec4 evaluate(SignalId signal, const ShadePoint& point) const;
    size_t count() const { return pictures_.size(); }
    size_t bytes() const;

  private:
    Vec4 lookup(const ImageSignal& image, const Picture& picture, const Vec2& uv) const;

    const std::vector<Signal>& signals_;
    std::vector<Picture> pictures_;
    std::vector<uint32_t> picture_of_;   ///< by signal; kNoId where the signal is no image
};

/// All signals reachable from `root`, itself included, appended to `out`.
void collect_signals(const Scene& scene, SignalId root, std::vector<SignalId>& out);

}  // namespace alidade
