// SPDX-License-Identifier: Apache-2.0
/// Functions, asked while a scene is read.
#pragma once

#include "core/vec.h"
#include "importers/pov/parser.h"
#include "scene/material.h"

#include <span>

namespace alidade::pov {

/// What patterns take that name no generator: as the last global_settings has it.
NoiseGenerator usual_noise(const Parser& p);

/// Builds functions, and the patterns and pigments that they ask, into a scene of their own, each once as long as there is room, and asks eval/.
class SpaceFunctions {
  public:
    explicit SpaceFunctions(Parser& p);
    ~SpaceFunctions();

    /// Of a function of a number. Fails with a place, which is `at` for the call itself.
    double number(const Function& function, std::span<const double> arguments, Place at);
    /// Red, green, blue, filter, transmit of a `pigment { }` at a point.
    std::array<double, 5> pigment(const Block& block, const Vec3& at);

  private:
    struct Stage;
    Stage& stage();

    Parser& p_;
    std::unique_ptr<Stage> stage_;
};

}  // namespace alidade::pov
