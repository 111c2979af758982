// SPDX-License-Identifier: Apache-2.0
/// Buffer views compressed by meshoptimizer: EXT_meshopt_compression, and what KHR_meshopt_compression shares with it.
#pragma once

#include "importers/gltf/buffers.h"

namespace alidade::gltf {

/// How `view` of a checked file is compressed: its extension object, or null.
const Json* meshopt_of(const Json& view);

/// May `buffer` of a checked file be without data, as the place that only the uncompressed views speak of?
bool is_meshopt_fallback(const Json& buffer);

/// Decodes every compressed view of the checked `root` into a buffer of its own, appended to `buffers`, and points the view at it. No more is
/// allocated than the compressed bytes can hold at meshoptimizer's best (64 bytes of attributes for one of data).
void decompress_views(Json& root, std::vector<Bytes>& buffers, Reporter& report);

}  // namespace alidade::gltf
