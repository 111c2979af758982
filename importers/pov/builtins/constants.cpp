// SPDX-License-Identifier: Apache-2.0
/// Constants and variables of the language (POV-Ray reference, 3.3.1.5.5, 3.3.1.5.6, 3.3.1.6.6).
#include "importers/pov/builtins/builtins.h"

#include <chrono>
#include <numbers>

namespace alidade::pov {

namespace {

template <int value>
Value whole(Parser&, Place) { return Value::number(value); }

template <int axis, int terms>
Value unit(Parser&, Place) {
    Value v = Value::vector(terms, {});
    v.c[axis] = 1;
    return v;
}

template <auto member>
Value of_frame(Parser& p, Place) { return Value::number(double(p.options.frame.*member)); }

Value pi(Parser&, Place) { return Value::number(std::numbers::pi); }
Value version(Parser& p, Place) { return Value::number(p.version); }

/// Days since the first day of 2000, in UTC.
Value now(Parser&, Place) {
    using namespace std::chrono;
    return Value::number(duration<double, days::period>(system_clock::now() - sys_days(year(2000) / 1 / 1)).count());
}

constexpr BuiltinEntry kConstants[] = {
    {"pi"_w, pi}, {"true"_w, whole<1>}, {"yes"_w, whole<1>}, {"on"_w, whole<1>}, {"false"_w, whole<0>}, {"no"_w, whole<0>}, {"off"_w, whole<0>},
    {"x"_w, unit<0, 3>}, {"y"_w, unit<1, 3>}, {"z"_w, unit<2, 3>}, {"t"_w, unit<3, 4>}, {"u"_w, unit<0, 2>}, {"v"_w, unit<1, 2>},
    {"version"_w, version}, {"now"_w, now},
    {"clock"_w, of_frame<&FrameSettings::clock>}, {"clock_delta"_w, of_frame<&FrameSettings::clock_delta>}, {"clock_on"_w, of_frame<&FrameSettings::clock_on>},
    {"initial_clock"_w, of_frame<&FrameSettings::initial_clock>}, {"final_clock"_w, of_frame<&FrameSettings::final_clock>},
    {"initial_frame"_w, of_frame<&FrameSettings::initial_frame>}, {"final_frame"_w, of_frame<&FrameSettings::final_frame>},
    {"frame_number"_w, of_frame<&FrameSettings::frame_number>},
    {"image_width"_w, of_frame<&FrameSettings::image_width>}, {"image_height"_w, of_frame<&FrameSettings::image_height>},
};

}  // namespace

std::span<const BuiltinEntry> constants() { return kConstants; }

}  // namespace alidade::pov
