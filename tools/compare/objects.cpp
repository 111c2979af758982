// SPDX-License-Identifier: Apache-2.0
#include "tools/compare/objects.h"

#include "eval/shapes/shape_ops.h"
#include "tracer/compiled_scene.h"
#include "tracer/render.h"

#include <fmt/format.h>

#include <filesystem>
#include <map>

namespace alidade {
namespace {

std::string name_of(const Scene& scene, const Node& node) {
    const auto* id = std::get_if<ShapeId>(&node.what);
    const ShapeEntry* shape = id ? &scene.shapes[id->index] : nullptr;
    const ShapeOps* ops = shape ? find_shape(shape->geometry) : nullptr;
    const std::string what = !node.name.empty() ? node.name : shape && !shape->name.empty() ? shape->name : ops ? ops->name : "mesh";
    const SourcePos& from = shape && node.from.file == kNoFile ? shape->from : node.from;
    if (from.file >= scene.files.size() || from.line == 0) return what;
    return fmt::format("{} ({}:{})", what, std::filesystem::path(scene.files[from.file].path).filename().string(), from.line);
}

}  // namespace

ReportObjects objects_seen(const CompiledScene& scene, int width, int height) {
    RenderOptions options;
    options.width = width, options.height = height, options.spp = 1, options.integrator = "cast", options.aovs = {"id"};
    ReportObjects out;
    const auto film = render(scene, options);
    if (!film) return out;
    std::map<std::string, uint32_t> numbers;
    constexpr uint32_t kNone = (1u << 24) - 1;
    const Picture& picture = film->picture;
    for (size_t i = size_t(picture.channels) - 1; i < picture.values.size(); i += size_t(picture.channels)) {
        const auto id = size_t(picture.values[i]);   // 1 + the instance
        if (id == 0 || id > scene.instances.size()) {
            out.index.push_back(kNone);
            continue;
        }
        const std::string name = name_of(scene.scene, scene.scene.nodes[scene.instances[id - 1].node.index]);
        const auto [known, added] = numbers.try_emplace(name, uint32_t(out.names.size()));
        if (added) out.names.push_back(name);
        out.index.push_back(known->second);
    }
    return out;
}

ReportObjects cropped(const ReportObjects& objects, int width, int x0, int y0, int x1, int y1) {
    ReportObjects out;
    out.names = objects.names;
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) out.index.push_back(objects.index[size_t(y) * size_t(width) + size_t(x)]);
    return out;
}

}  // namespace alidade
