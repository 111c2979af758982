// SPDX-License-Identifier: Apache-2.0
/// Brute force, asked about a few rays.
#pragma once

#include "stress/run.h"

#include <array>

namespace alidade {

class StressOracle {
  public:
    explicit StressOracle(const StressScene& scene) : scene_(scene) {}

    StressHit answer(const StressRay& ray, Question question, const std::string& precision);
    /// What it takes in memory, about: by the triangle.
    static constexpr size_t kBytes = 160;

  private:
    const StressScene& scene_;
    std::array<std::unique_ptr<StressPeer>, 2> brute_;   ///< in float and in double
};

/// Any-hit answers stand as hits of a primitive 0.
StressHit any_hit(bool hit);

/// Is `got` what an inexact peer may say where `wanted` is right?
bool is_near(const StressHit& got, const StressHit& wanted, Question question);

}  // namespace alidade
