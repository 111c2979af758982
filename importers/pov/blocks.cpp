// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/blocks.h"

#include "importers/pov/builtins/builtins.h"
#include "importers/pov/expressions.h"
#include "importers/pov/functions.h"

#include <fmt/format.h>

namespace alidade::pov {

namespace {

void read_items(Parser& p, Block& block, char close);

Item item_of(Item::Kind kind, Place at) {
    Item item;
    item.kind = kind, item.place = at;
    return item;
}

Item block_item(Parser& p, Item::Kind kind, WordId word, char close, Place at) {
    const Nested nested(p, at);
    Ref<Block> block(new Block(p.items));
    block->word = word, block->place = at, block->defaults = uint32_t(p.defaults.size()), block->version = float(p.version);
    block->items.reserve(4);                  // most have no more
    read_items(p, *block, close);
    Item item = item_of(kind, at);
    item.word = word, item.value = Value::of(Kind::block, block);
    return item;
}

/// `<...>`: up to five numbers begin an expression, more are a list (a matrix, the terms of a polynomial).
Item vector_item(Parser& p, Place at) {
    std::vector<double> numbers;
    Value v = parse_vector(p, at, numbers);
    if (!numbers.empty()) {
        Item item = item_of(Item::Kind::numbers, at);
        Ref<NumberList> list(new NumberList);
        list->numbers = std::move(numbers);
        item.value.shared = Ref<Shared>(list.get());
        return item;
    }
    Item item = item_of(Item::Kind::value, at);
    item.value = continue_from_value(p, std::move(v));
    return item;
}

/// Words that begin a colour elsewhere mean something else here.
bool colours_are_words(const Block& block) {
    const WordId last = block.items.empty() || block.items.back().kind != Item::Kind::word ? block.word : block.items.back().word;
    return block.word == "image_map"_w || last == "assumed_gamma"_w || last == "gamma"_w;
}

Item word_item(Parser& p, const Token& word) {
    Item item = item_of(Item::Kind::value, word.place());
    if (word.id == "function"_w) return item.value = parse_function(p, word.place()), item;
    if (word.id == "spline"_w) return item.value = parse_spline(p, word.place()), item;
    if (p.accept('{')) return block_item(p, Item::Kind::block, word.id, '}', word.place());
    item.kind = Item::Kind::word, item.word = word.id;
    return item;
}

Item read_item(Parser& p, const Block& block, const Token& token) {
    if (token.is('[')) return block_item(p, Item::Kind::entry, block.word, ']', token.place());
    if (token.is('<')) return vector_item(p, token.place());
    if (token.is('{')) {                     // behind the sizes of `pattern W, H { ... }`
        WordId word = block.word;
        for (const Item& item : block.items)
            if (item.kind == Item::Kind::word) word = item.word;
        return block_item(p, Item::Kind::block, word, '}', token.place());
    }
    const bool colour_words = colours_are_words(block);
    const bool plain = token.kind == TokenKind::word && ((begins_colour(token) && colour_words) || (!begins_colour(token) && !find_builtin(token.id)));
    if (plain) return word_item(p, token);
    p.put_back(token);
    Item item = item_of(Item::Kind::value, token.place());
    item.value = begins_colour(token) ? parse_colour(p) : parse_expression(p);
    if (item.value.kind == Kind::colour && !colour_words) item.value = parse_colour_components(p, std::move(item.value));
    return item;
}

/// Blocks hold numbers, strings, blocks and functions; and those not too deep in one another.
void check_part(Parser& p, const Item& item) {
    const Kind kind = item.value.kind;
    if (kind == Kind::array || kind == Kind::file || kind == Kind::macro) p.fail(item.place, fmt::format("{} cannot stand in a block", kind_name(item.value)));
    p.check_depth(item.value, item.place);
}

void read_items(Parser& p, Block& block, char close) {
    for (;;) {
        const Token token = p.next();
        if (token.is(close)) return;
        if (token.is(',')) continue;
        if (token.kind == TokenKind::end) p.fail_limit(block.place, fmt::format("{} is not closed", kWords[block.word]), fmt::format("{} is missing", close));
        p.check_items(token.place());
        Item item = read_item(p, block, token);
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
    while (word.id == "texture"_w && p.peek_in_value().is_word("texture"_w)) {
        const Token next = p.next();
        const Value layer = parse_block(p, next.id, next.place());
        value.as<Block>().layers.emplace_back(&layer.as<Block>());
    }
    return value;
}

}  // namespace alidade::pov
