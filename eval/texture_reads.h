// SPDX-License-Identifier: Apache-2.0
/// How many texels are read: work that a ray costs beside its boxes and triangles.
#pragma once

#include <cstdint>

namespace alidade {

/// Of all pictures, by this thread since it began; the difference tells what a piece of work read. Pictures are asked from deep within pigments and patterns:
/// a counter of the thread's spares them all an argument, and costs nothing where there are none.
inline constinit thread_local uint64_t texture_reads = 0;

}  // namespace alidade
