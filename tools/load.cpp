// SPDX-License-Identifier: Apache-2.0
#include "tools/load.h"

#include "scene/queries.h"

#include <chrono>

namespace alidade {

Loaded load(const Request& request) {
    Loaded loaded;
    const double start = seconds_now();
    ImportResult imported = import_scene(request.scene, request.import);
    loaded.said = imported ? std::move(imported->diagnostics) : std::move(imported.error());
    if (imported && !loaded.said.has_errors()) loaded.scene = request.time ? pose(imported->scene, *request.time) : std::move(imported->scene);
    if (loaded.scene) reshape(*loaded.scene, request.reshape, loaded.said);
    if (loaded.said.has_errors()) loaded.scene.reset();
    loaded.seconds = seconds_now() - start;
    return loaded;
}

double seconds_now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

}  // namespace alidade
