// SPDX-License-Identifier: Apache-2.0
/// Pigments that stand nowhere but in space, asked point by point.
#pragma once

#include "eval/patterns/pattern.h"
#include "scene/scene.h"

#include <unordered_map>

namespace alidade {

/// A colour of POV-Ray's: what part of the light that passes is coloured (filter), what part is not (transmit).
struct PigmentColor {
    Color color{0};
    double filter = 0, transmit = 0;
};

/// Constants, patterns, and maps of them. The scene may grow meanwhile.
class SpacePigments {
  public:
    /// `scene` must outlive the pigments.
    explicit SpacePigments(const Scene& scene) : scene_(scene) {}
    SpacePigments(const SpacePigments&) = delete;   // patterns hold on to it
    SpacePigments& operator=(const SpacePigments&) = delete;

    /// Makes all that `root` reads ready; or says why it has no value in space.
    tl::expected<void, std::string> prepare(SignalId root);
    /// Of a pigment that is ready. As POV-Ray's own map from black to white where a pattern has none.
    PigmentColor color(SignalId pigment, const Vec3& p) const;

    /// The grey of the pigment that the pattern takes, which must be ready when it is asked; none where it takes none.
    PatternSource source_of(const PatternSignal& signal) const;

  private:
    const Scene& scene_;
    std::unordered_map<uint32_t, Pattern> patterns_;
};

}  // namespace alidade
