// SPDX-License-Identifier: Apache-2.0
#include "exporters/pov/pov.h"

#include "exporters/pov/cameras.h"
#include "exporters/pov/nodes.h"
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
        const Camera camera = chosen_camera(scene_, losses_);
        write_camera(camera, scene_.settings, sdl_);
        textures_.declare(facts_.used_materials(), pigments_of_surroundings(scene_));
        if (facts_.needs_default()) textures_.declare_default();
        write_surroundings(scene_, sdl_, textures_, images_, losses_);
        directional_lights();
        if (scene_.settings.default_light && !lit_) lights_.write_default_sun(camera);
        const ShapeContext context{scene_, sdl_, textures_, losses_};
        NodeWriter(context, lights_, facts_).write();
        if (facts_.roots().empty() && !lit_) sdl_.line("light_source { 0, color rgb 0 }");   // POV-Ray warns of scenes without objects
        losses_.add("numbers that are not finite", sdl_.not_finite(), "0");
        return sdl_.take();
    }

  private:
    /// They stand at the top, outside of all nodes.
    void directional_lights() {
        visit_paths(scene_, [&](const Visit& v) {
            const auto* id = std::get_if<LightId>(&scene_.nodes[v.node.index].what);
            if (!id) return true;
            const Light& light = scene_.lights[id->index];
            lit_ = true;
            if (std::holds_alternative<DirectionalLight>(light.kind)) lights_.write_directional(light, v.to_world);
            return true;
        });
    }

    const Scene& scene_;
    Losses& losses_;
    Sdl sdl_;
    ImageWriter images_;
    TextureWriter textures_;
    LightWriter lights_;
    NodeFacts facts_;
    bool lit_ = false;
};

void tell_losses(const Scene& scene, Losses& losses) {
    losses.add("animations", scene.animations.size(), "what stands still");
    losses.add("skins", scene.skins.size(), "meshes as they stand");
    size_t morphs = 0;
    for (const ShapeEntry& shape : scene.shapes)
        if (const auto* mesh = std::get_if<Mesh>(&shape.geometry)) morphs += mesh->morphs.size();
    losses.add("morph targets", morphs, "meshes as they stand");
    size_t functions = 0;
    for (const Signal& signal : scene.signals) functions += std::holds_alternative<FunctionSignal>(signal.what);
    losses.add("functions", functions, "white");
}

}  // namespace

tl::expected<void, std::string> write_pov(const Scene& scene, OutputFiles& files, Losses& losses) {
    tell_losses(scene, losses);
    const bool still = scene.skins.empty() && std::none_of(scene.shapes.begin(), scene.shapes.end(), [](const ShapeEntry& shape) {
        const auto* mesh = std::get_if<Mesh>(&shape.geometry);
        return mesh && !mesh->morphs.empty();
    });
    files.set_main(still ? Document(scene, files, losses).text() : Document(deform(scene), files, losses).text());
    return {};
}

}  // namespace alidade
