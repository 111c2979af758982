// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/macros.h"

#include "importers/pov/expressions.h"

#include <fmt/format.h>

namespace alidade::pov {

void define_macro(Parser& p, const Token& directive, uint32_t index) {
    Ref<Macro> macro(new Macro);
    const Token name = p.raw_token();
    if (name.kind != TokenKind::name) p.fail(name.place(), fmt::format("a name that is no word of the language is expected behind #macro, not {}", p.describe(name)));
    if (const Token open = p.raw_token(); !open.is('(')) p.fail(open.place(), fmt::format("( is expected behind the macro's name, not {}", p.describe(open)));
    for (Token token = p.raw_token(); !token.is(')'); token = p.raw_token()) {
        if (token.is(',')) continue;
        if (token.kind != TokenKind::name) p.fail(token.place(), fmt::format("the name of a parameter is expected, not {}", p.describe(token)));
        macro->parameters.push_back(token.id);
    }
    Frame& frame = p.stream.frame();
    uint32_t end = index;
    while (end == index || frame.tokens[end].directive.word != "end"_w) {
        end = frame.tokens[end].directive.next;
        if (end == kOpen || end >= frame.end) p.fail_limit(directive.place(), "#macro has no #end");
    }
    macro->name = name.id, macro->source = frame.source, macro->begin = frame.at, macro->end = end;
    frame.at = end + 1;
    p.symbols.global(name.id).value = Value::of(Kind::macro, macro);
}

namespace {

/// One argument: a slot of its own, or the caller's.
Ref<Slot> argument(Parser& p) {
    const Token token = p.next();
    const Slot* known = token.kind == TokenKind::name ? p.symbols.find(token.id) : nullptr;
    if (!known) {
        p.put_back(token);
        Ref<Slot> fresh(new Slot);
        fresh->value = parse_value(p);
        return fresh;
    }
    if (known->value.kind == Kind::function || known->value.kind == Kind::spline) {
        Ref<Slot> same(const_cast<Slot*>(known));
        if (p.peek().is(',') || p.peek().is(')')) return same;
        Ref<Slot> fresh(new Slot);
        fresh->value = continue_from_identifier(p, token);
        return fresh;
    }
    const Ref<Slot> slot = parse_reference(p, token, false);
    if (!slot) p.fail(token.place(), "this array element has no value yet");
    if (p.peek().is(',') || p.peek().is(')')) return slot;
    Ref<Slot> fresh(new Slot);
    fresh->value = kept(continue_from_value(p, called(p, slot->value, token.place())));
    return fresh;
}

}  // namespace

void call_macro(Parser& p, const Token& name, Ref<Macro> macro) {
    const Nested nested(p, name.place());
    if (p.symbols.depth() >= p.options.limits.levels)
        p.fail_limit(name.place(), &Limits::levels, fmt::format("more than {} macros call one another: does {} ever end?", p.options.limits.levels, p.names.text(name.id)));
    p.expect('(', "behind the name of a macro");
    const auto asks = [&] { return fmt::format("{} takes {} argument{}", p.names.text(name.id), macro->parameters.size(), macro->parameters.size() == 1 ? "" : "s"); };
    std::vector<Ref<Slot>> arguments;
    while (!p.accept(')')) {
        if (arguments.size() >= macro->parameters.size()) p.fail(p.peek().place(), fmt::format("{}, and more are given", asks()));
        arguments.push_back(argument(p));
        p.accept(',');
    }
    if (arguments.size() < macro->parameters.size()) p.fail(name.place(), fmt::format("{}, and {} are given", asks(), arguments.size()));
    p.symbols.enter();
    for (size_t i = 0; i < arguments.size(); ++i) p.symbols.alias(macro->parameters[i], std::move(arguments[i]));
    p.stream.push_macro(std::move(macro), name.place());
}

}  // namespace alidade::pov
