// SPDX-License-Identifier: Apache-2.0
#include "scene/validation.h"

#include <algorithm>

namespace alidade {

namespace {

void check_step(Validation& v, const FunctionProgram& f, size_t i, const FunctionStep& step) {
    const Label who = label("function", i);
    const auto below = [&](size_t count, const char* what) {
        if (step.a >= count) v.error({}, fmt::format("{} refers to {} {}, but there are only {}", who.text(), what, step.a, count));
    };
    switch (step.op) {
        case FunctionOp::argument: return below(f.parameters, "parameter");
        case FunctionOp::call:
            if (step.a < i && v.scene.functions[step.a].parameters != step.b) v.error({}, fmt::format("{} calls function {} with {} arguments", who.text(), step.a, step.b));
            return below(i, "a function before it,");
        case FunctionOp::transform: return below(f.transforms.size(), "transformation");
        case FunctionOp::spline: return below(f.splines.size(), "spline");
        case FunctionOp::pattern:
            if (step.a < v.scene.signals.size() && !std::holds_alternative<PatternSignal>(v.scene.signals[step.a].what)) v.error({}, fmt::format("{} asks signal {} for a number, which is no pattern", who.text(), step.a));
            return below(v.scene.signals.size(), "signal");
        case FunctionOp::pigment:
            if (step.a < v.scene.signals.size() && std::holds_alternative<ReliefSignal>(v.scene.signals[step.a].what)) v.error({}, fmt::format("{} asks signal {} for a colour, which is a relief", who.text(), step.a));
            return below(v.scene.signals.size(), "signal");
        default: return;
    }
}

bool in_order(const SplineCurve& s) {
    return !s.knots.empty() && std::is_sorted(s.knots.begin(), s.knots.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
}

bool has_component(const FunctionStep& step) { return step.op == FunctionOp::transform || step.op == FunctionOp::spline || step.op == FunctionOp::pigment; }

}  // namespace

void check_functions(Validation& v) {
    for (size_t i = 0; i < v.scene.functions.size(); ++i) {
        const FunctionProgram& f = v.scene.functions[i];
        for (const FunctionStep& step : f.steps) {
            check_step(v, f, i, step);
            if (has_component(step) && step.b > kHeightComponent) v.error({}, fmt::format("{} asks for component {}", label("function", i).text(), step.b));
        }
        for (const SplineCurve& s : f.splines)
            if (!in_order(s)) v.error({}, fmt::format("{} has a spline whose knots are not in order, or which has none", label("function", i).text()));
        for (const SplineCurve& s : f.splines)
            if (s.terms < 1 || s.terms > std::tuple_size_v<SplineCurve::Components>) v.error({}, fmt::format("{} has a spline of {} components", label("function", i).text(), s.terms));
        if (!stack_height(f)) v.error({}, fmt::format("{} has steps that do not fit together", label("function", i).text()));
    }
}

}  // namespace alidade
