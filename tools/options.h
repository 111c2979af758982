// SPDX-License-Identifier: Apache-2.0
/// The options that verbs share, each declared once: its name, its values, its default. A bad value is one sentence and exit code 64.
#pragma once

#include "importers/importer.h"
#include "tools/verbs.h"
#include "topology/reshape.h"
#include "tracer/options.h"

#include <functional>
#include <optional>

namespace CLI {
class App;
}

namespace alidade {

/// What a user asks of a scene, from the file to the picture.
struct Request {
    std::string scene;
    ImportOptions import;
    std::optional<double> time;   ///< absent: the scene as the file has it, nothing posed
    ReshapeOptions reshape;
    CompileOptions compile;
    RenderOptions render;
};

/// SCENE, and how it is read: --time, --light-units, --strict, -I, --declare, --allow-write, --subdivide, --decimate, --crease.
void add_scene_options(CLI::App& app, Request& request);
/// What is built for its rays: --accel, --precision, --isa, --environment, --lazy, --full-kernel, --threads.
void add_compile_options(CLI::App& app, Request& request);
/// How it is seen: --size, --region, --camera, --exposure, --aperture, --focus, --integrator, --spp, --adaptive, --sampler, --light-samples, --seed, --max-depth,
/// --aov, --tile.
void add_render_options(CLI::App& app, Request& request);

/// An option that takes one of `names` and gives its number to `store`.
void add_choice(CLI::App& app, const char* option, std::vector<std::string> names, std::function<void(size_t)> store, const std::string& doc);

/// Hands `words` to `app`: what is wrong with them, in one sentence, or "". Throws CLI::CallForHelp where they ask for help.
std::string why_not_parsed(CLI::App& app, const Words& words);

/// Hands `words` to `app`, which takes the verb's description and exit codes. Returns the exit code if that ends the verb: help was asked for (0),
/// or the words are wrong (64).
std::optional<int> parse_words(CLI::App& app, const Verb& verb, const Words& words);

/// The sentence of a usage error, and its exit code.
int usage_error(const Verb& verb, const std::string& sentence);

}  // namespace alidade
