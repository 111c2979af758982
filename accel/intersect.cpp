// SPDX-License-Identifier: Apache-2.0
#include "accel/intersect.h"

#include <fmt/format.h>

namespace alidade {

static constexpr IntersectEntry kTable[] = {
    {"exact", "the decisions of exact arithmetic, t as good as double; all accelerators give the same hits", Intersect::exact, {0, 0, 0, 1}},
    {"robust", "watertight, t in double: nothing leaks; near an edge the neighbour may be hit, all decisions are rounded", Intersect::robust, {0, 0, 63218, 0.93}},
    {"fast", "Moeller and Trumbore's test in the precision of the mesh, boxes without pads: rays slip through edges and vertices, t is rounded, what is tiny, huge or far from the origin is lost", Intersect::fast, {79577, 184194, 199852, 0.85}},
};

std::string IntersectEntry::text() const {
    return fmt::format("{} (measured: of a million rays aimed at edges {} leak, at vertices {}; of a million hard decisions {} are wrong; rays take {} of the time of exact)", doc, measured.edges, measured.vertices,
                       measured.decisions, measured.time);
}

std::span<const IntersectEntry> intersects() { return kTable; }

}  // namespace alidade
