// SPDX-License-Identifier: Apache-2.0
#include "tests/exporters/canonical.h"

#include "core/image.h"
#include "scene/queries.h"

#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <functional>
#include <map>
#include <sstream>

namespace alidade::test {

namespace {

/// Rebuilds one array in the order of its use.
class SurfaceOrder {
  public:
    explicit SurfaceOrder(Scene& scene) : old_(scene) {}

    SignalId signal(SignalId id) {
        Signal s = old_.signals[id.index];
        s.from = {};
        if (auto* image = std::get_if<ImageSignal>(&s.what)) image->image = picture(image->image);
        if (auto* product = std::get_if<ProductSignal>(&s.what)) product->a = signal(product->a), product->b = signal(product->b);
        if (auto* channel = std::get_if<ChannelSignal>(&s.what)) channel->of = signal(channel->of);
        Scene alone;
        alone.signals = {s};
        const auto [known, added] = signals_.try_emplace(dump(alone), SignalId{uint32_t(signals.size())});
        if (added) signals.push_back(s);
        return known->second;
    }

    std::vector<Signal> signals;
    std::vector<Image> images;

  private:
    ImageId picture(ImageId id) {
        Image image = old_.images[id.index];
        if (image.bytes.empty())
            if (auto bytes = read_file(image.path)) image.bytes = std::move(*bytes);
        image.path.clear(), image.name.clear(), image.from = {};
        for (size_t i = 0; i < images.size(); ++i)
            if (images[i].bytes == image.bytes) return {uint32_t(i)};
        images.push_back(std::move(image));
        return {uint32_t(images.size() - 1)};
    }

    const Scene& old_;
    std::map<std::string, SignalId> signals_;
};

void order_surfaces(Scene& s) {
    SurfaceOrder order(s);
    for (Material& m : s.materials) {
        m.from = {};
        for (auto& layer : m.layers) {
            auto* g = std::get_if<GltfPbr>(&layer);
            if (!g) continue;
            g->base_color = order.signal(g->base_color);
            for (auto* id : {&g->metallic, &g->roughness, &g->normal, &g->occlusion, &g->emissive, &g->transmission, &g->specular, &g->specular_color,
                             &g->clearcoat, &g->clearcoat_roughness, &g->clearcoat_normal})
                if (*id) *id = order.signal(**id);
        }
    }
    s.signals = std::move(order.signals), s.images = std::move(order.images);
}

void order_shapes(Scene& s) {
    std::map<ShapeId, ShapeId> number;
    std::vector<ShapeEntry> shapes;
    for (Node& node : s.nodes) {
        auto* id = std::get_if<ShapeId>(&node.what);
        if (!id) continue;
        const auto [known, added] = number.try_emplace(*id, ShapeId{uint32_t(shapes.size())});
        if (added) shapes.push_back(s.shapes[id->index]), shapes.back().from = {};
        *id = known->second;
    }
    s.shapes = std::move(shapes);
}

}  // namespace

Scene canonical(Scene s) {
    s.files.clear();
    s.settings = {};
    order_shapes(s);
    order_surfaces(s);
    for (Node& n : s.nodes) {
        n.from = {};
        // A file may say that nothing is moved by saying nothing, or by numbers.
        if (n.to_parent.is_identity()) n.trs.reset();
    }
    for (Light& l : s.lights) l.from = {};
    for (Camera& c : s.cameras) c.from = {};
    std::erase_if(s.animations, [](const Animation& a) { return a.channels.empty(); });
    return s;
}

std::string first_difference(const std::string& a, const std::string& b) {
    std::istringstream lines_a(a), lines_b(b);
    std::string line_a, line_b;
    for (;;) {
        const bool more_a = bool(std::getline(lines_a, line_a)), more_b = bool(std::getline(lines_b, line_b));
        if (!more_a && !more_b) return "";
        if (more_a != more_b) return more_a ? line_a : line_b;
        const char *p = line_a.c_str(), *q = line_b.c_str();
        while (*p && *q) {
            char *end_p = nullptr, *end_q = nullptr;
            const bool number = (std::isdigit(*p) || *p == '-') && (std::isdigit(*q) || *q == '-');
            const double x = number ? std::strtod(p, &end_p) : 0, y = number ? std::strtod(q, &end_q) : 0;
            if (number && end_p != p && end_q != q && std::abs(x - y) <= 1e-14 * std::max({std::abs(x), std::abs(y), 0.1})) p = end_p, q = end_q;
            else if (*p == *q) ++p, ++q;
            else break;
        }
        if (*p || *q) return fmt::format("{}\n{}\n(at \"{:.60}\" and \"{:.60}\")", line_a.substr(0, 300), line_b.substr(0, 300), p, q);
    }
}

namespace {

std::optional<MaterialId> material_of(const Scene& scene, const Visit& visit, uint32_t slot) {
    for (size_t i = visit.path.size(); i-- > 0;) {
        const auto& list = scene.nodes[visit.path[i].index].materials;
        const size_t at = i + 1 == visit.path.size() ? slot : 0;
        if (at < list.size() && list[at]) return list[at];
    }
    return std::nullopt;
}

/// The constant part of a signal, and the fingerprint of its picture.
std::string describe(const Scene& scene, std::optional<SignalId> id) {
    if (!id) return "1";
    Vec4 factor(1);
    std::string picture;
    const std::function<void(SignalId)> walk = [&](SignalId s) {
        const auto& what = scene.signals[s.index].what;
        if (const auto* c = std::get_if<ConstantSignal>(&what)) factor *= c->value;
        if (const auto* p = std::get_if<ProductSignal>(&what)) walk(p->a), walk(p->b);
        if (const auto* c = std::get_if<ChannelSignal>(&what)) picture += fmt::format(" channel {}", c->channel), walk(c->of);
        if (const auto* i = std::get_if<ImageSignal>(&what)) {
            const Image& image = scene.images[i->image.index];
            auto bytes = image.bytes;
            if (bytes.empty())
                if (auto read = read_file(image.path)) bytes = *read;
            picture += fmt::format(" picture {} {}", bytes.size(), std::hash<std::string_view>()({reinterpret_cast<const char*>(bytes.data()), bytes.size()}));
        }
    };
    walk(*id);
    return fmt::format("{:.12g} {:.12g} {:.12g}{}", factor.x, factor.y, factor.z, picture);
}

std::string describe_material(const Scene& scene, std::optional<MaterialId> id) {
    if (!id) return "1 1 1 | 1 | 1";   // glTF's default
    const auto* g = std::get_if<GltfPbr>(&scene.materials[id->index].layers.at(0));
    if (!g) return "pov";
    const auto scalar = [&](std::optional<SignalId> s) { return describe(scene, s) == "1 1 1" ? "1" : describe(scene, s); };
    return fmt::format("{} | {} | {}", describe(scene, g->base_color), scalar(g->roughness), scalar(g->metallic));
}

std::array<float, 9> key(const WorldTriangle& t) {
    std::array<float, 9> out;
    for (size_t i = 0; i < 9; ++i) out[i] = float(t.corners[i / 3][i % 3]);
    return out;
}

Corner corner_of(const Mesh& mesh, const Visit& visit, const Transform& to_local, size_t t, int c, bool exact) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    Corner out;
    out.fill(none);
    const Index3& v = mesh.triangles[t];
    const Vec3 local = exact && !mesh.exact_positions.empty() ? mesh.exact_positions[v[c]] : Vec3(mesh.positions[v[c]]);
    const Vec3 p = visit.to_world.point(mesh.origin + local);
    for (int i = 0; i < 3; ++i) out[size_t(i)] = p[i];
    if (mesh.normals.present()) {
        const Vec3 n = normalized(to_local.transposed(Vec3(mesh.normals.values[mesh.normals.index(t, c, v)])));
        for (int i = 0; i < 3; ++i) out[size_t(3 + i)] = n[i];
    }
    if (!mesh.uvs.empty() && mesh.uvs[0].present())
        for (int i = 0; i < 2; ++i) out[size_t(6 + i)] = double(mesh.uvs[0].values[mesh.uvs[0].index(t, c, v)][i]);
    if (!mesh.colors.empty() && mesh.colors[0].present())
        for (int i = 0; i < 4; ++i) out[size_t(8 + i)] = double(mesh.colors[0].values[mesh.colors[0].index(t, c, v)][i]);
    return out;
}

Vec3 place(const Corner& c) { return {c[0], c[1], c[2]}; }

}  // namespace

std::vector<WorldTriangle> world_triangles(const Scene& scene, bool exact) {
    std::vector<WorldTriangle> out;
    visit_paths(scene, [&](const Visit& visit) {
        const auto* id = std::get_if<ShapeId>(&scene.nodes[visit.node.index].what);
        const auto* mesh = id ? std::get_if<Mesh>(&scene.shapes[id->index].geometry) : nullptr;
        const auto to_local = inverse(visit.to_world);
        if (!mesh || !to_local) return true;
        const bool mirrored = visit.to_world.determinant() < 0;
        for (size_t t = 0; t < mesh->triangles.size(); ++t) {
            WorldTriangle triangle;
            for (int c = 0; c < 3; ++c) triangle.corners[size_t(mirrored ? (3 - c) % 3 : c)] = corner_of(*mesh, visit, *to_local, t, c, exact);
            auto& k = triangle.corners;
            if (place(k[0]) == place(k[1]) || place(k[1]) == place(k[2]) || place(k[2]) == place(k[0])) continue;
            const auto float_place = [](const Corner& a) { return std::array{float(a[0]), float(a[1]), float(a[2])}; };
            std::rotate(k.begin(), std::min_element(k.begin(), k.end(), [&](const Corner& a, const Corner& b) { return float_place(a) < float_place(b); }), k.end());
            triangle.material = describe_material(scene, material_of(scene, visit, mesh->slots.empty() ? 0 : mesh->slots[t]));
            out.push_back(triangle);
        }
        return true;
    });
    std::stable_sort(out.begin(), out.end(), [](const WorldTriangle& a, const WorldTriangle& b) { return key(a) < key(b); });
    return out;
}

}  // namespace alidade::test
