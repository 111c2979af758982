// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/transforms.h"

#include "importers/pov/expressions.h"
#include "importers/pov/rotation.h"

#include <fmt/format.h>

namespace alidade::pov {

namespace {

Vec3 three(Parser& p, const Item& item, WordId word) {
    if (item.kind != Item::Kind::value || !item.numeric()) p.fail(item.place, fmt::format("a vector is expected behind {}", kWords[word]));
    const std::array<double, 5> c = wanted_vector(p, item.value(), 3, item.place, "behind", kWords[word]);
    return {c[0], c[1], c[2]};
}

Transform scaling(Parser& p, const Item& item) {
    Vec3 factors = three(p, item, "scale"_w);
    for (int i = 0; i < 3; ++i)
        if (factors[i] == 0) {
            p.warn(item.place, "a scale of 0 is taken as 1");
            factors[i] = 1;
        }
    return Transform::scale(factors);
}

/// `matrix <...>` of twelve numbers: where x, y, z and the origin go.
Transform matrix(Parser& p, const Item& item) {
    const bool list = item.kind == Item::Kind::numbers && item.as<NumberList>().numbers.size() == 12;
    if (!list) p.fail(item.place, "twelve numbers in < > are expected behind matrix");
    std::vector<double> m = item.as<NumberList>().numbers;
    for (size_t i = 0; i < 3; ++i)
        if (m[i] == 0 && m[3 + i] == 0 && m[6 + i] == 0) {
            p.warn(item.place, fmt::format("a matrix that makes all {0} 0 is taken as one that leaves {0} as it is", "xyz"[i]));
            m[4 * i] = 1;
        }
    return {Mat3(m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8]), Vec3(m[9], m[10], m[11])};
}

const Block* as_transform(const Item& item) {
    const bool holds = item.value_kind() == Kind::block && item.block().word == "transform"_w;
    return holds ? &item.block() : nullptr;
}

}  // namespace

bool begins_transform(const Item& item) {
    if (as_transform(item)) return true;
    return item.kind == Item::Kind::word && (item.word == "translate"_w || item.word == "rotate"_w || item.word == "scale"_w || item.word == "matrix"_w || item.word == "transform"_w);
}

Transform take_transform(Parser& p, const Block& block, size_t& i) {
    const Item& item = block.items()[i++];
    if (const Block* inner = as_transform(item)) {
        const bool by_name = item.kind == Item::Kind::value;
        if (by_name && block.word != "transform"_w) p.fail(item.place, "transform is expected before the name of a transformation: POV-Ray refuses it, too");
        return build_transform(p, *inner);
    }
    if (!begins_transform(item)) p.fail(item.place, "this is no transformation");
    if (i >= block.items().size()) p.fail(item.place, fmt::format("a value is expected behind {}", kWords[item.word]));
    const Item& value = block.items()[i++];
    switch (item.word) {
        case "translate"_w: return Transform::translate(three(p, value, item.word));
        case "rotate"_w: return {rotation(three(p, value, item.word)), Vec3(0)};
        case "scale"_w: return scaling(p, value);
        case "matrix"_w: return matrix(p, value);
        default: break;
    }
    if (const Block* inner = as_transform(value)) return build_transform(p, *inner);
    p.fail(value.place, "a transform is expected behind transform");
}

Transform build_transform(Parser& p, const Block& block) {
    Transform all;
    bool inverted = false;
    for (size_t i = 0; i < block.items().size();) {
        const Item& item = block.items()[i];
        if (item.kind == Item::Kind::word && item.word == "inverse"_w) inverted = true, ++i;
        else all = take_transform(p, block, i) * all;
    }
    if (!inverted) return all;
    const std::optional<Transform> back = inverse(all);
    if (!back) p.fail(block.place, "this transformation has no inverse");
    return *back;
}

}  // namespace alidade::pov
