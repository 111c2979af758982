// SPDX-License-Identifier: Apache-2.0
#include "exporters/pov/pov.h"

#include "exporters/pov/cameras.h"
#include "exporters/pov/nodes.h"
#include "exporters/pov/paths.h"
#include "exporters/pov/surroundings.h"
#include "scene/queries.h"

#include <fmt/format.h>

namespace alidade {

namespace {

using namespace pov_export;

/// In the order in which POV-Ray wants to know things: what is named must have been declared.
class Document {
  public:
    Document(const Scene& scene, OutputFiles& files, Losses& losses)
        : scene_(scene), losses_(losses), images_(scene, sdl_, files, losses), textures_(scene, sdl_, images_, losses), lights_(scene, sdl_, losses), facts_(scene, losses) {}

    std::string text() {
        write_settings(scene_, sdl_);
        const Cameras cameras = cameras_of(scene_, losses_);
        const bool lacks_light = scene_.settings.default_light && !is_lit();
        std::optional<Color> sky;
        if (const Atmosphere& air = scene_.atmosphere; air.environment) sky = *air.environment * air.environment_strength;
        if (lacks_light) sky = kDefaultSky;
        if (sky) textures_.set_sky(*sky);
        std::vector<SignalId> others = pigments_of_surroundings(scene_);
        for (const Camera& camera : cameras.all)
            if (camera.normal) others.push_back(*camera.normal);
        textures_.declare(facts_.used_materials(), others);
        write_cameras(cameras, scene_.settings, sdl_, textures_.patterns());
        if (facts_.needs_default()) textures_.declare_default();
        write_surroundings(scene_, sky, sdl_, textures_, images_, losses_);
        if (lacks_light) lights_.write_default_sun(cameras.first());
        directional_lights();
        const ShapeContext context{scene_, sdl_, textures_, losses_};
        NodeWriter(context, lights_, facts_).write();
        if (facts_.roots().empty()) sdl_.line("light_source { 0, color rgb 0 }");   // POV-Ray warns of scenes without objects
        losses_.add("numbers that are not finite", sdl_.not_finite(), "0");
        return sdl_.take();
    }

  private:
    /// The radiance of the sky that a scene without any light gets.
    static constexpr Color kDefaultSky{0.5};
    static constexpr size_t kMostSuns = 1000;

    /// As the renderer has it (tracer/materials.cpp), so that both add a sky and a sun to the same scenes.
    bool glows(const Material& m) const {
        const auto* pbr = m.layers.empty() ? nullptr : std::get_if<GltfPbr>(&m.layers.front());
        if (pbr && pbr->unlit) return true;
        if (!pbr || !pbr->emissive) return false;
        const auto* colour = std::get_if<ConstantSignal>(&scene_.signals[pbr->emissive->index].what);
        return !colour || !is_black(Color(colour->value));
    }

    bool is_lit() const {
        const Atmosphere& air = scene_.atmosphere;
        if (air.environment || air.environment_image) return true;
        const std::vector<bool> used = facts_.used_materials();
        for (size_t i = 0; i < used.size(); ++i)
            if (used[i] && glows(scene_.materials[i])) return true;
        const std::vector<uint32_t>& nodes = facts_.order();
        return std::any_of(nodes.begin(), nodes.end(), [&](uint32_t i) { return std::holds_alternative<LightId>(scene_.nodes[i].what); });
    }

    /// They stand at the top, outside of all nodes.
    void directional_lights() {
        const auto light_of = [&](const Node& node) -> const Light& { return scene_.lights[std::get<LightId>(node.what).index]; };
        const auto is_sun = [&](const Node& node) { return std::holds_alternative<LightId>(node.what) && std::holds_alternative<DirectionalLight>(light_of(node).kind); };
        const bool all = for_each_path(scene_, is_sun, kMostSuns, [&](const Node& node, const Transform& to_world) { lights_.write_directional(light_of(node), to_world); });
        losses_.add("directional lights beyond a thousand", !all);
    }

    const Scene& scene_;
    Losses& losses_;
    Sdl sdl_;
    ImageWriter images_;
    TextureWriter textures_;
    LightWriter lights_;
    NodeFacts facts_;
};

void tell_losses(const Scene& scene, Losses& losses) {
    losses.add("animations", scene.animations.size(), "what stands still");
    losses.add("skins", scene.skins.size(), "meshes as they stand");
    size_t morphs = 0;
    for (const ShapeEntry& shape : scene.shapes)
        if (const auto* mesh = std::get_if<Mesh>(&shape.geometry)) morphs += mesh->morphs.size();
    losses.add("morph targets", morphs, "meshes as they stand");
    const Bounds box = world_bounds(scene);
    const bool bounded = !box.empty() && box.finite();
    losses.add("places farther than 1e7 from the middle, which POV-Ray does not see", bounded && std::max(max_abs(box.min), max_abs(box.max)) > 1e7, "as they are");
}

bool lets_light_through(const Scene& scene, const Material& material) {
    const auto passes = [&](const auto& layer) {
        if (const auto* pbr = std::get_if<GltfPbr>(&layer)) return pbr->transmission || pbr->alpha_mode != AlphaMode::opaque;
        if (const auto* finish = std::get_if<PovFinish>(&layer)) return lets_light_through(scene, finish->pigment);
        const std::vector<MaterialId>& parts = std::get<PovTextureMap>(layer).textures;
        return std::any_of(parts.begin(), parts.end(), [&](MaterialId id) { return lets_light_through(scene, scene.materials[id.index]); });
    };
    return !material.layers.empty() && std::all_of(material.layers.begin(), material.layers.end(), passes);
}

/// POV-Ray takes surfaces nearer to each other than 0.0001, in shadows 0.001, for one: that costs a cube of 0.014 that lets light through 0.9 % of its light, of
/// 0.0014 19 %, and a mirror of 0.0014 3 %.
void tell_smallness(const Scene& scene, Losses& losses) {
    constexpr double kSmall = 0.02, kSmallIfClear = 0.1;
    const Bounds box = world_bounds(scene);
    if (box.empty() || !box.finite() || max_component(box.extent()) >= kSmallIfClear) return;
    const auto is_clear = [&](const MaterialRef& ref) { return ref.index < scene.materials.size() && lets_light_through(scene, scene.materials[ref.index]); };
    const std::vector<WrittenMaterial> written = losses.materials();
    for (const WrittenMaterial& each : written)
        losses.add_of_material(each.material, "the light that POV-Ray misses in so small a scene", max_component(box.extent()) < kSmall || is_clear(each.material), "what it finds");
}

}  // namespace

tl::expected<void, std::string> write_pov(const Scene& scene, OutputFiles& files, Losses& losses) {
    tell_losses(scene, losses);
    files.use_ascii_names();   // POV-Ray's parser refuses others in strings
    const bool still = scene.skins.empty() && std::none_of(scene.shapes.begin(), scene.shapes.end(), [](const ShapeEntry& shape) {
        const auto* mesh = std::get_if<Mesh>(&shape.geometry);
        return mesh && !mesh->morphs.empty();
    });
    files.set_main(still ? Document(scene, files, losses).text() : Document(deform(scene), files, losses).text());
    tell_smallness(scene, losses);
    return {};
}

}  // namespace alidade
