// SPDX-License-Identifier: Apache-2.0
#include "exporters/pov/picture_edges.h"

#include "scene/queries.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace alidade::pov_export {

namespace {

/// Pictures do not grow beyond that, and not by edges that are longer than some times their size.
constexpr double kMostPixels = double(1 << 26), kLongestEdge = 8;

/// Where it is looked up: bounds of u and v.
struct Range {
    Vec2 min{INFINITY}, max{-INFINITY};
    bool known = true;
};

bool is_shown_so(const Scene& scene, MaterialId id, const ImageSignal& image) {
    std::vector<SignalId> signals;
    for (const auto& layer : scene.materials[id.index].layers)
        if (const auto* pbr = std::get_if<GltfPbr>(&layer)) {
            collect_signals(scene, pbr->base_color, signals);
            if (pbr->emissive) collect_signals(scene, *pbr->emissive, signals);
        }
    return std::any_of(signals.begin(), signals.end(), [&](SignalId signal) {
        const auto* other = std::get_if<ImageSignal>(&scene.signals[signal.index].what);
        return other && other->image == image.image && other->uv_set == image.uv_set && other->uv_transform == image.uv_transform;
    });
}

void add_coordinates(const Mesh& mesh, const std::vector<bool>& slots, const ImageSignal& image, Range& range) {
    if (image.uv_set >= mesh.uvs.size()) return;
    const Attribute<Vec2f>& uvs = mesh.uvs[image.uv_set];
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (!slots[slots.size() < 2 || mesh.slots.empty() ? 0 : mesh.slots[t]]) continue;
        for (int corner = 0; corner < 3; ++corner) {
            const Vec2 at = Vec2(image.uv_transform * Vec3(Vec2(uvs.values[uvs.index(t, corner, mesh.triangles[t])]), 1));
            if (std::isfinite(at.x) && std::isfinite(at.y)) range.min = glm::min(range.min, at), range.max = glm::max(range.max, at);
        }
    }
}

Range range_of(const Scene& scene, const ImageSignal& image) {
    Range out;
    for (const Node& node : scene.nodes) {
        std::vector<bool> slots;
        for (const auto& material : node.materials) slots.push_back(material && is_shown_so(scene, *material, image));
        if (std::find(slots.begin(), slots.end(), true) == slots.end()) continue;
        const auto* shape = std::get_if<ShapeId>(&node.what);
        const auto* mesh = shape ? std::get_if<Mesh>(&scene.shapes[shape->index].geometry) : nullptr;
        if (mesh && (slots.size() < 2 || mesh->corner_slots.empty())) add_coordinates(*mesh, slots, image, out);
        else out.known = false;   // nodes below may inherit the material
    }
    return out;
}

/// How far a picture must reach beyond its edges, in its own sizes.
Vec2 overhang(double min, double max) { return {std::max(-min, 0.0), std::max(max - 1, 0.0)}; }

int pixels(double overhang, int size) { return int(std::ceil(overhang * size)) + 1; }   // one more for what lies between two pixels

int copied(int at, int before, int size, bool mirror) {
    if (mirror) return at < size ? at : 2 * size - 1 - at;
    return std::clamp(at - before, 0, size - 1);
}

}  // namespace

PictureEdges edges_of(const Scene& scene, const ImageSignal& image, int width, int height) {
    PictureEdges out{.mirror_u = image.wrap_u == Wrap::mirror, .mirror_v = image.wrap_v == Wrap::mirror};
    const bool clamp_u = image.wrap_u == Wrap::clamp, clamp_v = image.wrap_v == Wrap::clamp;
    if (!out.mirror_u && !out.mirror_v && !clamp_u && !clamp_v) return out;
    if (clamp_u || clamp_v) {
        const Range range = range_of(scene, image);
        const Vec2 across = overhang(range.min.x, range.max.x), down = overhang(range.min.y, range.max.y);
        const double longest = std::max(clamp_u ? std::max(across.x, across.y) : 0, clamp_v ? std::max(down.x, down.y) : 0);
        out.exact = range.known && longest <= kLongestEdge;
        if (!out.exact) return {.exact = false};
        if (clamp_u) out.left = pixels(across.x, width), out.right = pixels(across.y, width);
        if (clamp_v) out.top = pixels(down.x, height), out.bottom = pixels(down.y, height);
    }
    const double across = double(width) * (out.mirror_u ? 2 : 1) + out.left + out.right, down = double(height) * (out.mirror_v ? 2 : 1) + out.top + out.bottom;
    return across * down <= kMostPixels ? out : PictureEdges{.exact = false};
}

Picture with_edges(const Picture& from, const PictureEdges& e) {
    Picture out(from.width * (e.mirror_u ? 2 : 1) + e.left + e.right, from.height * (e.mirror_v ? 2 : 1) + e.top + e.bottom, from.names);
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            const int row = e.mirror_v ? out.height - 1 - y : y;   // the mirrored one is above, where v is less
            const float* pixel = from.at(copied(x, e.left, from.width, e.mirror_u), e.mirror_v ? from.height - 1 - copied(row, 0, from.height, true) : copied(row, e.top, from.height, false));
            std::copy_n(pixel, from.channels, out.at(x, y));
        }
    return out;
}

Transform place_of(const PictureEdges& e, int width, int height) {
    const double across = (e.mirror_u ? 2 : 1) + double(e.left + e.right) / width, down = (e.mirror_v ? 2 : 1) + double(e.top + e.bottom) / height;
    return {Mat3(across, 0, 0, 0, down, 0, 0, 0, 1), Vec3(-double(e.left) / width, -double(e.bottom) / height, 0)};
}

}  // namespace alidade::pov_export
