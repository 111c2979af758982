// SPDX-License-Identifier: Apache-2.0
/// A function of a scene, ready to be asked: at render time by many threads, and while a scene is read.
#pragma once

#include "core/vec.h"
#include "eval/functions/spline.h"
#include "scene/material.h"

#include <functional>
#include <span>
#include <string>
#include <tl/expected.hpp>

namespace alidade {

struct Scene;

/// Who knows what a function asks that is no arithmetic.
struct FunctionSources {
    std::function<double(SignalId pattern, const Vec3& p)> number;
    std::function<SplineCurve::Components(SignalId pigment, const Vec3& p)> color;   ///< red, green, blue, filter, transmit
    uint64_t* turns = nullptr;   ///< how many the loops of all functions may still make; null: each value has kMostTurns. At 0 a loop ends, and what is there counts
};

/// Keeps nothing of the scene but what `sources` do. Never allocates to be asked, but for stacks that no usual function needs.
class FunctionRunner {
  public:
    static constexpr uint64_t kMostTurns = 1'000'000;

    /// Of a function of a valid scene; or why not: it asks for what is not known here.
    static tl::expected<FunctionRunner, std::string> make(const Scene& scene, FunctionId function, FunctionSources sources);

    double value(std::span<const double> arguments) const;

  private:
    using Steps = std::vector<FunctionStep>;
    struct Frame;

    double call(const Steps& steps, const double* arguments, double* bottom, uint64_t& turns) const;
    double* run(const Frame& frame, size_t begin, size_t end, double* top) const;
    double series(const Frame& frame, size_t at, double* top) const;
    double asked(const FunctionStep& step, const double* arguments) const;

    FunctionSources sources_;
    std::vector<Steps> functions_;           ///< those that it calls, each behind what it calls; the last is its own
    std::vector<Transform> transforms_;
    std::vector<SplineEvaluator> splines_;
    NoiseGenerator noise_ = NoiseGenerator::range_corrected;
    size_t height_ = 0;                      ///< of the stack, at the most
};

/// A component of a colour or a vector; kGreyComponent is POV-Ray's grey, kHeightComponent its `.hf`.
/// Source   experiments with POV-Ray 3.7
double component_of(const SplineCurve::Components& c, uint32_t component);

/// The number of a function at a place, as POV-Ray's patterns begin with it: above 1, its fraction.
/// Source   experiments with POV-Ray 3.7
std::function<double(const Vec3&)> pattern_of_function(FunctionRunner runner);

}  // namespace alidade
