// SPDX-License-Identifier: Apache-2.0
#include "exporters/pov/functions.h"

#include "eval/functions/float_functions.h"
#include "exporters/numbers.h"

#include <cmath>
#include <fmt/format.h>

namespace alidade::pov_export {

namespace {

/// Text, and how strongly it holds together: what is not an atom stands in brackets where it has to.
struct Term {
    enum Strength { sum, product, atom };
    std::string text;
    Strength strength = atom;
};

std::string in_brackets(Term term, Term::Strength wanted) { return term.strength >= wanted ? std::move(term.text) : "(" + term.text + ")"; }

/// What is no number is a formula that gives it.
Term number_term(double x) {
    if (std::isnan(x)) return {"(1e300*1e300*0)"};
    if (std::isinf(x)) return {x > 0 ? "(1e300*1e300)" : "(-1e300*1e300)"};
    std::string text;
    append_number(text, x);
    return {std::signbit(x) ? "(" + text + ")" : text};
}

/// Comparisons stand in brackets always: between < and > in a list of arguments POV-Ray sees a vector.
Term binary_term(FunctionOp op, Term a, Term b) {
    switch (op) {
        case FunctionOp::add: return {in_brackets(std::move(a), Term::sum) + " + " + in_brackets(std::move(b), Term::product), Term::sum};
        case FunctionOp::subtract: return {in_brackets(std::move(a), Term::sum) + " - " + in_brackets(std::move(b), Term::product), Term::sum};
        case FunctionOp::multiply: return {in_brackets(std::move(a), Term::product) + "*" + in_brackets(std::move(b), Term::atom), Term::product};
        case FunctionOp::divide: return {in_brackets(std::move(a), Term::product) + "/" + in_brackets(std::move(b), Term::atom), Term::product};
        default: break;
    }
    static constexpr const char* kMarks[] = {"<", ">", "=", "<=", ">=", "!=", "&", "|"};
    return {fmt::format("({} {} {})", in_brackets(std::move(a), Term::sum), kMarks[size_t(op) - size_t(FunctionOp::less)], in_brackets(std::move(b), Term::sum))};
}

std::string part_name(uint32_t function, const FunctionStep& step) {
    switch (step.op) {
        case FunctionOp::built_in: return float_functions()[step.a].name;
        case FunctionOp::internal: return fmt::format("Internal_{}", step.a);
        case FunctionOp::call: return fmt::format("Function_{}", step.a);
        case FunctionOp::transform: return fmt::format("Transform_{}_{}", function, step.a);
        case FunctionOp::spline: return fmt::format("Spline_{}_{}", function, step.a);
        case FunctionOp::pattern: return fmt::format("Number_{}", step.a);
        case FunctionOp::pigment: return fmt::format("Colour_{}", step.a);
        default: return "";
    }
}

/// What stands behind a call that gives more than one number.
std::string component_name(const FunctionStep& step) {
    static constexpr const char* kOfPoints[] = {".x", ".y", ".z", ".t", ".transmit", ".gray", ".hf"};
    static constexpr const char* kOfColours[] = {".red", ".green", ".blue", ".filter", ".transmit", ".gray", ".hf"};
    if (step.op == FunctionOp::pigment) return kOfColours[step.b];
    return step.op == FunctionOp::transform || step.op == FunctionOp::spline ? kOfPoints[step.b] : "";
}

/// Runs a program on a stack of terms instead of numbers.
class Formula {
  public:
    Formula(const FunctionProgram& program, uint32_t function, std::vector<std::string> parameters) : program_(program), function_(function), parameters_(std::move(parameters)) {}

    std::string text() {
        run(0, program_.steps.size());
        return std::move(stack_.back().text);
    }

  private:
    Term pop() {
        Term top = std::move(stack_.back());
        stack_.pop_back();
        return top;
    }

    void run(size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
            const FunctionStep& step = program_.steps[i];
            switch (step.op) {
                case FunctionOp::number: stack_.push_back(number_term(step.value)); break;
                case FunctionOp::argument: stack_.push_back({parameters_[step.a]}); break;
                case FunctionOp::counter: stack_.push_back({counter(step.a)}); break;
                case FunctionOp::negate: stack_.push_back({"(-" + in_brackets(pop(), Term::atom) + ")"}); break;
                case FunctionOp::sum:
                case FunctionOp::product: series(i), i += step.a; break;
                default: operation(step);
            }
        }
    }

    void operation(const FunctionStep& step) {
        if (part_name(function_, step).empty()) {
            Term b = pop(), a = pop();
            return stack_.push_back(binary_term(step.op, std::move(a), std::move(b)));
        }
        const size_t first = stack_.size() - taken_from_stack(step);
        std::string call = part_name(function_, step) + "(";
        for (size_t i = first; i < stack_.size(); ++i) call += (i > first ? ", " : "") + stack_[i].text;
        stack_.resize(first);
        stack_.push_back({call + ")" + component_name(step)});
    }

    std::string counter(size_t place) const { return fmt::format("N_{}", place); }

    void series(size_t at) {
        const FunctionStep& step = program_.steps[at];
        const std::string name = counter(stack_.size() - 2);
        stack_.push_back({});                                // what is added up
        run(at + 1, at + 1 + step.a);
        const std::string term = pop().text;
        pop();
        const std::string last = pop().text, first = pop().text;
        stack_.push_back({fmt::format("{}({}, {}, {}, {})", step.op == FunctionOp::sum ? "sum" : "prod", name, first, last, term)});
    }

    const FunctionProgram& program_;
    uint32_t function_;
    std::vector<std::string> parameters_;
    std::vector<Term> stack_;
};

}  // namespace

std::string FunctionWriter::formula(FunctionId id) const { return Formula(scene_.functions[id.index], id.index, {"x", "y", "z"}).text(); }

void FunctionWriter::declare_parts(FunctionId id) {
    for (const FunctionStep& step : scene_.functions[id.index].steps)
        if (const std::string name = part_name(id.index, step); !name.empty() && step.op != FunctionOp::built_in && declared_.insert(name).second) declare_part(id.index, step);
}

void FunctionWriter::declare_part(uint32_t function, const FunctionStep& step) {
    const std::string name = part_name(function, step);
    if (step.op == FunctionOp::call) return declare(step.a);
    if (step.op == FunctionOp::internal) return sdl_.line("#declare", name, "= function { internal(", step.a, ") }");
    if (step.op == FunctionOp::spline) return declare_spline(function, step.a);
    if (step.op == FunctionOp::transform) return sdl_.line("#declare", name, "= function { transform {", scene_.functions[function].transforms[step.a], "} }");
    sdl_.begin("#declare", name, "= function {", step.op == FunctionOp::pattern ? "pattern" : "pigment");
    write_pattern_({step.a}, step.op == FunctionOp::pattern);
    sdl_.end();
    sdl_.line("}");
}

void FunctionWriter::declare(uint32_t function) {
    declare_parts({function});
    std::vector<std::string> names;
    std::string list;
    for (uint32_t i = 0; i < scene_.functions[function].parameters; ++i) names.push_back(fmt::format("A_{}", i)), list += (i ? ", " : "") + names.back();
    sdl_.line("#declare", fmt::format("Function_{} = function({}) {{", function, list), Formula(scene_.functions[function], function, names).text(), "}");
}

void FunctionWriter::declare_spline(uint32_t function, uint32_t i) {
    static constexpr const char* kTypes[] = {"linear_spline", "quadratic_spline", "cubic_spline", "natural_spline"};
    const SplineCurve& curve = scene_.functions[function].splines[i];
    sdl_.begin("#declare", fmt::format("Spline_{}_{} = function {{ spline", function, i));
    sdl_.line(kTypes[size_t(curve.type)]);
    for (const auto& [t, c] : curve.knots) sdl_.line(t, ",", std::span(c.data(), curve.terms), ",");   // without a comma, a time below 0 would be taken from the vector before it
    sdl_.end();
    sdl_.line("}");
}

}  // namespace alidade::pov_export
