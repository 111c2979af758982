// SPDX-License-Identifier: Apache-2.0
/// Polygons to triangles.
#pragma once

#include "core/vec.h"

#include <span>
#include <vector>

namespace alidade::mesh {

/// The area vector of a closed polygon: its length is the area, its direction the normal (counter-clockwise seen from its tip).
/// Source   Newell's formula; Sutherland, Sproull and Schumacker, "A Characterization of Ten Hidden-Surface Algorithms", ACM Computing Surveys 6(1), 1974.
Vec3 area_vector(std::span<const Vec3> polygon);

/// Cuts polygons in the coordinate plane where they appear largest. What a fan from the first corner covers exactly is a fan; everything else
/// is cut by ear clipping, which is right for every simple polygon, convex or not, with holes joined by bridges too.
/// Source   Meisters, "Polygons Have Ears", American Mathematical Monthly 82(6), 1975; ElGindy, Everett and Toussaint, "Slicing an Ear Using Prune-and-Search", 1993.
class Triangulator {
  public:
    /// Appends the corner numbers of polygon.size() - 2 triangles, wound as the polygon is. False if the polygon is not simple (it crosses itself,
    /// or has no area) or would take too long: its triangles may then overlap.
    bool triangulate(std::span<const Vec3> polygon, std::vector<Index3>& triangles);

  private:
    void project(std::span<const Vec3> polygon);
    bool fan(std::vector<Index3>& triangles) const;
    bool clip_ears(std::vector<Index3>& triangles);
    bool is_ear(uint32_t corner);
    double turn(uint32_t a, uint32_t b, uint32_t c) const;
    void unlink(uint32_t corner);

    std::vector<Vec2> points_;
    std::vector<uint32_t> next_, previous_;
    std::vector<uint8_t> ear_;
    /// Corners that may still be tested against ears, over all polygons: the algorithm takes quadratic time, and a file must not hang us. Some
    /// seconds' worth; an honest polygon of 5000 corners takes a tenth of it.
    uint64_t tests_left_ = uint64_t(1) << 28;
};

}  // namespace alidade::mesh
