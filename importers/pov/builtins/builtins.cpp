// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builtins/builtins.h"

#include "importers/pov/expressions.h"

#include <array>

namespace alidade::pov {

namespace {

std::array<Builtin, kWordCount> by_word() {
    std::array<Builtin, kWordCount> all{};
    for (std::span<const BuiltinEntry> table : {float_functions(), vector_functions(), string_functions(), object_functions(), constants()})
        for (const BuiltinEntry& entry : table) all[entry.word] = entry.evaluate;
    return all;
}

}  // namespace

Builtin find_builtin(WordId word) {
    static const std::array<Builtin, kWordCount> all = by_word();
    return all[word];
}

void close(Parser& p) { p.expect(')', "behind the arguments of a function"); }

Value of_three(const Vec3& v) { return Value::vector(3, {v.x, v.y, v.z}); }

double one_float(Parser& p) {
    p.expect('(', "before the arguments of a function");
    const double x = parse_float(p);
    close(p);
    return x;
}

double next_float(Parser& p) {
    p.accept(',');
    return parse_float(p);
}

Value one_value(Parser& p) {
    p.expect('(', "before the arguments of a function");
    Value value = parse_expression(p);
    close(p);
    return value;
}

}  // namespace alidade::pov
