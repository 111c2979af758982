// SPDX-License-Identifier: Apache-2.0
/// The installed POV-Ray.
#pragma once

#include "tools/compare/reference.h"

namespace alidade {

/// The words of both programs: +I, +W, +H, one sample at the pixel's centre unless the job's words say otherwise, one thread, no display, no pause.
Words povray_words(const CompareJob& job, const std::string& output);

/// Stands for everything that a reference depends on: all files of the scene's folder and of the library folders, the words, the reference program's version.
tl::expected<std::string, std::string> reference_key(const CompareJob& job);
/// POV-Ray's picture, from the cache if its folder (all that is in it), the words and POV-Ray's version are what they were.
tl::expected<Rendered, RenderFailure> povray_reference(const CompareJob& job, const std::string& scratch);
/// Ours, one of each seed, by the verb `povray` with the same words.
tl::expected<Rendered, RenderFailure> povray_test(const CompareJob& job, const std::string& scratch);

/// "3.7.0.10", or "" if POV-Ray is not installed.
const std::string& povray_version();

}  // namespace alidade
