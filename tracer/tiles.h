// SPDX-License-Identifier: Apache-2.0
/// The tiles that a picture is rendered in.
#pragma once

#include "tracer/options.h"

#include <tl/expected.hpp>

namespace alidade {

/// Squares that begin at the picture's upper left corner, whatever part of it is rendered: parts meet as if they had been rendered in one.
struct TileGrid {
    Region region;                 ///< what is rendered
    int width = 0, height = 0;     ///< of the picture
    int size = 1;                  ///< of a square
    int first_column = 0, first_row = 0, columns = 0, rows = 0;   ///< the squares that hold a part of the region

    size_t count() const { return size_t(columns) * size_t(rows); }
    /// A square, as far as it lies in the picture.
    Region square(size_t i) const;
    /// What is rendered of it.
    Region tile(size_t i) const;
};

/// The tiles of a render with `options`, or the error that render() would give for them.
tl::expected<TileGrid, std::string> tile_grid(const RenderOptions& options);

}  // namespace alidade
