// SPDX-License-Identifier: Apache-2.0
/// The outlines of an extrusion in their plane.
#pragma once

#include "scene/shape.h"

#include <memory_resource>

namespace alidade {

/// A quadratic Bezier curve from a to b.
struct BezierArc {
    Vec2 a, control, b;

    Vec2 at(double tau) const;
    Vec2 tangent(double tau) const;
    /// The point of the curve nearest to p.
    double nearest(const Vec2& p) const;
};

/// The arc `index`, counted through all outlines; its points minus `origin`.
BezierArc arc_of(const Extrusion& e, size_t index, const Vec2& origin);

/// Where a line p + s d of the plane meets an arc.
struct Cut {
    double s;
    uint32_t arc;
    int turn;           ///< +1 if the arc goes from the right of the line to its left
};

/// All of them, in order of s. Each end of an arc is on the left or the right of the line, and neighbouring arcs agree on which: so no line slips between
/// two arcs, and turns add up to 0.
std::pmr::vector<Cut> cuts_of(const Extrusion& e, const Vec2& origin, const Vec2& p, const Vec2& d, std::pmr::memory_resource& memory);

/// Is a place inside that is wound around `winding` times, by `cuts` passings?
inline bool is_inside(const Extrusion& e, int winding, int cuts) { return e.even_odd ? cuts % 2 != 0 : winding != 0; }

bool outlines_hold(const Extrusion& e, const Vec2& point);

}  // namespace alidade
