// SPDX-License-Identifier: Apache-2.0
/// What is varied: options of `render`, and placeholders of external commands, with the values that each takes.
#pragma once

#include "tools/options.h"
#include "tools/values.h"

#include <set>
#include <span>

namespace alidade::tradeoff {

/// An option without its dashes, and its value; a flag's is "true" or "false".
struct Choice {
    std::string name, value;
    friend bool operator==(const Choice&, const Choice&) = default;
};
using Setting = std::vector<Choice>;

struct Axis {
    std::string name;
    std::vector<std::string> values;
};

/// "spp=1,4,16"; where values have commas themselves they are separated by ';'.
Value<Axis> parse_axis(const std::string& text);

struct Mode {
    enum class Kind { full, one, halton } kind = Kind::full;
    size_t points = 0;   ///< of halton
};
/// "full", "one", "halton:N".
Value<Mode> parse_mode(const std::string& word);

/// More would take days; nobody means them.
inline constexpr size_t kMostSettings = 4096;

/// The settings of a mode, all different, the first axis slowest: every combination; each axis alone, the others as they are by default; or N points that
/// Halton's sequence spreads over the axes (fewer, where there are no more).
/// Source   Halton, "On the efficiency of certain quasi-random sequences of points", Numerische Mathematik 2 (1960).
Value<std::vector<Setting>> expand(std::span<const Axis> axes, const Mode& mode);

/// `base` with the options of `setting` in place of its own; those that may be given more than once are added to it.
Setting combined(const Setting& base, const Setting& setting);

/// As the command line has it: --name=value.
Words as_words(const Setting& setting);
/// "spp=4 accel=grid", or "default" where nothing is varied.
std::string label(const Setting& setting);

/// A scene and what is asked of it, through the parser of `render`, whose sentence an error is.
Value<Request> parse_request(const std::string& scene, const Setting& setting);

/// The options of `render` that `app` was given.
Setting given_options(const CLI::App& app);
/// Without dashes: those that `render` knows; and of them, those that decide how a scene is read.
const std::set<std::string>& render_options();
const std::set<std::string>& reading_options();

}  // namespace alidade::tradeoff
