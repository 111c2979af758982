// SPDX-License-Identifier: Apache-2.0
/// Messages about places in an OBJ or MTL file.
#pragma once

#include "core/diagnostics.h"
#include "importers/mesh/text_cursor.h"

#include <vector>

namespace alidade::mesh {

/// Says what is wrong in one file, where, and shows the line. What a file may repeat a million times is tallied, and said once.
class Reporter {
  public:
    /// `strict`: what is tallied is an error, not a warning.
    Reporter(Diagnostics& said, uint32_t file, const TextCursor& cursor, bool strict) : said_(said), cursor_(cursor), file_(file), strict_(strict) {}

    SourcePos place(const TextCursor::Mark& at) const;
    void error(const TextCursor::Mark& at, std::string message, std::string hint = {});
    void warning(const TextCursor::Mark& at, std::string message, std::string hint = {});
    /// Counts a message that says what was left out; tell_tallies() says each with its count, at its first place.
    void tally(const TextCursor::Mark& at, const std::string& message);
    void tell_tallies();

    Diagnostics& diagnostics() { return said_; }

  private:
    struct Tally {
        std::string message;
        TextCursor::Mark first;
        size_t count;
    };
    void say(Severity severity, const TextCursor::Mark& at, std::string message, std::string hint);

    Diagnostics& said_;
    const TextCursor& cursor_;
    uint32_t file_;
    bool strict_;
    std::vector<Tally> tallies_;
};

}  // namespace alidade::mesh
