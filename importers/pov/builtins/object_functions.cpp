// SPDX-License-Identifier: Apache-2.0
/// Functions of objects (POV-Ray reference, 3.3.1.6.5 and 3.3.1.5.4). Arguments as probed: an object is given by its name.
#include "importers/pov/builders/objects.h"
#include "importers/pov/builtins/builtins.h"
#include "importers/pov/expressions.h"
#include "importers/pov/object_queries.h"

#include <fmt/format.h>

namespace alidade::pov {

namespace {

Vec3 next_point(Parser& p) {
    p.accept(',');
    const auto c = parse_vector(p);
    return {c[0], c[1], c[2]};
}

/// The slot that a name stands for, which may be an element of an array.
Ref<Slot> named(Parser& p, const char* what) {
    const Token name = p.next();
    if (name.kind != TokenKind::name) p.fail(name.place(), fmt::format("the name of {} is expected, not {}", what, p.describe(name)), "#declare it");
    Ref<Slot> slot = parse_reference(p, name, false);
    if (!slot) p.fail(name.place(), "this array element has no value yet");
    return slot;
}

Value first_object(Parser& p) {
    p.expect('(', "before the arguments of a function");
    const Place at = p.peek().place();
    Value object = named(p, "an object")->value;
    if (object.kind != Kind::block || !is_object(object.as<Block>().word)) p.fail(at, fmt::format("the name of an object is expected, and this is {}", kind_name(object)));
    return object;
}

ObjectQueries& queries(Parser& p) {
    if (!p.objects) p.objects = std::make_unique<ObjectQueries>(p);
    return *p.objects;
}

Value is_inside(Parser& p, Place at) {
    const Value object = first_object(p);
    const Vec3 point = next_point(p);
    close(p);
    return Value::number(queries(p).inside(object, point, at));
}

/// trace(OBJECT, ORIGIN, DIRECTION [, NORMAL]): the last is the name of a vector, which is set.
Value trace(Parser& p, Place at) {
    const Value object = first_object(p);
    const Vec3 origin = next_point(p), dir = next_point(p);
    Ref<Slot> normal;
    if (p.accept(',')) {
        const Place place = p.peek().place();
        normal = named(p, "a vector");
        if (normal->value.kind != Kind::vector || normal->value.terms != 3) p.fail(place, fmt::format("the name of a vector of 3 is expected, and this is {}", kind_name(normal->value)));
    }
    close(p);
    const Traced traced = queries(p).trace(object, origin, dir, at);
    if (normal) normal->value = of_three(traced.normal);
    return of_three(traced.point);
}

template <bool high>
Value extent(Parser& p, Place) {
    const Value object = first_object(p);
    close(p);
    const Bounds box = queries(p).extent(object);
    if (box.empty() && !box.finite()) return of_three(Vec3(0));   // there is nothing; limits that are apart keep a box that is upside down
    return of_three(high ? box.max : box.min);
}

constexpr BuiltinEntry kObjectFunctions[] = {{"inside"_w, is_inside}, {"max_extent"_w, extent<true>}, {"min_extent"_w, extent<false>}, {"trace"_w, trace}};

}  // namespace

std::span<const BuiltinEntry> object_functions() { return kObjectFunctions; }

}  // namespace alidade::pov
