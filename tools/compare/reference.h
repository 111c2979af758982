// SPDX-License-Identifier: Apache-2.0
/// The other renderers that a scene can be compared with: a visible table. They run as processes of their own and are never linked.
#pragma once

#include "tools/verbs.h"

#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace alidade {

struct CompiledScene;
struct ReferenceProgram;

/// Pictures of one scene, by two programs.
struct CompareJob {
    const ReferenceProgram* against = nullptr;   ///< never null
    std::string scene;               ///< its file
    int width = 320, height = 240;
    int spp = 0;                     ///< samples a pixel of both; 0: what the reference program takes if nothing is said
    int seeds = 1;                   ///< pictures of ours, that differ by their random numbers alone; the first is the one that is measured
    Words words;                     ///< POV-Ray's, handed to both programs before ours: +A0.3, +Lfolder, an .ini, Declare=...
    double timeout = 600;            ///< seconds a program
    bool objects = false;            ///< asks our scene what each pixel shows, for a report
    std::string cache;               ///< the folder of kept references
    std::string results;             ///< a folder of results, or "": like the cache no part of the scene, though it may lie beside it
};

/// A program's pictures.
struct Rendered {
    std::string picture;             ///< its path
    std::vector<std::string> more;   ///< of further seeds
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

struct ReferenceProgram {
    const char* name;                ///< as --against spells it
    const char* title;
    const char* doc;
    const char* packages;            ///< Debian's
    const char* exported;            ///< the file that our exporter writes for it; its ending names the format
    const char* ending;              ///< of both pictures: the reference's and, of what was exported, ours
    int spp;                         ///< samples a pixel if nothing is said; 1: the pixel's centre
    bool random;                     ///< its pictures are made of random numbers whatever the scene is: it makes one of each seed
    const std::string& (*version)(); ///< "" if it is not installed
    /// The picture of what our exporter wrote to job.scene; `scene` is what we render.
    tl::expected<Rendered, RenderFailure> (*render)(const CompareJob& job, const CompiledScene& scene, const std::string& scratch);
};

/// POV-Ray first: it is asked if nothing is said.
std::span<const ReferenceProgram> references();

/// The sentence for a program that is not installed, with its packages; "" if it is.
std::string why_missing(const ReferenceProgram& program);

}  // namespace alidade
