// SPDX-License-Identifier: Apache-2.0
/// Decoded images, patterns made ready, and signals evaluated at a surface point.
#pragma once

#include "core/diagnostics.h"
#include "core/image.h"
#include "eval/patterns/pattern.h"
#include "scene/scene.h"

#include <memory>
#include <unordered_map>
#include <vector>

namespace alidade {

struct ShadePoint;

/// A colour of POV-Ray's: what part of the light that passes is coloured (filter), what part is not (transmit).
struct PigmentColor {
    Color color{0};
    double filter = 0, transmit = 0;
};

/// The images that used materials read, each decoded once for each encoding that is asked of it.
class Textures {
  public:
    /// Decodes, in parallel, what the signals in `used` read. An image that cannot be decoded and a pattern that does not exist are errors in `said`.
    Textures(const Scene& scene, const std::vector<SignalId>& used, int threads, Diagnostics& said);

    /// The value of a signal at a surface point. Channels that an image does not have: gray is repeated, alpha is 1.
    Vec4 evaluate(SignalId signal, const ShadePoint& point) const;

    /// The same, as a pigment of POV-Ray has it. What an image lets through by its alpha is transmitted.
    PigmentColor pigment(SignalId signal, const ShadePoint& point) const;

    size_t count() const { return pictures_.size(); }
    size_t bytes() const;

  private:
    struct Value {
        Vec4 rgba{0};
        double filter = 0, transmit = 0;
    };

    void add_patterns(const std::vector<SignalId>& used, Diagnostics& said);
    /// `place` is where the patterns above have moved the lookup to; null: the point's own.
    Value value(SignalId signal, const ShadePoint& point, const Vec3* place) const;
    Value mapped(const PatternSignal& signal, const Pattern& pattern, const ShadePoint& point, const Vec3* place) const;
    Vec4 lookup(const ImageSignal& image, const Picture& picture, const Vec2& uv) const;

    const std::vector<Signal>& signals_;
    std::vector<Picture> pictures_;
    std::vector<Pattern> patterns_;
    std::vector<uint32_t> resource_of_;   ///< by signal: its picture or its pattern; kNoId where the signal is neither
};

}  // namespace alidade
