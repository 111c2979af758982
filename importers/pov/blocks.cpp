// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/blocks.h"

#include "importers/pov/builtins/builtins.h"
#include "importers/pov/commas.h"
#include "importers/pov/expressions.h"
#include "importers/pov/functions.h"
#include "importers/pov/old_textures.h"
#include "importers/pov/suggestions.h"

#include <fmt/format.h>

namespace alidade::pov {

namespace {

/// A block of which some items have been read: they stand on a stack that all open blocks share, so that a finished one takes no more room than it needs.
class OpenBlock {
  public:
    OpenBlock(Parser& p, WordId word) : word(word), p_(p), begin_(p.open_items.size()) {}
    OpenBlock(const OpenBlock&) = delete;
    OpenBlock& operator=(const OpenBlock&) = delete;
    ~OpenBlock() {
        p_.items->used -= items().size();
        p_.open_items.erase(p_.open_items.begin() + std::ptrdiff_t(begin_), p_.open_items.end());
    }

    std::span<OpenItem> items() const { return std::span(p_.open_items).subspan(begin_); }
    void add(OpenItem item) { p_.open_items.push_back(std::move(item)), ++p_.items->used; }
    Ref<Block> finished(const BlockStanding& where) {
        std::vector<OpenItem> grouped;
        if (word == "texture"_w && where.version < 3) grouped = with_blocks_for_old_words(items(), p_.items, where);
        Ref<Block> block = Block::of(grouped.empty() ? items() : std::span(grouped), p_.items);
        block->word = word, block->stands(where);
        return block;
    }

    const WordId word;

  private:
    Parser& p_;
    const size_t begin_;
};

void read_items(Parser& p, OpenBlock& block, char close, Place at);

OpenItem item_of(Item::Kind kind, Place at) {
    OpenItem item;
    item.kind = kind, item.place = at;
    return item;
}

/// POV-Ray 1.0's word for what is a union since.
WordId word_of_today(Parser& p, WordId word, Place at) {
    if (word != "composite"_w) return word;
    p.warn(at, "composite is read as union");
    return "union"_w;
}

OpenItem block_item(Parser& p, Item::Kind kind, WordId given, char close, Place at) {
    const Nested nested(p, at);
    const WordId word = word_of_today(p, given, at);
    const BlockStanding where = p.standing();
    OpenBlock open(p, word);
    read_items(p, open, close, at);
    const Ref<Block> block = open.finished(where);
    block->place = at;
    OpenItem item = item_of(kind, at);
    item.word = word, item.value = Value::of(Kind::block, block);
    return item;
}

OpenItem numbers_item(std::vector<double> numbers, Place at) {
    OpenItem item = item_of(Item::Kind::numbers, at);
    Ref<NumberList> list(new NumberList);
    list->numbers = std::move(numbers);
    item.value.shared = Ref<Shared>(list.get());
    return item;
}

/// `xyz(1, 0, 2): 3` of a polynomial: the powers and what they are multiplied by.
OpenItem term_item(Parser& p, Place at) {
    std::vector<double> term;
    p.expect('(', "xyz");
    for (const char behind : {',', ',', ')'}) term.push_back(parse_float(p)), p.expect(behind, "a power of xyz");
    p.expect(':', "xyz(...)");
    term.push_back(parse_float(p));
    return numbers_item(std::move(term), at);
}

/// `<...>`: up to five numbers begin an expression, more are a list (a matrix, the terms of a polynomial).
OpenItem vector_item(Parser& p, Place at) {
    std::vector<double> numbers;
    Value v = parse_vector(p, at, numbers);
    if (!numbers.empty()) return numbers_item(std::move(numbers), at);
    OpenItem item = item_of(Item::Kind::value, at);
    item.value = continue_from_value(p, std::move(v));
    return item;
}

/// Words that begin a colour elsewhere mean something else here.
bool colours_are_words(const OpenBlock& block) {
    const std::span<const OpenItem> items = block.items();
    const WordId last = items.empty() || items.back().kind != Item::Kind::word ? block.word : items.back().word;
    return block.word == "image_map"_w || last == "assumed_gamma"_w || last == "gamma"_w;
}

OpenItem word_item(Parser& p, const Token& word) {
    OpenItem item = item_of(Item::Kind::value, word.place());
    if (word.id == "function"_w) return item.value = parse_function(p, word.place()), item;
    if (word.id == "spline"_w) return item.value = parse_spline(p, word.place()), item;
    if (p.accept('{')) return block_item(p, Item::Kind::block, word.id, '}', word.place());
    item.kind = Item::Kind::word, item.word = word.id;
    return item;
}

OpenItem read_item(Parser& p, const OpenBlock& block, const Token& token) {
    if (token.is('[')) return block_item(p, Item::Kind::entry, block.word, ']', token.place());
    if (token.is('<')) return vector_item(p, token.place());
    if (block.word == "polynomial"_w && token.kind == TokenKind::name && p.names.text(token.id) == "xyz") return term_item(p, token.place());
    if (token.is('{')) {                     // behind the sizes of `pattern W, H { ... }`
        WordId word = block.word;
        for (const OpenItem& item : block.items())
            if (item.kind == Item::Kind::word) word = item.word;
        return block_item(p, Item::Kind::block, word, '}', token.place());
    }
    const bool colour_words = colours_are_words(block);
    const bool plain = token.kind == TokenKind::word && ((begins_colour(token) && colour_words) || (!begins_colour(token) && !find_builtin(token.id)));
    if (plain) return word_item(p, token);
    p.put_back(token);
    OpenItem item = item_of(Item::Kind::value, token.place());
    item.value = begins_colour(token) ? parse_colour(p) : parse_expression(p);
    if (item.value.kind == Kind::colour && !colour_words) item.value = parse_colour_components(p, std::move(item.value));
    return item;
}

/// Blocks hold numbers, strings, blocks and functions; and those not too deep in one another.
void check_part(Parser& p, const OpenItem& item) {
    const Kind kind = item.value.kind;
    if (kind == Kind::array || kind == Kind::file || kind == Kind::macro) p.fail(item.place, fmt::format("{} cannot stand in a block", kind_name(item.value)));
    p.check_depth(item.value, item.place);
}

std::string text_of(const Parser& p, Place at) { return p.said.where(p.stream.source(uint16_t(at.source)).position(at.offset)); }

[[noreturn]] void fail_unclosed(Parser& p, const OpenBlock& block, char close, Place at) {
    const auto noticed = first_out_of_place(block.word, block.items());
    const std::string before = noticed ? fmt::format(", perhaps before {} at {}", kWords[noticed->first], text_of(p, noticed->second)) : "";
    p.fail_limit(at, fmt::format("{} is not closed", kWords[block.word]), fmt::format("{} is missing{}", close, before));
}

void read_items(Parser& p, OpenBlock& block, char close, Place at) {
    std::optional<Token> comma;        // that the last item stands before
    for (;;) {
        const Token token = p.next();
        if (comma && token.kind != TokenKind::end) check_behind_comma(p, block.word, block.items(), close, *comma, token), comma.reset();
        if (token.is(close)) return;
        if (token.is(',')) {
            if (block.items().empty()) p.fail(token.place(), "a value is expected before the ,");
            comma = token;
            continue;
        }
        if (token.kind == TokenKind::end) fail_unclosed(p, block, close, at);
        if (close == ']' && (token.is('[') || token.is('}'))) p.fail(token.place(), fmt::format("] is expected, not {}", token.mark), fmt::format("its [ is at {}", text_of(p, at)));
        p.check_items(token.place());
        OpenItem item = read_item(p, block, token);
        check_part(p, item);
        block.add(std::move(item));
    }
}

}  // namespace

Value parse_block(Parser& p, WordId word, Place at) {
    p.expect('{', "before the contents of a block");
    return block_item(p, Item::Kind::block, word, '}', at).value;
}

Value parse_declared_block(Parser& p, const Token& word) {
    Value value = parse_block(p, word.id, word.place());
    while (word.id == "texture"_w && p.peek_behind_value().is_word("texture"_w)) {
        const Token next = p.next();
        const Value layer = parse_block(p, next.id, next.place());
        auto& layers = value.as<Block>().layers;
        if (!layers) layers = std::make_unique<std::vector<Ref<Block>>>();
        layers->emplace_back(&layer.as<Block>());
    }
    return value;
}

}  // namespace alidade::pov
