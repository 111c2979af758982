// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/expressions.h"

#include "core/vec.h"
#include "importers/pov/arrays.h"
#include "importers/pov/blocks.h"
#include "importers/pov/builtins/builtins.h"
#include "importers/pov/functions.h"
#include "importers/pov/operators.h"
#include "importers/pov/suggestions.h"

#include <fmt/format.h>

namespace alidade::pov {

namespace {

void require_numeric(Parser& p, const Value& value, Place at) {
    if (!value.numeric()) p.fail(at, fmt::format("{} is no number to calculate with", kind_name(value)));
}

/// A float without what stands behind it.
Value by_itself(Value value) {
    if (value.rest > 0) std::fill(value.c.begin() + 1, value.c.end(), 0.0), value.rest = 0;
    return value;
}

/// The component that `.word` names.
Value component(Parser& p, const Value& value, const Token& word) {
    static constexpr std::pair<WordId, int> kComponents[] = {{"x"_w, 0}, {"u"_w, 0}, {"red"_w, 0}, {"y"_w, 1}, {"v"_w, 1}, {"green"_w, 1},
                                                              {"z"_w, 2}, {"blue"_w, 2}, {"t"_w, 3}, {"filter"_w, 3}, {"transmit"_w, 4}};
    require_numeric(p, value, word.place());
    if (word.is_word("gray"_w)) {
        const std::array<double, 5> c = promoted(value, 5);
        return Value::number(pov_grey({c[0], c[1], c[2]}));
    }
    for (const auto& [name, index] : kComponents)
        if (word.is_word(name)) {
            if (value.terms == 1 && index > 0) p.fail(word.place(), "a float has no second component");
            if (value.terms == 1) return value;
            Value one = value;
            one.kind = Kind::number, one.terms = 1, one.rest = value.terms, one.c[0] = value.c[index];
            return one;
        }
    p.fail(word.place(), fmt::format("a component (x, y, z, t, u, v, red, green, blue, filter, transmit, gray) is expected behind the dot, not {}", p.describe(word)));
}

/// `.x`, `.red` ... behind a value.
void take_components(Parser& p, Value& value, Standing standing = Standing::in_brackets) {
    if (!value.numeric()) return;                 // behind a string, say, nothing is looked at: the next directive must wait
    while (peek_behind(p, standing).is('.')) p.next(), value = component(p, value, p.next());
}

Value vector_literal(Parser& p, Place at) {
    std::vector<double> list;
    Value v = parse_vector(p, at, list);
    if (!list.empty()) p.fail(at, fmt::format("a vector has at most five components, not {}", list.size()));
    return v;
}

[[noreturn]] void fail_undeclared(Parser& p, const Token& name) {
    const std::string_view text = p.names.text(name.id);
    if (p.failed_names.count(name.id)) throw Failure{{}, false, true};
    const auto [hint, added] = p.undeclared_hints.try_emplace(name.id);
    if (added) hint->second = hint_for_undeclared(p, name);
    p.fail(name.place(), fmt::format("{} is not declared", text), hint->second);
}

void warn_if_deprecated(Parser& p, Slot& slot, const Token& name) {
    if (!slot.deprecation) return;
    const std::string& message = slot.deprecation->message;
    p.warn(name.place(), message.empty() ? fmt::format("{} was declared deprecated", p.names.text(name.id)) : message);
    if (slot.deprecation->once) slot.deprecation = {};
}

Value identifier(Parser& p, const Token& name) {
    Slot* plain = p.symbols.find(name.id);
    if (!plain || plain->value.kind == Kind::nothing) fail_undeclared(p, name);
    warn_if_deprecated(p, *plain, name);
    refuse_subscript(p, name, plain->value);
    if (plain->value.numeric()) return plain->value;
    if (const Ref<Slot> slot = parse_reference(p, name, false)) return called(p, slot->value, name.place());
    p.fail(name.place(), "this array element has no value yet");
}

[[noreturn]] void fail_no_value(Parser& p, const Token& token) {
    p.fail(token.place(), fmt::format("a number, a vector or another value is expected, not {}", p.describe(token)));
}

/// `.x`, `.u` and `.red` of a float, which are itself. Not inlined: it is rare, and its values would cost all that asks.
[[gnu::noinline]] double first_component(Parser& p, double x) {
    while (p.accept('.')) x = component(p, Value::number(x), p.next()).c[0];
    return x;
}

/// Takes a float that stands there as a literal or in a variable, if one does: what most operands are, so that no Value is made of them.
bool take_plain(Parser& p, double& x) {
    const Token& token = p.peek();
    if (token.kind == TokenKind::number) {
        x = token.number;
        p.take();
        return true;
    }
    const Slot* slot = token.kind == TokenKind::name ? p.symbols.find(token.id) : nullptr;
    if (!slot || slot->value.kind != Kind::number || slot->deprecation || p.stream.goes_on_with('[')) return false;
    x = slot->value.c[0];
    p.take();
    if (p.stream.goes_on_with('.')) x = first_component(p, x);
    return true;
}

Value factor(Parser& p, Standing standing = Standing::in_brackets);

/// Each component by itself.
Value negated(Value value) {
    for (size_t i = 0; i < value.terms; ++i) value.c[i] = !truth(value.c[i]);
    return value;
}

Value factor_of_mark(Parser& p, const Token& token, Standing standing) {
    const Nested nested(p, token.place());
    if (token.mark == '-' || token.mark == '+' || token.mark == '!') {
        Value value = factor(p, standing);
        require_numeric(p, value, token.place());
        if (token.mark == '!') return negated(std::move(value));
        if (token.mark == '-') negate(value);
        return value;
    }
    if (token.mark == '(') {
        Value value = parse_full(p);
        p.expect(')', "behind the expression");
        return by_itself(value);
    }
    if (token.mark == '<') return vector_literal(p, token.place());
    fail_no_value(p, token);
}

Value factor_without_components(Parser& p, Standing standing) {
    const Token token = p.next();
    switch (token.kind) {
        case TokenKind::vector: return p.vector(token);
        case TokenKind::string: return p.string(token);
        case TokenKind::name: return identifier(p, token);
        case TokenKind::mark: return factor_of_mark(p, token, standing);
        case TokenKind::word:
            if (const Builtin builtin = find_builtin(token.id)) {
                const Nested nested(p, token.place());
                return builtin(p, token.place());
            }
            break;
        default: break;
    }
    fail_no_value(p, token);
}

Value factor(Parser& p, Standing standing) {
    if (double x; take_plain(p, x)) return Value::number(x);
    Value value = factor_without_components(p, standing);
    take_components(p, value, standing);
    return value;
}

/// left = left op right
void calculate(Parser& p, const Token& op, Value& left, const Value& right) {
    require_numeric(p, left, op.place());
    require_numeric(p, right, op.place());
    if (apply(op.mark, left, right)) p.warn(op.place(), "division by zero");
}

void calculate(Parser& p, const Token& op, Value& left, double right) {
    if (left.kind == Kind::number && (right != 0 || op.mark != '/')) left.c[0] = arithmetic(op.mark, left.c[0], right);
    else calculate(p, op, left, Value::number(right));
}

bool is_product(const Token& token) { return token.mark == '*' || token.mark == '/'; }
bool is_sum(const Token& token) { return token.mark == '+' || token.mark == '-'; }

void continue_term(Parser& p, Value& left, Standing standing = Standing::in_brackets) {
    while (is_product(peek_behind(p, standing))) {
        const Token op = p.next();
        if (double x; take_plain(p, x)) calculate(p, op, left, x);
        else calculate(p, op, left, factor(p, standing));
    }
}

void continue_expression(Parser& p, Value& left, Standing standing = Standing::in_brackets) {
    continue_term(p, left, standing);
    while (is_sum(peek_behind(p, standing))) {
        const Token op = p.next();
        double x = 0;
        const bool plain = take_plain(p, x);
        if (plain && !is_product(peek_behind(p, standing))) {
            calculate(p, op, left, x);
            continue;
        }
        Value right = plain ? Value::number(x) : factor(p, standing);
        continue_term(p, right, standing);
        calculate(p, op, left, right);
    }
}

/// Before version 1.5, `<0 1 0> -1` were two values: operators stand in parentheses alone.
bool has_plain_operators(const Parser& p) { return p.version >= 1.5; }

Value expression_with_operators(Parser& p, Standing standing = Standing::in_brackets) {
    Value value = factor(p, standing);
    if (value.numeric()) continue_expression(p, value, standing);
    return value;
}

bool is_comparison(const Token& token) {
    return token.mark == '<' || token.mark == '>' || token.mark == '=' || token.mark == kLessEqual || token.mark == kGreaterEqual || token.mark == kNotEqual;
}

Value comparison(Parser& p) {
    Value left = expression_with_operators(p);
    while (is_comparison(p.peek())) {
        const Token op = p.next();
        const Value right = expression_with_operators(p);
        if (left.kind == Kind::string && right.kind == Kind::string) {
            left = Value::number(compared(op.mark, left.text(), right.text()));
        } else {
            if (!left.numeric() || !right.numeric()) p.fail(op.place(), fmt::format("two numbers or two strings can be compared, not {} and {}", kind_name(left), kind_name(right)));
            compare(op.mark, left, right);
        }
    }
    return left;
}

bool truth_of(Parser& p, const Value& value, Place at) {
    if (value.kind != Kind::number) p.fail(at, fmt::format("a condition is a float, not {}", kind_name(value)));
    return truth(value.c[0]);
}

}  // namespace

Ref<Slot> parse_reference(Parser& p, const Token& name, bool make, Ref<Array>* holder) {
    Slot* found = p.symbols.find(name.id);
    if (!found) fail_undeclared(p, name);
    Ref<Slot> slot(found);
    while (slot && slot->value.kind == Kind::array) {
        const Value array = slot->value;          // which may be declared anew by the subscript
        if (!p.peek_behind_value().is('[')) break;
        if (holder) *holder = Ref<Array>(&array.as<Array>());
        slot = parse_subscripts(p, array.as<Array>(), make);
    }
    return slot;
}

Value kept(Value value) {
    value = by_itself(value);
    const bool single = value.kind == Kind::colour || (value.kind == Kind::vector && value.terms == value.c.size());
    if (single)
        for (double& x : value.c) x = in_single(x);
    return value;
}

Value called(Parser& p, Value value, Place at) {
    if ((value.kind != Kind::function && value.kind != Kind::spline) || !p.peek_in_value().is('(')) return value;
    const Nested nested(p, at);
    return value.kind == Kind::function ? call_function(p, value.as<Function>(), at) : call_spline(p, value.as<Spline>(), at);
}

Value continue_from_identifier(Parser& p, const Token& name) {
    Value value = identifier(p, name);
    take_components(p, value);
    if (value.numeric() && has_plain_operators(p)) continue_expression(p, value);
    return value;
}

Value continue_from_value(Parser& p, Value value) {
    if (!value.numeric()) return value;
    take_components(p, value);
    if (has_plain_operators(p)) continue_expression(p, value);
    return value;
}

Value parse_expression(Parser& p, Standing standing) { return has_plain_operators(p) ? expression_with_operators(p, standing) : factor(p, standing); }

Value parse_full(Parser& p) {
    Value left = comparison(p);
    while (p.peek().is('&') || p.peek().is('|')) {       // of equal precedence, from left to right; both sides are evaluated
        const Token op = p.next();
        const Value right = comparison(p);
        require_numeric(p, left, op.place());
        require_numeric(p, right, op.place());
        compare(op.mark, left, right);
    }
    if (!p.peek().is('?')) return left;
    const Token op = p.next();
    const Nested nested(p, op.place());
    const bool first = truth_of(p, left, op.place());
    Value yes = parse_full(p);
    p.expect(':', "between the two values of a condition");
    Value no = parse_full(p);
    return first ? yes : no;
}

double parse_float(Parser& p, Standing standing) {
    const Place at = p.peek().place();
    Value value;
    if (double x; take_plain(p, x)) {
        if (const Token& behind = peek_behind(p, standing); !has_plain_operators(p) || (!is_product(behind) && !is_sum(behind))) return x;
        value = Value::number(x);
        continue_expression(p, value, standing);
    } else {
        value = parse_expression(p, standing);
    }
    if (value.kind != Kind::number) p.fail(at, fmt::format("a float is expected, not {}", kind_name(value)));
    return value.c[0];
}

std::array<double, 5> wanted_vector(Parser& p, const Value& value, uint8_t terms, Place at, std::string_view role, std::string_view of) {
    if (!value.numeric() || value.terms > terms) {
        const std::string length = value.numeric() ? fmt::format(" of {}", terms) : "", where = role.empty() ? "" : fmt::format(" {} {}", role, of);
        p.fail(at, fmt::format("a vector{} is expected{}, not {}", length, where, kind_name(value)));
    }
    return as_vector(value, terms);
}

std::array<double, 5> parse_vector(Parser& p) {
    const Place at = p.peek().place();
    return wanted_vector(p, parse_expression(p), 3, at);
}

std::string parse_string(Parser& p) {
    const Place at = p.peek().place();
    const Value value = parse_expression(p);
    if (value.kind != Kind::string) p.fail(at, fmt::format("a string is expected, not {}", kind_name(value)));
    return value.text();
}

bool parse_condition(Parser& p) {
    const Place at = p.expect('(', "before the condition").place();
    const Value value = parse_full(p);
    p.expect(')', "behind the condition");
    return truth_of(p, value, at);
}

bool begins_expression(const Parser& p, const Token& token) {
    switch (token.kind) {
        case TokenKind::number: case TokenKind::vector: case TokenKind::string: case TokenKind::name: return true;
        case TokenKind::word: return find_builtin(token.id) != nullptr;
        case TokenKind::mark: return token.mark == '(' || token.mark == '<' || token.mark == '-' || token.mark == '+' || token.mark == '!';
        default: return (void)p, false;
    }
}

Value parse_vector(Parser& p, Place at, std::vector<double>& list) {
    const Nested nested(p, at);
    Value v;
    size_t count = 0;
    for (; !p.accept('>'); ++count) {
        if (count > 1000) p.fail(at, "more than 1000 numbers stand in < >");
        if (count > 0 && !begins_expression(p, p.peek())) p.fail(p.peek().place(), fmt::format("> is expected behind the components of a vector, not {}", p.describe(p.peek())));
        const double x = parse_float(p);
        if (count == v.c.size()) list.assign(v.c.begin(), v.c.end());
        if (count < v.c.size()) v.c[count] = x;
        else list.push_back(x);
        p.accept(',');
    }
    if (count == 1) p.fail(at, "a vector has at least two components");
    v.kind = Kind::vector, v.terms = uint8_t(std::min(count, v.c.size()));
    return v;
}

Value parse_value(Parser& p, Standing standing) {
    const Token token = p.peek();
    if (begins_colour(token)) return parse_colour(p, standing);
    if (token.kind != TokenKind::word || find_builtin(token.id)) {
        return kept(parse_expression(p, standing));
    }
    p.next();
    if (token.id != "array"_w && token.id != "spline"_w && token.id != "function"_w && !p.peek().is('{')) fail_no_value(p, token);
    switch (token.id) {
        case "array"_w: return parse_array(p, token.place());
        case "spline"_w: return parse_spline(p, token.place());
        case "function"_w: return parse_declared_function(p, token.place());
        default: return parse_declared_block(p, token);
    }
}

}  // namespace alidade::pov
