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
            scene_.cutaways.push_back(*outermost_);
            scene_.cutaways.back().inverse = inverted;
        }
        leaves_.clear();
        outermost_ = nullptr;
    }

    CompiledScene& scene_;
    const CsgExpression* outermost_ = nullptr;
    std::vector<uint32_t> leaves_;
};

class LaidOpen {
  public:
    LaidOpen(const CompiledScene& scene, const ShadePoint& point) : scene_(scene), point_(point), leaves_(scene, unused_) {}

    void collect(const CsgExpression& e, bool inverted) {
        const size_t count = e.op == CsgOp::difference || e.op == CsgOp::clip ? std::min<size_t>(e.parts.size(), 1) : e.parts.size();
        for (size_t i = 0; i < count; ++i) {
            const CsgExpression& part = e.parts[i];
            if (holds(part) == inverted) continue;
            if (!is_instance(part)) collect(part, inverted != part.inverse);
            else if (const Instance& instance = scene_.instances[part.leaf.id]; instance.cutaway == kNoId) slots.push_back(instance.first_slot);
        }
    }

    std::vector<uint32_t> slots;

  private:
    bool holds(const CsgExpression& e) const {
        const auto part_holds = [&](const CsgExpression& part) { return holds(part); };
        switch (e.op) {
            // What was hit holds its surface.
            case CsgOp::leaf: return e.leaf.id != kNoId && (e.leaf.id == point_.instance || leaves_.inside(e.leaf.id, point_.position)) != (e.inverse && csg_leaf(scene_, e.leaf.id).inside != CsgInside::nowhere);
            case CsgOp::union_:
            case CsgOp::merge: return std::any_of(e.parts.begin(), e.parts.end(), part_holds) != e.inverse;
            case CsgOp::intersection: return std::all_of(e.parts.begin(), e.parts.end(), part_holds) != e.inverse;
            case CsgOp::difference: return (!e.parts.empty() && holds(e.parts[0]) && std::none_of(e.parts.begin() + 1, e.parts.end(), part_holds)) != e.inverse;
            case CsgOp::clip: return holds(e.parts[0]) != e.inverse && std::all_of(e.parts.begin() + 1, e.parts.end(), part_holds);
        }
        return false;
    }

    const CompiledScene& scene_;
    const ShadePoint& point_;
    WorkCounters unused_;
    InstanceLeaves leaves_;
};

}  // namespace

void find_cutaways(CompiledScene& scene, std::span<const CsgExpression> solids) {
    for (const CsgExpression& solid : solids) Finder(scene).look(solid, solid.inverse, false);
}

std::vector<uint32_t> slots_laid_open(const CompiledScene& scene, const ShadePoint& point) {
    LaidOpen open(scene, point);
    const CsgExpression& all = scene.cutaways[scene.instances[point.instance].cutaway];
    open.collect(all, all.inverse);
    return std::move(open.slots);
}

}  // namespace alidade
