// SPDX-License-Identifier: Apache-2.0
/// What each of POV-Ray's words does to a request.
#pragma once

#include "tools/povray_words.h"

#include <optional>
#include <span>
#include <string>

namespace alidade {

/// A word's value, and whether it is switched on (+) or off (-).
struct PovrayWord {
    std::string value;
    bool on = true;
};

/// "" if the value is taken, else what would be.
using ApplyPovrayWord = std::string (*)(PovrayRequest&, const PovrayWord&);

struct PovrayRow {
    const char* key;       ///< of Key=Value
    const char* letters;   ///< of the switch, or ""
    ApplyPovrayWord apply;
};

/// All that are known.
std::span<const PovrayRow> povray_table();
/// Is its value a name, of a file, a folder or a command, in which blanks may be?
bool takes_name(const PovrayRow& row);

/// on, true, yes, 1; off, false, no, 0.
std::optional<bool> truth(const std::string& text);

/// `+F`, `+FN8`, `-F`: whether there is a file, its type and its bits.
std::string file_switch(PovrayRequest& r, const PovrayWord& w);

}  // namespace alidade
