// SPDX-License-Identifier: Apache-2.0
#include "eval/csg_expression.h"

#include <utility>

namespace alidade {

namespace {

CsgOp csg_op(CsgKind kind) {
    switch (kind) {
        case CsgKind::merge: return CsgOp::merge;
        case CsgKind::intersection: return CsgOp::intersection;
        case CsgKind::difference: return CsgOp::difference;
        case CsgKind::none:
        case CsgKind::union_: break;
    }
    return CsgOp::union_;
}

constexpr Mask kMaskShadows = kMaskShadow | kMaskOpaque | kMaskFilter;

class Builder {
  public:
    Builder(const Scene& scene, Visit& at, CsgParts& parts) : scene_(scene), at_(at), parts_(parts) {}

    /// `inverted`: once at least, by what stands around the node.
    std::optional<CsgExpression> expression(Mask seen, bool inverted) {
        if (!parts_.enters(at_)) return std::nullopt;
        const Node& node = scene_.nodes[at_.node.index];
        CsgExpression e;
        e.leaf.id = parts_.place(at_, to_set_);                           // without one it is flat, and nothing
        const bool has_shape = std::holds_alternative<ShapeId>(node.what);
        if (!node.children.empty()) {
            CsgExpression below = operation(node, seen, inverted || node.inverse);
            if (!has_shape && lone_part(node) && below.parts.size() == 1) below = CsgExpression(std::move(below.parts[0]));   // what is placed, and no union of one
            else if (has_shape) below.parts.push_back(std::move(e));
            else if (below.parts.empty()) return std::nullopt;
            e = std::move(below);
        } else if (node.csg != CsgKind::none) {
            e.leaf.id = kNoId;                                   // a set without parts: nothing, or, since all points are in all of no parts, everything
            e.inverse = node.csg == CsgKind::intersection || node.csg == CsgKind::difference;
        } else if (!has_shape) {
            return std::nullopt;
        }
        e.inverse = e.inverse != node.inverse;
        return node.clips.empty() ? std::move(e) : clipped(node, std::move(e));
    }

  private:
    CsgExpression operation(const Node& node, Mask seen, bool inverted) {
        CsgExpression e;
        e.op = csg_op(node.csg);
        e.cutaway_textures = node.cutaway_textures;
        for (const NodeId child : node.children) {
            const Mask below = seen & mask_of_path(scene_, {child});
            auto part = part_at(child, below, inverted || (node.csg == CsgKind::difference && !e.parts.empty()));
            // POV-Ray looks at the flags of a solid as a whole, and at these of the parts of unions and merges: for a reflected ray, one without reflection is not there. Inverted, both are intersections.
            if (part && !inverted && (node.csg == CsgKind::merge || node.csg == CsgKind::union_)) part->mask = below | ~(node.csg == CsgKind::merge ? kMaskCamera | kMaskReflection : kMaskReflection);
            if (part) e.parts.push_back(std::move(*part));
            else if (node.csg == CsgKind::difference && e.parts.empty()) e.parts.emplace_back();   // nothing, from which something is taken
        }
        return e;
    }

    CsgExpression clipped(const Node& node, CsgExpression of) {
        CsgExpression e;
        e.op = CsgOp::clip;
        e.parts.push_back(std::move(of));
        for (const NodeId clip : node.clips)
            if (auto part = part_at(clip, kMaskAll, true)) e.parts.push_back(std::move(*part));
        return e;
    }

    std::optional<CsgExpression> part_at(NodeId id, Mask seen, bool inverted) {
        const Node& node = scene_.nodes[id.index];
        if (!node.flags.visible) return std::nullopt;
        const NodeId above = std::exchange(at_.node, id);
        const Transform to_world = std::exchange(at_.to_world, at_.to_world * node.to_parent), to_set = std::exchange(to_set_, to_set_ * node.to_parent);
        at_.path.push_back(id);
        auto part = expression(seen, inverted);
        at_.path.pop_back();
        at_.node = above, at_.to_world = to_world, to_set_ = to_set;
        return part;
    }

    const Scene& scene_;
    Visit& at_;
    Transform to_set_;
    CsgParts& parts_;
};

}  // namespace

bool is_solid(const Node& node) {
    const bool operation = node.csg == CsgKind::intersection || node.csg == CsgKind::difference || node.csg == CsgKind::merge;
    return operation || !node.clips.empty() || (node.inverse && !node.children.empty());
}

Mask mask_of(const NodeFlags& flags) {
    Mask mask = kMaskAll;
    if (!flags.image) mask &= ~kMaskCamera;
    if (!flags.shadow) mask &= ~kMaskShadows;
    if (!flags.reflection) mask &= ~kMaskReflection;
    return mask;
}

std::optional<NodeId> lone_part(const Node& node) {
    return node.csg == CsgKind::none && node.children.size() == 1 ? std::optional(node.children[0]) : std::nullopt;
}

LoneShape lone_shape(const Scene& scene, NodeId id) {
    Transform to_space;
    for (std::optional<NodeId> at = id; at; at = lone_part(scene.nodes[at->index])) {
        const Node& node = scene.nodes[at->index];
        if (node.inverse || !node.clips.empty() || !node.bounds.empty()) break;
        to_space = to_space * node.to_parent;
        const auto* shape = std::get_if<ShapeId>(&node.what);
        if (shape && node.children.empty()) return {&scene.shapes[shape->index].geometry, to_space};
    }
    return {};
}

Mask mask_of_path(const Scene& scene, std::vector<NodeId> path) {
    for (auto below = lone_part(scene.nodes[path.back().index]); below; below = lone_part(scene.nodes[below->index])) path.push_back(*below);
    Mask mask = kMaskAll;
    bool is_part = false, whole = false;
    for (const NodeId id : path) {
        const Node& node = scene.nodes[id.index];
        mask &= mask_of(node.flags) | (is_part ? ~kMaskReflection : 0);
        whole = whole || node.whole || !node.clips.empty();
        if (lone_part(node)) continue;                              // what it places may be a union
        is_part = is_part || (node.csg == CsgKind::union_ && whole);
        whole = false;
    }
    return mask;
}

std::optional<CsgExpression> csg_expression(const Scene& scene, Visit& at, Mask seen, CsgParts& parts) { return Builder(scene, at, parts).expression(seen, false); }

}  // namespace alidade
