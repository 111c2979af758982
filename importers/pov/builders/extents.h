// SPDX-License-Identifier: Apache-2.0
/// The box that POV-Ray keeps of an object, which min_extent() and max_extent() give: not the smallest one, but that which its way of transforming boxes leads to.
#pragma once

#include "importers/pov/builders/build.h"

namespace alidade::pov {

/// Half the size of what is unbounded.
inline constexpr double kUnboundedExtent = 1e10;

/// The boxes of objects. Each block is read once, however many others refer to it.
///
/// Method   A sphere stays one while it is moved, turned and scaled evenly; triangles and polygons have their points moved; of other shapes the box in their own space is moved by all their
///          transformations at once; of sets, meshes, text and quadrics the box is moved by each of them, and grows. The box of what clips or bounds an object stands for its own where its volume is
///          smaller. Of an intersection it is the common part of the boxes of its parts that are not turned inside out, cut by planes along the axes, and by the reach of quadrics in it.
/// Source   experiments with POV-Ray 3.7
/// Error    single precision, as there (held by pov_queries_test)
class Extents {
  public:
    /// `build` must outlive this, and the blocks that are asked must too, with all that they refer to.
    explicit Extents(Build& build);
    ~Extents();
    /// Of an object's block. Empty if nothing of it is modelled.
    Bounds of(const Block& block);

  private:
    class Reader;
    std::unique_ptr<Reader> reader_;
};

}  // namespace alidade::pov
