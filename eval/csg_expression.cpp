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

class Builder {
  public:
    Builder(const Scene& scene, Visit& at, CsgParts& parts) : scene_(scene), at_(at), parts_(parts) {}

    std::optional<CsgExpression> expression(Mask seen) {
        if (!parts_.enters(at_)) return std::nullopt;
        const Node& node = scene_.nodes[at_.node.index];
        CsgExpression e;
        e.leaf.id = parts_.place(at_);                           // without one it is flat, and nothing
        const bool has_shape = std::holds_alternative<ShapeId>(node.what);
        if (!node.children.empty()) {
            CsgExpression below = operation(node, seen);
            if (has_shape) below.parts.push_back(std::move(e));
            else if (below.parts.empty()) return std::nullopt;
            e = std::move(below);
        } else if (!has_shape) {
            return std::nullopt;
        }
        e.inverse = node.inverse;
        return node.clips.empty() ? std::move(e) : clipped(node, std::move(e));
    }

  private:
    CsgExpression operation(const Node& node, Mask seen) {
        CsgExpression e;
        e.op = csg_op(node.csg);
        e.cutaway_textures = node.cutaway_textures;
        for (const NodeId child : node.children) {
            const Mask below = seen & mask_of(scene_.nodes[child.index].flags);
            auto part = part_at(child, below);
            // POV-Ray looks at the flags of a solid as a whole, and at these two of the parts of merges: for a camera ray, one without image is not there.
            if (part && node.csg == CsgKind::merge) part->mask = below | ~(kMaskCamera | kMaskReflection);
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
            if (auto part = part_at(clip, kMaskAll)) e.parts.push_back(std::move(*part));
        return e;
    }

    std::optional<CsgExpression> part_at(NodeId id, Mask seen) {
        const Node& node = scene_.nodes[id.index];
        if (!node.flags.visible) return std::nullopt;
        const NodeId above = std::exchange(at_.node, id);
        const Transform to_world = std::exchange(at_.to_world, at_.to_world * node.to_parent);
        at_.path.push_back(id);
        auto part = expression(seen);
        at_.path.pop_back();
        at_.node = above, at_.to_world = to_world;
        return part;
    }

    const Scene& scene_;
    Visit& at_;
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
    if (!flags.shadow) mask &= ~(kMaskShadow | kMaskOpaque | kMaskFilter);
    if (!flags.reflection) mask &= ~kMaskReflection;
    return mask;
}

std::optional<CsgExpression> csg_expression(const Scene& scene, Visit& at, Mask seen, CsgParts& parts) { return Builder(scene, at, parts).expression(seen); }

}  // namespace alidade
