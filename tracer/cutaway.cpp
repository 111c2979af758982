// SPDX-License-Identifier: Apache-2.0
#include "tracer/cutaway.h"

#include "tracer/instance_leaves.h"
#include "tracer/shade_point.h"

#include <algorithm>

namespace alidade {
namespace {

/// Turned inside out, a union cuts and what cuts does not.
bool cuts(const CsgExpression& e, bool inverted) {
    switch (e.op) {
        case CsgOp::intersection:
        case CsgOp::difference: return !inverted;
        case CsgOp::union_:
        case CsgOp::merge: return inverted;
        case CsgOp::leaf:
        case CsgOp::clip: break;
    }
    return false;
}

bool is_instance(const CsgExpression& e) { return e.op == CsgOp::leaf && e.leaf.id != kNoId; }

bool has_material(const CompiledScene& scene, const CsgExpression& e) {
    if (is_instance(e)) return !scene.instances[e.leaf.id].usual_material;
    return std::any_of(e.parts.begin(), e.parts.end(), [&](const CsgExpression& part) { return has_material(scene, part); });
}

/// `inverted`: with all around it.
void flatten(const CsgExpression& e, bool inverted, std::vector<CutawayNode>& nodes) {
    const size_t here = nodes.size();
    nodes.push_back({e.op, e.inverse, inverted, false, e.op == CsgOp::leaf ? e.leaf.id : kNoId, 0, 0});
    for (size_t i = 0; i < e.parts.size(); ++i) {
        const size_t part = nodes.size();
        flatten(e.parts[i], inverted != e.parts[i].inverse, nodes);
        nodes[part].parent = uint32_t(here);
        nodes[part].cuts = i > 0 && (e.op == CsgOp::difference || e.op == CsgOp::clip);
    }
    nodes[here].end = uint32_t(nodes.size());
}

class Finder {
  public:
    explicit Finder(CompiledScene& scene) : scene_(scene) {}

    /// `inverted`: with all around it. `asked`: something around it says cutaway_textures.
    void look(const CsgExpression& e, bool inverted, bool asked) {
        const bool here = cuts(e, inverted), outermost = here && !outermost_;
        if (outermost) outermost_ = &e;
        asked = asked || e.cutaway_textures;
        for (size_t i = 0; i < e.parts.size(); ++i) {
            const CsgExpression& part = e.parts[i];
            if (!is_instance(part)) look(part, (inverted != part.inverse) != (e.op == CsgOp::difference && i > 0), asked);
            else if (here && asked && scene_.instances[part.leaf.id].usual_material) leaves_.push_back(part.leaf.id);
        }
        if (outermost) finish(inverted);
    }

  private:
    void finish(bool inverted) {
        if (!leaves_.empty() && has_material(scene_, *outermost_)) {
            for (const uint32_t leaf : leaves_) scene_.instances[leaf].cutaway = uint32_t(scene_.cutaways.size());
            scene_.cutaways.emplace_back();
            flatten(*outermost_, inverted, scene_.cutaways.back());
        }
        leaves_.clear();
        outermost_ = nullptr;
    }

    CompiledScene& scene_;
    const CsgExpression* outermost_ = nullptr;
    std::vector<uint32_t> leaves_;
};

/// Which nodes hold the point, each from what is in it, so that no depth needs a call stack.
class Holding {
  public:
    Holding(const CompiledScene& scene, const std::vector<CutawayNode>& nodes, const ShadePoint& point) : scene_(scene), nodes_(nodes), point_(point), leaves_(scene, unused_), holds_(nodes.size()) {
        for (size_t i = nodes.size(); i-- > 0; ) holds_[i] = nodes[i].op == CsgOp::leaf ? leaf_holds(i) : operation_holds(i);
    }
    bool operator[](size_t node) const { return holds_[node]; }

  private:
    bool leaf_holds(size_t node) const {
        const CutawayNode& leaf = nodes_[node];
        if (leaf.instance == kNoId) return false;
        if (leaf.instance == point_.instance) return nodes_[leaf.parent].inverted == carves(node);
        return leaves_.inside(leaf.instance, point_.position) != (leaf.inverse && csg_leaf(scene_, leaf.instance).inside != CsgInside::nowhere);
    }

    /// All that is around the part that was hit holds its surface, so what differences take away does not: of two that cut, one within the other, the inner gives.
    bool carves(size_t node) const {
        bool carves = false;
        for (; node != 0; node = nodes_[node].parent) carves = carves != (nodes_[node].cuts && nodes_[nodes_[node].parent].op == CsgOp::difference);
        return carves;
    }

    bool operation_holds(size_t node) const {
        const CutawayNode& operation = nodes_[node];
        const size_t first = node + 1;
        bool any = false, all = true, of_first = false, any_other = false, all_others = true;
        for (size_t part = first; part < operation.end; part = nodes_[part].end) {
            any = any || holds_[part], all = all && holds_[part];
            if (part == first) of_first = holds_[part];
            else any_other = any_other || holds_[part], all_others = all_others && holds_[part];
        }
        switch (operation.op) {
            case CsgOp::union_:
            case CsgOp::merge: return any != operation.inverse;
            case CsgOp::intersection: return all != operation.inverse;
            case CsgOp::difference: return (of_first && !any_other) != operation.inverse;
            case CsgOp::clip: return of_first != operation.inverse && all_others;
            case CsgOp::leaf: break;
        }
        return false;
    }

    const CompiledScene& scene_;
    const std::vector<CutawayNode>& nodes_;
    const ShadePoint& point_;
    WorkCounters unused_;
    InstanceLeaves leaves_;
    std::vector<bool> holds_;
};

}  // namespace

void find_cutaways(CompiledScene& scene, const CsgExpression& solid) { Finder(scene).look(solid, solid.inverse, false); }

std::vector<uint32_t> slots_laid_open(const CompiledScene& scene, const ShadePoint& point) {
    const std::vector<CutawayNode>& nodes = scene.cutaways[scene.instances[point.instance].cutaway];
    const Holding holding(scene, nodes, point);
    std::vector<uint32_t> slots;
    for (size_t i = 1; i < nodes.size(); ) {
        const CutawayNode& node = nodes[i];
        const bool open = !node.cuts && holding[i] != nodes[node.parent].inverted;
        if (open && node.instance != kNoId && scene.instances[node.instance].cutaway == kNoId) slots.push_back(scene.instances[node.instance].first_slot);
        i = open ? i + 1 : node.end;
    }
    return slots;
}

}  // namespace alidade
