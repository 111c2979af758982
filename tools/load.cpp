// SPDX-License-Identifier: Apache-2.0
#include "tools/load.h"

#include "scene/queries.h"
#include "tools/analytic.h"
#include "tools/scene_text.h"

#include <chrono>

namespace alidade {

namespace {

/// Posing relies on what validate() checks.
std::optional<Scene> posed(const Scene& scene, double time, Diagnostics& said) {
    const Diagnostics checked = validate(scene);
    for (const Diagnostic& d : checked.list())
        if (d.severity == Severity::error) said.add(d);
    return checked.has_errors() ? std::nullopt : std::optional(pose(scene, time));
}

ImportResult import_aloud(const Request& request) {
    SceneText text(true);
    ImportOptions options = request.import;
    if (!options.print) options.print = [&](pov::TextStream where, const std::string& what) { text.print(where, what); };
    ImportResult imported = import_scene(request.scene, options);
    text.end_line();
    return imported;
}

/// A file's, or one that the program has itself.
ImportResult read_scene(const Request& request) {
    if (!tradeoff::is_analytic(request.scene)) return import_aloud(request);
    auto made = tradeoff::analytic_scene(request.scene);
    if (made) return Imported{std::move(*made), {}};
    Diagnostics said;
    said.error({}, made.error());
    return tl::unexpected(std::move(said));
}

}  // namespace

Loaded load(const Request& request) {
    Loaded loaded;
    const double start = seconds_now();
    ImportResult imported = read_scene(request);
    loaded.said = imported ? std::move(imported->diagnostics) : std::move(imported.error());
    if (imported && !loaded.said.has_errors())
        loaded.scene = request.time ? posed(imported->scene, *request.time, loaded.said) : std::optional(std::move(imported->scene));
    if (loaded.scene) reshape(*loaded.scene, request.reshape, loaded.said);
    if (loaded.said.has_errors()) loaded.scene.reset();
    loaded.seconds = seconds_now() - start;
    return loaded;
}

Prepared prepare(const Request& request) {
    Request shown = request;
    shown.import.shown_only = true;
    Loaded loaded = load(shown);
    const double start = seconds_now();
    Prepared prepared;
    if (loaded.scene) prepared.scene = compile(std::move(*loaded.scene), request.compile, loaded.said);
    prepared.said = std::move(loaded.said);
    prepared.read_seconds = loaded.seconds;
    prepared.build_seconds = seconds_now() - start;
    return prepared;
}

double seconds_now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

}  // namespace alidade
