// SPDX-License-Identifier: Apache-2.0
#include "tracer/materials.h"

#include "scene/graph.h"
#include "tracer/interior_carrier.h"
#include "tracer/textures.h"

#include <algorithm>
#include <fmt/format.h>

namespace alidade {
namespace {

bool is_constant(const Scene& scene, SignalId id) { return std::holds_alternative<ConstantSignal>(scene.signals[id.index].what); }

bool is_zero(const Scene& scene, const std::optional<SignalId>& id) {
    if (!id) return true;
    const auto* constant = std::get_if<ConstantSignal>(&scene.signals[id->index].what);
    return constant && constant->value.x == 0 && constant->value.y == 0 && constant->value.z == 0;
}

/// Is the signal, or its default when absent, surely 1?
bool is_one(const Scene& scene, const std::optional<SignalId>& id) {
    if (!id) return true;
    const auto* constant = std::get_if<ConstantSignal>(&scene.signals[id->index].what);
    return constant && constant->value.x >= 1;
}

/// All signals that the render kernel evaluates of a material. Occlusion is not among them, so its image is not decoded.
std::vector<SignalId> read_signals(const GltfPbr& m) {
    std::vector<SignalId> out{m.base_color};
    for (const auto& s : {m.metallic, m.roughness, m.normal, m.emissive, m.transmission, m.specular, m.specular_color, m.clearcoat, m.clearcoat_roughness, m.clearcoat_normal})
        if (s) out.push_back(*s);
    return out;
}

/// What one material needs of the kernel.
unsigned features_of(const Scene& scene, const GltfPbr& m) {
    unsigned features = 0;
    for (const SignalId id : read_signals(m))
        if (!is_constant(scene, id)) features |= kTextures;
    if (m.normal || m.clearcoat_normal) features |= kTextures;
    if (m.alpha_mode != AlphaMode::opaque) features |= kAlpha;
    if (!is_zero(scene, m.transmission)) features |= kTransmission;
    if (!m.unlit && (!is_one(scene, m.roughness) || !is_zero(scene, m.clearcoat))) features |= kMirrors;
    return features;
}

unsigned features_of(const Scene& scene, const PovFinish& f) {
    unsigned features = is_constant(scene, f.pigment) && !f.normal ? 0u : unsigned(kTextures);
    if (lets_light_through(scene, f.pigment)) features |= kTransmission | kAlpha;   // where all passes there is a hole
    if (!is_black(f.reflection_min) || !is_black(f.reflection_max)) features |= kMirrors;
    return features;
}

unsigned features_of(const Scene&, const PovTextureMap&) { return kTextures; }   // those of its parts come on top

/// The materials `roots` and all their parts, each once.
std::vector<uint32_t> with_parts(const Scene& scene, const std::vector<uint32_t>& roots) {
    std::vector<bool> seen(scene.materials.size());
    std::vector<uint32_t> out;
    const auto use = [&](uint32_t i) {
        if (!seen[i]) seen[i] = true, out.push_back(i);
    };
    for (const uint32_t root : roots) use(root);
    for (size_t done = 0; done < out.size(); ++done) for_each_part(scene.materials[out[done]], [&](MaterialId part) { use(part.index); });
    return out;
}

/// POV-Ray's layers all belong to one kind: importers mix none. A map of textures has no layers beside it.
bool is_pov(const Scene& scene, uint32_t material) {
    const std::vector<uint32_t> parts = with_parts(scene, {material});
    return std::all_of(parts.begin(), parts.end(), [&](uint32_t part) {
        const auto& layers = scene.materials[part].layers;
        if (layers.size() == 1 && std::holds_alternative<PovTextureMap>(layers[0])) return true;
        return std::all_of(layers.begin(), layers.end(), [](const auto& layer) { return std::holds_alternative<PovFinish>(layer); });
    });
}

/// All signals that are evaluated for a material itself, without its parts.
std::vector<SignalId> read_signals(const Scene& scene, const Material& m) {
    std::vector<SignalId> out;
    for (const auto& layer : m.layers) {
        if (const auto* pbr = std::get_if<GltfPbr>(&layer))
            for (const SignalId id : read_signals(*pbr)) collect_signals(scene, id, out);
        if (const auto* finish = std::get_if<PovFinish>(&layer)) {
            collect_signals(scene, finish->pigment, out);
            if (finish->normal) collect_signals(scene, *finish->normal, out);
        }
        if (const auto* map = std::get_if<PovTextureMap>(&layer)) collect_signals(scene, map->pattern, out);
    }
    return out;
}

/// False, and an error, if the tracer cannot render the material.
bool check_supported(const Scene& scene, uint32_t material, Diagnostics& said) {
    const Material& m = scene.materials[material];
    if (!is_pov(scene, material) && (m.layers.size() != 1 || !std::holds_alternative<GltfPbr>(m.layers[0]))) {
        said.error(m.from, fmt::format("material '{}': layers of different kinds cannot be rendered", m.name));
        return false;
    }
    return true;
}

/// Does anything mirror by the interiors that POV-Ray gives to all objects, opaque ones too?
bool has_fresnel_mirrors(const Scene& scene) {
    return std::any_of(scene.materials.begin(), scene.materials.end(), [](const Material& material) {
        return std::any_of(material.layers.begin(), material.layers.end(), [](const auto& layer) {
            const auto* f = std::get_if<PovFinish>(&layer);
            return f && f->reflection_fresnel;
        });
    });
}

}  // namespace

MaterialTable::MaterialTable(CompiledScene& out) : out_(out), interiors_count_(out.scene.atmosphere.is_hazy() || has_fresnel_mirrors(out.scene)) {}

bool lets_light_through(const Scene& scene, uint32_t material) {
    const std::vector<uint32_t> parts = with_parts(scene, {material});
    return std::any_of(parts.begin(), parts.end(), [&](uint32_t part) {
        const auto& layers = scene.materials[part].layers;
        return std::all_of(layers.begin(), layers.end(), [&](const auto& layer) {
            if (const auto* g = std::get_if<GltfPbr>(&layer)) return (features_of(scene, *g) & (kAlpha | kTransmission)) != 0;
            const auto* f = std::get_if<PovFinish>(&layer);
            return f && lets_light_through(scene, f->pigment);
        });
    });
}

std::span<const char* const> feature_names() {
    static constexpr const char* kNames[] = {"textures", "alpha", "transmission", "mirrors", "sampled lights"};
    return kNames;
}

void FeatureReasons::need(unsigned features, const std::string& who) {
    for (int bit = 0; bit < kBits; ++bit)
        if (features & (1u << bit) && who_[bit].empty()) who_[bit] = who;
    mask_ |= features;
}

std::string FeatureReasons::text() const {
    std::string out = fmt::format("mask {} of {}", mask_, unsigned(kAllFeatures));
    for (int bit = 0; bit < kBits; ++bit)
        if (mask_ & (1u << bit)) out += fmt::format("; {} for {}", feature_names()[size_t(bit)], who_[bit]);
    return mask_ ? out : out + ": plain opaque surfaces, lights without extent";
}

uint32_t MaterialTable::default_material() {
    if (default_) return *default_;
    Scene& scene = out_.scene;
    scene.signals.emplace_back().what = ConstantSignal{Vec4(1)};
    GltfPbr pbr;
    pbr.base_color = {uint32_t(scene.signals.size() - 1)};
    Material material;
    material.name = "default";
    material.layers.push_back(pbr);
    scene.materials.push_back(material);
    default_ = uint32_t(scene.materials.size() - 1);
    return *default_;
}

uint32_t MaterialTable::add_interior(const Material& material, std::optional<InteriorId> interior, bool hollow) {
    CompiledInterior in;
    if (interior) static_cast<Interior&>(in) = out_.scene.interiors[interior->index];
    in.hollow = hollow;
    if (const auto* pbr = material.layers.empty() ? nullptr : std::get_if<GltfPbr>(&material.layers[0])) in.ior = pbr->ior;
    out_.interiors.push_back(in);
    return uint32_t(out_.interiors.size() - 1);
}

uint32_t MaterialTable::interior_of_whole(const std::vector<NodeId>& path) {
    const auto interior = out_.scene.nodes[path.back().index].interior;
    const bool hollow = is_hollow(out_.scene, path, path.size());
    if (!interior && !interiors_count_) return kNoId;
    const auto [at, added] = interior_of_.try_emplace({kNoId, interior ? interior->index : kNoId, hollow}, 0);
    if (added) at->second = add_interior(Material(), interior, hollow);
    return at->second;
}

SlotMaterial MaterialTable::slot(std::optional<MaterialId> material, std::optional<InteriorId> interior, bool hollow) {
    SlotMaterial out;
    out.material = material ? material->index : default_material();
    const Material& m = out_.scene.materials[out.material];
    const auto* pbr = m.layers.empty() ? nullptr : std::get_if<GltfPbr>(&m.layers[0]);
    const bool filled = interior || interiors_count_;
    if (pbr ? is_zero(out_.scene, pbr->transmission) : !filled && !lets_light_through(out_.scene, out.material)) return out;
    const auto [at, added] = interior_of_.try_emplace({out.material, interior ? interior->index : kNoId, hollow}, 0);
    if (added) at->second = add_interior(m, interior, hollow);
    out.interior = at->second;
    return out;
}

void MaterialTable::add_slots(const std::vector<NodeId>& path, uint32_t count, std::optional<InteriorId> interior, bool hollow, Instance& instance) {
    const auto add = [&](const std::optional<CarriedMaterial>& carried) {
        SlotMaterial material = slot(carried ? std::optional(carried->material) : std::nullopt, interior, hollow);
        if (carried) material.space = space(*carried, path);
        out_.slots.push_back(material);
    };
    instance.first_slot = uint32_t(out_.slots.size());
    for (uint32_t i = 0; i < count; ++i) {
        const auto carried = carried_material(out_.scene, path, i);
        instance.usual_material = (i == 0 || instance.usual_material) && (!carried || out_.scene.nodes[path[carried->carrier].index].usual_material);
        add(carried);
    }
    if (const auto inside = carried_inside_material(out_.scene, path)) instance.inside_slot = uint32_t(out_.slots.size()), add(inside);
    const uint32_t filling = out_.slots[instance.first_slot].interior;   // a solid has one
    if (instance.inside_slot != kNoId && filling != kNoId) out_.slots.back().interior = filling;
}

bool MaterialTable::has_patterns(uint32_t material) {
    const auto known = has_patterns_.find(material);
    if (known != has_patterns_.end()) return known->second;
    std::vector<SignalId> read;
    for_each_signal(out_.scene.materials[material], [&](SignalId root) { collect_signals(out_.scene, root, read); });
    const bool any = std::any_of(read.begin(), read.end(), [&](SignalId id) {
        const auto& what = out_.scene.signals[id.index].what;
        return std::holds_alternative<PatternSignal>(what) || std::holds_alternative<ReliefSignal>(what);
    });
    has_patterns_.emplace(material, any);
    return any;
}

uint32_t MaterialTable::space(const CarriedMaterial& carried, const std::vector<NodeId>& path) {
    if (!has_patterns(carried.material.index)) return kNoId;
    Transform to_world;
    for (size_t i = 0; i <= carried.carrier; ++i) to_world = to_world * out_.scene.nodes[path[i].index].to_parent;
    const auto from_world = inverse(to_world);
    if (!from_world) return kNoId;
    out_.pattern_spaces.push_back({to_world, *from_world});
    return uint32_t(out_.pattern_spaces.size() - 1);
}

void compile_materials(CompiledScene& out, const CompileOptions& options, FeatureReasons& reasons, Diagnostics& said) {
    std::vector<uint32_t> roots;
    for (const SlotMaterial& slot : out.slots) roots.push_back(slot.material);
    std::vector<uint32_t> used = with_parts(out.scene, roots);
    std::sort(used.begin(), used.end());
    std::vector<SignalId> signals;
    for (const uint32_t i : used) {
        const Material& m = out.scene.materials[i];
        const std::vector<SignalId> own = read_signals(out.scene, m);
        if (!check_supported(out.scene, i, said)) continue;
        const std::string who = fmt::format("material '{}'", m.name);
        for (const auto& layer : m.layers) reasons.need(std::visit([&](const auto& surface) { return features_of(out.scene, surface); }, layer), who);
        if (const auto* pbr = std::get_if<GltfPbr>(&m.layers[0])) out.glows = out.glows || (pbr->emissive && !is_zero(out.scene, pbr->emissive)) || pbr->unlit;
        signals.insert(signals.end(), own.begin(), own.end());
    }
    for (const PlacedCamera& placed : out.cameras)
        if (placed.camera.normal) collect_signals(out.scene, *placed.camera.normal, signals);
    for (const Rainbow& bow : out.scene.atmosphere.rainbows)
        if (bow.colors) collect_signals(out.scene, *bow.colors, signals);
    if (const auto& sky = out.scene.atmosphere.sky)
        for (const SignalId pigment : sky->pigments) collect_signals(out.scene, pigment, signals);
    for (const Geometry& g : out.geometries)
        if (g.mesh && !g.mesh->colors.empty()) reasons.need(kTextures, fmt::format("vertex colours of '{}'", out.scene.shapes[g.shape.index].name));
    out.textures = std::make_unique<Textures>(out.scene, signals, options.threads, said);
}

}  // namespace alidade
