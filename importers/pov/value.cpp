// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/value.h"

#include <fmt/format.h>
#include <memory>

namespace alidade::pov {

void destroy(const Shared* unused) { delete unused; }

Value Value::string(std::string text) { return of(Kind::string, Ref<String>(new String(std::move(text)))); }

const std::string& Value::text() const { return as<String>().text; }

Block::Block(std::span<Item> from, Ref<Meter> counted_by) : meter(std::move(counted_by)) {
    Item* const first = reinterpret_cast<Item*>(reinterpret_cast<std::byte*>(this) + sizeof(Block));
    std::uninitialized_move(from.begin(), from.end(), first);
    items = {first, from.size()};
    meter->used += items.size() + kWeight;
    for (const Item& item : items)
        if (item.value.shared) depth = std::max(depth, item.value.shared->depth + 1);
}

Block::~Block() {
    meter->used -= items.size() + kWeight;
    std::destroy(items.begin(), items.end());
}

std::string kind_name(const Value& value) {
    switch (value.kind) {
        case Kind::nothing: return "nothing";
        case Kind::number: return "a float";
        case Kind::vector: return fmt::format("a vector of {}", value.terms);
        case Kind::colour: return "a colour";
        case Kind::string: return "a string";
        case Kind::array: return "an array";
        case Kind::block: return fmt::format("a {}", kWords[value.as<Block>().word]);
        case Kind::function: return "a function";
        case Kind::spline: return "a spline";
        case Kind::macro: return "a macro";
        case Kind::file: return "a file";
    }
    return "nothing";
}

}  // namespace alidade::pov
