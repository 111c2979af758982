// SPDX-License-Identifier: Apache-2.0
#include "scene/dump_line.h"

namespace alidade {

namespace {

constexpr const char* kOps[] = {"number", "argument", "counter", "negate", "add", "subtract", "multiply", "divide", "less", "greater", "equal", "less_equal", "greater_equal", "not_equal", "both", "either",
                                "built_in", "internal", "call", "transform", "spline", "pattern", "pigment", "sum", "product"};
static_assert(std::size(kOps) == size_t(FunctionOp::product) + 1);
constexpr const char* kSplines[] = {"linear", "quadratic", "cubic", "natural"};

}  // namespace

void dump_function(std::string& out, size_t i, const FunctionProgram& f) {
    Line(out, fmt::format("function {}", i)).field("parameters", f.parameters, 3u);
    for (const FunctionStep& s : f.steps) Line(out, " ").word(kOps[size_t(s.op)]).field("a", s.a).field("b", s.b).field("value", s.value);
    for (const Transform& t : f.transforms) Line(out, "  transform").always("to", t);
    for (const SplineCurve& s : f.splines) {
        Line(out, "  spline").word(kSplines[size_t(s.type)]).field("terms", unsigned(s.terms), 5u);
        for (const auto& [t, c] : s.knots) Line(out, "    knot").always("at", t).always("value", std::vector<double>(c.begin(), c.end()));
    }
}

}  // namespace alidade
