// SPDX-License-Identifier: Apache-2.0
/// Programs of functions -> formulas.
#pragma once

#include "exporters/pov/sdl.h"
#include "scene/scene.h"

#include <functional>
#include <set>
#include <string>

namespace alidade::pov_export {

/// Functions are declared once, with what they ask, and called where they are used.
class FunctionWriter {
  public:
    /// `write_pattern`: what stands in `pattern { }`, or (false) in `pigment { }`, of a signal.
    FunctionWriter(const Scene& scene, Sdl& sdl, std::function<void(SignalId, bool)> write_pattern) : scene_(scene), sdl_(sdl), write_pattern_(std::move(write_pattern)) {}

    /// Declares all that a function calls and asks, and that is not declared yet. The pigments must be.
    void declare_parts(FunctionId id);
    /// The function of a pattern, of x, y, z, whose parts are declared.
    std::string formula(FunctionId id) const;

  private:
    void declare(uint32_t function);
    void declare_part(uint32_t function, const FunctionStep& step);
    void declare_spline(uint32_t function, uint32_t i);

    const Scene& scene_;
    Sdl& sdl_;
    std::function<void(SignalId, bool)> write_pattern_;
    std::set<std::string> declared_;
};

}  // namespace alidade::pov_export
