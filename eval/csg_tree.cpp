// SPDX-License-Identifier: Apache-2.0
/// From an expression to the nodes of a tree.
#include "eval/csg.h"

#include <algorithm>
#include <numeric>

namespace alidade {

namespace {

/// An expression without differences and without inverses but at leaves.
struct Plain {
    CsgOp op = CsgOp::leaf;
    bool inverted = false;
    CsgLeaf leaf;
    uint32_t rank = 0;
    Mask mask = kMaskAll;
    std::vector<Plain> parts;
    bool far = false;
    uint8_t cost = 0;
    Bounds box, surface;
};

/// Who tells the boxes of endless parts.
struct Narrowing {
    const CsgNarrow& narrow;                      ///< in the space of the rays
    const CsgOwnSpace& own;                       ///< in the set's own
    const CsgHalfSpaces* half_spaces = nullptr;   ///< null: corners are not looked for
};

Bounds everywhere() { return {Vec3(-kInf), Vec3(kInf)}; }

CsgOp plain_op(CsgOp op, bool inverse) {
    switch (op) {
        case CsgOp::union_: return inverse ? CsgOp::intersection : CsgOp::union_;
        case CsgOp::merge: return inverse ? CsgOp::intersection : CsgOp::merge;
        case CsgOp::intersection:
        case CsgOp::difference: return inverse ? CsgOp::merge : CsgOp::intersection;
        case CsgOp::leaf:
        case CsgOp::clip: break;
    }
    return op;
}

/// Outside of its box a set is nothing, or everything. Of an intersection only that is left which is in the box of every part that is nothing outside
/// of its own; where all parts go on for ever, it goes on outside of all boxes. For a merge the same holds of what is outside; a union shows the
/// surfaces of all parts, wherever they are.
void find_box(Plain& p) {
    if (p.op == CsgOp::leaf) {
        p.far = p.inverted;
        p.box = p.leaf.endless ? everywhere() : p.leaf.bounds;
        return;
    }
    const bool meets = p.op == CsgOp::intersection || p.op == CsgOp::clip;
    const auto decides = [&](const Plain& part) { return part.far != meets; };
    const bool decided = std::any_of(p.parts.begin(), p.parts.end(), decides);
    p.far = decided != meets;
    p.box = decided && p.op != CsgOp::union_ ? everywhere() : Bounds();
    for (const Plain& part : p.parts) {
        if (!decided || p.op == CsgOp::union_) p.box.extend(part.box);
        else if (decides(part)) p.box = intersection(p.box, part.box);
    }
}

/// What planes among the parts of an intersection enclose.
Bounds box_between_planes(const Plain& p, const CsgHalfSpaces& half_spaces) {
    std::vector<HalfSpace> planes;
    for (const Plain& part : p.parts) {
        const auto plane = part.op == CsgOp::leaf && part.leaf.id != kNoId ? half_spaces(part.leaf.id) : std::nullopt;
        if (plane) planes.push_back(part.inverted ? HalfSpace{-plane->normal, -plane->offset} : *plane);
    }
    return box_of_corners(planes);
}

/// What the parts of an intersection leave of `box`.
Bounds narrowed_by_parts(const Plain& p, Bounds box, const CsgNarrow& narrow) {
    Bounds before;
    constexpr int kMostRounds = 8;
    for (int round = 0; round < kMostRounds && !box.empty() && (box.min != before.min || box.max != before.max); ++round) {
        before = box;
        for (const Plain& part : p.parts)
            if (part.op == CsgOp::leaf && part.leaf.id != kNoId && part.leaf.inside == CsgInside::by_crossings && !box.empty()) box = narrow(part.leaf.id, part.inverted, box);
    }
    return box;
}

/// Endless parts of an intersection bound each other, as a cylinder does two planes across it. What goes on for ever stays so, unless it proves finite.
void narrow_box(Plain& p, const Narrowing& by) {
    if (!by.narrow || (p.op != CsgOp::intersection && p.op != CsgOp::clip)) return;
    Bounds start = p.far ? everywhere() : p.box;
    if (by.half_spaces && !start.finite()) start = intersection(start, box_between_planes(p, *by.half_spaces));
    Bounds box = narrowed_by_parts(p, start, by.narrow);
    if (by.own.narrow && !box.empty() && !box.finite()) {
        const Bounds there = narrowed_by_parts(p, everywhere(), by.own.narrow);
        if (there.empty()) box = Bounds();
        else if (there.finite()) box = intersection(box, by.own.placed(there));
    }
    if (p.far && !box.finite()) return;
    p.box = box.empty() ? Bounds() : box, p.far = false;
}

/// A surface of the whole is one of a part, and not beyond what decides that there is nothing else.
void find_surface(Plain& p) {
    if (p.op == CsgOp::leaf) return void(p.surface = p.leaf.bounds);
    p.surface = Bounds();
    for (size_t i = 0; i < (p.op == CsgOp::clip ? 1 : p.parts.size()); ++i) p.surface.extend(p.parts[i].surface);
    p.surface = intersection(p.surface, p.box);
}

/// Parts stay in order up to this many.
constexpr size_t kMostParts = 8;

void finish(Plain& p, const Narrowing& by);

/// Many parts become groups of parts that are near each other: halves by the middle of their boxes along the longest extent, and halves of those. What
/// a line can miss without deciding anything is sorted, the holes of an intersection or the solids of a union; the rest comes first.
void sort_by_place(Plain& p, const Narrowing& by) {
    if (p.parts.size() <= kMostParts) return;
    const bool meets = p.op == CsgOp::intersection;
    const auto bounded = std::stable_partition(p.parts.begin(), p.parts.end(), [meets](const Plain& part) { return !part.box.finite() || part.far != meets; });
    const std::ptrdiff_t count = p.parts.end() - bounded;
    if (count <= std::ptrdiff_t(kMostParts)) return;
    Bounds middles;
    for (auto i = bounded; i != p.parts.end(); ++i) middles.extend(i->box.center());
    const Vec3 extent = middles.extent();
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    std::stable_sort(bounded, p.parts.end(), [axis](const Plain& a, const Plain& b) { return a.box.center()[axis] < b.box.center()[axis]; });
    // Without what the parts took: levels of halves, each with room for all that was sorted into them, would hold most of the memory of a large merge.
    const auto middle = bounded + (count + 1) / 2;
    Plain halves[2];
    halves[0].parts.assign(std::move_iterator(bounded), std::move_iterator(middle));
    halves[1].parts.assign(std::move_iterator(middle), std::move_iterator(p.parts.end()));
    std::vector<Plain> rest(std::move_iterator(p.parts.begin()), std::move_iterator(bounded));
    p.parts = std::move(rest);
    for (Plain& half : halves) {
        half.op = p.op, half.mask = p.mask;
        finish(half, by);
        p.parts.push_back(std::move(half));
    }
}

void finish(Plain& p, const Narrowing& by) {
    // What clips stands behind what is clipped.
    if (p.op != CsgOp::leaf && p.op != CsgOp::clip) sort_by_place(p, by);
    find_box(p);
    narrow_box(p, by);
    find_surface(p);
    p.cost = p.leaf.cost;
    for (const Plain& part : p.parts) p.cost = std::max(p.cost, part.cost);
}

/// How leaves are ranked: in the order of POV-Ray's list of hits, whose end is seen.
struct Ranking {
    bool from_end = false;    ///< is the list of this part taken from its end?
    bool clipped = false;     ///< a union that is clipped takes those of its parts so, as an intersection does
};

Plain plain(const CsgExpression& e, bool inverse, Mask mask, Ranking ranking, uint32_t& rank) {
    Plain out;
    inverse = inverse != e.inverse;
    out.op = plain_op(e.op, inverse);
    out.leaf = e.leaf;
    out.mask = mask & e.mask;
    out.inverted = e.op == CsgOp::leaf && inverse && (e.leaf.id == kNoId || e.leaf.inside != CsgInside::nowhere);
    if (e.op == CsgOp::leaf) out.rank = rank++;
    const size_t count = e.parts.size();
    const bool turns = e.op == CsgOp::intersection || e.op == CsgOp::difference || (e.op == CsgOp::union_ && ranking.clipped);
    std::vector<Plain> made(count);
    for (size_t k = 0; k < count; ++k) {
        const size_t i = ranking.from_end ? count - 1 - k : k;
        made[i] = plain(e.parts[i], turns_part(e, i, inverse), out.mask, {ranking.from_end != turns, e.op == CsgOp::clip}, rank);
    }
    for (Plain& part : made) {
        if (part.op == out.op && out.op != CsgOp::clip) std::move(part.parts.begin(), part.parts.end(), std::back_inserter(out.parts));
        else out.parts.push_back(std::move(part));
    }
    if (out.op == CsgOp::leaf) find_box(out);
    if (out.parts.size() == 1) return Plain(std::move(out.parts.front()));
    return out;
}

void finish_below(Plain& p, const Narrowing& by) {
    for (Plain& part : p.parts) finish_below(part, by);
    finish(p, by);
}

CsgExtent extent_of(const Bounds& box) {
    if (box.empty()) return CsgExtent::nowhere;
    return box.min == Vec3(-kInf) && box.max == Vec3(kInf) ? CsgExtent::everywhere : CsgExtent::in_box;
}

void emit(const Plain& p, uint32_t parent, uint32_t place, std::vector<CsgNode>& out) {
    const uint32_t self = uint32_t(out.size());
    CsgNode node;
    node.op = p.op, node.inside = p.leaf.inside, node.inverted = p.inverted, node.far = p.far, node.leaf = p.leaf.id;
    node.parent = parent, node.place = place, node.children = uint32_t(p.parts.size());
    node.mask = p.mask, node.rank = p.rank, node.box = p.box, node.extent = extent_of(p.box);
    out.push_back(node);
    std::vector<uint32_t> order(node.children);
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return p.parts[a].cost < p.parts[b].cost; });
    for (const uint32_t i : order) emit(p.parts[i], self, i, out);
    out[self].end = uint32_t(out.size());
}

}  // namespace

uint32_t CsgTree::levels() const {
    std::vector<uint32_t> level(nodes_.size(), 1);   // parents stand before their parts
    for (size_t i = 1; i < nodes_.size(); ++i) level[i] = level[nodes_[i].parent] + 1;
    return *std::max_element(level.begin(), level.end());
}

CsgTree::CsgTree(const CsgExpression& expression, const CsgNarrow& narrow, const CsgOwnSpace& own, const CsgHalfSpaces& half_spaces) {
    uint32_t rank = 0;
    Plain p = plain(expression, false, kMaskAll, {}, rank);
    const CsgOwnSpace sides{own.by_sides, own.placed, nullptr};
    finish_below(p, {narrow, sides});
    bounds_by_sides_ = p.surface;
    if (own.narrow) finish_below(p, {narrow, own});
    if (half_spaces && !p.surface.finite() && !p.surface.empty()) finish_below(p, {narrow, own, &half_spaces});
    bounds_ = p.surface;
    emit(p, 0, 0, nodes_);
}

void CsgTree::find_bounded(const std::function<bool(uint32_t leaf)>& bounded) {
    for (CsgNode& node : nodes_) node.bounded = node.op == CsgOp::leaf && node.leaf != kNoId && bounded(node.leaf);
}

}  // namespace alidade
