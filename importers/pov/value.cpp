// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/value.h"

#include <algorithm>
#include <fmt/format.h>
#include <memory>

namespace alidade::pov {

void destroy(const Shared* unused) { delete unused; }

Value Value::string(std::string text) { return of(Kind::string, Ref<String>(new String(std::move(text)))); }

const std::string& Value::text() const { return as<String>().text; }

Item::Item(OpenItem&& from, double*& room) : kind(from.kind), value_kind_(from.value.kind), terms_(from.value.terms), rest_(from.value.rest), word(from.word), place(from.place) {
    if (const size_t several = from.components_behind()) {
        several_ = room;
        room = std::copy_n(from.value.c.begin(), several, room);
    } else if (numeric()) {
        number_ = from.value.c[0];
    } else {
        new (&shared_) Ref<Shared>(std::move(from.value.shared));
    }
}

Item::~Item() {
    if (!numeric()) std::destroy_at(&shared_);
}

Value Item::value() const {
    Value out;
    out.kind = value_kind_, out.terms = terms_, out.rest = rest_;
    if (components() > 1) std::copy_n(several_, components(), out.c.begin());
    else if (numeric()) out.c[0] = number_;
    else out.shared = shared_;
    return out;
}

Ref<Block> Block::of(std::span<OpenItem> items, Ref<Meter> meter) {
    size_t components = 0;
    for (const OpenItem& item : items) components += item.components_behind();
    return Ref<Block>(new (Room{items.size(), components}) Block(items, std::move(meter)));
}

Block::Block(std::span<OpenItem> from, Ref<Meter> counted_by) : count_(uint32_t(from.size())), meter(std::move(counted_by)) {
    meter->used += from.size() + kWeight;
    for (const OpenItem& item : from)
        if (item.value.shared) depth = std::max(depth, item.value.shared->depth + 1);
    Item* to = reinterpret_cast<Item*>(this + 1);
    double* room = reinterpret_cast<double*>(to + from.size());
    for (OpenItem& item : from) new (to++) Item(std::move(item), room);
}

Block::~Block() {
    meter->used -= count_ + kWeight;
    std::destroy_n(reinterpret_cast<Item*>(this + 1), count_);
}

ElementKind element_kind_of(const Value& value) {
    if (value.kind == Kind::vector) return value.terms == value.c.size() ? ElementKind{Kind::colour} : ElementKind{Kind::vector, value.terms};
    if (value.kind != Kind::block) return {value.kind};
    const WordId word = value.as<Block>().word;
    return {Kind::block, is_object(word) ? WordId("object"_w) : word == "colour_map"_w ? WordId("color_map"_w) : word};
}

std::string ElementKind::name() const {
    if (kind == Kind::block) return fmt::format("{} {}", std::string_view("aeio").find(kWords[detail][0]) == std::string_view::npos ? "a" : "an", kWords[detail]);
    Value like;
    like.kind = kind, like.terms = uint8_t(detail);
    return kind_name(like);
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
