// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/directives.h"

#include "importers/pov/expressions.h"
#include "importers/pov/macros.h"

#include <array>
#include <fmt/format.h>

namespace alidade::pov {

namespace {

void obey_message(Parser& p, const Token& directive) {
    static constexpr std::pair<WordId, TextStream> kStreams[] = {
        {"debug"_w, TextStream::debug}, {"warning"_w, TextStream::warning}, {"error"_w, TextStream::error}, {"render"_w, TextStream::render}, {"statistics"_w, TextStream::statistics}};
    const std::string text = parse_string(p);
    for (const auto& [word, stream] : kStreams) {
        if (word != directive.directive.word) continue;
        if (stream != TextStream::error) return p.print(stream, directive.place(), text);
        if (p.options.print) p.options.print(stream, text);
        p.fail_limit(directive.place(), fmt::format("the scene says: {}", text.substr(0, text.find_last_not_of(" \n\r\t") + 1)));
    }
}

void obey_include(Parser& p, const Token& directive) {
    const Token token = p.peek();
    if (token.kind == TokenKind::name && !p.symbols.find(token.id)) p.fail_limit(token.place(), "the name of a file stands in quotes behind #include", "#include \"colors.inc\"");
    const std::string name = parse_string(p);
    if (name.empty()) p.fail_limit(token.place(), "the name of the file is empty");
    p.include(name, directive.place());
}

/// `#max_trace_level 5` of old scenes, also without the #: a `global_settings { max_trace_level 5 }`.
void obey_setting(Parser& p, const Token& directive) {
    p.check_items(directive.place());
    std::array<OpenItem, 2> items;
    items[0].word = directive.directive.word, items[0].place = directive.place();
    items[1].kind = Item::Kind::value, items[1].place = directive.place(), items[1].value = Value::number(parse_float(p));
    const Ref<Block> block = Block::of(items, p.items);
    block->word = "global_settings"_w, block->place = directive.place(), block->stands(p.standing());
    p.globals.push_back(Value::of(Kind::block, block));
}

}  // namespace

void obey(Parser& p, const Token& directive) {
    const Nested nested(p, directive.place());
    const uint32_t index = p.stream.frame().at - 1;
    switch (directive.directive.word) {
        case "declare"_w: case "local"_w: case "undef"_w: case "default"_w: case "version"_w: return obey_declaration(p, directive);
        case "macro"_w: return define_macro(p, directive, index);
        case "include"_w: return obey_include(p, directive);
        case "debug"_w: case "warning"_w: case "error"_w: case "render"_w: case "statistics"_w: return obey_message(p, directive);
        case "fopen"_w: case "fclose"_w: case "read"_w: case "write"_w: return obey_file_directive(p, directive);
        case "if"_w: case "ifdef"_w: case "ifndef"_w: case "else"_w: case "elseif"_w: case "end"_w: case "while"_w: case "for"_w: case "switch"_w:
        case "case"_w: case "range"_w: case "break"_w: return obey_control(p, directive, index);
        default: return obey_setting(p, directive);                  // of the directives that there are
    }
}

}  // namespace alidade::pov
