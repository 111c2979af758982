// SPDX-License-Identifier: Apache-2.0
/// Signals -> pigments and normals.
#pragma once

#include "exporters/losses.h"
#include "exporters/pov/functions.h"
#include "exporters/pov/images.h"
#include "exporters/pov/sdl.h"

namespace alidade::pov_export {

/// Patterns are declared once, operands first, and named where they are used: a graph of signals stays as small as it is.
class PatternWriter {
  public:
    PatternWriter(const Scene& scene, Sdl& sdl, ImageWriter& images, Losses& losses)
        : scene_(scene), sdl_(sdl), images_(images), losses_(losses), functions_(scene, sdl, [this](SignalId id, bool number) { asked_by_function(id, number); }) {}
    PatternWriter(const PatternWriter&) = delete;   // functions point back to it

    /// Declares all that `roots` lead to.
    void declare(const std::vector<SignalId>& roots);
    /// What stands in `pigment { }`: a colour, or the name of what was declared.
    void pigment(SignalId id);
    /// `color_map { }` or `pigment_map { }` of a pattern.
    void pigment_map(const PatternSignal& s);
    /// `pigment { }` itself.
    void pigment_block(SignalId id);
    /// `normal { }`.
    void normal_block(SignalId id);
    /// The pattern's name and what belongs to it, without a map.
    void pattern_head(const PatternSignal& s);
    /// Waves, turbulence, warps.
    void pattern_modifiers(const PatternSignal& s);
    /// How many things stand behind the name of a pattern of blocks instead of in a map; 0 for the others.
    static size_t list_length(const PatternSignal& s);

  private:
    void declare_one(SignalId id);
    void pigment_pattern(const PatternSignal& s);
    void asked_by_function(SignalId id, bool number);
    void relief(const ReliefSignal& r);
    void picture(const PatternSignal& s);
    void parameters(const PatternSignal& s);
    std::string item(SignalId id, const char* kind) const;
    ExactColour colour(SignalId id) const;
    void declare_unit(const std::vector<SignalId>& all);
    bool is_colour(SignalId id) const;

    const Scene& scene_;
    Sdl& sdl_;
    ImageWriter& images_;
    Losses& losses_;
    FunctionWriter functions_;
};

/// The number of waves is one for the whole scene in POV-Ray: that of the first pattern that has one, else 10.
int number_of_waves(const Scene& scene);

}  // namespace alidade::pov_export
