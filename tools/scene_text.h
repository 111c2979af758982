// SPDX-License-Identifier: Apache-2.0
/// What a POV scene prints.
#pragma once

#include "importers/pov/settings.h"

#include <string>

namespace alidade {

/// What a scene prints with #debug, #render and #statistics goes to stderr as it comes and as it is: in POV-Ray 3.7, all three are the debug stream. Texts of #warning and #error are diagnostics, which say where.
class SceneText {
  public:
    explicit SceneText(bool shown) : shown_(shown) {}
    void print(pov::TextStream where, const std::string& text);
    /// Before other messages: ends a line that is open.
    void end_line() const;
    /// All of it, shown or not.
    const std::string& text() const { return text_; }
    /// The same, with the end of its last line.
    std::string lines() const { return line_is_open() ? text_ + "\n" : text_; }

  private:
    bool line_is_open() const { return !text_.empty() && text_.back() != '\n'; }

    bool shown_;
    std::string text_;
};

}  // namespace alidade
