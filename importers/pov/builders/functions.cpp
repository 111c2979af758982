// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/functions.h"

#include "eval/functions/float_functions.h"
#include "eval/functions/program.h"
#include "eval/patterns/registry.h"
#include "importers/pov/builders/patterns.h"
#include "importers/pov/builders/pigments.h"
#include "importers/pov/builders/transforms.h"
#include "importers/pov/builtins/builtins.h"

#include <algorithm>
#include <fmt/format.h>

namespace alidade::pov {

namespace {

constexpr uint32_t kMostCalls = 200;      // of functions inside one another

/// Turns a function's parts, read from left to right, into steps. Comparisons are exact here (probed).
class FunctionCompiler {
  public:
    FunctionCompiler(Build& build, const Function& function) : build_(build), p_(build.p), f_(function) {}

    FunctionProgram all() {
        out_.parameters = uint32_t(f_.parameters.size());
        logical();
        if (!at_end()) not_expected();
        return std::move(out_);
    }
    /// Of functions inside one another.
    uint32_t calls() const { return calls_; }

  private:
    /// Guards the call stack: stands where brackets, signs and calls nest.
    struct Level {
        explicit Level(FunctionCompiler& compiler) : of(compiler) {
            constexpr int kDeepest = 1000;   // sanitizers have large frames
            if (++of.build_.function_levels > kDeepest) --of.build_.function_levels, of.p_.fail_limit(of.f_.place, fmt::format("brackets and calls of a function are nested too deeply: more than {} in one another", kDeepest));
        }
        Level(const Level&) = delete;
        ~Level() { --of.build_.function_levels; }
        FunctionCompiler& of;
    };

    bool at_end() const { return at_ >= f_.parts.size(); }
    const Token& token() const { return f_.parts[at_].token; }
    bool take(char mark) {
        const bool there = !at_end() && token().is(mark);
        at_ += there;
        return there;
    }
    [[noreturn]] void not_expected() const {
        if (at_end()) p_.fail(f_.place, "the function ends in the middle of its expression");
        p_.fail(token().place(), fmt::format("{} is not expected in a function", p_.describe(token())));
    }
    void need(char mark) { if (!take(mark)) not_expected(); }

    void add(const FunctionStep& step) {
        height_ = height_ + 1 - taken_from_stack(step);
        out_.steps.push_back(step);
    }
    void add_number(double value) { add({FunctionOp::number, 0, 0, value}); }

    /// Operators of one precedence, from left to right, between operands that `operand` reads.
    template <size_t N> void operators(const std::pair<char, FunctionOp> (&table)[N], void (FunctionCompiler::*operand)()) {
        (this->*operand)();
        for (bool more = true; more;) {
            more = false;
            for (const auto& [mark, op] : table) {
                if (!take(mark)) continue;
                (this->*operand)();
                add({op});
                more = true;
                break;
            }
        }
    }

    void logical() {
        static constexpr std::pair<char, FunctionOp> kLogical[] = {{'&', FunctionOp::both}, {'|', FunctionOp::either}};
        operators(kLogical, &FunctionCompiler::comparison);
    }
    void comparison() {
        static constexpr std::pair<char, FunctionOp> kComparisons[] = {{'<', FunctionOp::less}, {'>', FunctionOp::greater}, {'=', FunctionOp::equal},
                                                                      {kLessEqual, FunctionOp::less_equal}, {kGreaterEqual, FunctionOp::greater_equal}, {kNotEqual, FunctionOp::not_equal}};
        operators(kComparisons, &FunctionCompiler::total);
    }
    void total() {
        static constexpr std::pair<char, FunctionOp> kTotals[] = {{'+', FunctionOp::add}, {'-', FunctionOp::subtract}};
        operators(kTotals, &FunctionCompiler::factors);
    }
    /// As POV-Ray has it (probed), by a 0 that is written or declared as a number nothing can be divided but such numbers and their products: x / 0 and (1 + 1) / 0 are errors, 1 / 0 and x / (0) are infinite.
    void factors() {
        bool numbers = number_operand();
        for (;;) {
            const bool divides = !at_end() && token().is('/');
            const Place at = at_end() ? f_.place : token().place();
            if (!take('*') && !take('/')) return;
            const bool number = number_operand();
            if (divides && number && !numbers && is_zero(out_.steps.back().op == FunctionOp::negate ? out_.steps[out_.steps.size() - 2] : out_.steps.back())) p_.fail(at, "a division by 0");
            add({divides ? FunctionOp::divide : FunctionOp::multiply});
            numbers = numbers && number;
        }
    }
    static bool is_zero(const FunctionStep& step) { return step.op == FunctionOp::number && step.value == 0; }
    /// Reads an operand; is it a number without brackets, with a sign perhaps?
    bool number_operand() {
        const size_t first = out_.steps.size();
        const bool opens = !at_end() && (token().is('(') || ((token().is('-') || token().is('+')) && at_ + 1 < f_.parts.size() && f_.parts[at_ + 1].token.is('(')));
        operand();
        const std::span<const FunctionStep> steps(out_.steps.begin() + std::ptrdiff_t(first), out_.steps.end());
        return !opens && steps[0].op == FunctionOp::number && (steps.size() == 1 || (steps.size() == 2 && steps[1].op == FunctionOp::negate));
    }

    /// With one sign at the most, as POV-Ray has it.
    void operand() {
        if (take('-')) return unsigned_operand(), add({FunctionOp::negate});
        take('+');
        unsigned_operand();
    }
    void unsigned_operand() {
        const Level level(*this);
        if (at_end()) not_expected();
        if (take('(')) return logical(), need(')');
        if (token().kind == TokenKind::number) return add_number(f_.parts[at_++].token.number);
        if (token().kind != TokenKind::name && token().kind != TokenKind::word) not_expected();
        word();
    }

    /// In functions u is x, and v is y, whatever the parameters are called.
    static uint32_t coordinate(uint32_t name) { return name == "u"_w ? "x"_w : name == "v"_w ? "y"_w : name; }

    static bool is_coordinate(const Token& token) { return token.is_word("x"_w) || token.is_word("y"_w) || token.is_word("z"_w) || token.is_word("u"_w) || token.is_word("v"_w); }

    /// Of two with one name the first, but of coordinates the last, as POV-Ray has it.
    std::optional<uint32_t> parameter() const {
        std::optional<uint32_t> found;
        for (uint32_t i = 0; i < f_.parameters.size(); ++i)
            if (coordinate(f_.parameters[i]) == coordinate(token().id) && (!found || is_coordinate(token()))) found = i;
        return found;
    }

    /// Coordinates are those of the function, even if a series counts with one of them.
    void word() {
        for (auto counter = counters_.rbegin(); counter != counters_.rend() && !is_coordinate(token()); ++counter)      // the innermost hides all others
            if (counter->first == token().id) return ++at_, add({FunctionOp::counter, counter->second});
        if (const std::optional<uint32_t> i = parameter()) return ++at_, add({FunctionOp::argument, *i});
        if (is_coordinate(token())) return ++at_, add_number(0);
        if (token().kind == TokenKind::name) return identifier();
        if (token().is_word("sum"_w) || token().is_word("prod"_w)) return series(token().is_word("sum"_w) ? FunctionOp::sum : FunctionOp::product);
        built_in();
    }

    /// Those that POV-Ray takes here. The number of the frame and its like are names.
    void constant() {
        for (const BuiltinEntry& entry : constants())
            if (token().is_word(entry.word) && (entry.word == "pi"_w || entry.word == "clock"_w)) return ++at_, add_number(entry.evaluate(p_, token().place()).c[0]);
        p_.fail(token().place(), fmt::format("{} cannot stand in a function, in POV-Ray either: there are functions of floats, operators, and what a scene has declared", p_.describe(token())));
    }

    void built_in() {
        const FloatFunction* row = find_float_function(kWords[token().id]);
        if (!row) return constant();
        const Place at = token().place();
        ++at_;
        const uint32_t count = arguments();
        if (count < row->fewest || count > row->most) p_.fail(at, fmt::format("{} does not take {} arguments", row->name, count));
        add({FunctionOp::built_in, uint32_t(row - alidade::float_functions().data()), count});
    }

    /// `sum(i, first, last, term)` or `prod(...)`: i goes from first by ones, as long as it is not beyond last.
    void series(FunctionOp op) {
        ++at_;
        need('(');
        if (at_end() || (token().kind != TokenKind::name && token().kind != TokenKind::word)) not_expected();
        const WordId counter = token().id;
        ++at_;
        need(',');
        logical();
        need(',');
        logical();
        need(',');
        const size_t at = out_.steps.size(), place = height_ - 2;
        add({op});
        height_ = place + 3;                                     // what the steps of the term stand on
        counters_.emplace_back(counter, uint32_t(place));
        logical();
        counters_.pop_back();
        out_.steps[at].a = uint32_t(out_.steps.size() - at - 1);
        height_ = place + 1;
        need(')');
    }

    uint32_t arguments() {
        need('(');
        uint32_t count = 0;
        do logical(), ++count;
        while (take(','));
        need(')');
        return count;
    }

    void identifier() {
        const Function::Part& it = f_.parts[at_++];
        if (it.value.kind == Kind::number) return add_number(it.value.c[0]);
        if (it.value.kind == Kind::function) return inner_call(it.value.as<Function>(), it.token.place());
        if (it.value.kind != Kind::spline) p_.fail(it.token.place(), fmt::format("{} cannot stand in a function", kind_name(it.value)), it.value.numeric() ? "declare a float of a component of it, and write that" : "");
        if (!it.value.as<Spline>().is_function) p_.fail(it.token.place(), "a spline cannot stand in a function", "declare a function of it, and call that: function { spline { NAME } }");
        if (arguments() != 1) p_.fail(it.token.place(), "a spline takes one argument");
        if (!take('.')) p_.fail(it.token.place(), "this function gives a vector, and a component of it is expected", "write .x, .y or .z behind it");
        out_.splines.push_back(it.value.as<Spline>().curve);
        add({FunctionOp::spline, uint32_t(out_.splines.size() - 1), component()});
    }

    void check_count(size_t parameters, uint32_t given, Place at) const {
        if (parameters != given) p_.fail(at, fmt::format("the function takes {} argument{}, and {} are given", parameters, parameters == 1 ? "" : "s", given));
    }

    void inner_call(const Function& inner, Place at) {
        const uint32_t count = arguments();
        const Block* block = block_of(inner);
        if (block) check_count(3, count, at);
        if (block && block->word == "pigment"_w) {
            if (!take('.')) p_.fail(at, "this function gives a colour, and a component of it is expected", "write .red, .green, .blue, .filter, .transmit or .gray behind it");
            return add({FunctionOp::pigment, build_function_pigment(build_, *block).index, component()});
        }
        if (block && block->word == "transform"_w) {
            if (!take('.')) p_.fail(at, "this function gives a point, and a component of it is expected", "write .x, .y or .z behind it");
            out_.transforms.push_back(build_transform(p_, *block));
            return add({FunctionOp::transform, uint32_t(out_.transforms.size() - 1), component()});
        }
        if (block) return add({FunctionOp::pattern, build_number_pattern(build_, *block).index});
        if (const InternalFunction* row = internal_of(p_, inner)) return check_count(3 + row->parameters, count, at), add({FunctionOp::internal, uint32_t(row->number), count});
        check_count(inner.parameters.size(), count, at);
        add({FunctionOp::call, callee(inner, at), count});
    }

    uint32_t callee(const Function& inner, Place at) {
        const FunctionId id = build_function(build_, inner);
        calls_ = std::max(calls_, build_.function_calls[id.index] + 1);
        if (calls_ > kMostCalls) p_.fail_limit(at, fmt::format("more than {} functions call one another", kMostCalls));
        return id.index;
    }

    uint32_t component() {
        static constexpr std::pair<WordId, uint32_t> kComponents[] = {{"x"_w, 0}, {"y"_w, 1}, {"z"_w, 2}, {"t"_w, 3}, {"u"_w, 0}, {"v"_w, 1}, {"red"_w, 0},
                                                                      {"green"_w, 1}, {"blue"_w, 2}, {"filter"_w, 3}, {"transmit"_w, 4}, {"gray"_w, kGreyComponent}};
        static constexpr std::pair<std::string_view, uint32_t> kMore[] = {{"grey", kGreyComponent}, {"hf", kHeightComponent}};   // no words elsewhere
        if (at_end()) not_expected();
        for (const auto& [word, index] : kComponents)
            if (token().is_word(word)) return ++at_, index;
        for (const auto& [name, index] : kMore)
            if (token().kind == TokenKind::name && p_.names.text(token().id) == name) return ++at_, index;
        not_expected();
    }

    Build& build_;
    Parser& p_;
    const Function& f_;
    FunctionProgram out_;
    uint32_t calls_ = 0;
    size_t at_ = 0, height_ = 0;
    std::vector<std::pair<WordId, uint32_t>> counters_;      // of the series around, and where on the stack they count
};

/// That asks one thing with all its parameters.
FunctionProgram forwarding(uint32_t parameters, FunctionStep step) {
    FunctionProgram out;
    out.parameters = parameters;
    for (uint32_t i = 0; i < parameters; ++i) out.steps.push_back({FunctionOp::argument, i});
    out.steps.push_back(step);
    return out;
}

FunctionProgram program_of(Build& build, const Function& function, uint32_t& calls) {
    if (const InternalFunction* row = internal_of(build.p, function)) {
        const uint32_t parameters = uint32_t(3 + row->parameters);
        return forwarding(parameters, {FunctionOp::internal, uint32_t(row->number), parameters});
    }
    const Block* block = block_of(function);
    if (block && block->word == "pattern"_w) return forwarding(3, {FunctionOp::pattern, build_number_pattern(build, *block).index});
    FunctionCompiler compiler(build, function);
    FunctionProgram program = compiler.all();
    calls = compiler.calls();
    return program;
}

/// Has the pattern a value at a point of space? Two have one that POV-Ray does not give to functions.
bool has_number(const PatternSignal& signal) {
    const PatternOps* row = find_pattern(signal.pattern);
    if (signal.pattern == "square" || signal.pattern == "triangular") return false;
    return row->value || row->source == SourceKind::pigment || row->source == SourceKind::function || signal.pattern == "image_pattern";
}

/// What is no pattern, and no modifier of one.
[[noreturn]] void fail_in_number_pattern(const Build& build, const Cursor& at, bool begun) {
    const Item& item = at.peek();
    const bool named = item.kind == Item::Kind::word || at.any_block();
    const std::string_view name = named ? std::string_view(kWords[at.any_block() ? at.any_block()->word : item.word]) : "a value";
    if (!begun && (name == "object" || name == "density_file")) build.p.fail_unmodelled(item.place, fmt::format("{} in the pattern of a function is not modelled yet", name));
    build.p.fail(item.place, fmt::format("{} cannot stand in the pattern of a function", name), "the name of a pattern stands there, and behind it what moves or waves it");
}

}  // namespace

const Block* block_of(const Function& function) {
    const bool one = function.parts.size() == 1 && function.parts[0].value.kind == Kind::block;
    return one ? &function.parts[0].value.as<Block>() : nullptr;
}

const InternalFunction* internal_of(const Parser& p, const Function& function) {
    const std::vector<Function::Part>& parts = function.parts;
    if (parts.size() != 4 || !parts[0].token.is_word("internal"_w) || !parts[1].token.is('(') || parts[2].token.kind != TokenKind::number || !parts[3].token.is(')')) return nullptr;
    const double number = parts[2].token.number;
    const InternalFunction* row = find_internal_function(number);
    if (row) return row;
    const std::string_view name = internal_function_name(number);
    if (name.empty()) p.fail(function.place, fmt::format("there is no internal({})", number));
    std::string known;
    for (const InternalFunction& other : internal_functions()) known += fmt::format("{}{}", known.empty() ? "" : ", ", other.name);
    p.fail_unmodelled(function.place, fmt::format("{}, which is internal({}), is not modelled yet", name, number), "those of functions.inc that are: " + known);
}

FunctionId build_function(Build& build, const Function& function) {
    const auto known = build.functions.find(&function);
    if (known != build.functions.end()) return known->second;
    const Nested nested(build.p, function.place);
    uint32_t calls = 0;
    FunctionProgram program = program_of(build, function, calls);    // what it calls comes to stand before it
    build.function_calls.push_back(calls);
    append(build.scene.functions, std::move(program));
    const FunctionId id{uint32_t(build.scene.functions.size() - 1)};
    build.functions.emplace(&function, id);
    return id;
}

SignalId build_number_pattern(Build& build, const Block& block) {
    const auto known = build.number_patterns.find(&block);
    if (known != build.number_patterns.end()) return known->second;
    const Nested nested(build.p, block.place);
    PatternSignal signal;
    for (Cursor at(build, block); !at.done();) {
        const bool begun = !signal.pattern.empty();
        if (begun ? take_pattern_modifier(build, at, signal) || at.accept("no_bump_scale"_w) : take_pattern(build, at, signal)) continue;
        fail_in_number_pattern(build, at, begun);
    }
    if (signal.pattern.empty()) build.p.fail(block.place, "the name of a pattern is expected in pattern { }");
    if (!has_number(signal)) build.p.fail(block.place, fmt::format("the pattern {} cannot stand in a function", signal.pattern));
    const SignalId id = build.add_signal(std::move(signal), block.place);
    build.number_patterns.emplace(&block, id);
    return id;
}

SignalId build_function_pigment(Build& build, const Block& block) { return build_pigment(build, block, plain_pigment(build)); }

bool is_declared(const Function& function, Place place) { return place.source != function.place.source || place.offset != function.place.offset; }

void check_pattern_function(const Parser& p, const Function& function, Place place) {
    if (is_declared(function, place)) p.fail(place, "a declared function cannot stand here by its name", "call it: function { NAME(x, y, z) }");
    if (function.size) p.fail(place, "a function with a size is a picture: it cannot stand here", "it can in image_map, image_pattern, bump_map and material_map");
    if (function.named) p.fail(place, "the function of a pattern has no parameters of its own", "they are x, y and z");
    const std::string_view alone = block_of(function) ? std::string_view(kWords[block_of(function)->word]) : internal_of(p, function) ? "internal" : "";
    if (!alone.empty()) p.fail(place, fmt::format("{} cannot stand in the function of a pattern", alone), "declare a function of it, and call that: function { NAME(x, y, z) }");
}

}  // namespace alidade::pov
