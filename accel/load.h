// SPDX-License-Identifier: Apache-2.0
/// Structures from files: docs/accelerators.md has the format.
#pragma once

#include "accel/accelerator.h"

namespace alidade {

/// What Accelerator::save wrote over the same triangles, in the same precision; all of `options.intersect` can be asked of one file. The file is mapped and stays so: its pages are shared with all who map it, and
/// must not be changed in place meanwhile. Everything in it is checked once: a file that is cut off, damaged, of another version, machine, precision or mesh, or whose numbers lead nowhere is an error, one sentence. Answers are
/// those of the structure that was saved, bit for bit. stats().phases has "map" alone.
tl::expected<std::unique_ptr<Accelerator>, std::string> load_accelerator(const std::string& path, const TriangleView& mesh, const AccelOptions& options);

/// Stands for the triangles and positions that a structure of that precision reads: a name for its file.
uint64_t mesh_fingerprint(const TriangleView& mesh, Precision precision);

}  // namespace alidade
