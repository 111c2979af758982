// SPDX-License-Identifier: Apache-2.0
/// Functions whose body is no expression, `pattern { }`, `pigment { }` or `internal(N)`: asked at points while a scene is read.
#pragma once

#include "eval/functions/internal.h"
#include "importers/pov/parser.h"

namespace alidade::pov {

/// The block of a function that is nothing but `pattern { }` or `pigment { }` (or `transform { }`), or null.
const Block* block_of(const Function& function);
/// The row of a function that is nothing but `internal(N)`, or null. Fails for numbers that are not modelled.
const InternalFunction* internal_of(const Parser& p, const Function& function);

/// What patterns take that name no generator: as the last global_settings has it.
NoiseGenerator usual_noise(const Parser& p);

/// Builds patterns and pigments into a scene of their own, each once as long as there is room, and asks eval/.
class SpaceFunctions {
  public:
    explicit SpaceFunctions(Parser& p);
    ~SpaceFunctions();

    /// The number of a `pattern { }` at a point.
    double pattern(const Block& block, const Vec3& at);
    /// Red, green, blue, filter, transmit of a `pigment { }` at a point.
    std::array<double, 5> pigment(const Block& block, const Vec3& at);

  private:
    struct Stage;
    Stage& stage();

    Parser& p_;
    std::unique_ptr<Stage> stage_;
};

}  // namespace alidade::pov
