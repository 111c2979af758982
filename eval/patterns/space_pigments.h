// SPDX-License-Identifier: Apache-2.0
/// Pigments that stand nowhere but in space, asked point by point.
#pragma once

#include "eval/functions/program.h"
#include "eval/patterns/pattern.h"
#include "eval/patterns/picture.h"
#include "scene/scene.h"

#include <unordered_map>

namespace alidade {

/// Constants, patterns, pictures, and maps of them. The scene may grow meanwhile.
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

    /// Of a pattern that is ready.
    double number(SignalId pattern, const Vec3& p) const { return patterns_.at(pattern.index).value(p); }
    /// A function of the scene; the patterns and pigments that it asks must be ready by then.
    tl::expected<FunctionRunner, std::string> runner(FunctionId function) const;
    /// How many turns the loops of all functions may still make (FunctionSources::turns); null: no matter.
    uint64_t* turns = nullptr;

    /// The pattern, with the grey of the pigment that it takes, which must be ready when it is asked, or the picture that it shows, which is read now.
    tl::expected<Pattern, std::string> make(const PatternSignal& signal);

  private:
    const Scene& scene_;
    std::unordered_map<uint32_t, Pattern> patterns_;
    SpacePictures pictures_;
};

}  // namespace alidade
