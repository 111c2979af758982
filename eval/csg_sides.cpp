// SPDX-License-Identifier: Apache-2.0
/// What a part of space leaves open of a tree.
#include "eval/csg.h"

namespace alidade {

namespace {

/// After so many nodes the search is given up: others vary, for all that is known. In large trees most are passed by their boxes; where they are not, it would take longer than the rays.
constexpr int kMostNodes = 256;

class Sides {
  public:
    Sides(std::span<const CsgNode> nodes, const CsgRegion& region, CsgSide* out) : nodes_(nodes), region_(region), out_(out) {}

    CsgSide find(uint32_t n) {
        const CsgNode& node = nodes_[n];
        if (++asked_ > kMostNodes) return out_[n] = CsgSide::varies;
        if (!region_.meets(node.box)) return out_[n] = node.far ? CsgSide::inside : CsgSide::outside;
        return out_[n] = node.op == CsgOp::leaf ? of_leaf(node) : of_parts(n);
    }

  private:
    CsgSide of_leaf(const CsgNode& node) const {
        const CsgSide side = node.inside == CsgInside::by_crossings ? region_.side(node.leaf) : CsgSide::varies;
        if (!node.inverted || side == CsgSide::varies) return side;
        return side == CsgSide::inside ? CsgSide::outside : CsgSide::inside;
    }

    /// Of parts that not the same rays see nothing follows: to some rays they are not there.
    CsgSide of_parts(uint32_t n) {
        const CsgNode& node = nodes_[n];
        const bool meets = node.op == CsgOp::intersection || node.op == CsgOp::clip;
        const CsgSide deciding = meets ? CsgSide::outside : CsgSide::inside, usual = meets ? CsgSide::inside : CsgSide::outside;
        bool varies = false, decided = false;
        for (uint32_t part = n + 1; part != node.end; part = nodes_[part].end) {
            const CsgSide side = find(part);
            varies = varies || side == CsgSide::varies || nodes_[part].mask != node.mask;
            decided = decided || (side == deciding && nodes_[part].mask == node.mask);
            if (decided && node.op != CsgOp::union_) return deciding;   // a union shows the surfaces of all parts
        }
        return varies ? CsgSide::varies : decided ? deciding : usual;
    }

    std::span<const CsgNode> nodes_;
    const CsgRegion& region_;
    CsgSide* out_;
    int asked_ = 0;
};

}  // namespace

CsgSide CsgTree::sides(const CsgRegion& region, std::vector<CsgSide>& out) const {
    const size_t first = out.size();
    out.resize(first + nodes_.size());   // below a node whose side is known, nobody asks
    return Sides(nodes_, region, out.data() + first).find(0);
}

}  // namespace alidade
