// SPDX-License-Identifier: Apache-2.0
/// #declare, #local, #undef, #default, #version.
#include "importers/pov/arrays.h"
#include "importers/pov/blocks.h"
#include "importers/pov/directives.h"
#include "importers/pov/expressions.h"

#include <fmt/format.h>

namespace alidade::pov {

namespace {

/// `deprecated [once] ["message"]`, or nothing; `name` becomes the token behind it.
Ref<Deprecation> read_deprecation(Parser& p, Token& name) {
    if (!name.is_word("deprecated"_w)) return {};
    Ref<Deprecation> deprecation(new Deprecation);
    name = p.raw_token();
    if (name.is_word("once"_w)) deprecation->once = true, name = p.raw_token();
    if (name.kind == TokenKind::string) deprecation->message = p.text(name), name = p.raw_token();
    return deprecation;
}

/// The element `name[i]...` that is assigned to, or empty if a whole identifier is. `holder`: its array.
Ref<Slot> element(Parser& p, const Token& name, Ref<Array>& holder) {
    Slot* slot = p.symbols.find(name.id);
    if (slot) refuse_subscript(p, name, slot->value);
    if (!slot || slot->value.kind != Kind::array || !p.peek_behind_value().is('[')) return {};
    return parse_reference(p, name, true, &holder);
}

/// Behind floats, vectors and colours a semicolon must stand, and a second one may, as where a macro that gives the value ends with one; behind all else one may.
void end_declaration(Parser& p, bool needs_semicolon, const Token& name) {
    // Not peek(): it would obey the next #declare inside of this one, and that the next, until nothing nests any deeper.
    const Token behind = p.peek_behind_value();
    if (behind.is(';')) {
        p.next();
        if (needs_semicolon && p.peek_behind_value().is(';')) p.next();
        return;
    }
    if (!needs_semicolon) return;
    if (p.version >= 3.5) p.fail(behind.place(), fmt::format("; is expected behind the value of {}, not {}", p.names.text(name.id), p.describe(behind)));
    p.tally(behind.place(), "; is expected behind the value of a declaration");
}

Value declared_value(Parser& p, const Token& name) try {
    const Place at = p.peek().place();
    Value value = parse_value(p, Standing::in_declaration);
    if (value.kind == Kind::nothing) p.fail(at, "this has no value");
    return value.kind == Kind::array ? owned(p, std::move(value), at) : value;
} catch (const Failure&) {
    if (!p.symbols.find(name.id)) p.failed_names.insert(name.id);
    throw;
}

void declare(Parser& p, const Token& directive) {
    Token name = p.raw_token();
    Ref<Deprecation> deprecation = read_deprecation(p, name);
    if (name.kind == TokenKind::word) p.fail(name.place(), fmt::format("{} is a word of the language and cannot be declared", p.describe(name)));
    if (name.kind != TokenKind::name) p.fail(name.place(), fmt::format("a name is expected behind #{}, not {}", kWords[directive.directive.word], p.describe(name)));
    const bool local = directive.directive.word == "local"_w;
    const size_t depth = p.symbols.depth();
    Ref<Array> holder;
    Ref<Slot> into = element(p, name, holder);
    const bool of_outer_level = into && local && !p.symbols.is_at_this_level(name.id);
    if (!into && !local) into = Ref<Slot>(p.symbols.find(name.id));    // now: a macro in the value may hide the name
    p.expect('=', "behind the name that is declared");
    const Place at = p.peek_behind_value().place();
    Value value = declared_value(p, name);
    Slot& slot = into ? *into : local ? p.symbols.local(name.id, depth) : p.symbols.global(name.id);
    const bool needs_semicolon = value.numeric();
    if (of_outer_level && into->value.kind != Kind::nothing) {     // by experiment
        p.warn(name.place(), "#local leaves an element as it is of an array that was not declared in the same macro or file, as in POV-Ray: #declare sets it");
    } else {
        if (holder) check_element(p, *holder, value, at);
        slot.value = std::move(value);
        slot.deprecation = std::move(deprecation);
    }
    end_declaration(p, needs_semicolon, name);
}

void undefine(Parser& p, const Token&) {
    const Token name = p.raw_token();
    if (name.kind != TokenKind::name) p.fail(name.place(), fmt::format("a name is expected behind #undef, not {}", p.describe(name)));
    Ref<Array> holder;
    if (const Ref<Slot> part = element(p, name, holder)) part->value = {};
    else if (!p.symbols.undefine(name.id)) p.warn(name.place(), fmt::format("{} is not declared, so #undef has nothing to do", p.names.text(name.id)));
}

void set_version(Parser& p) {
    if (p.peek().kind == TokenKind::name && p.names.text(p.peek().id) == "unofficial") p.next();   // a patched POV-Ray's own language
    const Place at = p.peek().place();
    const double version = parse_float(p, Standing::in_declaration);    // holds for what stands behind it
    const bool known = version >= 0 && version <= 3.7 + 1e-9;
    if (!known) p.warn(at, fmt::format("the language of version {} is not known, the scene is read as one of 3.7", version));
    p.version = known ? std::min(version, 3.7) : 3.7;
    p.version_given = true;
    if (p.peek_behind_value().is(';')) p.next();
}

}  // namespace

void obey_declaration(Parser& p, const Token& directive) {
    switch (directive.directive.word) {
        case "undef"_w: return undefine(p, directive);
        case "version"_w: return set_version(p);
        case "default"_w: p.defaults.emplace_back(directive.place(), parse_block(p, "default"_w, directive.place())); return;
        default: return declare(p, directive);
    }
}

}  // namespace alidade::pov
