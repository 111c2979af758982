// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/functions.h"

#include "importers/pov/blocks.h"
#include "importers/pov/builders/functions.h"
#include "importers/pov/expressions.h"
#include "importers/pov/function_values.h"
#include "importers/pov/space_functions.h"

#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace alidade::pov {

namespace {

bool is_coordinate(WordId id) { return id == "x"_w || id == "y"_w || id == "z"_w || id == "u"_w || id == "v"_w; }

/// Of a parameter, or of what a series counts with. As in POV-Ray, it means nothing yet; t is ours.
WordId new_name(const Parser& p, const Token& token, const char* what) {
    const bool is_word = token.kind == TokenKind::word && (is_coordinate(token.id) || token.id == "t"_w);
    if (!is_word && token.kind != TokenKind::name) p.fail(token.place(), fmt::format("the name of {} is expected, not {}", what, p.describe(token)));
    const Slot* slot = is_word ? nullptr : p.symbols.find(token.id);
    if (slot && slot->value.kind != Kind::nothing) p.fail(token.place(), fmt::format("{} is declared: {} has another name", p.names.text(token.id), what));
    return token.id;
}

void read_parameters(Parser& p, Function& function) {
    if (!p.accept('(')) return;
    for (Token token = p.raw_token();; token = p.raw_token()) {
        function.parameters.push_back(new_name(p, token, "a parameter"));
        if (p.accept(')')) return;
        p.accept(',');
    }
}

bool is_parameter(const Function& function, const Token& token) {
    const auto holds = [&](const std::vector<WordId>& names) { return std::find(names.begin(), names.end(), token.id) != names.end(); };
    return holds(function.parameters) || holds(function.counters);
}

/// The name behind `sum(` and `prod(` is a counter of its own.
void note_counter(const Parser& p, Function& function, const Token& token) {
    const size_t n = function.parts.size();
    if (n < 2 || !function.parts[n - 1].token.is('(') || is_parameter(function, token)) return;
    const Token& word = function.parts[n - 2].token;
    if (word.is_word("sum"_w) || word.is_word("prod"_w)) function.counters.push_back(new_name(p, token, "what a series counts with"));
}

/// What an identifier is worth now. Array elements become their values; what stands behind a dot is a component.
void resolve(Parser& p, Function& function, Function::Part& part) {
    const Token& token = part.token;
    const bool is_component = !function.parts.empty() && function.parts.back().token.is('.');
    if (token.kind == TokenKind::name && !is_component && !is_parameter(function, token)) {
        const Ref<Slot> slot = parse_reference(p, token, false);
        if (!slot) p.fail(token.place(), "this array element has no value yet");
        part.value = slot->value;
    } else if (token.kind == TokenKind::word && (token.id == "pigment"_w || token.id == "pattern"_w || token.id == "transform"_w) && p.peek().is('{')) {
        part.value = parse_block(p, token.id, token.place());
    } else if (token.kind == TokenKind::string) {
        part.value = p.string(token);
    }
    if (part.value.shared) function.depth = std::max(function.depth, part.value.shared->depth + 1);
    p.check_depth(part.value, token.place());
}

/// Between < and > that compare, what looks like a vector are arguments: select(x <1, 2> 3, 4).
void add_apart(const Parser& p, Function& function, const Token& vector) {
    Function::Part part;
    const auto add = [&](TokenKind kind, char mark) {
        part.token = vector;
        part.token.kind = kind, part.token.mark = mark;
        function.parts.push_back(part);
    };
    char before = '<';
    for (const double x : p.stream.vector(vector)) {
        add(TokenKind::mark, std::exchange(before, ','));
        if (std::signbit(x)) add(TokenKind::mark, '-');
        add(TokenKind::number, 0);
        function.parts.back().token.number = std::fabs(x);
    }
    add(TokenKind::mark, '>');
}

}  // namespace

Value parse_function(Parser& p, Place at) {
    const Nested nested(p, at);
    Ref<Function> function(new Function);
    function->place = at;
    read_parameters(p, *function);
    function->named = !function->parameters.empty();
    if (function->parameters.empty() && !p.peek().is('{')) {       // the sizes of a picture made of a function
        const double columns = parse_float(p);
        p.accept(',');
        function->size = {columns, parse_float(p)};
    }
    if (function->parameters.empty()) function->parameters = {"x"_w, "y"_w, "z"_w};
    p.expect('{', "before the body of a function");
    if (p.peek().is_word("spline"_w)) {                            // such a function is a spline that functions can call
        Value spline = parse_spline(p, p.next().place());
        if (function->named) p.fail(at, "the function of a spline has no parameters of its own", "write function { spline { ... } }, and call it with one argument");
        spline.as<Spline>().is_function = true;
        p.expect('}', "behind the spline");
        return spline;
    }
    for (int depth = 1;;) {
        p.check_items(at);
        Function::Part part;
        part.token = p.next();
        if (part.token.kind == TokenKind::end) p.fail_limit(at, "the function is not closed", "} is missing");
        depth += part.token.is('{') - part.token.is('}');
        if (depth == 0) break;
        if (part.token.kind == TokenKind::vector) {
            add_apart(p, *function, part.token);
            continue;
        }
        note_counter(p, *function, part.token);
        resolve(p, *function, part);
        function->parts.push_back(std::move(part));
    }
    const bool of_block = function->parts.size() == 1 && function->parts[0].value.kind == Kind::block;
    if (function->named && of_block) p.fail(at, "the function of a pattern, a pigment or a transformation has no parameters of its own", "write function { ... }, and call it with a point's x, y and z");
    return Value::of(Kind::function, function);
}

namespace {

/// Fails for the mistakes of a function that nobody may ever call, which POV-Ray finds where it is declared. What calls others is looked at where it is called.
void check_alone(Parser& p, const Function& function) {
    for (const Function::Part& part : function.parts)
        if ((part.value.kind != Kind::nothing && part.value.kind != Kind::number) || part.token.is_word("internal"_w)) return;
    Build build(p);
    build_function(build, function);
}

}  // namespace

Value parse_declared_function(Parser& p, Place at) {
    Value value = parse_function(p, at);
    if (value.kind == Kind::function) check_alone(p, value.as<Function>());
    if (value.kind == Kind::function && value.as<Function>().size) p.fail(at, "a function with a size is a picture: it has no name", "it can stand in image_map, image_pattern, bump_map and material_map");
    return value;
}

Value call_function(Parser& p, const Function& function, Place at) {
    const Ref<Function> hold(const_cast<Function*>(&function));
    p.expect('(', "before the arguments of a function");
    std::vector<double> arguments;
    do arguments.push_back(parse_float(p));
    while (p.accept(',') || !p.peek().is(')'));          // commas may be missing
    p.take();
    if (const auto moved = function_point(p, function, arguments, at)) return Value::vector(3, {moved->x, moved->y, moved->z});
    if (const auto colour = function_colour(p, function, arguments, at)) return Value::colour(*colour);
    return Value::number(function_value(p, function, arguments, at));
}

}  // namespace alidade::pov
