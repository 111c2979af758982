// SPDX-License-Identifier: Apache-2.0
/// Conditions, loops and switches: jumps within the tokens of one file or macro, along the links that the lexer has made.
#include "importers/pov/directives.h"
#include "importers/pov/expressions.h"
#include "importers/pov/operators.h"

#include <fmt/format.h>

namespace alidade::pov {

namespace {

using Kind = Condition::Kind;

WordId word_at(Parser& p, uint32_t index) { return p.stream.frame().tokens[index].directive.word; }

/// The next clause or #end of the structure that the clause at `index` belongs to.
uint32_t next_clause(Parser& p, uint32_t index) {
    const Token& token = p.stream.frame().tokens[index];
    if (token.directive.next == kOpen || token.directive.next >= p.stream.frame().end)
        p.fail_limit(token.place(), fmt::format("#{} has no #end", kWords[token.directive.word]));
    return token.directive.next;
}

void jump(Parser& p, uint32_t to) { p.stream.frame().at = to; }

void jump_behind_end(Parser& p, uint32_t index) {
    while (word_at(p, index) != "end"_w) index = next_clause(p, index);
    jump(p, index + 1);
}

void enter(Parser& p, Kind kind, uint32_t opened) {
    Condition condition;
    condition.kind = kind, condition.opened = opened;
    p.stream.conditions().push_back(condition);
}

/// What a directive reads must end in the frame where the directive stands.
template <class Read>
auto within_frame(Parser& p, const Token& directive, Read read) {
    const size_t frames = p.stream.frames().size();
    auto value = read();
    if (p.stream.frames().size() != frames) p.fail_limit(directive.place(), fmt::format("what #{} reads ends in another file or macro", kWords[directive.directive.word]));
    return value;
}

/// Words of the language are not, whatever they are worth (probed).
bool name_is_defined(Parser& p) {
    p.expect('(', "before the name");
    const Token name = p.raw_token();
    bool known = false;
    if (name.kind == TokenKind::name) known = p.symbols.find(name.id) && bool(parse_reference(p, name, false));
    p.expect(')', "behind the name");
    return known;
}

bool holds(Parser& p, const Token& directive) {
    return within_frame(p, directive, [&] {
        switch (directive.directive.word) {
            case "ifdef"_w: return name_is_defined(p);
            case "ifndef"_w: return !name_is_defined(p);
            default: return parse_condition(p);
        }
    });
}

/// From an #if (or #elseif) whose condition stands next: goes to the clause that holds.
void choose_branch(Parser& p, uint32_t opened) {
    for (uint32_t clause = opened;;) {
        if (word_at(p, clause) == "else"_w || holds(p, p.stream.frame().tokens[clause])) return enter(p, Kind::branch, opened);
        clause = next_clause(p, clause);
        jump(p, clause + 1);
        if (word_at(p, clause) == "end"_w) return;
    }
}

void count_turn(Parser& p, Place at) {
    if (++p.loop_turns > p.options.limits.loop_turns) p.fail_limit(at, &Limits::loop_turns, fmt::format("the loops of the scene have made more than {} turns: does one never end?", p.options.limits.loop_turns));
}

void obey_while(Parser& p, const Token& directive, uint32_t index) {
    count_turn(p, directive.place());
    if (holds(p, directive)) enter(p, Kind::while_loop, index);
    else jump_behind_end(p, index);
}

bool for_goes_on(const Condition& loop, double counter) { return loop.step > 0 ? counter < loop.last + kEpsilon : counter > loop.last - kEpsilon; }

struct ForHead {
    WordId counter;
    double first, last, step;
};

ForHead read_for_head(Parser& p) {
    p.expect('(', "behind #for");
    const Token name = p.raw_token();
    if (name.kind != TokenKind::name) p.fail(name.place(), fmt::format("the name of a counter is expected, not {}", p.describe(name)));
    p.accept(',');                                                    // as everywhere, commas may be left out
    const double first = parse_float(p);
    p.accept(',');
    const double last = parse_float(p);
    p.accept(',');
    const Place at = p.peek().place();
    const double step = p.peek().is(')') ? 1 : parse_float(p);
    if (std::fabs(step) < kEpsilon) p.fail(at, "the step of a #for must not be 0");
    p.expect(')', "behind the values of #for");
    return {name.id, first, last, step};
}

void obey_for(Parser& p, const Token& directive, uint32_t index) {
    const ForHead head = within_frame(p, directive, [&] { return read_for_head(p); });
    Condition loop;
    loop.kind = Kind::for_loop, loop.opened = index, loop.body = p.stream.frame().at, loop.counter = head.counter, loop.last = head.last, loop.step = head.step;
    p.symbols.local(head.counter, p.symbols.depth()).value = Value::number(head.first);
    count_turn(p, directive.place());
    if (for_goes_on(loop, head.first)) p.stream.conditions().push_back(loop);
    else jump_behind_end(p, index);
}

void next_turn_of_for(Parser& p, const Token& end) {
    const Condition loop = p.stream.conditions().back();
    Slot* counter = p.symbols.find(loop.counter);
    if (!counter || counter->value.kind != pov::Kind::number) p.fail_limit(end.place(), "the counter of the #for is no float any more");
    counter->value.c[0] += loop.step;
    count_turn(p, end.place());
    if (for_goes_on(loop, counter->value.c[0])) return jump(p, loop.body);
    p.stream.conditions().pop_back();
}

/// A float that may be a condition, as behind #switch and #case, but not #range.
double parse_float_or_condition(Parser& p) {
    const Place at = p.peek().place();
    const Value value = parse_full(p);
    if (value.kind != pov::Kind::number) p.fail(at, fmt::format("a float is expected, not {}", kind_name(value)));
    return value.c[0];
}

/// Reads what stands in the brackets of #case or #range: does `value` match?
bool matches(Parser& p, const Token& clause, double value) {
    return within_frame(p, clause, [&] {
        p.expect('(', "behind #case or #range");
        const double low = clause.directive.word == "range"_w ? parse_float(p) : parse_float_or_condition(p);
        bool match = std::fabs(value - low) < kEpsilon;
        if (clause.directive.word == "range"_w) {
            p.accept(',');
            const double high = parse_float(p);              // read whatever the value is
            match = value >= low && value <= high;
        }
        p.expect(')', "behind the value of #case or #range");
        return match;
    });
}

void obey_switch(Parser& p, const Token& directive, uint32_t index) {
    const double value = within_frame(p, directive, [&] {
        p.expect('(', "behind #switch");
        const double x = parse_float_or_condition(p);
        p.expect(')', "behind the value of #switch");
        return x;
    });
    const Token first = p.stream.frame().tokens[next_clause(p, index)];
    if (first.directive.word == "end"_w || first.directive.word == "else"_w) {
        jump_behind_end(p, index);                                   // where it goes on: the #end is no error of its own
        p.fail(first.place(), fmt::format("#case or #range is expected in #switch before #{}", kWords[first.directive.word]));
    }
    enter(p, Kind::switch_, index);                                  // what stands before the first clause is obeyed
    p.stream.conditions().back().waiting = value;
}

/// Takes the first clause from the one at `index` on that matches.
void choose_case(Parser& p, uint32_t index, double value) {
    for (uint32_t clause = index;; clause = next_clause(p, clause)) {
        jump(p, clause + 1);
        const Token token = p.stream.frame().tokens[clause];
        if (token.directive.word == "end"_w) return p.stream.conditions().pop_back();
        if (token.directive.word == "else"_w || matches(p, token, value)) return p.stream.conditions().back().waiting.reset();
    }
}

/// The end of what has been taken: of a branch's clause, a switch, a turn of a loop.
void obey_end(Parser& p, const Token& directive) {
    const Condition condition = p.stream.conditions().back();
    if (condition.kind == Kind::for_loop) return next_turn_of_for(p, directive);
    p.stream.conditions().pop_back();
    if (condition.kind == Kind::while_loop) jump(p, condition.opened);
}

/// Leaves the innermost loop, switch or macro.
void obey_break(Parser& p, const Token& directive) {
    while (p.stream.frame_has_conditions()) {
        const Condition condition = p.stream.conditions().back();
        p.stream.conditions().pop_back();
        if (condition.kind != Kind::branch) return jump_behind_end(p, condition.opened);
    }
    if (!p.stream.frame().macro) p.fail(directive.place(), "#break stands in no loop, #switch or macro");
    jump(p, p.stream.frame().end);
}

/// #else, #elseif, #case or #range behind a clause that was taken: a branch is left, a switch falls through.
void obey_clause(Parser& p, const Token& directive, uint32_t index) {
    if (p.stream.conditions().back().kind == Kind::switch_) {
        if (const auto value = p.stream.conditions().back().waiting) return choose_case(p, index, *value);
        if (directive.directive.word == "case"_w || directive.directive.word == "range"_w) matches(p, directive, 0);
        return;
    }
    if (p.stream.conditions().back().kind != Kind::branch) p.fail_limit(directive.place(), fmt::format("#{} does not belong into a loop", kWords[directive.directive.word]));
    p.stream.conditions().pop_back();
    jump_behind_end(p, index);
}

}  // namespace

void obey_control(Parser& p, const Token& directive, uint32_t index) {
    switch (directive.directive.word) {
        case "if"_w: case "ifdef"_w: case "ifndef"_w: return choose_branch(p, index);
        case "while"_w: return obey_while(p, directive, index);
        case "for"_w: return obey_for(p, directive, index);
        case "switch"_w: return obey_switch(p, directive, index);
        case "break"_w: return obey_break(p, directive);
        default: break;
    }
    if (!p.stream.frame_has_conditions()) p.fail_limit(directive.place(), fmt::format("#{} stands without an #if, #switch, #while, #for or #macro", kWords[directive.directive.word]));
    if (directive.directive.word == "end"_w) obey_end(p, directive);
    else obey_clause(p, directive, index);
}

}  // namespace alidade::pov
