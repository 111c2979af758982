// SPDX-License-Identifier: Apache-2.0
#include "eval/functions/program.h"

#include "eval/functions/float_functions.h"
#include "eval/functions/internal.h"
#include "scene/queries.h"
#include "scene/scene.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <memory>

namespace alidade {

namespace {

double binary(FunctionOp op, double a, double b) {
    switch (op) {
        case FunctionOp::add: return a + b;
        case FunctionOp::subtract: return a - b;
        case FunctionOp::multiply: return a * b;
        case FunctionOp::divide: return a / b;
        case FunctionOp::less: return a < b;
        case FunctionOp::greater: return a > b;
        case FunctionOp::equal: return a == b;
        case FunctionOp::less_equal: return a <= b;
        case FunctionOp::greater_equal: return a >= b;
        case FunctionOp::not_equal: return a != b;
        case FunctionOp::both: return a != 0 && b != 0;
        case FunctionOp::either: return a != 0 || b != 0;
        default: return 0;
    }
}

/// Why a step cannot run here; "" if it can.
std::string refusal(const FunctionStep& step) {
    if (step.op == FunctionOp::built_in) {
        const auto rows = float_functions();
        if (step.a >= rows.size()) return fmt::format("there is no function of floats {}", step.a);
        if (step.b < rows[step.a].fewest || step.b > rows[step.a].most) return fmt::format("{} does not take {} arguments", rows[step.a].name, step.b);
    }
    if (step.op == FunctionOp::internal) {
        const InternalFunction* row = find_internal_function(step.a);
        if (!row || step.b != 3 + row->parameters) return fmt::format("there is no internal({}) of {} arguments", step.a, step.b);
    }
    return "";
}

/// The function and those that it calls, each behind what it calls.
std::vector<uint32_t> with_callees(const Scene& scene, FunctionId function) {
    std::map<uint32_t, bool> reached{{function.index, true}};
    for (auto at = reached.rbegin(); at != reached.rend(); ++at)      // what is called stands before, and is reached later
        for (const FunctionStep& step : scene.functions[at->first].steps)
            if (step.op == FunctionOp::call) reached.emplace(step.a, true);
    std::vector<uint32_t> out;
    for (const auto& [index, there] : reached) out.push_back(index);
    return out;
}

/// Behind what a function gives, POV-Ray has what was given to it.
/// Source   experiments with POV-Ray 3.7
SplineCurve::Components with_arguments(SplineCurve::Components given, size_t terms, std::span<const double> arguments) {
    for (size_t i = terms; i < given.size() && i < terms + arguments.size(); ++i) given[i] = arguments[i - terms];
    return given;
}

}  // namespace

struct FunctionRunner::Frame {
    const Steps& steps;
    const double* arguments;
    const double* bottom;
    uint64_t& turns;
};

tl::expected<FunctionRunner, std::string> FunctionRunner::make(const Scene& scene, FunctionId function, FunctionSources sources) {
    FunctionRunner out;
    out.sources_ = std::move(sources), out.noise_ = scene.settings.noise;
    std::map<uint32_t, uint32_t> number;
    std::vector<size_t> heights;
    for (const uint32_t index : with_callees(scene, function)) {
        const FunctionProgram& program = scene.functions[index];
        number.emplace(index, uint32_t(out.functions_.size()));
        Steps& steps = out.functions_.emplace_back(program.steps);
        size_t below = 0;
        for (FunctionStep& step : steps) {
            if (const std::string why = refusal(step); !why.empty()) return tl::unexpected(why);
            if (step.op == FunctionOp::call) step.a = number.at(step.a), below = std::max(below, heights[step.a]);
            if (step.op == FunctionOp::transform) step.a += uint32_t(out.transforms_.size());
            if (step.op == FunctionOp::spline) step.a += uint32_t(out.splines_.size());
        }
        out.transforms_.insert(out.transforms_.end(), program.transforms.begin(), program.transforms.end());
        for (const SplineCurve& curve : program.splines) out.splines_.emplace_back(curve);
        heights.push_back(below + stack_height(program).value_or(0));
    }
    out.height_ = heights.back();
    return out;
}

double FunctionRunner::value(std::span<const double> arguments) const {
    uint64_t own = kMostTurns;
    uint64_t& turns = sources_.turns ? *sources_.turns : own;
    constexpr size_t kUsual = 64;
    if (height_ > kUsual) return call(functions_.back(), arguments.data(), std::vector<double>(height_).data(), turns);
    double stack[kUsual];
    return call(functions_.back(), arguments.data(), stack, turns);
}

double FunctionRunner::call(const Steps& steps, const double* arguments, double* bottom, uint64_t& turns) const {
    return *(run({steps, arguments, bottom, turns}, 0, steps.size(), bottom) - 1);
}

double* FunctionRunner::run(const Frame& frame, size_t begin, size_t end, double* top) const {
    for (size_t i = begin; i < end; ++i) {
        const FunctionStep& step = frame.steps[i];
        switch (step.op) {
            case FunctionOp::number: *top++ = step.value; break;
            case FunctionOp::argument: *top++ = frame.arguments[step.a]; break;
            case FunctionOp::counter: *top++ = frame.bottom[step.a]; break;
            case FunctionOp::negate: top[-1] = -top[-1]; break;
            case FunctionOp::call:
                top -= step.b;
                *top = call(functions_[step.a], top, top + step.b, frame.turns);
                ++top;
                break;
            case FunctionOp::sum:
            case FunctionOp::product:
                top[-2] = series(frame, i, top);
                --top;
                i += step.a;
                break;
            case FunctionOp::built_in:
            case FunctionOp::internal:
            case FunctionOp::transform:
            case FunctionOp::spline:
            case FunctionOp::pattern:
            case FunctionOp::pigment:
                top -= taken_from_stack(step);
                *top = asked(step, top);
                ++top;
                break;
            default:
                --top;
                top[-1] = binary(step.op, top[-1], *top);
        }
    }
    return top;
}

/// With first, where it counts, and last below `top`.
double FunctionRunner::series(const Frame& frame, size_t at, double* top) const {
    const FunctionStep& step = frame.steps[at];
    const bool adds = step.op == FunctionOp::sum;
    double& all = *top = adds ? 0 : 1;
    for (double& i = top[-2]; i <= top[-1] && frame.turns > 0; ++i, --frame.turns) {
        const double term = *(run(frame, at + 1, at + 1 + step.a, top + 1) - 1);
        all = adds ? all + term : all * term;
    }
    return all;
}

double FunctionRunner::asked(const FunctionStep& step, const double* a) const {
    switch (step.op) {
        case FunctionOp::built_in: return float_functions()[step.a].value({a, step.b});
        case FunctionOp::internal: return find_internal_function(step.a)->value({a[0], a[1], a[2]}, {a + 3, step.b - 3}, noise_);
        case FunctionOp::spline: return component_of(with_arguments(splines_[step.a].value(a[0]), splines_[step.a].terms(), {a, 1}), step.b);
        case FunctionOp::pattern: return sources_.number({step.a}, {a[0], a[1], a[2]});
        case FunctionOp::pigment: return component_of(sources_.color({step.a}, {a[0], a[1], a[2]}), step.b);
        default: break;
    }
    const Vec3 moved = transforms_[step.a].point({a[0], a[1], a[2]});
    return component_of(with_arguments({moved.x, moved.y, moved.z}, 3, {a, 3}), step.b);
}

double component_of(const SplineCurve::Components& c, uint32_t component) {
    constexpr double kCoarse = 0.996093, kFine = kCoarse / 255;   // POV-Ray's digits
    if (component == kHeightComponent) return kCoarse * c[0] + kFine * c[1];
    return component == kGreyComponent ? pov_grey({c[0], c[1], c[2]}) : c[component];
}

std::function<double(const Vec3&)> pattern_of_function(FunctionRunner runner) {
    const auto shared = std::make_shared<const FunctionRunner>(std::move(runner));
    return [shared](const Vec3& p) {
        const double xyz[] = {p.x, p.y, p.z}, value = shared->value(xyz);
        return value > 1 ? std::fmod(value, 1.0) : value;
    };
}

}  // namespace alidade
