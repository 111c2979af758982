// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/function_values.h"

#include "importers/pov/builders/transforms.h"
#include "importers/pov/builtins/builtins.h"
#include "importers/pov/functions.h"
#include "importers/pov/integers.h"
#include "importers/pov/operators.h"
#include "importers/pov/space_functions.h"

#include <cmath>
#include <fmt/format.h>

namespace alidade::pov {

namespace {

constexpr int kMostCalls = 200;      // of functions inside one another
constexpr uint64_t kStepsOfCall = 4; // what a call in a function counts as, among the steps of the scene

/// A built-in of floats; `arity` 0: any number.
struct FloatFunction {
    WordId word;
    int arity;
    double (*value)(std::span<const double> a);
};

double atan_of_two(std::span<const double> a) { return std::atan2(a[0], a[1]); }
double least(std::span<const double> a) { return *std::min_element(a.begin(), a.end()); }
double greatest(std::span<const double> a) { return *std::max_element(a.begin(), a.end()); }
double select_sign(std::span<const double> a) { return a[0] < 0 ? a[1] : a.size() < 4 || a[0] == 0 ? a[2] : a[3]; }

template <double (*function)(double)>
double of_one(std::span<const double> a) { return function(a[0]); }
double degrees(double x) { return x * (180.0 / std::numbers::pi); }
double radians(double x) { return x * (std::numbers::pi / 180.0); }

constexpr FloatFunction kFunctions[] = {
    {"abs"_w, 1, of_one<std::fabs>}, {"acos"_w, 1, of_one<std::acos>}, {"acosh"_w, 1, of_one<std::acosh>}, {"asin"_w, 1, of_one<std::asin>},
    {"asinh"_w, 1, of_one<std::asinh>}, {"atan"_w, 1, of_one<std::atan>}, {"atanh"_w, 1, of_one<std::atanh>}, {"ceil"_w, 1, of_one<std::ceil>},
    {"cos"_w, 1, of_one<std::cos>}, {"cosh"_w, 1, of_one<std::cosh>}, {"exp"_w, 1, of_one<std::exp>}, {"floor"_w, 1, of_one<std::floor>},
    {"ln"_w, 1, of_one<std::log>}, {"log"_w, 1, of_one<std::log10>}, {"sin"_w, 1, of_one<std::sin>}, {"sinh"_w, 1, of_one<std::sinh>},
    {"sqrt"_w, 1, of_one<std::sqrt>}, {"tan"_w, 1, of_one<std::tan>}, {"tanh"_w, 1, of_one<std::tanh>}, {"degrees"_w, 1, of_one<degrees>},
    {"radians"_w, 1, of_one<radians>}, {"int"_w, 1, of_one<std::trunc>}, {"atan2"_w, 2, atan_of_two},
    {"mod"_w, 2, [](std::span<const double> a) { return std::fmod(a[0], a[1]); }}, {"pow"_w, 2, [](std::span<const double> a) { return std::pow(a[0], a[1]); }},
    {"div"_w, 2, [](std::span<const double> a) { return std::trunc(a[0] / a[1]); }}, {"min"_w, 0, least}, {"max"_w, 0, greatest}, {"select"_w, 0, select_sign},
};

void check_count(const Parser& p, size_t parameters, size_t arguments, Place at) {
    if (parameters != arguments) p.fail(at, fmt::format("the function takes {} argument{}, and {} are given", parameters, parameters == 1 ? "" : "s", arguments));
}

SpaceFunctions& space_functions(Parser& p) {
    if (!p.functions) p.functions = std::make_unique<SpaceFunctions>(p);
    return *p.functions;
}

/// Of a pattern or one of POV-Ray's own functions; nothing for others.
std::optional<double> value_in_space(Parser& p, const Function& function, std::span<const double> arguments, Place at) {
    const Block* block = block_of(function);
    const InternalFunction* internal = internal_of(p, function);
    const bool pattern = block && block->word == "pattern"_w;
    if (!pattern && !internal) return std::nullopt;
    check_count(p, 3 + (internal ? internal->parameters : 0), arguments.size(), at);
    const Vec3 point(arguments[0], arguments[1], arguments[2]);
    return internal ? internal->value(point, arguments.subspan(3), usual_noise(p)) : space_functions(p).pattern(*block, point);
}

/// Reads a function's parts from left to right, and calculates at once. Comparisons are exact here (probed).
class Evaluation {
  public:
    Evaluation(Parser& p, const Function& function, std::span<const double> arguments, int calls, size_t depth = 0) : p_(p), f_(function), arguments_(arguments), calls_(calls), depth_(depth) {}

    double all() {
        const double value = logical();
        if (!at_end()) not_expected();
        return value;
    }

  private:
    /// Guards the call stack: stands where brackets, signs and calls nest.
    struct Level {
        explicit Level(Evaluation& evaluation) : of(evaluation) {
            constexpr size_t kDeepest = 1000;   // sanitizers have large frames
            if (++of.depth_ > kDeepest) of.p_.fail_limit(of.f_.place, fmt::format("brackets and calls of a function are nested too deeply: more than {} in one another", kDeepest));
        }
        Level(const Level&) = delete;
        ~Level() { --of.depth_; }
        Evaluation& of;
    };

    bool at_end() const { return at_ >= f_.parts.size() || token().is(';'); }
    const Function::Part& part() const { return f_.parts[at_]; }
    const Token& token() const { return f_.parts[at_].token; }
    bool take(char mark) {
        const bool there = at_ < f_.parts.size() && token().is(mark);
        at_ += there;
        return there;
    }
    [[noreturn]] void not_expected() const {
        if (at_ >= f_.parts.size()) p_.fail(f_.place, "the function ends in the middle of its expression");
        p_.fail(token().place(), fmt::format("{} is not expected in a function", p_.describe(token())));
    }
    void need(char mark) { if (!take(mark)) not_expected(); }

    double logical() {
        double left = comparison();
        for (;;) {
            if (take('&')) {
                const double right = comparison();
                left = left != 0 && right != 0;
            } else if (take('|')) {
                const double right = comparison();
                left = left != 0 || right != 0;
            } else {
                return left;
            }
        }
    }

    double comparison() {
        double left = sum();
        for (;;) {
            if (take('<')) left = left < sum();
            else if (take('>')) left = left > sum();
            else if (take('=')) left = left == sum();
            else if (take(kLessEqual)) left = left <= sum();
            else if (take(kGreaterEqual)) left = left >= sum();
            else if (take(kNotEqual)) left = left != sum();
            else return left;
        }
    }

    double sum() {
        double left = product();
        for (;;) {
            if (take('+')) left += product();
            else if (take('-')) left -= product();
            else return left;
        }
    }

    double product() {
        double left = operand();
        for (;;) {
            if (take('*')) left *= operand();
            else if (take('/')) left /= operand();
            else return left;
        }
    }

    double operand() {
        const Level level(*this);
        if (take('-')) return -operand();
        if (take('+')) return operand();
        if (at_end()) not_expected();
        if (take('(')) {
            const double value = logical();
            need(')');
            return value;
        }
        if (token().kind == TokenKind::number) return f_.parts[at_++].token.number;
        if (token().kind == TokenKind::name || token().kind == TokenKind::word) return word();
        not_expected();
    }

    /// In functions u is x, and v is y, whatever the parameters are called.
    static uint32_t coordinate(uint32_t name) { return name == "u"_w ? "x"_w : name == "v"_w ? "y"_w : name; }

    double word() {
        for (auto counter = counters_.rbegin(); counter != counters_.rend(); ++counter)      // the innermost hides all others
            if (counter->first == token().id) return ++at_, counter->second;
        for (size_t i = f_.parameters.size(); i-- > 0;)                                     // of two with one name the last
            if (coordinate(f_.parameters[i]) == coordinate(token().id)) return ++at_, arguments_[i];
        if (token().is_word("x"_w) || token().is_word("y"_w) || token().is_word("z"_w) || token().is_word("u"_w) || token().is_word("v"_w)) return ++at_, 0;
        if (token().kind == TokenKind::name) return identifier();
        if (token().is_word("sum"_w) || token().is_word("prod"_w)) return series(token().is_word("sum"_w));
        return built_in();
    }

    /// Of one number.
    double constant() {
        for (const BuiltinEntry& entry : constants())
            if (token().is_word(entry.word))
                if (const Value value = entry.evaluate(p_, token().place()); value.kind == Kind::number) return ++at_, value.c[0];
        p_.fail(token().place(), fmt::format("{} cannot stand in a function, in POV-Ray either: there are functions of floats, operators, and what a scene has declared", p_.describe(token())));
    }

    double built_in() {
        const auto entry = std::find_if(std::begin(kFunctions), std::end(kFunctions), [&](const FloatFunction& f) { return f.word == token().id; });
        if (entry == std::end(kFunctions)) return constant();
        const Place at = token().place();
        ++at_;
        const std::vector<double> values = call_arguments();
        const bool fits = entry->arity ? values.size() == size_t(entry->arity) : entry->word == "select"_w ? values.size() == 3 || values.size() == 4 : !values.empty();
        if (!fits) p_.fail(at, fmt::format("{} does not take {} arguments", kWords[entry->word], values.size()));
        return entry->value(values);
    }

    /// `sum(i, first, last, term)` or `prod(...)`: i goes from first by ones, as long as it is not beyond last.
    double series(bool adds) {
        ++at_;
        need('(');
        if (at_end() || (token().kind != TokenKind::name && token().kind != TokenKind::word)) not_expected();
        const WordId counter = token().id;
        ++at_;
        need(',');
        const double first = logical();
        need(',');
        const double last = logical();
        need(',');
        const size_t term = at_;
        double all = adds ? 0 : 1;
        for (double i = first; i <= last; ++i) {
            if (++p_.loop_turns > p_.options.limits.loop_turns) p_.fail_limit(f_.place, &Limits::loop_turns, fmt::format("the loops of the scene have made more than {} turns: does one never end?", p_.options.limits.loop_turns));
            at_ = term;
            counters_.emplace_back(counter, i);
            const double value = logical();
            counters_.pop_back();
            all = adds ? all + value : all * value;
        }
        if (first <= last) return need(')'), all;
        skip_to_bracket();
        return all;
    }

    /// Behind the bracket that closes what is open here.
    void skip_to_bracket() {
        for (int depth = 1; depth > 0; ++at_) {
            if (at_end()) not_expected();
            depth += token().is('(') - token().is(')');
        }
    }

    std::vector<double> call_arguments() {
        std::vector<double> values;
        need('(');
        while (!take(')')) {
            values.push_back(logical());
            if (!take(',') && !(at_ < f_.parts.size() && token().is(')'))) not_expected();
        }
        return values;
    }

    double identifier() {
        const Function::Part& it = part();
        ++at_;
        if (it.value.kind == Kind::number) return it.value.c[0];
        if (it.value.kind == Kind::function) return inner_call(it.value.as<Function>(), it.token.place());
        if (it.value.kind == Kind::vector || it.value.kind == Kind::colour) {
            need('.');
            return component(it.value.c);
        }
        if (it.value.kind == Kind::spline) {
            const std::vector<double> t = call_arguments();
            if (t.size() != 1) p_.fail(it.token.place(), "a spline takes one argument");
            need('.');
            return component(spline_value(it.value.as<Spline>(), t[0]));
        }
        p_.fail(it.token.place(), fmt::format("{} cannot stand in a function", kind_name(it.value)));
    }

    double inner_call(const Function& inner, Place at) {
        const std::vector<double> values = call_arguments();
        p_.charge(kStepsOfCall, at);
        if (const auto colour = function_colour(p_, inner, values, at)) {
            if (!take('.')) p_.fail(at, "this function gives a colour, and a component of it is expected", "write .red, .green, .blue, .filter, .transmit or .gray behind it");
            return component(*colour);
        }
        if (const auto moved = function_point(p_, inner, values, at)) {
            if (!take('.')) p_.fail(at, "this function gives a point, and a component of it is expected", "write .x, .y or .z behind it");
            return component({moved->x, moved->y, moved->z});
        }
        if (const auto value = value_in_space(p_, inner, values, at)) return *value;
        check_count(p_, inner.parameters.size(), values.size(), at);
        if (calls_ >= kMostCalls) p_.fail_limit(at, fmt::format("more than {} functions call one another", kMostCalls));
        return Evaluation(p_, inner, values, calls_ + 1, depth_).all();
    }

    double component(const std::array<double, 5>& c) {
        static constexpr std::pair<WordId, int> kComponents[] = {{"x"_w, 0}, {"y"_w, 1}, {"z"_w, 2}, {"t"_w, 3}, {"u"_w, 0}, {"v"_w, 1}, {"red"_w, 0},
                                                                  {"green"_w, 1}, {"blue"_w, 2}, {"filter"_w, 3}, {"transmit"_w, 4}};
        if (at_end()) not_expected();
        if (token().is_word("gray"_w)) return ++at_, pov_grey({c[0], c[1], c[2]});
        for (const auto& [word, index] : kComponents)
            if (token().is_word(word)) return ++at_, c[size_t(index)];
        not_expected();
    }

    Parser& p_;
    const Function& f_;
    std::span<const double> arguments_;
    int calls_;
    size_t depth_;
    size_t at_ = 0;
    std::vector<std::pair<WordId, double>> counters_;      // of the sums and products around
};

}  // namespace

std::optional<std::array<double, 5>> function_colour(Parser& p, const Function& function, std::span<const double> arguments, Place at) {
    const Block* block = block_of(function);
    if (!block || block->word != "pigment"_w) return std::nullopt;
    check_count(p, 3, arguments.size(), at);
    return space_functions(p).pigment(*block, {arguments[0], arguments[1], arguments[2]});
}

std::optional<Vec3> function_point(Parser& p, const Function& function, std::span<const double> arguments, Place at) {
    const Block* block = block_of(function);
    if (!block || block->word != "transform"_w) return std::nullopt;
    if (arguments.size() != 3) p.fail(at, "the function of a transformation takes three arguments");
    return build_transform(p, *block).point({arguments[0], arguments[1], arguments[2]});
}

double function_value(Parser& p, const Function& function, std::span<const double> arguments, Place at) {
    if (const auto value = value_in_space(p, function, arguments, at)) return *value;
    check_count(p, function.parameters.size(), arguments.size(), at);
    return Evaluation(p, function, arguments, 0).all();
}

}  // namespace alidade::pov
