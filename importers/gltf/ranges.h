// SPDX-License-Identifier: Apache-2.0
/// Do buffer views lie in their buffers, and accessors in their views? What passes can be read without a further check.
#pragma once

#include "importers/gltf/buffers.h"

namespace alidade::gltf {

/// Where the elements of an accessor lie, and what they look like (glTF 2.0 specification, sections 3.6.2.2 to 3.6.2.4).
struct ElementLayout {
    uint32_t component_bytes = 0;
    uint32_t columns = 1, rows = 1;   ///< a vector is one column
    uint32_t column_bytes = 0;        ///< of matrices: padded to 4 bytes
    uint32_t components() const { return columns * rows; }
    /// From one packed element to the next: columns of matrices stay aligned.
    uint32_t stride() const { return column_bytes * columns; }
    uint32_t bytes() const { return column_bytes * (columns - 1) + component_bytes * rows; }
    /// Byte offset of component `c`, counted column by column.
    uint32_t offset(uint32_t c) const { return c / rows * column_bytes + c % rows * component_bytes; }
};

/// `component_type` as glTF numbers it (5120 ... 5126); `columns` and `rows` from its type.
ElementLayout element_layout(int component_type, uint32_t columns, uint32_t rows);

/// The layout of the elements of an accessor that has passed check_schema().
ElementLayout layout_of(const Json& accessor);

/// Checks the accessors of `root`, which has passed check_schema(), against their buffer views, and these against the lengths of buffers as the file
/// states them: load_buffers() sees to it that buffers have these lengths.
void check_ranges(const Json& root, Reporter& report);

/// Accessors without a buffer view are zeros (then changed by their sparse values): gives all of them one view into one buffer of zeros, no larger
/// than the largest of them needs. What such accessors claim all together is limited, since the file does not back it with bytes.
void materialise_zeros(Json& root, std::vector<Bytes>& buffers, Reporter& report);

}  // namespace alidade::gltf
