// SPDX-License-Identifier: Apache-2.0
#include "eval/csg.h"

#include "eval/mesh_inside.h"
#include "eval/shapes/rows.h"

#include <algorithm>
#include <utility>

namespace alidade {

namespace {

/// Crossings this many error bounds apart are still one place: files give numbers that are rounded themselves, and so are products of transforms.
constexpr double kSameWithin = 32;
/// At grazing incidence the error along the line grows beyond all bounds; not here.
constexpr double kLeastCosine = 1e-4;

/// What a range is widened by, in parts of its distance: far more than any rounding, so that what is left out is surely not in it.
constexpr double kOrderSlack = 1e-9;
/// Crossings farther from each other than this, in parts of their distance, are not asked for their errors.
constexpr double kNear = 1e-6;

/// A node on the line, as far as it has been walked; `before` is in front of the crossings that are looked at.
struct State {
    uint32_t count = 0, count_before = 0;      ///< children that are inside
    uint32_t place = 0;                        ///< the number of the place whose `before` is kept here
    uint32_t first_in = 0, first_out = 0;      ///< the first child that the line enters or leaves at this place
    uint32_t skin_place = 0;                   ///< the number of the last place that is on the surface of a leaf that does not hold it: this one, or one below
    bool inside = false, inside_before = false;
    bool unseen = false;                       ///< of a leaf: its surface is not there for this ray
};

struct Scratch {
    std::vector<CsgCrossing> crossings;
    std::vector<State> states;
    std::vector<uint32_t> at_points, changed;
};

/// Each thread walks one line at a time.
Scratch& scratch() {
    thread_local Scratch one;
    return one;
}

bool meets(const CsgNode& node) { return node.op == CsgOp::intersection || node.op == CsgOp::clip; }

class Walk {
  public:
    Walk(std::span<const CsgNode> nodes, std::span<const CsgSide> known, const Ray& ray, const CsgLeaves& leaves) : nodes_(nodes), known_(known), ray_(ray), leaves_(leaves), s_(scratch()), reach_(max_abs(ray.origin) / max_abs(ray.dir)), over_dir_(1.0 / ray.dir) {
        s_.crossings.clear(), s_.at_points.clear();
        if (s_.states.size() < nodes.size()) s_.states.resize(nodes.size());
    }

    /// Calls visit(hit) for the surfaces of the whole, in order of t; `one_place`: for the one that is seen of those of the first place that has any.
    template <class Visit> void run(const Bounds& bounds, bool one_place, const Visit& visit) {
        if (bounds.empty()) return;
        const LineInterval box = inside_bounds(ray_, bounds);   // as accelerators compute it, and as they expect of hits
        const auto show = [&](Hit hit) {
            hit.t = std::clamp(hit.t, box.entry, box.exit);
            visit(hit);
        };
        range_ = {std::max(ray_.tmin, box.entry), std::min(ray_.tmax, box.exit)};
        if (box.empty() || range_.empty()) return;
        range_ = widened(range_);
        if (!gather(0, {range_, range_})) return;
        auto& all = s_.crossings;
        std::sort(all.begin(), all.end(), [](const CsgCrossing& a, const CsgCrossing& b) { return a.hit.t != b.hit.t ? a.hit.t < b.hit.t : a.node < b.node; });
        for (size_t first = 0, end; first < all.size() && all[first].hit.t <= range_.exit; first = end) {
            for (end = first + 1; end < all.size() && coincide(all[end - 1], all[end]); ) ++end;
            const std::span<const CsgCrossing> place(all.data() + first, end - first);
            if (place.size() == 1 && s_.at_points.empty() && nodes_[place[0].node].inside == CsgInside::by_crossings) {
                if (step_alone(place[0].node) && in_range(place[0].hit.t)) {
                    show(place[0].hit);
                    if (one_place) return;
                }
                continue;
            }
            step(place);
            const CsgCrossing* seen = nullptr;
            for (const CsgCrossing& c : place) {
                if (!in_range(c.hit.t) || !shown(c, one_place)) continue;
                if (!one_place) show(c.hit);
                else if (!seen || nodes_[c.node].rank > nodes_[seen->node].rank) seen = &c;
            }
            if (seen) return show(seen->hit);
        }
    }

  private:
    /// The part of `range` in a box, widened. What is not a number, where a line lies in a plane of the box, shortens nothing.
    LineInterval within(const Bounds& box, LineInterval range) const {
        if (box.empty()) return {kInf, -kInf};
        for (int axis = 0; axis < 3; ++axis) {
            const double a = (box.min[axis] - ray_.origin[axis]) * over_dir_[axis], b = (box.max[axis] - ray_.origin[axis]) * over_dir_[axis];
            const double entry = b < a ? b : a, exit = b < a ? a : b;
            if (entry > range.entry) range.entry = entry;
            if (exit < range.exit) range.exit = exit;
        }
        return widened(range);
    }
    bool in_range(double t) const { return t >= ray_.tmin && t <= ray_.tmax && t >= range_.entry && t <= range_.exit; }
    double near(double t) const { return kNear * (std::abs(t) + reach_); }
    double slack(double t) const { return kOrderSlack * (std::abs(t) + reach_); }
    LineInterval widened(const LineInterval& r) const { return {r.entry - slack(r.entry), r.exit + slack(r.exit)}; }

    /// Two ranges of the line. Outside of `crossings`, crossings that were found tell that the line is outside of some part of an intersection: what the
    /// others are there does not matter. Outside of `boxes`, which is shorter, boxes tell it.
    struct Ranges {
        LineInterval crossings, boxes;
    };

    /// Asks the leaves that can matter within the ranges for their crossings; false if the node is all inside or all outside there and has no surface.
    bool gather(uint32_t n, const Ranges& ranges) {
        const CsgNode& node = nodes_[n];
        State& state = s_.states[n] = {};
        if (!(node.mask & ray_.mask)) return state.inside = n != 0 && meets(nodes_[node.parent]), false;
        if (!known_.empty() && known_[n] != CsgSide::varies) return state.inside = known_[n] == CsgSide::inside, false;
        const LineInterval boxes = within(node.box, ranges.boxes);
        if (boxes.empty()) return state.inside = node.far, false;
        return node.op == CsgOp::leaf ? gather_leaf(n, ranges.crossings) : gather_parts(n, {ranges.crossings, boxes});
    }

    bool gather_leaf(uint32_t n, const LineInterval& range) {
        const CsgNode& node = nodes_[n];
        const size_t had = s_.crossings.size();
        Ray asked = ray_;   // a thousand times as far as what can count as one place
        asked.tmin = range.entry - 1000 * near(range.entry), asked.tmax = range.exit + 1000 * near(range.exit);
        const bool comes_from_inside = leaves_.crossings(node.leaf, asked, s_.crossings);
        for (size_t i = had; i < s_.crossings.size(); ++i) s_.crossings[i].node = n;
        s_.states[n].inside = node.inverted != (node.inside == CsgInside::by_crossings && comes_from_inside);
        if (node.inside == CsgInside::at_points) s_.at_points.push_back(n);
        if (node.inside == CsgInside::by_crossings && settle(n, had, range)) return false;
        if (node.bounded && s_.crossings.size() > had) see(n);
        return node.inside == CsgInside::at_points || s_.crossings.size() > had;
    }

    /// Other trees may be walked along meanwhile: of what bounds the leaf.
    [[gnu::noinline]] void see(uint32_t n) {
        Scratch own = std::exchange(s_, Scratch());
        const bool seen = leaves_.sees(nodes_[n].leaf, ray_);
        s_ = std::move(own);
        s_.states[n].unseen = !seen;
    }

    /// If none of the crossings from `had` on is in or near `range`, the leaf is all inside or all outside there, and they are dropped.
    bool settle(uint32_t n, size_t had, const LineInterval& range) {
        auto& all = s_.crossings;
        const double entry = range.entry - near(range.entry), exit = range.exit + near(range.exit);
        bool inside = s_.states[n].inside;
        for (size_t i = had; i < all.size() && all[i].hit.t <= exit; ++i) {
            if (all[i].hit.t >= entry) return false;
            inside = !inside;
        }
        all.resize(had);
        s_.states[n].inside = inside;
        return true;
    }

    /// The part of `range` from where the line enters the leaf first to where it leaves it last; empty if it does not. The crossings are those from `had` on.
    LineInterval inside_leaf(uint32_t n, size_t had, const LineInterval& range) const {
        LineInterval out{kInf, -kInf};
        bool inside = s_.states[n].inside;
        double from = range.entry;
        for (size_t i = had; i <= s_.crossings.size(); ++i) {
            const double to = i < s_.crossings.size() ? std::clamp(s_.crossings[i].hit.t, range.entry, range.exit) : range.exit;
            if (inside) out.entry = std::min(out.entry, from), out.exit = to;
            inside = !inside, from = to;
        }
        return out;
    }

    /// Does an operation above the node depend on what is inside of it?
    bool is_asked(uint32_t n) const {
        while (n != 0) {
            n = nodes_[n].parent;
            if (nodes_[n].op != CsgOp::union_) return true;
        }
        return false;
    }

    bool gather_parts(uint32_t n, Ranges ranges) {
        const CsgNode& node = nodes_[n];
        const size_t had = s_.crossings.size(), points = s_.at_points.size();
        const bool is_meet = meets(node);
        bool varies = false;
        uint32_t count = 0;
        for (uint32_t part = n + 1; part != node.end; part = nodes_[part].end) {
            const size_t first = s_.crossings.size();
            const bool part_varies = gather(part, ranges), inside = s_.states[part].inside;
            varies = varies || part_varies;
            count += inside;
            if (part_varies && is_meet && nodes_[part].op == CsgOp::leaf && nodes_[part].inside == CsgInside::by_crossings) {
                ranges.crossings = inside_leaf(part, first, ranges.crossings);
                ranges.boxes = {std::max(ranges.boxes.entry, ranges.crossings.entry), std::min(ranges.boxes.exit, ranges.crossings.exit)};
            }
            // What is clipped shows no surface: whether the line is inside of all of it, nobody asks.
            const bool hidden = node.op == CsgOp::clip && nodes_[part].place == 0 && !part_varies && !is_asked(n);
            // One part that is outside all along empties an intersection, and so do parts that the line is in one after the other; one that is inside fills a merge.
            const bool apart = is_meet && ranges.boxes.empty();
            if (!apart && !hidden && (part_varies || inside == is_meet || node.op == CsgOp::union_)) continue;
            s_.crossings.resize(had), s_.at_points.resize(points);
            return s_.states[n].inside = !is_meet, false;
        }
        s_.states[n].count = count;
        s_.states[n].inside = is_meet ? count == node.children : count > 0;
        return varies;
    }

    bool coincide(const CsgCrossing& a, const CsgCrossing& b) const {
        const double gap = b.hit.t - a.hit.t;
        if (gap == 0) return true;
        if (gap > near(b.hit.t)) return false;
        const auto along = [&](const CsgCrossing& c) {
            const CsgLeaves::Sharpness s = leaves_.sharpness(ray_, c.hit);
            return s.error / std::max(s.cosine, kLeastCosine);
        };
        return gap * length(ray_.dir) <= kSameWithin * (along(a) + along(b));
    }

    /// Walks over the crossings of one place.
    void step(std::span<const CsgCrossing> place) {
        for (const uint32_t n : s_.at_points) set(n, nodes_[n].inverted != leaves_.inside(nodes_[n].leaf, ray_.at(place.front().hit.t)));
        ++place_;
        s_.changed.clear();
        for (const CsgCrossing& c : place)
            if (nodes_[c.node].inside == CsgInside::by_crossings) set(c.node, !s_.states[c.node].inside);
        for (const CsgCrossing& c : place)
            if (place.size() > 1 && nodes_[c.node].without_surface) mark_skin(c.node);
        for (const uint32_t n : s_.changed) s_.states[n].first_in = s_.states[n].first_out = kNoId;
        for (const uint32_t n : s_.changed) {
            const State& state = s_.states[n];
            if (n == 0 || state.inside == state.inside_before) continue;
            State& parent = s_.states[nodes_[n].parent];
            uint32_t& first = state.inside ? parent.first_in : parent.first_out;
            first = std::min(first, nodes_[n].place);
        }
    }

    void mark_skin(uint32_t n) {
        for (; s_.states[n].skin_place != place_; n = nodes_[n].parent) s_.states[n].skin_place = place_;
    }

    /// Is the place, or what is just before it, inside of node `n`, if leaves without their surface hold none of it?
    bool holds(uint32_t n, bool before) const {
        const CsgNode& node = nodes_[n];
        const State& state = s_.states[n];
        if (state.skin_place != place_) return before && state.place == place_ ? state.inside_before : state.inside;
        if (node.op == CsgOp::leaf) return node.inverted;
        const uint32_t count = count_holding(n, before);
        return meets(node) ? count == node.children : count > 0;
    }
    uint32_t count_holding(uint32_t n, bool before) const {
        uint32_t count = 0;
        for (uint32_t part = n + 1; part != nodes_[n].end; part = nodes_[part].end) count += holds(part, before);
        return count;
    }

    /// The same for a crossing of leaf `n` that stands alone, and whether it is shown: only what is above it changes, and siblings are the same on both sides.
    bool step_alone(uint32_t n) {
        bool is_shown = !s_.states[n].unseen, changes = true;
        s_.states[n].inside = !s_.states[n].inside;
        for (; n != 0 && (changes || is_shown); n = nodes_[n].parent) {
            const CsgNode& above = nodes_[nodes_[n].parent];
            State& all = s_.states[nodes_[n].parent];
            const bool inside = s_.states[n].inside;
            if (changes) all.count = inside ? all.count + 1 : all.count - 1;
            const uint32_t siblings = all.count - inside;
            if (above.op == CsgOp::clip && nodes_[n].place > 0) is_shown = false;
            else if (above.op != CsgOp::union_) is_shown = is_shown && siblings == (meets(above) ? above.children - 1 : 0);
            const bool was = all.inside;
            all.inside = meets(above) ? all.count == above.children : all.count > 0;
            changes = changes && all.inside != was;
        }
        return is_shown;
    }

    void keep_before(uint32_t n) {
        State& state = s_.states[n];
        if (state.place == place_) return;
        state.place = place_, state.count_before = state.count, state.inside_before = state.inside;
        s_.changed.push_back(n);
    }

    /// What changes in a node changes the count of the one above, and by that perhaps the one above it.
    void set(uint32_t n, bool inside) {
        while (s_.states[n].inside != inside) {
            keep_before(n);
            s_.states[n].inside = inside;
            if (n == 0) return;
            const uint32_t parent = nodes_[n].parent;
            keep_before(parent);
            uint32_t& count = s_.states[parent].count;
            count = inside ? count + 1 : count - 1;
            inside = meets(nodes_[parent]) ? count == nodes_[parent].children : count > 0;
            n = parent;
        }
    }

    /// `with_equals`: also where it coincides with one that is shown for it.
    bool shown(const CsgCrossing& c, bool with_equals) const {
        if (s_.states[c.node].unseen) return false;
        for (uint32_t n = c.node; n != 0; n = nodes_[n].parent)
            if (!survives(n, with_equals)) return false;
        return true;
    }

    /// Does a surface of the node survive the operation above it?
    bool survives(uint32_t n, bool with_equals) const {
        const CsgNode &node = nodes_[n], &above = nodes_[node.parent];
        if (above.op == CsgOp::union_) return true;
        if (above.op == CsgOp::clip && node.place > 0) return false;
        const State &own = s_.states[n], &all = s_.states[node.parent];
        const bool after = own.inside, before = own.place == place_ ? own.inside_before : after;
        const bool skin = all.skin_place == place_;
        const uint32_t others_after = skin ? count_holding(node.parent, false) - holds(n, false) : all.count - after;
        const uint32_t others_before = skin ? count_holding(node.parent, true) - holds(n, true) : (all.place == place_ ? all.count_before : all.count) - before;
        // The side that counts is that on which the part is inside of an intersection, or outside of a merge; both, if it is the same on both.
        const bool merge = above.op == CsgOp::merge;
        const uint32_t wanted = merge ? 0 : above.children - 1;
        if (before == after) return others_before == wanted && others_after == wanted;
        const bool counts_before = before != merge;
        return (counts_before ? others_before : others_after) == wanted && (with_equals || skin || (after ? all.first_in : all.first_out) == node.place);
    }

    std::span<const CsgNode> nodes_;
    std::span<const CsgSide> known_;   // nothing: no side is known
    const Ray& ray_;
    const CsgLeaves& leaves_;
    Scratch& s_;
    double reach_;         ///< the size of the ray's origin, in t
    Vec3 over_dir_;
    LineInterval range_;
    uint32_t place_ = 0;   ///< counts the places on the line, from 1
};

bool node_inside(std::span<const CsgNode> nodes, uint32_t n, const Vec3& point, const CsgLeaves& leaves) {
    const CsgNode& node = nodes[n];
    if (!node.box.contains(point)) return node.far;
    if (node.op == CsgOp::leaf) return node.inverted != (node.leaf != kNoId && leaves.inside(node.leaf, point));
    const bool is_meet = meets(node);
    for (uint32_t part = n + 1; part != node.end; part = nodes[part].end)
        if (node_inside(nodes, part, point, leaves) != is_meet) return !is_meet;
    return is_meet;
}

}  // namespace

bool CsgTree::inside(const Vec3& point, const CsgLeaves& leaves) const { return node_inside(nodes_, 0, point, leaves); }

bool CsgTree::first(const Ray& ray, const CsgLeaves& leaves, Hit& hit, std::span<const CsgSide> known) const {
    bool found = false;
    Walk(nodes_, known, ray, leaves).run(bounds_, true, [&](const Hit& h) { hit = h, found = true; });
    return found;
}

void CsgTree::all(const Ray& ray, const CsgLeaves& leaves, std::vector<Hit>& hits) const {
    Walk(nodes_, {}, ray, leaves).run(bounds_, false, [&](const Hit& h) { hits.push_back(h); });
}

CsgInside csg_inside(const ShapeOps* ops, const ShapeGeometry& shape) {
    if (const auto* mesh = std::get_if<Mesh>(&shape)) return mesh->inside_vector ? CsgInside::at_points : CsgInside::nowhere;
    if (!ops || ops->sheet) return CsgInside::nowhere;
    return ops->solid(shape) ? CsgInside::by_crossings : CsgInside::at_points;
}

bool csg_endless(const ShapeGeometry& shape) {
    const auto* mesh = std::get_if<Mesh>(&shape);
    return std::holds_alternative<Disc>(shape) || (mesh && mesh->inside_vector && !keeps_inside_in_box(*mesh));
}

bool csg_without_surface(const ShapeGeometry& shape) {
    const auto* cylinder = std::get_if<Cylinder>(&shape);
    const auto* cone = std::get_if<Cone>(&shape);
    return (cylinder && !cylinder->open) || (cone && !cone->open);
}

uint8_t csg_cost(const ShapeOps& ops) { return ops.costly ? 2 : ops.kind == kind_of<Plane>() ? 0 : 1; }

bool begins_inside(const ShapeOps& ops, const ShapeGeometry& shape, const Ray& ray, const Crossings& crossings) {
    if (crossings.count == 0) return ops.inside(shape, ray.origin);
    const double first = crossings.at[0].t;
    return ops.inside(shape, ray.at(first - (1 + std::abs(first))));
}

}  // namespace alidade
