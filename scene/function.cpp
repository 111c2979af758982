// SPDX-License-Identifier: Apache-2.0
#include "scene/function.h"

#include "scene/scene.h"

#include <algorithm>
#include <functional>

namespace alidade {

namespace {

bool is_series(FunctionOp op) { return op == FunctionOp::sum || op == FunctionOp::product; }

/// Steps whose stack begins at a height of its own: a term of a series, or the whole program.
struct Stretch {
    size_t end, base;
};

}  // namespace

uint32_t taken_from_stack(const FunctionStep& step) {
    switch (step.op) {
        case FunctionOp::number:
        case FunctionOp::argument:
        case FunctionOp::counter: return 0;
        case FunctionOp::negate:
        case FunctionOp::spline: return 1;
        case FunctionOp::transform:
        case FunctionOp::pattern:
        case FunctionOp::pigment: return 3;
        case FunctionOp::built_in:
        case FunctionOp::internal:
        case FunctionOp::call: return step.b;
        default: return 2;
    }
}

std::optional<size_t> stack_height(const FunctionProgram& program) {
    const size_t count = program.steps.size();
    std::vector<Stretch> open{{count, 0}};
    size_t height = 0, highest = 1;
    for (size_t i = 0; i < count; ++i) {
        const FunctionStep& step = program.steps[i];
        const size_t taken = taken_from_stack(step);
        if (height - open.back().base < taken || (step.op == FunctionOp::counter && step.a >= height)) return std::nullopt;
        if (is_series(step.op)) {
            if (step.a == 0 || step.a > open.back().end - i - 1) return std::nullopt;
            open.push_back({i + 1 + step.a, ++height});      // what is added up stands on first and last
        } else {
            height += 1 - taken;
        }
        highest = std::max(highest, height);
        while (i + 1 == open.back().end) {
            if (height != open.back().base + 1) return std::nullopt;
            if (open.size() == 1) return highest;
            open.pop_back();
            height -= 3;
        }
    }
    return std::nullopt;                                     // there are no steps
}

FunctionWork function_work(const Scene& scene, FunctionId function) {
    FunctionWork work;
    struct Times {
        double times = 0;
        uint32_t level = 0;
    };
    std::map<uint32_t, Times, std::greater<>> reached;       // functions call those before them
    if (function.index < scene.functions.size()) reached[function.index] = {1, 0};
    for (auto at = reached.begin(); at != reached.end(); ++at) {
        const Times here = at->second;
        work.steps += here.times * double(scene.functions[at->first].steps.size());
        work.calls = std::max(work.calls, here.level);
        for (const FunctionStep& step : scene.functions[at->first].steps) {
            if (step.op == FunctionOp::pattern || step.op == FunctionOp::pigment) work.asked[{step.a}] += here.times;
            if (step.op != FunctionOp::call || step.a >= at->first) continue;
            Times& callee = reached[step.a];
            callee = {callee.times + here.times, std::max(callee.level, here.level + 1)};
        }
    }
    return work;
}

}  // namespace alidade
