// SPDX-License-Identifier: Apache-2.0
#include "importers/pov/builders/clips.h"

#include "core/transform.h"
#include "importers/pov/builders/objects.h"

#include <fmt/format.h>

namespace alidade::pov {

namespace {

/// What clips or bounds an object is moved by its `own` transformations, and by those of the object behind it; `moved` are those before it.
void add_limit(Build& build, std::vector<NodeId>& limits, const Block& limit, const Transform& moved, const Transform& own) {
    const auto built = build_object(build, limit);
    if (!built) return;
    if (!built->limits) build.p.fail(limit.place, "what clips or bounds an object has no texture, no light and no triangles in it, but for meshes with an inside_vector", "take them away: what is clipped keeps its own texture");
    NodeId node = built->node;
    if (!moved.is_identity() || !own.is_identity()) {
        const auto back = inverse(moved);
        if (!back) return build.p.warn(limit.place, "the object is flat or infinitely large here and cannot be clipped or bounded");
        Node placed;
        placed.from = build.position(limit.place);
        placed.to_parent = *back * own;
        placed.children.push_back(node);
        node = build.add_node(std::move(placed));
    }
    limits.push_back(node);
}

/// The transformations in `clipped_by { ... }` or `bounded_by { ... }`, which move all of it.
Transform moves_of_limits(Build& build, const Block& block) {
    Transform all;
    for (Cursor at(build, block); !at.done(); ) {
        if (at.at_transform()) all = at.transform() * all;
        else at.next();
    }
    return all;
}

/// As POV-Ray does: flags and the like stand in the objects.
[[noreturn]] void refuse_in_limits(const Build& build, const Cursor& at) {
    at.refuse_misplaced();
    const Block* block = at.any_block();
    const Item& item = at.peek();
    const std::string_view what = block ? kWords[block->word] : item.kind == Item::Kind::word ? kWords[item.word] : std::string_view("a value");
    build.p.fail(at.place(), fmt::format("{} cannot stand in {}: objects do, and what moves them", what, kWords[at.block().word]));
}

}  // namespace

bool names_other_limits(Build& build, const Block& block) {
    Cursor at(build, block);
    if (!at.accept(block.word == "clipped_by"_w ? "bounded_by"_w : "clipped_by"_w)) return false;
    if (!at.done()) build.p.fail(at.place(), fmt::format("what {} names stands alone in it", kWords[block.word]));
    return true;
}

void take_limits(Build& build, std::vector<Bound>& bounds, std::vector<NodeId>& limits, const Block& block, const Transform& moved) {
    if (names_other_limits(build, block)) return take_last_bound(build, bounds, limits);
    if (const Cursor first(build, block); first.done() || first.at_transform()) build.p.fail(block.place, fmt::format("an object is expected in {}", kWords[block.word]));
    const Transform own = moves_of_limits(build, block);
    bool moves = false;
    for (Cursor at(build, block); !at.done(); ) {
        const Block* limit = at.any_block();
        const bool object = limit && is_object(limit->word);
        if (object && moves) build.p.fail(limit->place, fmt::format("{} cannot stand behind what moves the objects in {}", kWords[limit->word], kWords[block.word]), "put it before the transformations, which move it too");
        if (object) at.next(), add_limit(build, limits, *limit, moved, own);
        else if (at.at_transform()) at.transform(), moves = true;
        else refuse_in_limits(build, at);
    }
}

void take_last_bound(Build& build, std::vector<Bound>& bounds, std::vector<NodeId>& limits) {
    if (bounds.empty()) return;
    const Bound bound = bounds.back();
    bounds.pop_back();
    take_limits(build, bounds, limits, *bound.block, bound.moved);
}

}  // namespace alidade::pov
