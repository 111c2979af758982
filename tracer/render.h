// SPDX-License-Identifier: Apache-2.0
/// Scene -> CompiledScene -> Film.
#pragma once

#include "core/diagnostics.h"
#include "scene/scene.h"
#include "tracer/film.h"
#include "tracer/options.h"

#include <memory>
#include <tl/expected.hpp>

namespace alidade {

struct CompiledScene;

/// What compile() built, for `info`.
struct CompiledSummary {
    size_t instances = 0, geometries = 0, lights = 0, images = 0;
    size_t triangles = 0, instanced_triangles = 0;
    size_t waiting = 0;                    ///< structures of meshes that no ray has come near yet (CompileOptions::lazy)
    size_t bytes = 0;                      ///< of acceleration structures and vertex attributes
    std::string kernel;                    ///< which feature mask the render kernel has, and why
    std::vector<std::pair<std::string, BuildStats>> structures;   ///< top level first
    std::string accelerator;               ///< of meshes, where it was chosen for them: each choice once, and why
    std::string intersect;                 ///< how rays meet triangles, and what that gives up; empty where there are none
};

/// Builds what a ray needs, and nothing that this scene does not require. What has to be said (a default sky, a framed camera, an image that cannot
/// be read) goes to `said`; null if there is an error among it. The scene is kept inside: move it in.
std::shared_ptr<const CompiledScene> compile(Scene scene, const CompileOptions& options, Diagnostics& said);
CompiledSummary summary(const CompiledScene& scene);

/// A usage error (no such camera, integrator or layer) is one sentence.
tl::expected<Film, std::string> render(const CompiledScene& scene, const RenderOptions& options, const Monitor& monitor = {});

struct IntegratorEntry {
    const char* name;
    const char* doc;
};
std::span<const IntegratorEntry> integrators();

}  // namespace alidade
