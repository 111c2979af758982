// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/arrays.h"

#include "importers/pov/expressions.h"

#include <fmt/format.h>

namespace alidade::pov {

void check_element(Parser& p, Array& array, const Value& value, Place at) {
    const ElementKind kind = element_kind_of(value);
    if (array.element_kind.kind == Kind::nothing) array.element_kind = kind;
    else if (!(kind == array.element_kind)) p.fail(at, fmt::format("the elements of an array are of one kind: this is {}, and the first one was {}", kind.name(), array.element_kind.name()));
}

namespace {

/// What subscripts and sizes are increased by before they are cut, as in POV-Ray (by experiment): A[.29*100] is A[29].
constexpr double kSubscriptSlack = 1e-10;

/// `{ a, b, { c, d } }`: the elements of dimension `level` and those below, from element `first`.
void parse_initialisers(Parser& p, Array& array, size_t level, size_t first, size_t stride) {
    p.expect('{', "before the elements of an array");
    stride /= array.sizes[level];
    for (uint32_t i = 0; i < array.sizes[level]; ++i, first += stride) {
        if (p.peek().is('}')) p.fail(p.peek().place(), fmt::format("the array has {} elements here, and only {} are given", array.sizes[level], i));
        if (level + 1 < array.sizes.size()) {
            parse_initialisers(p, array, level + 1, first, stride);
        } else {
            Ref<Slot> slot(new Slot);
            const Place at = p.peek().place();
            slot->value = owned(p, parse_value(p), at);
            check_element(p, array, slot->value, at);
            array.slots[first] = std::move(slot);
        }
        p.accept(',');
    }
    p.expect('}', "behind the elements of an array");
}

}  // namespace

Value parse_array(Parser& p, Place at) {
    const Nested nested(p, at);
    std::vector<uint32_t> sizes;
    uint64_t elements = 1;
    while (p.peek_behind_value().is('[')) {
        p.next();
        const Place here = p.peek().place();
        const double given = parse_float(p), size = given + kSubscriptSlack;
        if (!(size >= 1)) p.fail(here, fmt::format("an array has at least one element, not {}", given));
        if (size > double(p.options.limits.array_elements)) p.check_array_elements(uint64_t(std::min(size, 1e18)), here);
        p.expect(']', "behind the size of an array");
        sizes.push_back(uint32_t(size));
        elements *= sizes.back();
        p.check_array_elements(elements, here);
        if (sizes.size() > 5) p.fail(here, "an array has at most five dimensions");
    }
    if (sizes.empty()) p.fail(p.peek().place(), "the size of the array is expected in [ ]");
    Ref<Array> array(new Array(p.elements));
    array->resize(std::move(sizes), elements);
    if (p.peek_behind_value().is('{')) parse_initialisers(p, *array, 0, 0, elements);
    return Value::of(Kind::array, array);
}

void refuse_subscript(Parser& p, const Token& name, const Value& value) {
    if (value.kind == Kind::array || p.version < 3.5 || !p.stream.goes_on_with('[')) return;
    p.fail(p.peek_behind_value().place(), fmt::format("{} is no array but {}", p.names.text(name.id), kind_name(value)));
}

Value owned(Parser& p, Value value, Place at) {
    if (value.kind != Kind::array || value.shared->uses == 1) return value;
    const Nested nested(p, at);
    const Array& array = value.as<Array>();
    p.check_array_elements(array.slots.size(), at);
    Ref<Array> copy(new Array(p.elements));
    copy->resize(array.sizes, array.slots.size());
    copy->element_kind = array.element_kind;
    for (size_t i = 0; i < array.slots.size(); ++i)
        if (array.slots[i]) {
            copy->slots[i] = Ref<Slot>(new Slot);
            copy->slots[i]->value = owned(p, array.slots[i]->value, at);
        }
    return Value::of(Kind::array, copy);
}

Ref<Slot> parse_subscripts(Parser& p, Array& array, bool make) {
    const Nested nested(p, p.peek().place());
    const Ref<Array> hold(&array);
    size_t index = 0;
    for (uint32_t size : array.sizes) {
        p.expect('[', "before the subscript of an array");
        const Place at = p.peek().place();
        const double given = parse_float(p);
        const double cut = given + kSubscriptSlack;
        if (!(cut >= 0)) p.fail(at, fmt::format("the subscript {} is negative", given));
        if (cut >= size) p.fail(at, fmt::format("the subscript {} is out of range: the array has {} elements, 0 to {}", given, size, size - 1));
        index = index * size + size_t(cut);
        p.expect(']', "behind the subscript of an array");
    }
    if (make && !array.slots[index]) array.slots[index] = Ref<Slot>(new Slot);
    const bool empty = array.slots[index] && array.slots[index]->value.kind == Kind::nothing;    // of which #undef has taken the value, or one that was never given
    return empty && !make ? Ref<Slot>() : array.slots[index];
}

}  // namespace alidade::pov
