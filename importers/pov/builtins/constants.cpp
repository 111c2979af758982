// SPDX-License-Identifier: Apache-2.0
/// Constants and variables of the language (POV-Ray reference, 3.3.1.5.5, 3.3.1.5.6, 3.3.1.6.6).
#include "importers/pov/builtins/builtins.h"

#include <chrono>
#include <filesystem>
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
    {"clock"_w, of_frame<&FrameSettings::clock>}, {"clock_on"_w, of_frame<&FrameSettings::clock_on>},
};

}  // namespace

std::span<const BuiltinEntry> constants() { return kConstants; }

void predeclare(Parser& p) {
    const FrameSettings& f = p.options.frame;
    const std::pair<std::string_view, double> numbers[] = {
        {"clock_delta", f.clock_delta}, {"initial_clock", f.initial_clock}, {"final_clock", f.final_clock}, {"initial_frame", f.initial_frame},
        {"final_frame", f.final_frame}, {"frame_number", f.frame_number},   {"image_width", f.image_width}, {"image_height", f.image_height},
    };
    const auto set = [&](std::string_view name, Value value) {
        const WordId id = p.names.id(name);
        if (!p.symbols.find(id)) p.symbols.global(id).value = std::move(value);
    };
    for (const auto& [name, value] : numbers) set(name, Value::number(value));
    set("input_file_name", Value::string(std::filesystem::path(p.stream.source(0).path()).filename().string()));
}

}  // namespace alidade::pov
