// SPDX-License-Identifier: Apache-2.0
#include "accel/intersect.h"
#include "accel/lazy.h"
#include "tracer/compiled_scene.h"
#include "tracer/render.h"
#include "tracer/textures.h"

#include <fmt/format.h>

namespace alidade {

CompiledSummary summary(const CompiledScene& scene) {
    CompiledSummary s;
    s.instances = scene.instances.size();
    s.geometries = scene.geometries.size();
    s.lights = scene.lights.size();
    s.images = scene.textures->count();
    s.kernel = scene.kernel;
    s.structures.emplace_back("instances", scene.top->stats());
    s.bytes = scene.top->stats().bytes + scene.textures->bytes() + scene.instances.size() * sizeof(Instance);
    if (scene.filters) s.structures.emplace_back("instances that let light through", scene.filters->stats()), s.bytes += scene.filters->stats().bytes;
    if (scene.opaques) s.structures.emplace_back("instances that let no light through", scene.opaques->stats()), s.bytes += scene.opaques->stats().bytes;
    const IntersectEntry& test = intersects()[size_t(scene.intersect)];
    for (const Geometry& g : scene.geometries) {
        if (!g.mesh) continue;
        s.intersect = fmt::format("{}: {}", test.name, test.text());
        s.triangles += g.mesh->triangles.size();
        s.structures.emplace_back(scene.scene.shapes[g.shape.index].name, g.triangles->stats());
        s.bytes += g.triangles->stats().bytes;
        const Accelerator* structure = built(*g.triangles);
        if (!structure) ++s.waiting;
        else if (const std::string& why = structure->why; s.accelerator.find(why) == why.npos) s.accelerator += (s.accelerator.empty() ? "" : "; ") + why;   // each once
    }
    for (const Instance& i : scene.instances)
        if (const Mesh* mesh = scene.geometries[i.geometry].mesh) s.instanced_triangles += mesh->triangles.size();
    return s;
}

}  // namespace alidade
