// SPDX-License-Identifier: Apache-2.0
#include "scene/graph.h"
#include "scene/queries.h"

#include <array>

namespace alidade {

namespace {

constexpr const char* kNames[] = {
    "textures", "alpha mask", "alpha blend", "normal maps", "vertex colors", "emission", "mirror", "transmission", "absorption", "media", "fog",
    "point lights", "spot lights", "directional lights", "area lights", "environment", "csg", "clipping", "instances", "mirrored instances",
    "analytic shapes", "unbounded shapes", "meshes", "animation", "skins", "morphs", "depth of field", "orthographic", "patterns", "functions",
};
constexpr size_t kCount = std::size(kNames);
static_assert(kCount == size_t(Requirement::functions) + 1);

/// What can be reached from the roots, as marks beside the arrays of the scene.
struct Reached {
    explicit Reached(const Scene& s)
        : nodes(s.nodes.size()), mirrored(s.nodes.size()), uses(s.nodes.size()), shapes(s.shapes.size()), signals(s.signals.size()),
          materials(s.materials.size()), interiors(s.interiors.size()), lights(s.lights.size()), cameras(s.cameras.size()) {}
    std::vector<bool> nodes, mirrored;   ///< mirrored: on some path
    std::vector<uint32_t> uses;          ///< of a node: how many reached parents and roots lead to it (at most 2)
    std::vector<uint32_t> shapes;        ///< how many reached nodes hold the shape (at most 2)
    std::vector<bool> signals, materials, interiors, lights, cameras;
};

class Collector {
  public:
    explicit Collector(const Scene& scene) : scene_(scene), reached_(scene) {}

    std::vector<RequiredBy> run() {
        reach_nodes();
        reach_content();
        reach_signals();
        for (size_t i = 0; i < scene_.nodes.size(); ++i)
            if (reached_.nodes[i]) node(i);
        for (size_t i = 0; i < scene_.shapes.size(); ++i)
            if (reached_.shapes[i]) shape(scene_.shapes[i]);
        for (size_t i = 0; i < scene_.materials.size(); ++i)
            if (reached_.materials[i]) material(scene_.materials[i]);
        for (size_t i = 0; i < scene_.interiors.size(); ++i)
            if (reached_.interiors[i]) interior(scene_.interiors[i]);
        for (size_t i = 0; i < scene_.signals.size(); ++i)
            if (reached_.signals[i]) signal(scene_.signals[i]);
        for (size_t i = 0; i < scene_.lights.size(); ++i)
            if (reached_.lights[i]) light(scene_.lights[i]);
        for (size_t i = 0; i < scene_.cameras.size(); ++i)
            if (reached_.cameras[i]) camera(scene_.cameras[i]);
        animations();
        atmosphere();
        return result();
    }

  private:
    void need(Requirement what, const SourcePos& from) {
        RequiredBy& r = found_[size_t(what)];
        if (r.count++ == 0) r.first = from;
    }

    void reach_nodes() {
        const auto links = [&](uint32_t i, const auto& f) { for_each_link(scene_, scene_.nodes[i], [&](NodeId n) { f(n.index); }); };
        const std::vector<uint32_t> order = topological_order(scene_.nodes.size(), links).sequence;
        std::vector<bool> plain(scene_.nodes.size());   // reached on a path that mirrors an even number of times
        const auto enter = [&](uint32_t i, bool from_plain, bool from_mirrored) {
            const Node& n = scene_.nodes[i];
            if (!n.flags.visible) return;
            reached_.nodes[i] = true;
            reached_.uses[i] = std::min(reached_.uses[i] + 1, 2u);
            const bool mirrors = n.to_parent.determinant() < 0;
            if (mirrors ? from_mirrored : from_plain) plain[i] = true;
            if (mirrors ? from_plain : from_mirrored) reached_.mirrored[i] = true;
        };
        for (const NodeId root : scene_.roots) enter(root.index, true, false);
        for (const uint32_t i : order) {
            if (!reached_.nodes[i]) continue;
            links(i, [&](uint32_t child) { enter(child, plain[i], reached_.mirrored[i]); });
        }
    }

    void reach_content() {
        for (size_t i = 0; i < scene_.nodes.size(); ++i) {
            if (!reached_.nodes[i]) continue;
            const Node& n = scene_.nodes[i];
            if (const auto* s = std::get_if<ShapeId>(&n.what)) reached_.shapes[s->index] = std::min(reached_.shapes[s->index] + 1, 2u);
            if (const auto* l = std::get_if<LightId>(&n.what)) reached_.lights[l->index] = true;
            if (const auto* c = std::get_if<CameraId>(&n.what)) reached_.cameras[c->index] = true;
            if (n.interior) reached_.interiors[n.interior->index] = true;
            if (n.inside_material) reached_.materials[n.inside_material->index] = true;
            for (const std::optional<MaterialId>& m : n.materials)
                if (m) reached_.materials[m->index] = true;
        }
    }

    void reach_parts();
    void reach_signals();

    void node(size_t i) {
        const Node& n = scene_.nodes[i];
        const auto* s = std::get_if<ShapeId>(&n.what);
        if (n.csg != CsgKind::none) need(Requirement::csg, n.from);
        if (!n.clips.empty()) need(Requirement::clipping, n.from);
        if (reached_.uses[i] > 1 || (s && reached_.shapes[s->index] > 1)) need(Requirement::instances, n.from);
        if (s && reached_.mirrored[i]) need(Requirement::mirrored_instances, n.from);
        if (s && n.skin) need(Requirement::skins, n.from);
    }

    void shape(const ShapeEntry& entry) {
        const Mesh* mesh = std::get_if<Mesh>(&entry.geometry);
        need(mesh ? Requirement::meshes : Requirement::analytic_shapes, entry.from);
        if (!mesh && !bounds(entry.geometry).finite()) need(Requirement::unbounded_shapes, entry.from);
        if (mesh && !mesh->colors.empty()) need(Requirement::vertex_colors, entry.from);
        if (mesh && !mesh->morphs.empty()) need(Requirement::morphs, entry.from);
    }

    /// Can any component of the signal differ from 0? A constant answers, everything else may.
    bool may_be_nonzero(const std::optional<SignalId>& id) const {
        if (!id) return false;
        const auto* constant = std::get_if<ConstantSignal>(&scene_.signals[id->index].what);
        return !constant || !is_black(Vec3(constant->value));
    }

    void material(const Material& m) {
        for (const auto& layer : m.layers) std::visit([&](const auto& surface) { this->surface(surface, m.from); }, layer);
    }

    void surface(const GltfPbr& g, const SourcePos& from) {
        if (g.alpha_mode == AlphaMode::mask) need(Requirement::alpha_mask, from);
        if (g.alpha_mode == AlphaMode::blend) need(Requirement::alpha_blend, from);
        if (g.normal || g.clearcoat_normal) need(Requirement::normal_maps, from);
        if (may_be_nonzero(g.emissive) && g.emissive_strength != 0) need(Requirement::emission, from);
        if (may_be_nonzero(g.transmission)) need(Requirement::transmission, from);
        if (g.roughness && !may_be_nonzero(g.roughness)) need(Requirement::mirror, from);
    }

    void surface(const PovFinish& p, const SourcePos& from) {
        if (p.normal) need(Requirement::normal_maps, from);
        if (!is_black(p.emission)) need(Requirement::emission, from);
        if (!is_black(p.reflection_max) || !is_black(p.reflection_min)) need(Requirement::mirror, from);
        if (lets_light_through(scene_, p.pigment)) need(Requirement::transmission, from);
    }

    void surface(const PovTextureMap&, const SourcePos&) {}   // its parts are materials of their own

    void interior(const Interior& i) {
        if (i.fade_distance > 0 || std::isfinite(i.attenuation_distance)) need(Requirement::absorption, i.from);
        if (!i.media.empty()) need(Requirement::media, i.from);
    }

    void signal(const Signal& s) {
        if (std::holds_alternative<ImageSignal>(s.what)) need(Requirement::textures, s.from);
        if (const PatternSignal* pattern = pattern_of(s); pattern && pattern->picture) need(Requirement::textures, s.from);
        if (std::holds_alternative<PatternSignal>(s.what) || std::holds_alternative<ReliefSignal>(s.what)) need(Requirement::patterns, s.from);
        if (const PatternSignal* pattern = pattern_of(s); pattern && pattern->function) need(Requirement::functions, s.from);
    }

    void light(const Light& l) {
        static constexpr Requirement kKinds[] = {Requirement::point_lights, Requirement::spot_lights, Requirement::directional_lights,
                                                 Requirement::area_lights, Requirement::spot_lights, Requirement::spot_lights};
        static_assert(std::size(kKinds) == std::variant_size_v<decltype(Light::kind)>);
        need(kKinds[l.kind.index()], l.from);
        if (l.shadow_grid) need(Requirement::area_lights, l.from);
    }

    void camera(const Camera& c) {
        if (c.aperture > 0) need(Requirement::depth_of_field, c.from);
        if (c.projection == Projection::orthographic) need(Requirement::orthographic, c.from);
    }

    void animations() {
        for (const Animation& a : scene_.animations)
            for (const Channel& c : a.channels)
                if (reached_.nodes[c.target.index]) need(Requirement::animation, scene_.nodes[c.target.index].from);
    }

    void atmosphere() {
        const Atmosphere& a = scene_.atmosphere;
        if (a.environment || a.environment_image || a.sky) need(Requirement::environment, {});
        for (size_t i = 0; i < a.fogs.size() + a.rainbows.size(); ++i) need(Requirement::fog, {});
        for (size_t i = 0; i < a.media.size(); ++i) need(Requirement::media, {});
    }

    std::vector<RequiredBy> result() {
        std::vector<RequiredBy> out;
        for (size_t i = 0; i < kCount; ++i) {
            if (found_[i].count == 0) continue;
            out.push_back(found_[i]);
            out.back().what = Requirement(i);
        }
        return out;
    }

    const Scene& scene_;
    Reached reached_;
    std::array<RequiredBy, kCount> found_{};
};

/// Used materials use their parts.
void Collector::reach_parts() {
    const auto parts = [&](uint32_t i, const auto& f) { for_each_part(scene_.materials[i], [&](MaterialId id) { f(id.index); }); };
    for (const uint32_t i : topological_order(scene_.materials.size(), parts).sequence)
        if (reached_.materials[i]) parts(i, [&](uint32_t part) { reached_.materials[part] = true; });
}

/// From the used materials and interiors and from the atmosphere, through the graph of signals.
void Collector::reach_signals() {
    std::vector<SignalId> open;
    const auto reach = [&](SignalId id) {
        if (reached_.signals[id.index]) return;
        reached_.signals[id.index] = true;
        open.push_back(id);
    };
    reach_parts();
    const auto of_media = [&](const std::vector<Interior::Medium>& media) {
        for (const Interior::Medium& medium : media)
            for (const SignalId density : medium.density) reach(density);
    };
    for (size_t i = 0; i < scene_.materials.size(); ++i)
        if (reached_.materials[i]) for_each_signal(scene_.materials[i], reach);
    for (size_t i = 0; i < scene_.interiors.size(); ++i)
        if (reached_.interiors[i]) of_media(scene_.interiors[i].media);
    of_media(scene_.atmosphere.media);
    for (size_t i = 0; i < scene_.cameras.size(); ++i)
        if (reached_.cameras[i] && scene_.cameras[i].normal) reach(*scene_.cameras[i].normal);
    for (const Rainbow& bow : scene_.atmosphere.rainbows)
        if (bow.colors) reach(*bow.colors);
    if (scene_.atmosphere.sky)
        for (const SignalId pigment : scene_.atmosphere.sky->pigments) reach(pigment);
    while (!open.empty()) {
        const SignalId id = open.back();
        open.pop_back();
        for_each_operand(scene_, scene_.signals[id.index], reach);
    }
}

}  // namespace

const char* name(Requirement r) { return kNames[size_t(r)]; }

std::vector<RequiredBy> requirements(const Scene& scene) { return Collector(scene).run(); }

}  // namespace alidade
