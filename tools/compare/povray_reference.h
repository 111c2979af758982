// SPDX-License-Identifier: Apache-2.0
/// The installed POV-Ray, as a process of its own: its pictures are references. Kept, so that a scene that has not changed costs nothing.
#pragma once

#include "tools/verbs.h"

#include <string>
#include <tl/expected.hpp>

namespace alidade {

/// One picture of one scene, in POV-Ray's words.
struct PovJob {
    std::string scene;               ///< the .pov file; its folder is copied, and both programs work in copies
    int width = 320, height = 240;
    Words words;                     ///< handed to both programs before ours: +A0.3, +Lfolder, an .ini, Declare=...
    double timeout = 600;            ///< seconds a program
    std::string cache;               ///< the folder of kept references
    std::string results;             ///< a folder of results, or "": like the cache no part of the scene, though it may lie beside it
};

/// A program's picture.
struct Rendered {
    std::string picture;             ///< its path
    Words command;                   ///< as a shell would take it, in the folder of the scene
    double cpu_seconds = 0;
    bool from_cache = false;
};

/// Which program failed, and how.
struct RenderFailure {
    bool missing = false;            ///< the other program is not installed
    bool reference = true;           ///< it was the reference's
    std::string sentence;
};

/// The words of both programs: +I, +W, +H, one sample at the pixel's centre unless the job's words say otherwise, one thread, no display, no pause.
Words povray_words(const PovJob& job, const std::string& output);

/// Stands for everything that a reference depends on: all files of the scene's folder and of the library folders, the words, POV-Ray's version.
tl::expected<std::string, std::string> reference_key(const PovJob& job);
/// POV-Ray's picture, from the cache if its folder (all that is in it), the words and POV-Ray's version are what they were.
tl::expected<Rendered, RenderFailure> povray_reference(const PovJob& job, const std::string& scratch);
/// Ours, by the verb `povray` with the same words.
tl::expected<Rendered, RenderFailure> povray_test(const PovJob& job, const std::string& scratch);

/// "3.7.0.10", or "" if POV-Ray is not installed.
const std::string& povray_version();
/// Where references are kept if nothing else is asked for.
std::string default_cache();

}  // namespace alidade
