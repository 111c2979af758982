// SPDX-License-Identifier: Apache-2.0
/// Which triangles meet at which edge, for any set of triangles: three at an edge, or two wound against each other, are no obstacle.
#pragma once

#include "topology/weld.h"

namespace alidade::topology {

/// A side of a triangle, from `corner` to the next; `from` < `to` or the other way round, as the triangle is wound.
struct Side {
    uint32_t corner, from, to;
};

/// The edges of the sound triangles, each with the sides that lie on it. Linear in the number of triangles, but for vertices where very many meet.
class Edges {
  public:
    explicit Edges(const Welded& surface);

    size_t count() const { return first_.size() - 1; }
    /// The sides on an edge, in the order of their corners.
    std::span<const Side> sides(size_t edge) const { return {sides_.data() + first_[edge], first_[edge + 1] - first_[edge]}; }

  private:
    std::vector<Side> sides_;       // grouped by edge
    std::vector<uint32_t> first_;   // of each edge, and one past the last
};

/// Disjoint sets of numbers.
/// Source   Tarjan and van Leeuwen, "Worst-Case Analysis of Set Union Algorithms", JACM 31(2), 1984 (linking to the lower number, halving of paths).
class Sets {
  public:
    explicit Sets(size_t count);
    uint32_t find(uint32_t i);
    void unite(uint32_t a, uint32_t b);

  private:
    std::vector<uint32_t> parent_;
};

/// Joins the corners around each vertex that hang together through edges for which `joins(side, other side)` holds; asked only of edges with exactly
/// two sides. What hangs together at a vertex is a fan.
template <class Joins> Sets fans(const Welded& surface, const Edges& edges, Joins joins) {
    Sets sets(3 * surface.triangles.size());
    for (size_t e = 0; e < edges.count(); ++e) {
        const auto sides = edges.sides(e);
        if (sides.size() != 2 || !joins(sides[0], sides[1])) continue;
        const bool opposite = sides[0].from == sides[1].to;
        const uint32_t a = sides[1].corner, b = next_corner(a);
        sets.unite(sides[0].corner, opposite ? b : a);
        sets.unite(next_corner(sides[0].corner), opposite ? a : b);
    }
    return sets;
}

}  // namespace alidade::topology
