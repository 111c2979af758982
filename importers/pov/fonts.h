// SPDX-License-Identifier: Apache-2.0
/// TrueType fonts: glyphs as outlines of quadratic Bezier curves, as exact as the file has them.
#pragma once

#include "scene/shape.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace alidade::pov {

/// The em of the font is 1.
struct Glyph {
    std::vector<Outline> outlines;
    double advance = 0;
    double left = 0;             ///< the left side bearing: of a simple glyph, the smallest x
    double moved = 0;            ///< by how much the outlines stand farther to the right than the font says: POV-Ray counts the bearing of composite glyphs, such as letters with accents, twice (by experiment)
};

class Font {
  public:
    /// The font in these bytes, or nothing if it is not a TrueType font.
    static std::optional<Font> read(std::string bytes);
    Font(Font&&) noexcept;
    ~Font();

    /// The glyph that the font has for a character: that of "missing" if there is none. By `ascii`, which is POV-Ray's way without `charset utf8`, a number is looked up among those
    /// of the Macintosh, where 142 is e with an acute accent, if the font has them (by experiment).
    uint32_t glyph_of(uint32_t character, bool ascii) const;
    /// Nothing if its curves are not quadratic, or the font is damaged.
    std::optional<Glyph> glyph(uint32_t index) const;
    /// What is added between two glyphs.
    double kerning(uint32_t left, uint32_t right) const;

  private:
    struct Face;
    explicit Font(std::unique_ptr<Face> face);
    std::unique_ptr<Face> face_;
};

}  // namespace alidade::pov
