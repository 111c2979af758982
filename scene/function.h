// SPDX-License-Identifier: Apache-2.0
/// The formulas of a scene, of which patterns are made: each is a program for a stack of numbers, which eval/functions/program.h runs.
#pragma once

#include "core/transform.h"
#include "scene/ids.h"

#include <array>
#include <map>
#include <optional>
#include <vector>

namespace alidade {

struct Scene;

/// A curve of up to five components through knots, which stand in the order of their parameter (POV-Ray's `spline`). Constant outside.
struct SplineCurve {
    using Components = std::array<double, 5>;
    enum class Type { linear, quadratic, cubic, natural };
    Type type = Type::linear;
    std::vector<std::pair<double, Components>> knots;
    uint8_t terms = 5;                              ///< how many components its knots have; the others are 0
};

/// What a step takes from the top of the stack, and leaves there: always one number.
enum class FunctionOp : uint8_t {
    number,                                         ///< takes nothing; leaves `value`
    argument, counter,                              ///< takes nothing; argument `a`, or what stands at place `a` of the function's own stack: where a series counts
    negate, add, subtract, multiply, divide,
    less, greater, equal, less_equal, greater_equal, not_equal, both, either,   ///< leave 1 or 0
    built_in,                                       ///< takes `b` arguments of row `a` of float_functions() (eval/functions/float_functions.h)
    internal,                                       ///< takes x, y, z and `b` - 3 more arguments of POV-Ray's `internal(a)` (eval/functions/internal.h)
    call,                                           ///< takes `b` arguments of function `a`, which stands before this one in the scene
    transform, spline,                              ///< takes a point or a parameter; component `b` of where transforms[a] moves the point, or of splines[a] there; beyond their own are the arguments
    pattern, pigment,                               ///< takes a point; the number of the pattern that signal `a` is, or component `b` of its colour
    sum, product,                                   ///< takes first and last; the sum or product of what the next `a` steps leave, for all numbers from the first by ones that are not beyond the last
};

/// Components of colours: red, green, blue, filter, transmit, and these: the grey, and POV-Ray's number of a height field whose fine part is green.
inline constexpr uint32_t kGreyComponent = 5, kHeightComponent = 6;

struct FunctionStep {
    FunctionOp op = FunctionOp::number;
    uint32_t a = 0, b = 0;
    double value = 0;

    friend bool operator==(const FunctionStep&, const FunctionStep&) = default;
};

/// A function of numbers whose steps leave one number. A series has three places of the stack while it runs: where it counts (first), last, and what was added up.
struct FunctionProgram {
    uint32_t parameters = 3;
    std::vector<FunctionStep> steps;
    std::vector<Transform> transforms;
    std::vector<SplineCurve> splines;
};

/// How many numbers a step takes from the stack.
uint32_t taken_from_stack(const FunctionStep& step);

/// How high a program's own stack becomes, without those of the functions that it calls; nothing where its steps do not fit together.
std::optional<size_t> stack_height(const FunctionProgram& program);

/// What one value of a function costs, if all series have one term.
struct FunctionWork {
    double steps = 0;                       ///< of it and of all functions that it calls, as often as they are called
    uint32_t calls = 0;                     ///< that stand in one another, at the most
    std::map<SignalId, double> asked;       ///< patterns and pigments, and how often
};
FunctionWork function_work(const Scene& scene, FunctionId function);

}  // namespace alidade
