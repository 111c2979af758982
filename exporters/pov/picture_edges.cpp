// SPDX-License-Identifier: Apache-2.0
#include "exporters/pov/picture_edges.h"

#include "exporters/pov/node_facts.h"
#include "scene/queries.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

namespace alidade::pov_export {

namespace {

/// Pictures do not grow beyond that, and not by edges that are longer than some times their size.
constexpr double kMostPixels = double(1 << 26), kLongestEdge = 8;

/// A clamped picture of a material, and where it is looked up.
struct Shown {
    const ImageSignal* image;
    LookupRange* range;
};

/// By material.
std::vector<std::vector<Shown>> clamped_pictures(const Scene& scene, std::map<Lookup, LookupRange>& ranges) {
    std::vector<std::vector<Shown>> out(scene.materials.size());
    for (uint32_t i = 0; i < out.size(); ++i)
        for (const SignalId id : shown_signals(scene, {i})) {
            const auto* image = std::get_if<ImageSignal>(&scene.signals[id.index].what);
            if (image && Lookup(*image).clamps()) out[i].push_back({image, &ranges[Lookup(*image)]});
        }
    return out;
}

void add_triangle(const Mesh& mesh, size_t t, const Shown& shown) {
    if (shown.image->uv_set >= mesh.uvs.size()) return;
    const Attribute<Vec2f>& uvs = mesh.uvs[shown.image->uv_set];
    for (int corner = 0; corner < 3; ++corner) {
        const Vec2 at = Vec2(shown.image->uv_transform * Vec3(Vec2(uvs.values[uvs.index(t, corner, mesh.triangles[t])]), 1));
        if (std::isfinite(at.x) && std::isfinite(at.y)) shown.range->min = glm::min(shown.range->min, at), shown.range->max = glm::max(shown.range->max, at);
    }
}

/// How far a picture must reach beyond its edges, in its own sizes.
Vec2 overhang(double min, double max) { return {std::max(-min, 0.0), std::max(max - 1, 0.0)}; }

int pixels(double overhang, int size) { return int(std::ceil(overhang * size)) + 1; }   // one more for what lies between two pixels

int copied(int at, int before, int size, bool mirror) {
    if (mirror) return at < size ? at : 2 * size - 1 - at;
    return std::clamp(at - before, 0, size - 1);
}

}  // namespace

std::vector<SignalId> shown_signals(const Scene& scene, MaterialId id) {
    std::vector<SignalId> out;
    for (const auto& layer : scene.materials[id.index].layers)
        if (const auto* pbr = std::get_if<GltfPbr>(&layer)) {
            collect_signals(scene, pbr->base_color, out);
            if (pbr->emissive) collect_signals(scene, *pbr->emissive, out);
        }
    return out;
}

Lookup::Lookup(const ImageSignal& from) : image(from.image.index), uv_set(from.uv_set), wrap_u(from.wrap_u), wrap_v(from.wrap_v) {
    const Mat3& m = from.uv_transform;
    uv_transform = {m[0].x, m[0].y, m[0].z, m[1].x, m[1].y, m[1].z, m[2].x, m[2].y, m[2].z};
}

std::map<Lookup, LookupRange> ranges_of_clamped(const Scene& scene) {
    std::map<Lookup, LookupRange> ranges;
    const std::vector<std::vector<Shown>> pictures = clamped_pictures(scene, ranges);
    const auto of = [&](const std::optional<MaterialId>& material) { return material ? std::span(pictures[material->index]) : std::span<const Shown>(); };
    for (const Node& node : scene.nodes) {
        const auto& slots = node.materials;
        if (std::all_of(slots.begin(), slots.end(), [&](const auto& material) { return of(material).empty(); })) continue;
        const auto* shape = std::get_if<ShapeId>(&node.what);
        const auto* mesh = shape ? std::get_if<Mesh>(&scene.shapes[shape->index].geometry) : nullptr;
        if (mesh && (slots.size() < 2 || mesh->corner_slots.empty())) {
            for (size_t t = 0; t < mesh->triangles.size(); ++t)
                for (const Shown& shown : of(slots[slot_of(*mesh, slots.size(), t)])) add_triangle(*mesh, t, shown);
        } else {   // nodes below may inherit the material
            for (const auto& material : slots)
                for (const Shown& shown : of(material)) shown.range->known = false;
        }
    }
    return ranges;
}

PictureEdges edges_of(const Lookup& lookup, const LookupRange& range, int width, int height) {
    PictureEdges out{.mirror_u = lookup.wrap_u == Wrap::mirror, .mirror_v = lookup.wrap_v == Wrap::mirror};
    const bool clamp_u = lookup.wrap_u == Wrap::clamp, clamp_v = lookup.wrap_v == Wrap::clamp;
    if (!lookup.mirrors() && !lookup.clamps()) return out;
    if (lookup.clamps()) {
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
